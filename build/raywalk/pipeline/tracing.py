"""Traces scenes into the store: on all cores, or on a cluster."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.pipeline.cluster import run_on_cluster
from raywalk.pipeline.trace_task import trace_into
from raywalk.scene.model import Scene
from raywalk.scene.wording import counted
from raywalk.work.chains import Chain, run_chains
from raywalk.work.digests import key_of
from raywalk.work.maker import Parts
from raywalk.work.making import reasons
from raywalk.work.pool import Job, Workers, cores
from raywalk.work.progress import Begin, End, Message, Progress
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, note


def guessed_cost(scene: Scene) -> float:
    """For the order and the progress bar only, in no unit."""
    bounces = scene.render.depth + 1
    return (
        len(scene.objects) * bounces * (4 if scene.has_glass else 1) * (3 if scene.has_mesh else 1)
    )


class Tracing:
    """Scenes with their traces in a store: which are missing, and how many of these are done."""

    def __init__(self, scenes: Sequence[Scene], store: Store, parts: dict[str, Parts]):
        self._store, self._parts, self._done = store, parts, 0
        self._keys = {scene.id: key_of(parts[scene.id]) for scene in scenes}
        self.missing = by_cost([each for each in scenes if not store.find(self._keys[each.id])])
        self._wanted = {scene.id for scene in self.missing}

    def begin(self, scheduler: str | None = None) -> Iterator[str | Message]:
        """Says what will be traced and why, and traces it if that is done on a cluster."""
        for scene in self.missing:
            yield from reasons(self._store, self._parts[scene.id])
        if self.missing:
            where = f"the cluster {scheduler}" if scheduler else f"{cores()} cores"
            yield f"tracing {len(self.missing)} of {counted(len(self._keys), 'scene')} on {where}"
            yield Begin({scene.id: guessed_cost(scene) for scene in self.missing})
        if self.missing and scheduler:
            yield from self._on_cluster(scheduler)

    def chain(self, scene: Scene) -> Chain[Entry]:
        """A scene's trace, made if it is not there."""
        if scene.id in self._wanted and not self._store.find(self._keys[scene.id]):
            spent = yield Job(scene.id, partial(trace_into, self._store, self._parts), scene)
            yield from self._done_with(scene, spent)
        return self._store.get(self._keys[scene.id])

    def _on_cluster(self, scheduler: str) -> Iterator[str | Message]:
        for message in run_on_cluster(scheduler, self.missing):
            if isinstance(message, Progress):
                yield message
                continue
            made_from = self._parts[message.task.id]
            seconds, files = message.result
            self._store.entry(key_of(made_from), partial(write_files, files), made_from)
            yield from self._done_with(message.task, Spent(seconds))

    def _done_with(self, scene: Scene, spent: Spent) -> Iterator[str | Message]:
        """One of those that were missing is there."""
        note(spent)
        self._done += 1
        yield Progress(scene.id, "", 1.0)
        yield f"[{self._done}/{len(self.missing)}] {scene.id}: {spent.seconds:.1f} s"
        if self._done == len(self.missing):
            yield End()


def by_cost(scenes: Sequence[Scene]) -> list[Scene]:
    """Long work first, or a core waits at the end."""
    return sorted(scenes, key=guessed_cost, reverse=True)


def trace_all(scenes: Sequence[Scene], store: Store, parts: dict[str, Parts]) -> Iterator[Any]:
    """Traces scenes into the store, and does nothing else; says how far it is."""
    tracing = Tracing(scenes, store, parts)
    yield from tracing.begin()
    with Workers() as workers:
        yield from run_chains([tracing.chain(scene) for scene in tracing.missing], workers)


def write_files(files: dict[str, bytes], folder: Path) -> None:
    """What a worker sent, into a folder."""
    for name, content in files.items():
        (folder / name).write_bytes(content)
