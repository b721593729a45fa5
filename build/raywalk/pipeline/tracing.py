"""Traces scenes into the store: on all cores, or on a cluster."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path

from raywalk.pipeline.cluster import run_on_cluster
from raywalk.pipeline.trace_task import trace_into
from raywalk.scene.model import Scene
from raywalk.work.digests import key_of
from raywalk.work.maker import Parts
from raywalk.work.pool import Finished, run_all
from raywalk.work.progress import Begin, End, Message, Progress
from raywalk.work.store import Store
from raywalk.work.times import Spent, note


def guessed_cost(scene: Scene) -> float:
    """For the order and the progress bar only, in no unit."""
    bounces = scene.render.depth + 1
    return (
        len(scene.objects) * bounces * (4 if scene.has_glass else 1) * (3 if scene.has_mesh else 1)
    )


def trace_all(
    missing: list[Scene], store: Store, parts: dict[str, Parts], scheduler: str | None
) -> Iterator[str | Message]:
    """Traces scenes into the store, here or on a cluster; says how far it is."""
    # Long work is started first, or a core waits at the end.
    scenes = sorted(missing, key=guessed_cost, reverse=True)
    yield Begin({scene.id: guessed_cost(scene) for scene in scenes})
    taken: list[Spent] = []
    for message in _traced(scenes, store, parts, scheduler):
        if isinstance(message, Progress):
            yield message
            continue
        taken.append(message.result)
        yield Progress(message.task.id, "", 1.0)
        yield f"[{len(taken)}/{len(scenes)}] {message.task.id}: {message.result.seconds:.1f} s"
    note(taken)
    yield End()


def _traced(
    scenes: list[Scene], store: Store, parts: dict[str, Parts], scheduler: str | None
) -> Iterator[Progress | Finished[Scene, Spent]]:
    if not scheduler:
        yield from run_all(partial(trace_into, store, parts), scenes, lambda scene: scene.id)
        return
    for message in run_on_cluster(scheduler, scenes):
        if isinstance(message, Progress):
            yield message
            continue
        seconds, files = message.result
        made_from = parts[message.task.id]
        store.entry(key_of(made_from), partial(write_files, files), made_from)
        yield Finished(message.task, Spent(seconds))


def write_files(files: dict[str, bytes], folder: Path) -> None:
    """What a worker sent, into a folder."""
    for name, content in files.items():
        (folder / name).write_bytes(content)
