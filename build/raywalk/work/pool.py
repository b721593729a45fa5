"""Runs independent work on all cores, and hands results on as they are finished."""

from __future__ import annotations

import multiprocessing
import os
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from dataclasses import dataclass
from queue import SimpleQueue
from threading import Event as Flag
from threading import Thread
from typing import Any, Generic, TypeVar

from raywalk.work.progress import Progress, Report
from raywalk.work.snapshot import held, hold

Task = TypeVar("Task")
Result = TypeVar("Result")
# How many threads a task may run at the moment: more when less is left to do.
Threads = Callable[[], int]
# work(task, threads, report) -> result; report(stage, share) as often as it likes.
Work = Callable[[Task, Threads, Report], Result]

EVERY = 0.1  # seconds between two checks of how far the work is, and between two reports
# In a worker process: where progress goes to, and how many tasks are not finished.
_messages: Any = None
_left: Any = None


@dataclass(frozen=True)
class Finished(Generic[Task, Result]):
    """One task is done."""

    task: Task
    result: Result


class Stopped(Exception):
    """Raised in work whose result nobody waits for any longer."""


def cores() -> int:
    """Processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run_all(
    work: Work[Task, Result], tasks: Sequence[Task], name: Callable[[Task], str]
) -> Iterator[Progress | Finished[Task, Result]]:
    """work(task, threads, report) for every task, in the order in which they finish, and how far
    each of them is, under its name.

    One task gets all cores as threads; several get a process each, with one thread, and with
    more when fewer are left than there are cores. The results are the same either way.
    Processes are spawned, not forked: numba's and Embree's
    threads do not survive a fork. The first exception ends everything.
    """
    if len(tasks) < 2 or cores() < 2:
        yield from _one_by_one(work, tasks, name)
        return
    context = multiprocessing.get_context("spawn")
    messages, left = context.SimpleQueue(), context.Value("i", len(tasks))
    given = (messages, left, held())
    with ProcessPoolExecutor(
        min(cores(), len(tasks)), mp_context=context, initializer=_begin, initargs=given
    ) as pool:
        waiting = {pool.submit(_in_process, work, task, name(task)): task for task in tasks}
        yield from follow(pool, waiting, messages)


def _one_by_one(
    work: Work[Task, Result], tasks: Sequence[Task], name: Callable[[Task], str]
) -> Iterator[Progress | Finished[Task, Result]]:
    """In a thread, so that progress can be reported meanwhile."""
    messages: SimpleQueue[Progress] = SimpleQueue()
    stopped = Flag()

    def run(task: Task) -> Result:
        return work(task, cores, reporter(messages, name(task), stopped))

    with ThreadPoolExecutor(1) as pool:
        try:
            yield from follow(pool, {pool.submit(run, task): task for task in tasks}, messages)
        finally:
            stopped.set()


def follow(
    pool: Executor, waiting: dict[Future[Result], Task], messages: Any
) -> Iterator[Progress | Finished[Task, Result]]:
    """Hands on messages and what is finished, until nothing is waited for."""
    try:
        while waiting:
            done, _ = wait(waiting, timeout=EVERY, return_when=FIRST_COMPLETED)
            while not messages.empty():
                yield messages.get()
            for future in done:
                yield Finished(waiting.pop(future), future.result())
    finally:
        # Where all is done, the processes are waited for: then what they spent is known.
        pool.shutdown(wait=not waiting, cancel_futures=True)


def reporter(messages: Any, of: str, stopped: Flag | None = None) -> Report:
    """Reports progress into a queue, but not more often than anybody reads."""
    last = 0.0

    def report(stage: str, share: float) -> None:
        nonlocal last
        if stopped and stopped.is_set():
            raise Stopped
        now = time.monotonic()
        if now - last >= EVERY:
            last = now
            messages.put(Progress(of, stage, share))

    return report


def _begin(messages: Any, left: Any, files: dict[str, bytes] | None) -> None:
    global _messages, _left
    _messages, _left = messages, left
    hold(files)
    Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """A build that is killed cannot tell its processes to end; they would wait for ever."""
    parent = multiprocessing.parent_process()
    if parent:
        parent.join()
        os._exit(1)


def _in_process(work: Work[Task, Result], task: Task, of: str) -> Result:
    try:
        return work(task, _share_of_cores, reporter(_messages, of))
    finally:
        with _left.get_lock():
            _left.value -= 1


def _share_of_cores() -> int:
    """Of each task that is not finished."""
    return max(1, cores() // max(1, _left.value))
