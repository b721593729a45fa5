"""Chains of work beside one another: in which order their jobs run, and what comes of them."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from raywalk.work import chains as chains_module
from raywalk.work import pool
from raywalk.work.chains import run_chains
from raywalk.work.pool import Job, Workers
from raywalk.work.progress import Progress

PATIENCE = 60.0  # seconds after which a thread is taken to wait for ever


class Desk:
    """In place of processes: threads, and a note of what was handed in."""

    def __init__(self, threads):
        self.threads, self.taken, self.left = ThreadPoolExecutor(threads), [], []

    def submit(self, job, left):
        self.taken.append(job.of)
        self.left.append(left)
        return self.threads.submit(job.work, job.task, lambda: 1, lambda *_: None)

    def tell_left(self, count):
        self.left.append(count)

    def messages(self):
        return iter(())


def chain(name, works):
    """A job after the other; each result is said, the last one returned."""
    result = None
    for work in works:
        result = yield Job(name, lambda task, threads, report, work=work: work(), None)
        yield f"{name}: {result}"
    return result


def ended(steps):
    """What was said, and what is returned."""
    said = []
    while True:
        try:
            said.append(next(steps))
        except StopIteration as end:
            return said, end.value


def test_each_chain_returns_its_own_in_the_order_of_the_chains():
    """Whichever ends first; what they say is handed on."""
    chains = [chain("a", [lambda: 1, lambda: 2]), chain("b", []), chain("c", [lambda: 3])]
    said, results = ended(run_chains(chains, Desk(2)))
    assert results == [2, None, 3]
    assert sorted(said) == ["a: 1", "a: 2", "c: 3"]


def test_a_chain_goes_on_while_another_one_is_not_done_with_its_first_job(monkeypatch):
    """The long job ends only when the short chain has come to its end."""
    monkeypatch.setattr(chains_module, "cores", lambda: 2)
    last = threading.Event()
    long = chain("long", [lambda: last.wait(PATIENCE)])
    short = chain("short", [lambda: 1, lambda: 2, lambda: last.set()])
    said, results = ended(run_chains([long, short], Desk(2)))
    assert results == [True, None]
    assert said[0] == "short: 1"


def test_of_jobs_that_can_run_those_of_the_first_chains_do(monkeypatch):
    """The first is the longest: its next job comes before others' first ones."""
    monkeypatch.setattr(chains_module, "cores", lambda: 1)
    monkeypatch.setattr(chains_module, "AHEAD", 0)
    desk = Desk(1)
    ended(run_chains([chain(name, [lambda: 0] * 2) for name in "abc"], desk))
    assert desk.taken == list("aabbcc")


def test_chains_that_are_not_finished_share_the_cores():
    """With each that ends, one less is told."""
    desk = Desk(1)
    ended(run_chains([chain("a", [lambda: 0]), chain("b", []), chain("c", [lambda: 0])], desk))
    assert desk.left[0] == 2  # the first job waited to see whether there is a second one
    assert desk.left[-1] == 0


def test_the_first_exception_ends_everything():
    """A scene with a fault: the next one's job is never handed in."""

    def broken():
        raise ValueError("buried")

    desk = Desk(1)
    with pytest.raises(ValueError, match="buried"):
        ended(run_chains([chain("a", [broken, lambda: 1])], desk))
    assert desk.taken == ["a"]


def test_a_lone_job_runs_in_this_process_and_gets_all_cores(monkeypatch):
    """Its kernels are loaded here already; and its progress is told."""
    monkeypatch.setattr(pool, "cores", lambda: 5)
    seen = []

    def work(task, threads, report):
        seen.append((task, threads(), threading.current_thread() is threading.main_thread()))
        report("tracing", 0.5)
        return "done"

    def alone():
        return (yield Job("ball", work, 7))

    with Workers() as workers:
        said, results = ended(run_chains([alone(), chain("idle", [])], workers))
    assert results == ["done", None]
    assert seen == [(7, 5, False)]
    assert said == [Progress("ball", "tracing", 0.5)]


def test_work_that_nobody_waits_for_stops_at_its_next_report():
    """A build that is given up does not go on tracing."""
    begun, stopped = threading.Event(), threading.Event()

    def work(task, threads, report):
        begun.set()
        try:
            while True:
                report("tracing", 0.5)
        except pool.Stopped:
            stopped.set()
            raise

    def alone():
        yield Job("ball", work, None)

    with Workers() as workers:
        steps = run_chains([alone()], workers)
        next(steps)
        assert begun.wait(PATIENCE)
        steps.close()
    assert stopped.wait(PATIENCE)
