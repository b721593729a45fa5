"""Where a build's jobs run: in processes that are started once, on all cores."""

from __future__ import annotations

import multiprocessing
import os
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import dataclass
from queue import SimpleQueue
from threading import Event as Flag
from threading import Thread
from types import TracebackType
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
# In a worker process: where progress goes to, and how many chains of jobs are not finished.
_messages: Any = None
_left: Any = None


@dataclass(frozen=True)
class Finished(Generic[Task, Result]):
    """One task is done."""

    task: Task
    result: Result


@dataclass(frozen=True)
class Job(Generic[Task, Result]):
    """work(task, threads, report), and under whose name its progress is told."""

    of: str
    work: Work[Task, Result]
    task: Task


class Stopped(Exception):
    """Raised in work whose result nobody waits for any longer."""


def cores() -> int:
    """Processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Workers:
    """Processes for jobs, started when there is work for two, and there until all of a build is
    done: what they have imported and loaded serves each job that follows.

    They are spawned, not forked: numba's and Embree's threads do not survive a fork. They have what
    this build has read until they start (`snapshot.py`): what jobs read has to be read before.
    """

    def __init__(self) -> None:
        self._context = multiprocessing.get_context("spawn")
        self._processes: ProcessPoolExecutor | None = None
        self._thread: ThreadPoolExecutor | None = None
        self._said_here: SimpleQueue[Progress] = SimpleQueue()
        self._stopped = Flag()
        self._said: Any = None
        self._left: Any = None

    def __enter__(self) -> Workers:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:  # fmt: skip
        self._stopped.set()
        if self._thread:
            self._thread.shutdown(cancel_futures=True)
        if self._processes:
            # Where all is done, the processes are waited for: then what they spent is known.
            self._processes.shutdown(wait=kind is None, cancel_futures=True)

    def submit(self, job: Job[Any, Result], left: int) -> Future[Result]:
        """left: how many chains of jobs are not finished, which share the cores. Where there is but
        one and never were others, it gets all cores as threads, and this process, which may have
        done such work before."""
        if cores() < 2 or (left == 1 and not self._processes):
            self._thread = self._thread or ThreadPoolExecutor(1)
            report = reporter(self._said_here, job.of, self._stopped)
            return self._thread.submit(job.work, job.task, cores, report)
        pool = self._started()
        self.tell_left(left)
        return pool.submit(_in_process, job)

    def tell_left(self, count: int) -> None:
        """So many chains are not finished: a core that none of them needs serves the others."""
        if self._left:
            self._left.value = count

    def messages(self) -> Iterator[Progress]:
        """What was reported since they were asked for last."""
        for queue in (self._said_here, self._said):
            while queue and not queue.empty():
                yield queue.get()

    def _started(self) -> Executor:
        if not self._processes:
            self._said, self._left = self._context.SimpleQueue(), self._context.Value("i", 0)
            self._processes = ProcessPoolExecutor(
                cores(), mp_context=self._context, initializer=_begin,
                initargs=(self._said, self._left, held()),
            )  # fmt: skip
        return self._processes


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


def _in_process(job: Job[Any, Result]) -> Result:
    return job.work(job.task, _share_of_cores, reporter(_messages, job.of))


def _share_of_cores() -> int:
    """Of each chain that is not finished."""
    return max(1, cores() // max(1, _left.value))
