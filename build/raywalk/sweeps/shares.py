"""python -m raywalk.sweeps.shares SCENE...: where a stop's processor time goes, of each scene that
has a sweep. What tracing takes of it is the most that anything cleverer than tracing could save;
re-lighting is tracing where what rays hit is known."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene
from raywalk.sweeps.trace_stop import write_stop
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.relighting import KnownPaths
from raywalk.trace.wavefront import Tracer, trace_coarse

TIMES = 5  # stops, of which the fastest counts: what else runs makes them slower, never faster


def shares(scene: Scene) -> tuple[float, float, float]:
    """Seconds of a stop's re-lighting, of its tracing, and of all of it, in one thread."""
    sweep = scene.sweeps[0]
    stop = sweep.stops[0]
    paths = KnownPaths()

    def traced(known: KnownPaths | None = None) -> None:
        tracer = Tracer(stop, least_share=LEAST_SHARE, known=known)
        trace_coarse(tracer, sweep.resolutions, sweep.picture, 1)

    with TemporaryDirectory() as folder:

        def whole() -> None:
            write_stop(stop, sweep.resolutions, sweep.picture, Path(folder), 1)

        whole()  # compiles kernels, reads meshes
        traced(paths)
        ways = partial(traced, paths), traced, whole
        times = [[_seconds(way) for way in ways] for _ in range(TIMES)]
    relit, tracing, all_of_it = (min(each) for each in zip(*times, strict=True))
    return relit, tracing, all_of_it


def _seconds(what: Callable[[], None]) -> float:
    begun = process_time()
    what()
    return process_time() - begun


if __name__ == "__main__":
    for name in sys.argv[1:]:
        relit, tracing, all_of_it = shares(read_scene(Path(name)))
        share = f"{tracing / all_of_it:.0%}; re-lit {relit:.3f} s, {relit / tracing:.0%} of that"
        print(f"{name}: {tracing:.3f} of {all_of_it:.3f} s, {share}")
