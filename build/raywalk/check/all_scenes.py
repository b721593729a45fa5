"""What all scenes look like from afar: so that a picture of another scene than was chosen is known.

scenes     {"scenes": [id, ...], "along": squares along a picture,
           "means": of each scene, each of its along x along squares' mean red, green, blue}
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from PIL import Image

from raywalk.trace_file.container import write_script

FILE = "scenes.js"
ALONG = 20  # of the 320 pixels of a small picture: squares of 16


def write_scenes(folder: Path, small: Iterable[tuple[str, Path]]) -> None:
    """scenes.js. small: each scene's id and small picture."""
    means = {id: list(means_of(path)) for id, path in small}
    told = {"scenes": list(means), "along": ALONG, "means": list(means.values())}
    as_json = json.dumps(told, separators=(",", ":")).encode()
    write_script(folder / FILE, "check/scenes", as_json)


def means_of(path: Path) -> bytes:
    """Of a square picture's ALONG x ALONG squares, row by row."""
    with Image.open(path) as picture:
        return picture.convert("RGB").resize((ALONG, ALONG), Image.Resampling.BOX).tobytes()
