"""The task of a process that traces: it loads what tracing needs, and nothing of the pages."""

from __future__ import annotations

from pathlib import Path

from raywalk.pipeline.parts import TRACE, models_of
from raywalk.scene.model import Scene
from raywalk.work.maker import Parts
from raywalk.work.making import made, refuse_changed
from raywalk.work.pool import Threads
from raywalk.work.progress import Report
from raywalk.work.store import Store
from raywalk.work.times import Spent, Stages


def trace_into(
    store: Store, parts: dict[str, Parts], scene: Scene, threads: Threads, report: Report
) -> Spent:
    """Traces a scene into the store, under its key; returns what it took."""
    # Only where something is traced: a change of words imports no compiler.
    from raywalk.optics.compiling import seconds_spent

    made_from, stages = parts[scene.id], Stages("compiling kernels", seconds_spent)

    def trace(folder: Path) -> None:
        TRACE(scene, folder, threads, stages.following(report))
        refuse_changed(made_from, made_from["models"], models_of(scene))

    made(store, made_from, trace)
    return stages.spent("keeping")
