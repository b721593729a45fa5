"""Writes what the page check/ and `raywalk compare` hold a picture of a scene against.

    about      {"scene", "grid", "own": sizes that are parts of the scene's picture, the last is
               its own, "others": sizes, "grids": of the frustum, "mistakes": [{"name", "family",
               "wrong": [strip, ...]}, ...], "leftOut": why there are none, or ""}; a mistake that
               draws things nearer to the middle has "drawnIn": by which factors
    atlas      red, green, blue of grid x grid pixels, a picture after the other: first the right
               one, then what others are wrong by (modulo 256), strip 1, 2, ... Packed by gzip,
               which browsers unpack themselves: a first check waits for no filters
    places     as rows.py packs it, grid x grid: what is seen where (places.py)
    <n>        as rows.py packs it, n x n: the right picture at the scene's own size and at others

Each as a classic script: a page on a disk may read no other file, and no picture's pixels.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from raywalk.check.atlas import GRID, Atlas, atlas_of
from raywalk.check.places import places
from raywalk.check.right_pictures import (
    has_few_lamps,
    other_sizes,
    right_picture,
    shared_sizes,
)
from raywalk.check.rows import packed_rows
from raywalk.mistakes.camera import drawn_in
from raywalk.mistakes.world import left_out
from raywalk.scene.model import Scene
from raywalk.trace.wavefront import Threads
from raywalk.trace_file.container import pack, script, write_beside

#: What pictures are wrong by, in multiples of this many steps of 255, and nothing below it: half
#: of it is less than what recognition takes for noise (check/layer.ts), and it packs in 3/5.
STEP = 4


def write_check(scene: Scene, traced: Path, threads: Threads, folder: Path) -> None:
    """about.js, places.js, <n>.js; atlas.js of a scene that has one. traced: the folder with its
    picture."""
    own = np.asarray(Image.open(traced / "picture.png").convert("RGB"))
    _write(folder, str(scene.render.size), packed_rows(own))
    for n in other_sizes(scene):
        _write(folder, str(n), packed_rows(right_picture(scene, n, threads)))
    _write(folder, "places", packed_rows(places(scene)))
    why = why_no_atlas(scene)
    atlas = None if why else atlas_of(scene)
    if atlas:
        _write(folder, "atlas", packed_strips(atlas))
    about = about_of(scene, atlas) | {"leftOut": why}
    _write(folder, "about", pack(json.dumps(about, separators=(",", ":")).encode()))


def _write(folder: Path, name: str, packed: bytes) -> None:
    write_beside(folder / f"{name}.js", script(f"check/{name}", packed))


def why_no_atlas(scene: Scene) -> str:
    """A word for what the numpy tracer has no rule for, or "lamps" for very many."""
    if scene.has_mesh:
        return "meshes"
    if any(left_out(obj) for obj in scene.objects):
        return "textures"
    return "" if has_few_lamps(scene) else "lamps"


def about_of(scene: Scene, atlas: Atlas | None) -> dict[str, Any]:
    """As above, without leftOut."""
    rows, first = [], 1
    for each in atlas.wrong if atlas else []:
        places = list(range(first, first + len(each.pictures)))
        row = {"name": each.mistake.name, "family": each.mistake.family, "wrong": places}
        factors = drawn_in(scene.camera, each.mistake.name)
        rows.append(row | ({"drawnIn": factors} if factors else {}))
        first += len(places)
    return {
        "scene": scene.id, "grid": GRID, "own": shared_sizes(scene), "others": other_sizes(scene),
        "grids": sorted(scene.render.resolutions), "mistakes": rows,
    }  # fmt: skip


def strips(atlas: Atlas) -> np.ndarray:
    """(GRID * (1 + pictures), GRID, 3) uint8."""
    every = [picture for each in atlas.wrong for picture in each.pictures]
    return np.concatenate([atlas.right, *_wrong_by(atlas.right, every)])


def packed_strips(atlas: Atlas) -> bytes:
    """The atlas, as it is published."""
    return pack(strips(atlas).tobytes())


def _wrong_by(right: np.ndarray, pictures: Iterable[np.ndarray]) -> Iterable[np.ndarray]:
    """Differences, rounded to multiples of STEP; what would leave 0 to 255 by that stays."""
    for picture in pictures:
        exact = picture.astype(int) - right
        rounded = STEP * np.round(exact / STEP).astype(int)
        laid = right + rounded
        yield np.where((laid < 0) | (laid > 255), exact, rounded).astype(np.uint8)
