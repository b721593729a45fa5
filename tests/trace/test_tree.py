"""What must hold in every ray tree: the invariants of trace/tree.py, and the picture's."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest
from tests.geometry.by_hand import CHALK, CLEAR, MIRROR, scene_of

from raywalk.scene.model import Light, Scene, SceneObject
from raywalk.scene.shapes import Plane, Sphere
from raywalk.trace.record import kept_pixels
from raywalk.trace.tree import Kind, RayTree, Visibility
from raywalk.trace.wavefront import (
    LEAST_SHARE,
    Traced,
    Tracer,
    eight_bit,
    trace_picture,
    trace_scene,
)

from .conftest import NAMES, small

SUM = 1e-12  # a sum of some dozen terms up to 1, over ten bounces


def glass_scene() -> Scene:
    """Glass in glass, a mirror, chalk and two lights, one of them coloured."""
    half = replace(CLEAR, name="half glass", reflect=0.1, transmit=0.6)
    return scene_of(
        [
            SceneObject("ball", Sphere((-0.6, 0.0, 0.5), 0.8), 1),
            SceneObject("mirror", Sphere((0.9, 0.1, -0.5), 0.9), 2),
            SceneObject("inner", Sphere((-0.6, 0.1, 0.5), 0.3), 3),
            SceneObject("floor", Plane((0, -1, 0), (0, 1, 0)), 0),
        ],
        [CHALK, half, MIRROR, CLEAR],
        [Light("a", (2, 3, 2), intensity=0.6), Light("b", (-2, 2, 1), (1, 0.5, 0.2), 0.5)],
        background=(0.2, 0.3, 0.4),
        size=105,
        resolutions=(5, 15, 105),
        depth=7,
    )


@pytest.fixture(scope="module")
def traced(small_course: dict[str, Scene]) -> dict[str, tuple[Scene, Traced]]:
    """Every scene with its small picture and all its trees."""
    scenes = {**small_course, "glass": glass_scene()}
    return {name: (scene, trace_scene(scene)) for name, scene in scenes.items()}


EVERY = pytest.mark.parametrize("name", [*NAMES, "glass"])
Everything = dict[str, tuple[Scene, Traced]]


def gathered(scene: Scene, tree: RayTree) -> np.ndarray:
    """Colours (m, 3) worked out from the tree alone, from its last ray to its first."""
    colour = np.zeros_like(tree.colour)
    for ray in range(len(tree.pixel) - 1, -1, -1):
        if tree.object[ray] < 0:
            colour[ray] = scene.background
        else:
            colour[ray] += tree.local_weight[ray] * local_colour(scene, tree, ray)
        if tree.parent[ray] >= 0:
            colour[tree.parent[ray]] += tree.weight[ray] * colour[ray]
    return colour


def local_colour(scene: Scene, tree: RayTree, ray: int) -> np.ndarray:
    """ambient + sum over lights V (diffuse kd + specular ks) light colour."""
    material = scene.materials[tree.material[ray]]
    total = np.array(material.ambient, float)
    for k, light in enumerate(scene.lights):
        if tree.visibility[ray, k] in (Visibility.REACHED, Visibility.UNTESTED):
            shine = tree.diffuse[ray, k] * np.array(material.diffuse)
            shine = shine + tree.specular[ray, k] * np.array(material.specular)
            total = total + shine * np.array(light.colour)
    return total


@EVERY
def test_every_pixel_is_the_sum_of_its_ray_tree(traced: Everything, name: str) -> None:
    """Each ray's colour follows from its hit's lighting and its children, to 1e-12."""
    scene, result = traced[name]
    tree = result.tree
    np.testing.assert_allclose(tree.colour, gathered(scene, tree), rtol=0, atol=SUM)
    local = np.array(
        [local_colour(scene, tree, int(k)) for k in np.flatnonzero(tree.local_weight > 0)]
    )
    np.testing.assert_allclose(tree.local[tree.local_weight > 0], local, rtol=0, atol=SUM)


@EVERY
def test_a_tiles_colour_is_the_pictures_pixel(traced: Everything, name: str) -> None:
    """Exactly: the picture's bytes are the rounded colours of the camera rays, for every tile of
    every resolution, in the middle of the tile."""
    scene, result = traced[name]
    tree, size = result.tree, scene.render.size
    flat = result.picture.reshape(-1, 3)
    cameras = slice(0, tree.cameras)
    assert (eight_bit(tree.colour[cameras]) == flat[tree.pixel[cameras]]).all()
    recorded = set(tree.pixel[cameras].tolist())
    for n in scene.render.resolutions:
        step = size // n
        middle = step * np.arange(n) + step // 2
        assert recorded.issuperset((middle[:, None] * size + middle).ravel().tolist())


@EVERY
def test_rays_stand_path_by_path(traced: Everything, name: str) -> None:
    """Camera rays in raster order, then all their reflected children, then the refracted ones, and
    so on depth by depth; in each group in the order of the parents. Parents before children."""
    tree = traced[name][1].tree
    cameras = tree.cameras
    assert (tree.kind[:cameras] == Kind.CAMERA).all()
    assert (np.diff(tree.pixel[:cameras]) > 0).all()
    assert (tree.parent[:cameras] == -1).all()
    rows = np.arange(len(tree.pixel))
    assert (tree.parent < rows).all()
    children = rows[cameras:]
    assert (tree.depth[children] == tree.depth[tree.parent[children]] + 1).all()
    assert (tree.pixel[children] == tree.pixel[tree.parent[children]]).all()
    path: list[tuple[int, ...]] = [() for _ in rows]
    for k in children:
        path[k] = (*path[tree.parent[k]], int(tree.kind[k] == Kind.REFRACTED))
    keys = [(len(path[k]), path[k], int(tree.parent[k])) for k in rows]
    assert keys[cameras:] == sorted(keys[cameras:])


@EVERY
def test_the_columns_of_a_ray_agree_with_each_other(traced: Everything, name: str) -> None:
    """Unit normals that face the ray, hits on the ray, lights and blockers, weights, hit lists."""
    scene, result = traced[name]
    tree = result.tree
    met = tree.object >= 0
    assert (np.isfinite(tree.t) == met).all()
    assert ((tree.material >= 0) == met).all()
    assert (tree.normal[~met] == 0).all()
    eye = np.array(scene.camera.eye)
    origin = np.where(tree.parent[:, None] < 0, eye, tree.point[tree.parent])
    way = tree.point - origin
    np.testing.assert_allclose(
        np.linalg.norm(way[met], axis=1), tree.t[met], rtol=1e-13, atol=1e-13
    )
    assert np.abs(np.linalg.norm(tree.normal[met], axis=1) - 1).max() < 1e-15
    assert ((tree.normal * way).sum(axis=1)[met] < 1e-12).all()
    assert (tree.depth <= scene.render.depth).all()
    assert ((tree.visibility == Visibility.BLOCKED) == (tree.blocker >= 0)).all()
    assert (tree.blocked_at[tree.blocker < 0] == 1).all()
    assert ((tree.blocked_at > 0) & (tree.blocked_at <= 1)).all()
    assert (tree.tests > 0).all()
    for column in fields(tree):
        values = getattr(tree, column.name)
        if isinstance(values, np.ndarray) and column.name != "t":
            assert np.isfinite(values).all(), column.name


@EVERY
def test_the_shares_of_a_hit_add_up_to_one(traced: Everything, name: str) -> None:
    """Local, reflected and refracted weight: 1 in all, unless the bounce limit cut rays off or a
    ray's share in its pixel (the product of the weights up to it) is too small to be seen."""
    scene, result = traced[name]
    tree = result.tree
    whole, share = tree.local_weight.copy(), np.ones(len(tree.pixel))
    for ray in range(tree.cameras, len(tree.pixel)):
        whole[tree.parent[ray]] += tree.weight[ray]
        share[ray] = share[tree.parent[ray]] * tree.weight[ray]
    missing = np.abs(whole - 1) * share
    expected = (tree.object >= 0) & (tree.depth < scene.render.depth)
    assert (missing[expected] <= 2 * LEAST_SHARE).all()
    assert (missing[expected & (share > 0.01)] < 1e-15).all()


def test_rays_too_weak_to_be_seen_are_left_out_unseen() -> None:
    """Clear glass at depth 7: with and without the weakest rays no 8-bit value differs by more
    than 1, and fewer than 1 in 100 do."""
    scene = glass_scene()
    every = trace_picture(Tracer(scene)).picture.astype(int)
    changed = np.abs(trace_scene(scene).picture.astype(int) - every)
    assert changed.max() <= 1
    assert (changed > 0).mean() < 0.01


@EVERY
def test_the_hits_along_a_camera_ray_begin_with_its_own(traced: Everything, name: str) -> None:
    """hits_t ascends, and its first is the ray's t and object, exactly."""
    tree = traced[name][1].tree
    for k in range(tree.cameras):
        along = slice(tree.hits_start[k], tree.hits_start[k + 1])
        t, met = tree.hits_t[along], tree.hits_object[along]
        assert (np.diff(t) >= 0).all()
        assert len(t) == 0 if tree.object[k] < 0 else (t[0], met[0]) == (tree.t[k], tree.object[k])


@pytest.mark.slow  # smaller pictures are asked above
def test_at_full_size_every_pixel_is_its_tree_too(course: dict[str, Scene]) -> None:
    """Scene 5 at 1155 x 1155, nine resolutions: sums, tiles and the rays kept."""
    scene = course["05-many-bounces"]
    result = trace_scene(scene)
    tree = result.tree
    np.testing.assert_allclose(tree.colour, gathered(scene, tree), rtol=0, atol=SUM)
    flat = result.picture.reshape(-1, 3)
    assert (eight_bit(tree.colour[: tree.cameras]) == flat[tree.pixel[: tree.cameras]]).all()
    kept = np.flatnonzero(kept_pixels(1155, scene.render.resolutions))
    assert (tree.pixel[: tree.cameras] == kept).all()


@pytest.mark.parametrize("name", ["05-many-bounces", "07-bunny-near", "glass"])
def test_workers_and_runs_change_no_byte(small_course: dict[str, Scene], name: str) -> None:
    """One worker, two, and two again: the same picture and the same tree, bit for bit. 231 x 231
    pixels are four strips."""
    scene = glass_scene() if name == "glass" else small_course[name]
    scene = small(scene, 231, 7, 21, 77)
    first, *others = (trace_scene(scene, workers) for workers in (1, 2, 2))
    for other in others:
        assert first.picture.tobytes() == other.picture.tobytes()
        for column in fields(RayTree):
            a, b = getattr(first.tree, column.name), getattr(other.tree, column.name)
            assert np.array(a).tobytes() == np.array(b).tobytes(), column.name


@pytest.mark.parametrize("depth", range(4))
def test_no_ray_goes_deeper_than_it_may(depth: int) -> None:
    """The bounce limit counts rays after the camera's, and each limit is used up."""
    scene = glass_scene()
    tree = trace_scene(replace(scene, render=replace(scene.render, depth=depth))).tree
    assert tree.depth.max() == depth


def test_a_deeper_limit_leaves_the_first_rays_as_they_are() -> None:
    """Up to the smaller limit both trees hold the same rays; only colours gather more."""
    scene = glass_scene()
    shallow, deep = (
        trace_scene(replace(scene, render=replace(scene.render, depth=d))).tree for d in (2, 5)
    )
    count = len(shallow.pixel)
    for column in ("pixel", "parent", "kind", "object", "t", "point", "normal", "weight", "local"):
        assert (getattr(shallow, column) == getattr(deep, column)[:count]).all(), column


def test_objects_beyond_what_16_bits_count_are_told_right() -> None:
    """A ball of glass that stands behind 33,000 others: met, shading the floor, and left again."""
    dust = [SceneObject(f"{k}", Sphere((10.0 * k, -1e4, 0.0), 1.0), 0) for k in range(33_000)]
    floor = SceneObject("floor", Plane((0, -1, 0), (0, 1, 0)), 0)
    ball = SceneObject("ball", Sphere((0.0, 0.0, 0.0), 0.5), 1)
    scene = scene_of(
        [*dust, floor, ball], [CHALK, CLEAR], [Light("lamp", (0, 5, 0))],
        size=15, resolutions=(5, 15), depth=3,
    )  # fmt: skip
    tree = trace_scene(scene).tree
    assert set(tree.object[:225]) == {-1, 33_000, 33_001}
    assert set(tree.blocker.ravel()) == {-1, 33_001}
    within = tree.parent[np.flatnonzero((tree.object == 33_001) & tree.inside)]
    assert len(within)
    assert (tree.object[within] == 33_001).all()  # what is inside of it came in through it


def test_what_is_counted_does_not_depend_on_the_strips(monkeypatch: pytest.MonkeyPatch) -> None:
    """Rays too faint to be sent on were once left out where a strip sent none at all."""
    scene = glass_scene()
    whole = trace_scene(scene, 1)
    monkeypatch.setattr("raywalk.trace.wavefront.STRIP", 8)
    parts = trace_scene(scene, 1)
    assert whole.tally.faint > 0
    assert parts.tally.as_dict() == whole.tally.as_dict()
    np.testing.assert_array_equal(parts.picture, whole.picture)
