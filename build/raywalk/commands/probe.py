"""raywalk probe: the nearest hits of given rays, in full float64."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.commands.check import scene_file
from raywalk.scene.read import read_scene


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("probe", help="nearest hits of given rays")
    parser.add_argument("scene", help="a scene file, folder or id")
    parser.add_argument(
        "--rays",
        type=Path,
        required=True,
        help="JSON list of origin, direction and, if wished, leaving",
    )
    parser.add_argument("--out", type=Path, help="where to write the hits; printed if left out")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """Writes the hits beside and renames, or yields them."""
    from raywalk.trace.probe import probe, read_rays
    from raywalk.trace_file.container import write_beside

    scene = read_scene(scene_file(chosen.scene, chosen.scenes))
    listed = read_rays(chosen.rays)
    hits = probe(scene, listed.origin, listed.direction, listed)
    text = json.dumps(hits, allow_nan=False)
    if chosen.out is None:
        yield text
        return
    write_beside(chosen.out, f"{text}\n".encode())
    met = sum(hit is not None for hit in hits)
    yield f"{len(hits)} rays, {met} hits: {chosen.out}"
