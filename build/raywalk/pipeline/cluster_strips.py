"""One scene's picture in strips over a Dask cluster: where one machine would take too long.

The scene and its files go to a worker once and from there to the others; each keeps what it
compiled of them. A strip comes back as its colours and kept rays, deflated. The builder holds the
picture, the kept rays and two tasks a worker, however large the picture is. A lost worker's strips
are traced by the others, to the same bytes.
"""

from __future__ import annotations

import hashlib
import pickle
import tempfile
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.pipeline.cluster import (
    made_by,
    mesh_files,
    refuse_other_makers,
    task_result,
    with_meshes,
)
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.record import Recorded, assemble, kept_pixels
from raywalk.trace.tally import Tally
from raywalk.trace.wavefront import STRIP, Threads, Traced, Tracer, strip_pixels, trace_strip
from raywalk.work.maker import Parts

AT_ONCE = 8 * STRIP  # pixels of a task: a tenth of a second and more, so that asking costs little
AHEAD = 2  # tasks a worker: one at work, one that waits for it


@dataclass
class Wire:
    """Bytes that went to the cluster, and came back."""

    there: int = 0
    back: int = 0


def trace_there(
    client: Any, wire: Wire, tracer: Tracer, threads: Threads = 1,
    report: Callable[[float], None] | None = None,
) -> Traced:  # fmt: skip
    """As `trace_picture` gives it, byte for byte. client: of a cluster (see cluster.connected);
    threads: of no meaning here. Raises ClusterError if workers die again and again or run other
    code."""
    size = tracer.scene.render.size
    picture = np.empty((size * size, 3), np.uint8)
    firsts = range(0, size * size, AT_ONCE)
    records: list[list[Recorded]] = [[] for _ in firsts]
    tallies = [Tally() for _ in firsts]
    for done, (task, packed) in enumerate(_packed_strips(client, wire, tracer, firsts), start=1):
        colours, records[task], tallies[task] = pickle.loads(zlib.decompress(packed))
        picture[firsts[task] : firsts[task] + len(colours)] = colours
        if report:
            report(done / len(firsts))
    total = Tally()
    for tally in tallies:
        total.add(tally)
    tree = assemble(tracer, [each for task in records for each in task], size)
    return Traced(picture.reshape(size, size, 3), tree, total)


def _packed_strips(
    client: Any, wire: Wire, tracer: Tracer, firsts: range
) -> Iterator[tuple[int, bytes]]:
    """(task, what strips_there made of it), as they are finished; few are asked for ahead."""
    import distributed

    cargo = pickle.dumps((tracer.scene, mesh_files(tracer.scene), made_by()))
    key = hashlib.sha256(cargo).hexdigest()
    # A task, not data handed to one worker: if that is lost the scheduler can make it again.
    sent = client.submit(bytes, cargo, pure=False)
    wire.there += len(cargo)
    waiting: dict[Any, int] = {}
    finished = distributed.as_completed(loop=client.loop)
    tasks = iter(range(len(firsts)))

    def ask() -> None:
        if (task := next(tasks, None)) is not None:
            end = min(firsts[task] + AT_ONCE, tracer.scene.render.size**2)
            asked = client.submit(strips_there, sent, key, firsts[task], end, pure=False)
            waiting[asked] = task
            finished.add(asked)

    for _ in range(AHEAD * len(client.scheduler_info()["workers"])):
        ask()
    for done in finished:
        packed = task_result(done)
        wire.back += len(packed)
        ask()
        yield waiting.pop(done), packed


_kept: dict[str, tuple[Tracer, np.ndarray]] = {}  # on a worker: of the scene that it traces


def strips_there(cargo: bytes, key: str, first: int, end: int) -> bytes:
    """On a worker: pixels first to end, strip by strip, deflated: colours, records and tally.

    Raises ClusterError if the worker's code or packages are not the builder's.
    """
    if key not in _kept:
        _kept.clear()
        _kept[key] = _unpacked(cargo)
    tracer, kept = _kept[key]
    tally, colours, records = Tally(), [], []
    step = strip_pixels(tracer.scene)
    for at in range(first, end, step):
        pixels = np.arange(at, min(at + step, end))
        own, recorded, counted = trace_strip(tracer, pixels, kept)
        colours.append(own)
        records.append(recorded)
        tally.add(counted)
    return zlib.compress(pickle.dumps((np.concatenate(colours), records, tally)), 1)


def _unpacked(cargo: bytes) -> tuple[Tracer, np.ndarray]:
    """A tracer, and which pixels are kept."""
    scene, meshes, expected = pickle.loads(cargo)
    parts: Parts = expected
    refuse_other_makers(parts, made_by())
    with tempfile.TemporaryDirectory() as scratch:
        tracer = Tracer(with_meshes(scene, meshes, Path(scratch)), least_share=LEAST_SHARE)
    return tracer, kept_pixels(scene.render.size, scene.render.resolutions)
