"""The task of a process that traces: it loads what tracing needs, and nothing of the pages."""

from __future__ import annotations

import time

from raywalk.scene.model import Scene
from raywalk.work.digests import key_of
from raywalk.work.keys import Parts
from raywalk.work.pool import Threads
from raywalk.work.progress import Report
from raywalk.work.store import Store


def trace_into(
    store: Store, parts: dict[str, Parts], scene: Scene, threads: Threads, report: Report
) -> float:
    """Traces a scene into the store, under its key; returns the seconds it took."""
    # Only here: a build with nothing to trace never pays for numba, trimesh and Embree.
    from raywalk.products import write_products

    begun = time.monotonic()
    made_from = parts[scene.id]
    store.entry(
        key_of(made_from), lambda folder: write_products(scene, folder, threads, report), made_from
    )
    return time.monotonic() - begun
