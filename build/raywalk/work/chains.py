"""Chains of work that go on beside one another: of a scene, say, trace, slide views, slides.

A chain is a generator. What is quick it does itself, in this process; what takes long it yields as
a Job, and gets the job's result when that is done. Texts and messages that it yields are handed on.
So what follows after what reads from top to bottom, and no core waits for the slowest chain before
another one may go on.
"""

from __future__ import annotations

import heapq
from collections.abc import Generator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import Any, TypeVar

from raywalk.work.pool import EVERY, Job, Workers, cores
from raywalk.work.progress import Message

Result = TypeVar("Result")
Chain = Generator[Job[Any, Any] | str | Message, Any, Result]

# Jobs that wait at the processes beside one for each core: while this process takes a chain
# further, no core has nothing to do.
AHEAD = 1


def run_chains(
    chains: Sequence[Chain[Result]], workers: Workers
) -> Generator[str | Message, None, list[Result]]:
    """What each chain returns. The longest should come first: of the jobs that can run, those of
    the first chains do, or a core waits at the end. The first exception ends everything."""
    return (yield from _Running(chains, workers).to_the_end())


class _Running:
    """Chains, by their place: which jobs wait, which run, what came of those that ended."""

    def __init__(self, chains: Sequence[Chain[Any]], workers: Workers):
        self.chains, self.workers = chains, workers
        self.ready: list[tuple[int, Job[Any, Any]]] = []
        self.running: dict[Future[Any], int] = {}
        self.results: dict[int, Any] = {}

    def to_the_end(self) -> Generator[str | Message, None, list[Any]]:
        for place in range(len(self.chains)):
            yield from self._further(place, None)
            # One job may be all there is, which then gets all cores: it waits for a second one.
            if self.running or len(self.ready) > 1:
                self._submit()
        self._submit()
        while self.running:
            done, _ = wait(self.running, timeout=EVERY, return_when=FIRST_COMPLETED)
            yield from self.workers.messages()
            for future in sorted(done, key=lambda each: self.running[each]):
                yield from self._further(self.running.pop(future), future.result())
                self._submit()
        return [self.results[place] for place in range(len(self.chains))]

    def _further(self, place: int, result: Any) -> Generator[str | Message, None, None]:
        """Takes a chain to its next job, or to its end."""
        try:
            said = self.chains[place].send(result)
            while not isinstance(said, Job):
                yield said
                said = next(self.chains[place])
            heapq.heappush(self.ready, (place, said))
        except StopIteration as end:
            self.results[place] = end.value
            self.workers.tell_left(self._left())

    def _submit(self) -> None:
        while self.ready and len(self.running) < cores() + AHEAD:
            place, job = heapq.heappop(self.ready)
            self.running[self.workers.submit(job, self._left())] = place

    def _left(self) -> int:
        return len(self.chains) - len(self.results)
