"""Pixels for figures: the shaded view pale on the ground, fine grids of tiles, the picture."""

from __future__ import annotations

import io
from functools import cache, lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from PIL import Image

from raywalk.slides.figure import Picture
from raywalk.slides.layout import Box
from raywalk.slides.palette import PRINT, SCREEN, Palette
from raywalk.slides.stops import Figure
from raywalk.slides.words import say

PALE = 56  # JPEG's quality of the views: they are pale, nothing of it shows
CLEAR = 80  # that of the traced picture
FOR_WEB = 72  # WebP's, which browsers show and PowerPoint and PDF do not
# Dark sides lie on a dark ground: a power below 1 lifts them off it, and leaves black and white.
LIFT = 0.6
WEB_WASH = (SCREEN.wash + PRINT.wash) / 2  # one transparent view for both palettes
SHARP = 2.0  # pixels a point of a fine grid
PICTURE_SIDE = 400  # pixels of the traced picture beside a figure
GRID_SIDE = 210  # of that picture as the finest grid has it: two for each of its tiles
TITLE_SIDE = 640


@cache
def view_pixels(view: Path) -> np.ndarray:
    """(rows, columns, 4) 8-bit, of a shaded view's file."""
    return np.asarray(Image.open(view))


@cache
def washed(view: Path) -> tuple[bytes, bytes, bytes]:
    """The view (RGBA file) laid pale on the ground: JPEG for the screen and for paper; and pale
    by itself for browsers, which lay it on either."""
    pixels = view_pixels(view).astype(np.float32)
    presence = pixels[..., 3:] / 255
    lifted = 255 * (pixels[..., :3] / 255) ** LIFT
    pale = np.concatenate([lifted, pixels[..., 3:] * WEB_WASH], axis=-1)
    return (
        _laid(lifted, presence, SCREEN),
        _laid(pixels[..., :3], presence, PRINT),
        webp(Image.fromarray(np.rint(pale).astype(np.uint8))),
    )


def _laid(colours: np.ndarray, presence: np.ndarray, palette: Palette) -> bytes:
    ground = np.array([int(palette["ground"][k : k + 2], 16) for k in (1, 3, 5)], np.float32)
    strength = presence * palette.wash
    laid = np.rint(ground + strength * (colours - ground)).astype(np.uint8)
    return jpeg(Image.fromarray(laid), PALE)


def jpeg(image: Image.Image, quality: int) -> bytes:
    return _file(image.convert("RGB"), "JPEG", quality=quality, optimize=True)


def png(image: Image.Image) -> bytes:
    return _file(image, "PNG", optimize=True)


def webp(image: Image.Image) -> bytes:
    return _file(image, "WEBP", quality=FOR_WEB, method=4)


def _file(image: Image.Image, kind: str, **options: Any) -> bytes:
    out = io.BytesIO()
    image.save(out, kind, **options)
    return out.getvalue()


class Window(NamedTuple):
    """A square part of a picture; shares of its side."""

    left: float
    top: float
    share: float

    def of(self, image: Image.Image) -> Image.Image:
        """That part of it."""
        wide = image.width
        box = [round(k * wide) for k in (self.left, self.top)]
        side = round(self.share * wide)
        return image.crop((box[0], box[1], box[0] + side, box[1] + side))


WHOLE = Window(0.0, 0.0, 1.0)


@cache
def traced_picture(file: Path, side: int, window: Window = WHOLE) -> tuple[bytes, bytes]:
    """The scene's picture, or a part of it, at most `side` pixels wide, as JPEG and as WebP."""
    image = window.of(Image.open(file).convert("RGB"))
    if image.width > side:
        image = image.resize((side, side), Image.Resampling.BOX)
    return jpeg(image, CLEAR), webp(image)


def picture_of(data: tuple[bytes, bytes], frame: Box, alt: str) -> Picture:
    """The traced picture in its frame."""
    return Picture(frame, data[0], data[0], say("slides.picture"), alt, data[1])


@lru_cache(maxsize=64)
def smaller(data: bytes, wide: int) -> bytes:
    """A JPEG at most so many pixels wide; other files as they are."""
    if not data.startswith(b"\xff\xd8"):
        return data
    image = Image.open(io.BytesIO(data))
    if image.width <= wide:
        return data
    high = max(1, round(image.height * wide / image.width))
    return jpeg(image.resize((wide, high), Image.Resampling.BOX), PALE)


def grid_picture(tiles: np.ndarray, n: int, window: Window = WHOLE) -> tuple[bytes, bytes]:
    """A grid's tiles (3 * n * n,) 8-bit, or a part of them, seen from the front."""
    image = window.of(Image.fromarray(np.asarray(tiles, np.uint8).reshape(n, n, 3)))
    side = image.width * max(1, round(GRID_SIDE / image.width))
    tiled = image.resize((side, side), Image.Resampling.NEAREST)
    return jpeg(tiled, CLEAR), webp(tiled)


def squares_picture(colours: np.ndarray) -> bytes:
    """(k, k, 3) 8-bit as PNG: so few colours are small, and their borders stay sharp."""
    k = len(colours)
    palette, places = np.unique(colours.reshape(-1, 3), axis=0, return_inverse=True)
    image = Image.fromarray(places.reshape(k, k).astype(np.uint8), "P")
    image.putpalette(palette.tobytes())
    side = k * max(1, round(GRID_SIDE / k))
    return png(image.resize((side, side), Image.Resampling.NEAREST))


def tiles_picture(
    figure: Figure, colours: np.ndarray, hidden: frozenset[int], box: Box
) -> Picture | None:
    """A fine grid's coloured tiles as one picture in perspective; None if none is seen.

    colours: (n * n, 3) 8-bit."""
    n = round(len(colours) ** 0.5)
    if not np.isfinite(figure.grid).all() or abs(np.linalg.det(figure.grid)) < 1e-12:
        return None
    corners = figure.on_plane(np.array([0, n, n, 0]), np.array([0, 0, n, n]))
    if (corners[:, 2] <= 0).any():
        return None
    low = np.clip(np.floor(corners[:, :2].min(axis=0)), 0, [box.width, box.height])
    high = np.clip(np.ceil(corners[:, :2].max(axis=0)), 0, [box.width, box.height])
    if (high - low < 1).any():
        return None
    # Pixel (x, y) of the picture -> point of the figure -> tile (column, row).
    place = np.array([[1 / SHARP, 0, low[0]], [0, 1 / SHARP, low[1]], [0, 0, 1.0]])
    back = np.linalg.inv(figure.grid) @ place
    back = back / back[2, 2]
    tiles = np.full((n, n, 4), 255, np.uint8)
    tiles[..., :3] = colours.reshape(n, n, 3)
    tiles.reshape(-1, 4)[sorted(hidden), 3] = 0
    across, down = (int(k) for k in np.rint((high - low) * SHARP))
    image = Image.fromarray(tiles).transform(
        (across, down),
        Image.Transform.PERSPECTIVE,
        back.reshape(-1)[:8].tolist(),
        Image.Resampling.NEAREST,
    )
    data = png(image)
    where = Box(box.left + low[0], box.top + low[1], high[0] - low[0], high[1] - low[1])
    return Picture(where, data, data, say("slides.tiles", n=n), "")
