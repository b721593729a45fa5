"""Runs independent work on all cores, and hands results on as they are finished."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from typing import TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")


def cores() -> int:
    """Processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run_all(
    work: Callable[[Task, int], Result], tasks: Sequence[Task]
) -> Iterator[tuple[Task, Result]]:
    """work(task, threads) for every task, in the order in which they finish.

    One task gets all cores as threads; several get a process each, with one thread. The
    results are the same either way. Processes are spawned, not forked: numba's and Embree's
    threads do not survive a fork. The first exception ends everything.
    """
    if len(tasks) < 2 or cores() < 2:
        for task in tasks:
            yield task, work(task, cores())
        return
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(min(cores(), len(tasks)), mp_context=context) as pool:
        waiting = {pool.submit(work, task, 1): task for task in tasks}
        try:
            for done in as_completed(waiting):
                yield waiting[done], done.result()
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
