"""Why a shadow ray starts a little off its surface, drawn for lesson 02: on the left from a point
that rounding has put below its sphere, on the right from as far above it.

`python -m raywalk.mistake_pages.buried` writes the drawing. It is to scale but for that distance,
which is drawn TIMES as large; it has no words, so that it serves all languages.
"""

from __future__ import annotations

from math import acos, cos, pi, sin, sqrt
from pathlib import Path
from typing import NamedTuple

import numpy as np
from PIL import Image, ImageDraw

from raywalk.mistakes.rays import rays_off_rounded
from raywalk.mistakes.tracer import trace
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene
from raywalk.scene.shapes import Sphere
from raywalk.trace.kinds import LINES
from raywalk.trace.tree import Visibility

FILE = Path("scenes/02-shadows/start.png")
GRID, PIXEL = 15, (4, 3)  # column, row: of the lesson's step
TIMES = 1_000_000  # the distance from the surface is drawn so much too large
PANEL = (600, 400)  # pixels of each of the two
RADIUS = 420.0  # pixels that the sphere's takes
TOP = 230.0  # from the panel's top to the sphere's
FINER = 4  # drawn so much larger, so that edges come out smooth
LINE, DOT, CROSS = 9.0, 15.0, 20.0  # pixels
CAP = 0.62  # radians of the sphere to each side of its top
BODY, EDGE, POINT, NEVER = "#c9cfee", "#3a4480", "#000000", "#8a8a8a"


class Start(NamedTuple):
    """Where a program in single precision starts a shadow ray."""

    depth: float  # below its sphere, of radius 1
    turn: float  # radians between the normal and the way to the light


def starts(scene: Scene, n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of all pixels (n * n,) of a scene of spheres: how far below its sphere the hit comes out as
    o + t d in single precision (nan: no hit), n.l there, and whether the light reaches it."""
    wave = trace(scene, n, np.arange(n * n))[1][0]
    hits, met = wave.hits, wave.hits.object >= 0
    spheres = [obj.shape for obj in scene.objects if isinstance(obj.shape, Sphere)]
    centre = np.array([each.center for each in spheres])[np.where(met, hits.object, 0)].T
    radius = np.array([each.radius for each in spheres])[np.where(met, hits.object, 0)]
    with np.errstate(invalid="ignore"):
        start = rays_off_rounded(wave.sent.rays, hits, hits.normal).origin
    depth = np.where(met, radius - np.sqrt(((start - centre) ** 2).sum(axis=0)), np.nan)
    way = np.array(scene.lights[0].position)[:, None] - hits.point
    facing = (way * hits.normal).sum(axis=0) / np.sqrt((way**2).sum(axis=0))
    return depth, facing, wave.lighting.visibility.reshape(-1) == int(Visibility.REACHED)


def start_of(scene: Scene) -> Start:
    """That of the lesson's pixel."""
    depth, facing, _ = starts(scene, GRID)
    pixel = PIXEL[1] * GRID + PIXEL[0]
    return Start(float(depth[pixel]), acos(float(facing[pixel])))


def way_to_surface(below: float, turn: float) -> float:
    """How far a ray from `below` a unit sphere's top runs to it, turned so far from the normal."""
    height = 1 - below
    return sqrt(1 - (height * sin(turn)) ** 2) - height * cos(turn)


def drawing(start: Start) -> Image.Image:
    wide, high = PANEL
    image = Image.new("RGB", (2 * wide * FINER, high * FINER), "white")
    off = start.depth * TIMES
    for panel, below in enumerate((off, -off)):
        _panel(ImageDraw.Draw(image), (panel + 0.5) * wide, below, start.turn)
    return image.resize((2 * wide, high), Image.Resampling.BOX)


def _panel(draw: ImageDraw.ImageDraw, middle: float, below: float, turn: float) -> None:
    """A sphere's top at `middle`, and the ray to the light on its left; lengths in radii."""

    def at(right: float, up: float) -> tuple[float, float]:
        """Of the sphere's centre, to the drawing's pixels."""
        return (middle + RADIUS * right) * FINER, (TOP + RADIUS - RADIUS * up) * FINER

    def along(way: float) -> tuple[float, float]:
        return at(-sin(turn) * way, 1 - below + cos(turn) * way)

    width = round(LINE * FINER)
    outline = [at(sin(angle), cos(angle)) for angle in np.linspace(-CAP, CAP, 200)]
    draw.polygon([*outline, at(sin(CAP), 0.5), at(-sin(CAP), 0.5)], BODY)
    draw.line(outline, EDGE, width, joint="curve")
    is_buried = below > 0
    kind = "blocked" if is_buried else "reached"
    out = (TOP / RADIUS + below) / cos(turn) * 0.75  # almost at the panel's top
    end = way_to_surface(below, turn) if is_buried else out
    draw.line([along(0), along(end)], LINES[kind]["light"], width)
    if is_buried:
        for way in np.arange(end, out, 0.06):
            draw.line([along(way), along(way + 0.025)], NEVER, width // 2)
        _cross(draw, along(end), LINES[kind]["light"], width)
    else:
        _tip(draw, along(end), turn, LINES[kind]["light"])
    _dot(draw, along(0))


def _dot(draw: ImageDraw.ImageDraw, place: tuple[float, float]) -> None:
    reach = DOT * FINER
    draw.ellipse([place[0] - reach, place[1] - reach, place[0] + reach, place[1] + reach], POINT)


def _cross(
    draw: ImageDraw.ImageDraw, place: tuple[float, float], colour: str, width: int
) -> None:  # fmt: skip
    reach = CROSS * FINER
    for side in (1, -1):
        ends = [(place[0] + k * reach, place[1] + k * side * reach) for k in (-1, 1)]
        draw.line(ends, colour, width)


def _tip(
    draw: ImageDraw.ImageDraw, place: tuple[float, float], turn: float, colour: str
) -> None:  # fmt: skip
    """An arrow's head, to the left and up."""
    corners = [(turn, 1.6), (turn + 2 * pi / 3, 1.0), (turn - 2 * pi / 3, 1.0)]
    reach = CROSS * FINER
    draw.polygon(
        [(place[0] - sin(a) * r * reach, place[1] - cos(a) * r * reach) for a, r in corners], colour
    )


def main() -> None:
    drawing(start_of(read_scene(FILE.parent))).save(FILE, optimize=True)


if __name__ == "__main__":
    main()
