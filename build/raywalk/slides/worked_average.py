"""The rays of finer grids in a tile and their mean, as figures and as a picture."""

from __future__ import annotations

import base64
import re

import numpy as np

from raywalk.scene.model import Scene
from raywalk.slides.figure import Cell, Picture, hex_of
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import plain_text
from raywalk.slides.pictures import squares_picture
from raywalk.slides.stops import Stop
from raywalk.slides.words import say
from raywalk.slides.worked_figures import Figures, Worked, at_pixel, heading, view_of


def key_figures(scene: Scene, stop: Stop, worked: Worked) -> Figures:
    """One ray, as many as the step begins with, and those whose mean its words name."""
    said = {int(number) for number in re.findall(r"\d+", plain_text(stop.text(scene)))}
    own = rays_of(scene, stop)
    counts = [
        k * k for k in worked["average"]["across"]
        if k * k in (1, own) or said & set(mean_of(worked, stop, k * k))
    ]  # fmt: skip
    return _means(stop, worked, counts, own)


def all_figures(stop: Stop, worked: Worked) -> Figures:
    return _means(stop, worked, [k * k for k in worked["average"]["across"]], 0)


def rays_of(scene: Scene, stop: Stop) -> int:
    """In a tile, that the stop begins with."""
    return int(view_of(scene, stop).get("rays_a_tile") or 1)


def mean_of(worked: Worked, stop: Stop, count: int) -> list[int]:
    """Three bytes: of the selected tile, with so many rays."""
    n = worked["average"]["n"]
    means = _unpacked(worked["average"]["means"][_place(worked, count)], n)
    column, row = stop.pixel
    found: list[int] = means[row, column].tolist()
    return found


def samples_of(worked: Worked, stop: Stop, count: int) -> np.ndarray:
    """(k, k, 3) 8-bit: the tile's rays, row by row."""
    k = round(count**0.5)
    grid = _unpacked(
        worked["average"]["samples"][_place(worked, count)], worked["average"]["n"] * k
    )
    column, row = stop.pixel
    return grid[row * k : row * k + k, column * k : column * k + k]


def inside(worked: Worked, stop: Stop, count: int, frame: Box) -> Picture:
    """The tile, enlarged: a square a ray."""
    data = squares_picture(samples_of(worked, stop, count))
    return Picture(frame, data, data, say("slides.worked.inside", count=count), "", data)


def _means(stop: Stop, worked: Worked, counts: list[int], own: int) -> Figures:
    rows = [heading(say("slides.worked.rays"), "", say("slides.worked.mean"))]
    for count in counts:
        mean, is_own = mean_of(worked, stop, count), count == own
        rows.append(
            (Cell(str(count), bold=is_own), Cell(swatch=hex_of(mean)),
             Cell(", ".join(map(str, mean)), bold=is_own))
        )  # fmt: skip
    return Figures(say("slides.worked.average", **at_pixel(stop)), tuple(rows))


def _place(worked: Worked, count: int) -> int:
    across: list[int] = worked["average"]["across"]
    return across.index(round(count**0.5))


def _unpacked(text: str, n: int) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), np.uint8).reshape(n, n, 3)
