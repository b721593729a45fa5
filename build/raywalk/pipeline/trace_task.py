"""The task of a process that traces: it loads what tracing needs, and nothing of the pages."""

from __future__ import annotations

import time
from pathlib import Path

from raywalk.pipeline.parts import TRACE, models_of
from raywalk.scene.model import Scene
from raywalk.work.maker import Parts
from raywalk.work.making import made, refuse_changed
from raywalk.work.pool import Threads
from raywalk.work.progress import Report
from raywalk.work.store import Store


def trace_into(
    store: Store, parts: dict[str, Parts], scene: Scene, threads: Threads, report: Report
) -> float:
    """Traces a scene into the store, under its key; returns the seconds it took."""
    begun, made_from = time.monotonic(), parts[scene.id]

    def trace(folder: Path) -> None:
        TRACE(scene, folder, threads, report)
        refuse_changed(made_from, made_from["models"], models_of(scene))

    made(store, made_from, trace)
    return time.monotonic() - begun
