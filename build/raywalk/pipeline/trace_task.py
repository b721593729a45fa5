"""The task of a process that traces: it loads what tracing needs, and nothing of the pages."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from raywalk.pipeline.parts import TRACE, grids_parts, models_of
from raywalk.scene.model import Scene
from raywalk.work.digests import key_of
from raywalk.work.maker import Parts
from raywalk.work.making import made, refuse_changed
from raywalk.work.pool import Threads
from raywalk.work.progress import Report
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, Stages


def trace_into(
    store: Store, parts: dict[str, Parts], scene: Scene, threads: Threads, report: Report
) -> Spent:
    """Traces a scene into the store, under its key; returns what it took. Grids that are there
    already (`grids_into`) are not made again."""
    # Only where something is traced: a change of words imports no compiler.
    from raywalk.optics.compiling import seconds_spent

    made_from, stages = parts[scene.id], Stages("compiling kernels", seconds_spent)
    grids = store.find(key_of(grids_parts(made_from)))
    trace = partial(
        TRACE, scene, threads=threads, report=stages.following(report),
        ready=grids.files() if grids else (),
    )  # fmt: skip
    made(store, made_from, partial(_unless_changed, trace, made_from, scene))
    return stages.spent("keeping")


def grids_into(store: Store, made_from: Parts, scene: Scene, threads: Threads) -> Entry:
    """A scene's grids alone, in a sixtieth of the time; made_from: what its trace is made from."""
    from raywalk.trace.wavefront import trace_grids

    trace = partial(TRACE, scene, threads=threads, trace=trace_grids)
    parts = grids_parts(made_from)
    return made(store, parts, partial(_unless_changed, trace, parts, scene))


def _unless_changed(
    trace: Callable[[Path], None], made_from: Parts, scene: Scene, folder: Path
) -> None:
    trace(folder)
    refuse_changed(made_from, made_from["models"], models_of(scene))
