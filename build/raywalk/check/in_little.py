"""What a scene's right and wrong pictures look like in little: made from what write.py wrote.

tiles      as rows.py packs it, n x n of the scene's finest grid: the right colour at the middle
           of each tile, and of each tile of the grids that divide it
afar.json  by mistake the ALONG x ALONG squares' mean red, green, blue of each of its pictures
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from raywalk.check.rows import packed_rows, rows_of
from raywalk.trace_file.container import script, unpack, write_beside

AFAR = "afar.json"
ALONG = 10  # squares along a picture


def write_in_little(check: Path, folder: Path) -> None:
    """check: the folder of a scene that write_check wrote."""
    about = json.loads(unpack((check / "about.js").read_bytes()))
    tiles = tiles_of(rows_of((check / f"{about['own'][-1]}.js").read_bytes()), about["grids"][-1])
    write_beside(folder / "tiles.js", script("check/tiles", packed_rows(tiles)))
    told = means_of(about, (check / "atlas.js").read_bytes()) if about["mistakes"] else {}
    text = json.dumps(told, separators=(",", ":"))
    (folder / AFAR).write_text(text, encoding="utf-8")


def tiles_of(picture: np.ndarray, n: int) -> np.ndarray:
    """(n, n, 3): an odd number of the picture's pixels goes to each tile, so one is its middle."""
    step = len(picture) // n
    return np.ascontiguousarray(picture[step // 2 :: step, step // 2 :: step])


def means_of(about: dict[str, Any], atlas: bytes) -> dict[str, list[list[int]]]:
    """By mistake. atlas: the script that write.py wrote."""
    strips = np.frombuffer(unpack(atlas), np.uint8).reshape(-1, about["grid"], about["grid"], 3)
    right = strips[0]
    return {
        each["name"]: [_means(right + strips[place]) for place in each["wrong"]]
        for each in about["mistakes"]
    }


def _means(picture: np.ndarray) -> list[int]:
    """Row by row. (n, n, 3) uint8; what the strips add goes round at 256."""
    small = Image.fromarray(picture).resize((ALONG, ALONG), Image.Resampling.BOX)
    return list(small.tobytes())
