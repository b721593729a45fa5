"""Outlines of what a plane cuts lie on the surface, and all of the surface lies on them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tests.geometry.by_hand import SHAPES, affine, random_affine, scene_of

from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.cross_section import ROUND, Cut, Outline, Sliced
from raywalk.scene.model import SceneObject
from raywalk.scene.placement import placement

REACH = 50.0
# A cylinder is drawn as a prism of ROUND sides: it is inside its surface by this share of a radius,
# and by up to a side's length where a plane almost only touches it.
BULGE = 1.0 - math.cos(math.pi / ROUND)
SIDE = 2.0 * math.sin(math.pi / ROUND)
# Cones are cut in test_cones.py.
CUT = [name for name in SHAPES if "cone" not in name and name != "frustum"]
UPRIGHT = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def cut_at(obj: SceneObject, normal: np.ndarray, offset: float) -> Cut:
    """The plane normal . p = offset of the object's own canonical coordinates, in the world."""
    linear, centre = placement(obj)
    across = np.linalg.solve(linear.T, normal)
    across /= np.linalg.norm(across)
    x = np.cross(across, [0.36, 0.48, 0.8])
    x /= np.linalg.norm(x)
    origin = linear @ (offset * normal) + centre
    return Cut(origin, np.array([x, np.cross(across, x)]), REACH)


def corners_of(outline: Outline, count: int = 720) -> np.ndarray:
    """(n, 2) points along it; of a closed one the first is also the last."""
    points = outline.points
    if outline.kind == "ellipse":
        angle = np.linspace(0.0, 2.0 * np.pi, count)[:, None]
        return points[0] + np.cos(angle) * points[1] + np.sin(angle) * points[2]
    return np.vstack([points, points[:1]]) if outline.kind == "closed" else points


def away_from_surface(name: str, p: np.ndarray) -> np.ndarray:
    """(n,) how far canonical points (n, 3) are from the canonical surface."""
    x, y, z = p.T
    round_z = np.hypot(x, y)
    match name:
        case "sphere" | "ellipsoid":
            return np.abs(np.linalg.norm(p, axis=1) - 1)
        case "box":
            return np.abs(np.abs(p).max(axis=1) - 1)
        case "capped cylinder":
            return np.abs(np.maximum(round_z, np.abs(z)) - 1)
        case "open cylinder":
            return np.maximum(np.abs(round_z - 1), np.abs(z) - 1)
        case "disc":
            return np.maximum(np.abs(z), round_z - 1)
        case "plane":
            return np.abs(y)
        case "triangle":
            return np.maximum.reduce([np.abs(z), -x, -y, x + y - 1])
    raise KeyError(name)


def away_from_outlines(outlines: list[Outline], point: np.ndarray) -> float:
    """How far a point (2,) is from the nearest of them."""
    found = [math.inf]
    for outline in outlines:
        corners = corners_of(outline)
        start, way = corners[:-1], np.diff(corners, axis=0)
        length = np.maximum((way**2).sum(axis=1), 1e-300)
        share = np.clip(((point - start) * way).sum(axis=1) / length, 0.0, 1.0)
        found.append(float(np.linalg.norm(start + share[:, None] * way - point, axis=1).min()))
    return min(found)


def cuts_of(obj: SceneObject, rng: np.random.Generator) -> list[Cut]:
    """Planes through it and past it: any, and those along its own axes."""
    normals = [*map(np.array, UPRIGHT.values()), *rng.normal(size=(8, 3))]
    return [cut_at(obj, n / np.linalg.norm(n), rng.uniform(-1.3, 1.3)) for n in normals]


@pytest.mark.parametrize("is_moved", [False, True], ids=["as it is", "transformed"])
@pytest.mark.parametrize("name", CUT)
def test_outline_and_surface_are_one_in_the_plane(
    name: str, is_moved: bool, rng: np.random.Generator
) -> None:
    """Each corner of an outline lies on the surface; each line in the plane meets the surface on
    an outline, and as often as there are outlines in its way."""
    obj = SceneObject("o", SHAPES[name], 0, random_affine(rng) if is_moved else affine(np.eye(3)))
    linear, centre = placement(obj)
    sliced, compiled = Sliced(obj), CompiledScene(scene_of([obj]))
    size = np.linalg.norm(linear, 2)
    # An ellipse's 720 pieces bulge 1e-5 of its size; else roundings, times the condition.
    inside, slack = (BULGE, SIDE * size) if "cylinder" in name else (0.0, 2e-5 * size)
    met = 0
    for cut in cuts_of(obj, rng):
        outlines = sliced.outlines(cut)
        for outline in outlines:
            flat = corners_of(outline)
            world = cut.origin + flat @ cut.axes
            local = np.linalg.solve(linear, (world - centre).T).T
            assert away_from_surface(name, local).max() < inside + 1e-11
        start = rng.normal(size=(20, 2)) * size
        aim = rng.normal(size=(20, 2)) * size / 3 + cut.flat(centre)
        direction = (aim - start) @ cut.axes
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        origin = cut.origin + start @ cut.axes
        first, t, _ = compiled.crossings(rays_from(origin, direction))
        for k in range(20):
            for distance in t[first[k] : first[k + 1]]:
                point = cut.flat(origin[k] + distance * direction[k])
                if np.linalg.norm(point) < REACH:
                    assert away_from_outlines(outlines, point) < slack
                    met += 1
    assert met


@pytest.mark.parametrize("kind", ["sphere", "box", "capped cylinder", "open cylinder", "disc"])
@pytest.mark.parametrize("axis", UPRIGHT)
def test_a_plane_past_a_shape_has_no_outline(kind: str, axis: str) -> None:
    """On either side, right beside it, and just inside it has one."""
    obj = SceneObject("o", SHAPES[kind], 0)
    sliced, normal = Sliced(obj), np.array(UPRIGHT[axis])
    reach = 0.0 if (kind, axis) == ("disc", "z") else 1.0
    for side in (-1.0, 1.0):
        assert sliced.outlines(cut_at(obj, normal, side * (reach + 1e-6))) == []
        if reach:
            assert len(sliced.outlines(cut_at(obj, normal, side * (reach - 1e-6)))) >= 1


def test_a_plane_that_touches_a_sphere_shows_the_point(rng: np.random.Generator) -> None:
    """Rays in it meet that point: an ellipse without size, where rounding may go either way."""
    obj = SceneObject("o", SHAPES["sphere"], 0)
    linear, centre = placement(obj)
    for n in rng.normal(size=(20, 3)):
        normal = n / np.linalg.norm(n)
        cut = cut_at(obj, normal, 1.0)
        [outline] = Sliced(obj).outlines(cut)
        np.testing.assert_allclose(
            cut.origin + outline.points[0] @ cut.axes, linear @ normal + centre, atol=1e-14
        )
        assert np.abs(outline.points[1:]).max() < 1e-6  # the root of a few roundings


def test_a_tube_cut_along_its_axis_is_two_lines_and_with_caps_one_rectangle() -> None:
    """4 corners at the ends, right across from one another; across it one ring."""
    for name, kinds in (("open cylinder", ["open", "open"]), ("capped cylinder", ["closed"])):
        obj = SceneObject("o", SHAPES[name], 0)
        along = Sliced(obj).outlines(cut_at(obj, np.array([0.6, 0.8, 0.0]), 0.5))
        assert [outline.kind for outline in along] == kinds
        assert sum(len(outline.points) for outline in along) == 4
        [ring] = Sliced(obj).outlines(cut_at(obj, np.array([0.0, 0.0, 1.0]), 0.5))
        assert len(corners_of(ring)) >= ROUND
