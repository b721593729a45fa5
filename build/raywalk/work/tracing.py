"""The task of a process that traces: it loads what tracing needs, and nothing of the pages."""

from __future__ import annotations

import time

from raywalk.scene.model import Scene
from raywalk.work.keys import TRACE, Parts
from raywalk.work.making import made
from raywalk.work.pool import Threads
from raywalk.work.progress import Report
from raywalk.work.store import Store


def trace_into(
    store: Store, parts: dict[str, Parts], scene: Scene, threads: Threads, report: Report
) -> float:
    """Traces a scene into the store, under its key; returns the seconds it took."""
    begun = time.monotonic()
    made(store, parts[scene.id], lambda folder: TRACE(scene, folder, threads, report))
    return time.monotonic() - begun
