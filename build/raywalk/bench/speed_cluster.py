"""A cluster at the scale it is for: many scenes, and one large picture in strips with a worker
killed in the middle. Bytes as on one machine; time beside it; what goes over the wire."""

from __future__ import annotations

import hashlib
import importlib.util
import resource
import signal
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from raywalk.bench.cases import Case
from raywalk.bench.own_cluster import PATIENCE, own_cluster
from raywalk.bench.speed_many import write_scenes
from raywalk.pipeline.cluster import connected, run_on_cluster
from raywalk.pipeline.cluster_strips import Wire, trace_there
from raywalk.pipeline.trace_products import write_products
from raywalk.scene.model import Scene
from raywalk.scene.read import read_own_scenes, read_scene
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import Traced, Tracer, trace_picture
from raywalk.work.pool import Finished, cores

SIDE, SCENES = 8085, 200  # 3 x 5 x 7 x 7 x 11: the largest up to 8192 with a grid of 5 x 5 in it
QUICK_SIDE, QUICK_SCENES = 1155, 8
WORKERS = 2
# Of one machine's time, on as many workers as it has cores, one of which is killed after a quarter
# of the work: 1.6 if the other did all of the rest, and what sending costs.
SHARE = 2.0
BACK = 3.0  # bytes a pixel that come back: 8-bit colours, not deflated
HELD = 600  # MiB that the builder holds beside the picture: kernels and kept rays, not strips


def cluster(course: Path, quick: bool) -> dict[str, Any] | None:
    """Figures of one large picture and of many scenes; None without the package."""
    if importlib.util.find_spec("distributed") is None:
        return None
    with own_cluster(WORKERS) as (address, processes):
        client, _ = connected(address)
        try:
            client.wait_for_workers(WORKERS, timeout=PATIENCE)
            scenes = many_scenes(address, QUICK_SCENES if quick else SCENES)
            victim = processes[0]
            large = large_scene(course, QUICK_SIDE if quick else SIDE)
            picture = one_picture(client, large, lambda: victim.send_signal(signal.SIGKILL))
        finally:
            client.close()
    return {"picture": picture, "scenes": scenes}


def large_scene(course: Path, side: int) -> Scene:
    """The course's scene of many mirrors, with the smallest grid, and no lesson."""
    scene = read_scene(next(course.glob("05-*")))
    render = replace(scene.render, size=side, resolutions=(5,))
    return replace(scene, render=render, lesson=())


def one_picture(client: Any, scene: Scene, kill: Any) -> dict[str, Any]:
    """Traced there, a worker killed after a quarter; then here, on all cores."""
    wire, killed = Wire(), False
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    small = replace(scene, render=replace(scene.render, size=315))
    trace_there(client, Wire(), Tracer(small, least_share=LEAST_SHARE))  # loads the kernels

    def report(share: float) -> None:
        nonlocal killed
        if share >= 0.25 and not killed:
            killed = True
            kill()

    start = time.perf_counter()
    there = _digest(trace_there(client, wire, tracer, report=report))
    seconds, held = time.perf_counter() - start, _peak_mib()
    start = time.perf_counter()
    here = _digest(trace_picture(tracer, cores()))
    side = scene.render.size
    return {
        "side": side, "same": there == here, "there": seconds,
        "here": time.perf_counter() - start, "sent": wire.there, "back": wire.back / side**2,
        "held": held - 3 * side**2 / 2**20,
    }  # fmt: skip


def _digest(traced: Traced) -> str:
    return hashlib.sha256(traced.picture.tobytes()).hexdigest()


def _peak_mib() -> float:
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (2**20 if sys.platform == "darwin" else 2**10)


def many_scenes(address: str, count: int) -> dict[str, Any]:
    """So many small scenes there, and a tenth of them here, on one core: time and bytes."""
    with tempfile.TemporaryDirectory() as folder:
        write_scenes(Path(folder) / "scenes", count)
        scenes = read_own_scenes(Path(folder) / "scenes")
        start = time.perf_counter()
        found = {
            message.task.id: message.result[1]
            for message in run_on_cluster(address, scenes)
            if isinstance(message, Finished)
        }
        there = time.perf_counter() - start
        some, same = scenes[:: max(1, count // 20)], True
        start = time.perf_counter()
        for scene in some:
            place = Path(folder) / "here" / scene.id
            place.mkdir(parents=True)
            write_products(scene, place, 1)
            own = {path.name: path.read_bytes() for path in place.iterdir()}
            same = same and own == found[scene.id]
        here = (time.perf_counter() - start) / len(some) * count / cores()
    back = sum(len(content) for files in found.values() for content in files.values())
    return {"count": len(found), "same": same, "there": there, "here": here, "back": back}


def as_table(row: dict[str, Any] | None) -> Iterator[str]:
    """Ratios and bytes."""
    if not row:
        yield '  not measured: the package `distributed` is not installed (extra "cluster")'
        return
    picture, scenes = row["picture"], row["scenes"]
    share = picture["there"] / picture["here"]
    yield (
        f"  one scene of {picture['side']} x {picture['side']} pixels in strips over {WORKERS} "
        f"workers here, one killed after a quarter: {share:.2f} of the time on all cores"
    )
    yield (
        f"  {picture['sent'] / 1000:.0f} KB go there, {picture['back']:.2f} bytes a pixel come "
        f"back; the builder holds {picture['held']:.0f} MiB beside the picture"
    )
    yield (
        f"  {scenes['count']} scenes: {scenes['there'] / scenes['here']:.2f} of the time of "
        f"the same work alone; {scenes['back'] / scenes['count'] / 1000:.0f} KB a scene come back"
    )


def cluster_cases(row: dict[str, Any] | None, seed: int) -> Iterator[Case]:
    """Right bytes, time and traffic keep their bounds."""
    if not row:
        return
    picture, scenes = row["picture"], row["scenes"]
    pixels = picture["side"] ** 2
    name = f"one scene of {picture['side']} x {picture['side']}, a worker killed"
    wrong = "pictures that differ from one machine's"
    yield Case("cluster", name, wrong, 0, float(not picture["same"]), pixels, seed)
    share = picture["there"] / picture["here"]
    yield Case("cluster", name, "of one machine's time", SHARE, share, pixels, seed)
    yield Case("cluster", name, "bytes a pixel sent back", BACK, picture["back"], pixels, seed)
    yield Case("cluster", name, "MiB held beside the picture", HELD, picture["held"], pixels, seed)
    name = f"{scenes['count']} scenes"
    wrong = "differ from one machine's files (of those made here too)"
    yield Case("cluster", name, wrong, 0, float(not scenes["same"]), scenes["count"], seed)
