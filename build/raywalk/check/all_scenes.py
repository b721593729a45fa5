"""What all scenes look like from afar: so that a picture of another scene than was chosen is known.

scenes     {"scenes": [id, ...], "along": squares along a picture,
           "means": of each scene, each of its along x along squares' mean red, green, blue,
           "wrongAlong": the same of wrong pictures, "wrong": of each scene, by mistake}
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from PIL import Image

from raywalk.check import in_little
from raywalk.trace_file.container import write_script

FILE = "scenes.js"
ALONG = 20  # of the 320 pixels of a small picture: squares of 16


def write_scenes(folder: Path, small: Iterable[tuple[str, Path, Path]]) -> None:
    """scenes.js. small: each scene's id, its small picture, and the folder with in_little.AFAR."""
    scenes = list(small)
    wrong = [json.loads((made / in_little.AFAR).read_bytes()) for _, _, made in scenes]
    told = {
        "scenes": [id for id, _, _ in scenes], "along": ALONG,
        "means": [list(means_of(path)) for _, path, _ in scenes],
        "wrongAlong": in_little.ALONG, "wrong": wrong,
    }  # fmt: skip
    as_json = json.dumps(told, separators=(",", ":")).encode()
    write_script(folder / FILE, "check/scenes", as_json)


def means_of(path: Path) -> bytes:
    """Of a square picture's ALONG x ALONG squares, row by row."""
    with Image.open(path) as picture:
        return picture.convert("RGB").resize((ALONG, ALONG), Image.Resampling.BOX).tobytes()
