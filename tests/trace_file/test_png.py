"""Pictures are written without loss, the same bytes each time."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raywalk.trace_file.png import write_png

NOISE = np.random.default_rng(1).integers(0, 256, (19, 23, 3)).astype(np.uint8)
PICTURES = {
    "noise": NOISE,
    "two colours": np.where(NOISE[..., :1] > 99, [[[255, 0, 7]]], [[[0, 9, 255]]]).astype(np.uint8),
    "one pixel": NOISE[:1, :1],
    "ramp": np.repeat(np.arange(256, dtype=np.uint8)[:, None, None], 3, 2)
    * np.ones((1, 9, 1), np.uint8),
}


@pytest.mark.parametrize("name", PICTURES)
def test_a_picture_comes_back_pixel_by_pixel(name: str, tmp_path: Path) -> None:
    path = tmp_path / "picture.png"
    write_png(path, PICTURES[name])
    with Image.open(path) as image:
        np.testing.assert_array_equal(np.asarray(image.convert("RGB")), PICTURES[name])
    first = path.read_bytes()
    write_png(path, PICTURES[name])
    assert path.read_bytes() == first
    assert [p.name for p in tmp_path.iterdir()] == ["picture.png"], "nothing half written is left"
