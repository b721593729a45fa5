"""python -m raywalk.sweeps.shares SCENE...: where a stop's processor time goes, of each scene that
has a sweep. What tracing takes of it is the most that anything cleverer than tracing could save."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene
from raywalk.sweeps.trace_stop import write_stop
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import Tracer, trace_coarse

TIMES = 5  # stops, of which the fastest counts: what else runs makes them slower, never faster


def shares(scene: Scene) -> tuple[float, float]:
    """Seconds of a stop's tracing, and of all of it, in one thread."""
    sweep = scene.sweeps[0]
    stop = sweep.stops[0]

    def traced() -> None:
        tracer = Tracer(stop, least_share=LEAST_SHARE)
        trace_coarse(tracer, sweep.resolutions, sweep.picture, 1)

    with TemporaryDirectory() as folder:

        def whole() -> None:
            write_stop(stop, sweep.resolutions, sweep.picture, Path(folder), 1)

        whole()  # compiles kernels, reads meshes
        times = [(_seconds(traced), _seconds(whole)) for _ in range(TIMES)]
    tracing, all_of_it = (min(each) for each in zip(*times, strict=True))
    return tracing, all_of_it


def _seconds(what: Callable[[], None]) -> float:
    begun = process_time()
    what()
    return process_time() - begun


if __name__ == "__main__":
    for name in sys.argv[1:]:
        tracing, all_of_it = shares(read_scene(Path(name)))
        print(f"{name}: {tracing:.3f} of {all_of_it:.3f} s, {tracing / all_of_it:.0%}")
