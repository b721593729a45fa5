"""Faults that people asked about in public, rebuilt from their descriptions alone, and put to the
check as their pictures would be: float32, another size, a curve of brightness."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from raywalk.bench.recognition import SCRIPT
from raywalk.mistakes.habits import Habits
from raywalk.mistakes.table import BY_NAME
from raywalk.mistakes.tracer import picture
from raywalk.stops.process import Stops

from ..mistakes.course import scene

DATA = Path(__file__).parents[2] / "dist" / "check"
STUDENTS = Habits(precision=np.float32, offset=1e-3, truncates=True)


@pytest.fixture(scope="module")
def node() -> Iterator[Stops]:
    with Stops(SCRIPT) as process:
        yield process


def names(node: Stops, tmp_path: Path, of: str, values: np.ndarray) -> list[list[str]]:
    """What the check answers to a picture of a scene, best first."""
    file = tmp_path / "mine.ppm"
    n = len(values)
    file.write_bytes(b"P6 %d %d 255\n" % (n, n) + np.ascontiguousarray(values).tobytes())
    called = {
        "objects": [obj.name for obj in scene(of).objects],
        "mistakes": {m: {"title": m, "right": "", "wrong": ""} for m in BY_NAME},
    }
    asked = {"do": "check", "language": "en", "names": called, "data": str(DATA / of)}
    asked["picture"] = str(file)
    found: dict[str, Any] = json.loads(node.ask(asked))
    return [answer["names"] for answer in found["answers"]]


def test_rows_written_from_the_bottom_are_named_though_a_root_brightens_the_picture(
    node: Stops, tmp_path: Path
) -> None:
    """Whoever follows a book that measures v upwards, and takes the root of each colour, gets a
    picture upside down and pale: the rays are right, what is made of them is not."""
    right = picture(scene("03-two-lights"), 200, frozenset(), STUDENTS).bytes
    pale = np.floor(255 * np.sqrt(right[::-1] / 255)).astype(np.uint8)
    first, second = names(node, tmp_path, "03-two-lights", pale)[:2]
    assert {"upside-down"} <= {*first, *second} and {"gamma-applied"} <= {*first, *second}


def test_a_closed_room_in_which_walls_shade_each_other(node: Stops, tmp_path: Path) -> None:
    """In a box with a lamp in it, shadows are cast that nothing casts: the nearest of what a shadow
    ray meets was taken, though it lies beyond the lamp."""
    made = picture(scene("10-cornell-box"), 128, frozenset({"shadow-beyond-the-light"}), STUDENTS)
    assert "shadow-beyond-the-light" in names(node, tmp_path, "10-cornell-box", made.bytes)[0]


def test_glass_that_is_black_where_it_cannot_refract(node: Stops, tmp_path: Path) -> None:
    """Where the sine beyond the border would be above 1 the ray was ended, as one that brings
    nothing: dark patches in glass, and all else right."""
    made = picture(scene("08-glass"), 256, frozenset({"total-black"}), STUDENTS)
    assert names(node, tmp_path, "08-glass", made.bytes)[0] == ["total-black"]


def test_surfaces_that_light_shines_through(node: Stops, tmp_path: Path) -> None:
    """Lit on the side turned away as on the other, as if both were one: no sign of n.l was kept."""
    made = picture(scene("01-shading"), 105, frozenset({"cosine-absolute"}), STUDENTS)
    assert "cosine-absolute" in names(node, tmp_path, "01-shading", made.bytes)[0]


@pytest.mark.parametrize(
    ("of", "mistake"),
    [
        ("02-shadows", "shadow-acne"), ("04-one-bounce", "shadow-acne"),
        ("05-many-bounces", "shadow-acne"), ("08-glass", "inside-not-told"),
    ],
)  # fmt: skip
def test_speckles_of_shadow_and_glass_that_bends_the_wrong_way_at_the_exit(
    node: Stops, tmp_path: Path, of: str, mistake: str
) -> None:
    """Black dots on what is lit; a ball that magnifies where it should turn things upside down."""
    made = picture(scene(of), 105, frozenset({mistake}), STUDENTS)
    assert mistake in names(node, tmp_path, of, made.bytes)[0]
