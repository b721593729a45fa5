"""The shaded view behind a figure: pale, and seen on either ground."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from PIL import Image

from raywalk.slides.palette import SCREEN
from raywalk.slides.pictures import washed


def test_a_side_that_faces_away_is_seen_on_the_dark_ground(tmp_path: Path):
    """Ambient light is a tenth, 26 of 255: laid on the ground as it was it vanished in a hall."""
    pixels = np.zeros((8, 16, 4), np.uint8)
    pixels[:, 8:] = (26, 26, 26, 255)
    file = tmp_path / "view.png"
    Image.fromarray(pixels).save(file)
    on_screen, on_paper, _ = (np.asarray(Image.open(io.BytesIO(f)).convert("RGB"), int)
                              for f in washed(file))  # fmt: skip
    ground = [int(SCREEN["ground"][k : k + 2], 16) for k in (1, 3, 5)]
    assert np.abs(on_screen[4, 2] - ground).max() <= 3
    assert (on_screen[4, 13] - ground).min() >= 18
    assert (on_paper[4, 2] >= 252).all() and (on_paper[4, 13] < 200).all()
