"""The course's own sweeps, as they are published, against scenes whose files say each value.

Such a file is a copy of the scene's, edited here by what its sweep says, without our reading of it.
"""

from __future__ import annotations

import json
import tomllib
from functools import cache
from math import cos, radians, sin
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from PIL import Image
from tests.cases import cases

from raywalk.scene.read import read_scene
from raywalk.sweeps.differences import whole_again
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.tree import level_pixels
from raywalk.trace.wavefront import Tracer, trace_picture
from raywalk.trace_file.container import unpack
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of

ROOT = Path(__file__).parent.parent.parent
RAW = {
    path.parent.name: tomllib.loads(path.read_text(encoding="utf-8"))
    for path in sorted(ROOT.glob("scenes/*/scene.toml"))
}


def values_of(axis: dict[str, Any]) -> list[Any]:
    """Of each stop along an axis: those listed, or as far from each other as from the next."""
    if "values" in axis:
        return list(axis["values"])
    steps = axis["stops"] - 1
    first, last = np.array(axis["from"], float), np.array(axis["to"], float)
    return [written(first + (last - first) * k / steps) for k in range(steps + 1)]


def written(value: np.ndarray) -> Any:
    """As an author would write it: with nine decimals, whole numbers without a point."""
    numbers = [int(each) if each.is_integer() else float(each) for each in value.round(9).flat]
    return numbers if value.ndim else numbers[0]


def put(raw: dict[str, Any], axis: dict[str, Any], value: Any) -> None:
    """Writes a value where `varies` says, turned about a place if the axis says so."""
    keys: list[Any] = []
    table = tomllib.loads(f"{axis['varies']} = 0")
    while isinstance(table, dict):
        [(key, table)] = table.items()
        keys.append(key)
    here: Any = raw
    for key in keys[:-1]:
        here = here[place_in(here, key)]
    last = place_in(here, keys[-1])
    here[last] = turned(here[last], axis["about"], value) if "about" in axis else value


def place_in(here: Any, key: str) -> Any:
    """Things in lists are called by their names, or by their numbers."""
    if not isinstance(here, list):
        return key
    named = [k for k, each in enumerate(here) if isinstance(each, dict) and each.get("name") == key]
    if named:
        return named[0]
    kind, _, number = key.rpartition(" ")
    return int(number) - 1 if kind else int(number)


def turned(place: list[float], about: list[float], degrees: float) -> list[float]:
    """About the axis that points up, counterclockwise seen from above."""
    x, y, z = np.subtract(place, about)
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return list(written(np.add(about, [c * x + s * z, y, c * z - s * x])))


def toml(value: Any) -> str:
    """A value as TOML writes it: tables in one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def stops_of(sweep: dict[str, Any]) -> list[list[tuple[dict[str, Any], Any]]]:
    """What is put at each stop, row by row."""
    rows = [[]] if "across" not in sweep else [[(sweep["across"], each)]
            for each in values_of(sweep["across"])]  # fmt: skip
    return [[(sweep, each), *row] for row in rows for each in values_of(sweep)]


class Which(NamedTuple):
    """A stop, counted from 1."""

    scene: str
    sweep: str
    stop: int

    def __str__(self) -> str:
        return f"{self.scene}, {self.sweep}, stop {self.stop}"


EACH_STOP = [
    Which(scene, sweep["name"], stop + 1)
    for scene, raw in RAW.items()
    for sweep in raw.get("sweeps", [])
    for stop in range(len(stops_of(sweep)))
]
FEW = [
    Which("01-shading", "lamp round the spheres", 4),
    Which("05-many-bounces", "bounce limit", 5),
    Which("10-cornell-box", "yellow ball left and right", 9),
]


@pytest.mark.parametrize("which", cases(EACH_STOP, FEW), ids=str)
def test_each_stop_of_the_course_is_what_an_edited_copy_of_its_scene_gives(
    tmp_path: Path, which: Which
) -> None:
    """Byte for byte, all published grids; and the picture's pixels."""
    id, name, stop = which
    [sweep] = [each for each in RAW[id]["sweeps"] if each["name"] == name]
    raw = json.loads(json.dumps({key: part for key, part in RAW[id].items() if key != "sweeps"}))
    raw.pop("lesson", None)
    for axis, value in stops_of(sweep)[stop - 1]:
        put(raw, axis, value)
    folder = tmp_path / "scenes" / id
    folder.mkdir(parents=True)
    (tmp_path / "models").symlink_to(ROOT / "models")
    text = "".join(f"{key} = {toml(part)}\n" for key, part in raw.items())
    (folder / "scene.toml").write_text(text, encoding="utf-8")
    fresh = read_scene(folder)
    traced = trace_picture(Tracer(fresh, least_share=LEAST_SHARE))
    published = ROOT / "dist" / "scenes" / id / name.replace(" ", "-")
    grids = sorted(path for path in published.glob("*.js") if path.stem.isdigit())
    assert [int(path.stem) for path in grids] == sweep.get("resolutions", [15, 33])
    for path in grids:
        level = level_of(traced.tree, int(path.stem))
        assert stop_text(path, stop) == encode(level, fresh, traced.picture)
    [path] = published.glob(f"{stop}.[wp]*")
    picture = np.asarray(Image.open(path).convert("RGB"))
    pixels = traced.picture.reshape(-1, 3)[level_pixels(fresh.render.size, len(picture))]
    assert np.array_equal(picture.reshape(-1, 3), pixels)


def stop_text(path: Path, stop: int) -> bytes:
    """Canonical JSON of a stop's rays, as a scene's own trace file holds them."""
    text = json.dumps(published_stops(path)[stop - 1], sort_keys=True, separators=(",", ":"))
    return text.encode()


@cache
def published_stops(path: Path) -> list[dict[str, Any]]:
    return list(whole_again(json.loads(unpack(path.read_bytes()))["stops"]))
