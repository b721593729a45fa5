"""Shadows by shadow maps: at their edges stairs of the map's pixels, else the traced shadows."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from raywalk.geometry.compiled import Hits, rays_from
from raywalk.scene.read import read_scene
from raywalk.trace.shadow_maps import BACK, GOLDEN_ANGLE, TAPS, ShadowMaps, lit_share
from raywalk.trace.wavefront import Tracer

ROOT = Path(__file__).parent.parent.parent
SLANT = np.tan(np.radians(6))
# The board ends in a line through (0, 2, 0); from a lamp twice as high and 1 before it, its shadow
# on the floor ends in a line through (0, 0, -1), which runs a little across the map's rows.
BOARD = """
version = 1
title = "Board"
teaches = "A board's shadow has a straight edge."
[camera]
eye = [0, 1, 9]
target = [0, 0, 0]
[[objects]]
name = "floor"
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "white"
[[objects]]
name = "board"
type = "box"
minimum = [-40, 1.99999, -60]
maximum = [40, 2, 0]
material = "white"
transform = [{ rotate = { axis = "y", degrees = 6 } }]
[[lights]]
position = [0, 4, 1]
"""


@pytest.fixture(scope="module")
def board(tmp_path_factory: pytest.TempPathFactory) -> Tracer:
    folder = tmp_path_factory.mktemp("board")
    (folder / "scene.toml").write_text(BOARD, encoding="utf-8")
    return Tracer(read_scene(folder))


def floor(tracer: Tracer, x: np.ndarray, z: np.ndarray) -> Hits:
    """Hits on the floor, from below the board."""
    below = np.stack([x, np.ones_like(x), z], axis=1)
    return tracer.compiled.hits(rays_from(below, np.tile([0.0, -1, 0], (len(x), 1))))


def edge(x: np.ndarray) -> np.ndarray:
    """Where the board's shadow really ends: z of its edge."""
    return -1 - SLANT * x


def lit(tracer: Tracer, pixels: int, x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Without biases, which would move the edge."""
    maps = ShadowMaps(
        pixels, near=0.1, far=30.0, bias=0.0, normal_bias=0.0, lamps=(0,), apart=1,
        casts=(None, BACK),
    )  # fmt: skip
    places = np.random.default_rng(5).uniform(0, 500, (len(x), 2))
    return lit_share(tracer, maps, 0, floor(tracer, x, z), places)


def grid(width: float, depth: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Points of the floor along the edge: x, and how far before the edge."""
    x, off = np.meshgrid(np.linspace(-width, width, count), np.linspace(-depth, depth, count))
    return x.ravel(), off.ravel()


@pytest.mark.parametrize("pixels", [32, 64, 256])
def test_a_shadows_edge_is_stairs_of_the_maps_pixels(board, pixels):
    """A pixel of the map is 8 / pixels wide on the floor, 4 below the lamp. In pixels, a straight
    edge would lie as often at any share of one; stairs lie at their borders."""
    pixel = 8 / pixels
    x = np.linspace(-24 * pixel, 24 * pixel, 480)  # 48 pixels across, 5 down
    off = np.linspace(-1.5 * pixel, 1.5 * pixel, 151)
    points = np.repeat(x, 151), np.repeat(edge(x), 151) + np.tile(off, 480)
    share = lit(board, pixels, *points).reshape(480, 151)
    z = edge(x) + off[(share > 0.5).argmax(axis=1)]
    row = (z - 1) / pixel
    from_border = np.abs(row - np.rint(row))
    assert (from_border < 0.25).mean() > 0.7  # of a straight edge: half
    assert np.abs(z - edge(x)).max() < pixel


@pytest.mark.parametrize("pixels", [32, 64, 256])
def test_away_from_edges_it_is_the_traced_shadow(board, pixels):
    """What a place is mixed from lies at most 1.5 pixels away: half a pixel of a disc and one of
    the four pixels round that; the edge within it at most 1 more."""
    pixel = 8 / pixels
    x, off = grid(3, 0.9, 80)
    away = np.abs(off) > 2.5 * pixel
    share = lit(board, pixels, x[away], edge(x[away]) + off[away])
    assert (share == (off[away] > 0)).all()


def test_a_map_of_twice_as_many_pixels_is_wrong_half_as_often(board):
    x, off = grid(3, 0.9, 200)
    wrong = [
        np.abs(lit(board, pixels, x, edge(x) + off) - (off > 0)).mean() for pixels in (32, 64, 128)
    ]
    ratios = np.array(wrong[:-1]) / wrong[1:]
    assert (
        np.abs(ratios - 2) < 0.2
    ).all()  # each of 200 columns of points errs by half a point of 3, either way


def test_the_rules_are_those_of_the_three_that_the_viewer_is_built_with():
    """Should a new release filter otherwise, this must follow it."""
    shader = "node_modules/three/src/renderers/shaders/ShaderChunk/shadowmap_pars_fragment.glsl.js"
    text = (ROOT / shader).read_text(encoding="utf-8")
    cube = text[text.index("float getPointShadow( samplerCubeShadow") :]
    cube = re.sub(r"\s+", " ", cube[: cube.index("#elif")])
    assert f"i < {TAPS};" in cube and f"vogelDiskSample( i, {TAPS}, phi )" in cube
    assert f"goldenAngle = {GOLDEN_ANGLE};" in text
    assert "float texelSize = shadowRadius / shadowMapSize.x;" in cube
    assert "52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) )" in text
    assert "bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize" in cube
    assert "depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z )" in cube
