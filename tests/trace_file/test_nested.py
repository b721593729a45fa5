"""Means of the rays of finer grids in a tile: no ray is new."""

from __future__ import annotations

import base64
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raywalk.trace_file.nested import grid_of, nested_counts, nested_samples

DIST = Path(__file__).parents[2] / "dist" / "scenes"
GRIDS = (5, 7, 11, 15, 21, 33, 55, 77, 105)


def picture(scene):
    return np.asarray(Image.open(DIST / scene / "picture.png").convert("RGB"))


def unpacked(text, n):
    return np.frombuffer(base64.b64decode(text), np.uint8).reshape(n, n, 3)


@pytest.mark.parametrize(
    ("scene", "tile", "channel", "means"),
    [
        ("02-shadows", (1, 6), 0, [242, 151, 134, 121]),
        ("02-shadows", (6, 6), 1, [199, 79, 84, 93]),
        ("03-two-lights", (7, 7), 0, [211, 133, 130, 123]),
    ],
)
def test_three_tiles_get_the_means_that_another_tracer_found(scene, tile, channel, means):
    """1, 9, 25 and 49 rays."""
    found = nested_samples(picture(scene), 11, GRIDS)
    column, row = tile
    assert [int(unpacked(each, 11)[row, column, channel]) for each in found["means"]] == means


def test_the_lesson_s_slots_are_these_means():
    """In its words as in its panel, though they come by other ways: traced pixels, the picture."""
    page = DIST.parent / "scenes" / "18-jagged-edges" / "index.html"
    text = " ".join(page.read_text(encoding="utf-8").split())
    for said in ("not 242, but 151", "jumps to 151", "134 and 121", "199 to 79", "84 and 93"):
        assert said in text


def test_counts_are_odd_and_nest():
    """Only then the tile's own ray is among them."""
    assert nested_counts(11, GRIDS) == [1, 3, 5, 7]
    assert nested_counts(5, GRIDS) == [1, 3, 11, 21]  # of 15, 55 and 105


def test_samples_are_pixels_of_the_picture_and_the_middle_one_is_the_tiles():
    """To the last bit."""
    whole = picture("02-shadows")
    found = nested_samples(whole, 11, GRIDS)
    coarse = grid_of(whole, 11)
    for k, samples in zip(found["across"], found["samples"], strict=True):
        fine = unpacked(samples, 11 * k)
        np.testing.assert_array_equal(fine[k // 2 :: k, k // 2 :: k], coarse)
        np.testing.assert_array_equal(fine, grid_of(whole, 11 * k))
