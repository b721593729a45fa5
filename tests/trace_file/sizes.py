"""python tests/trace_file/sizes.py FILE.json.gz ... : bytes per ray of built trace files.

A ray is a camera, reflected, refracted or totally reflected ray, or a shadow ray shot.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from raywalk.stops.decoded import read_trace
from raywalk.trace.tree import SHOT


def main() -> None:
    all_bytes = all_rays = 0
    for path in map(Path, sys.argv[1:]):
        trace = read_trace(path)
        shadow = int(np.isin(trace.visibility[trace.object >= 0], SHOT).sum())
        rays, size = trace.count + shadow, path.stat().st_size
        name = f"{trace.header['scene']}/{trace.n}"
        print(f"{name:24} {rays:7} rays {size:8} bytes {size / rays:6.2f} a ray")
        all_bytes, all_rays = all_bytes + size, all_rays + rays
    print(
        f"{'together':24} {all_rays:7} rays {all_bytes:8} bytes {all_bytes / all_rays:6.2f} a ray"
    )


if __name__ == "__main__":
    main()
