"""The boxes that the viewer draws against the tree that the tracer walks."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from raywalk.geometry.compiled import rays_from
from raywalk.geometry.shallow_boxes import (
    LEVELS,
    boxes_entered,
    crosses_sphere,
    shallow_boxes,
)
from raywalk.scene.read import read_scenes
from raywalk.trace.camera import camera_directions
from raywalk.trace.mesh_boxes import _runs, boxes_of
from raywalk.trace.wavefront import Tracer

SCENES = {scene.id: scene for scene in read_scenes(Path("scenes"))}
N = 21
SLACK = 1e-12  # boxes are widened by 50 roundings


@pytest.fixture(scope="module")
def bunny():
    tracer = Tracer(SCENES["07-bunny-near"])
    direction = camera_directions(tracer.scene.camera, N, N, np.arange(N * N))
    origin = np.tile(np.array(tracer.scene.camera.eye, float), (N * N, 1))
    t, met, triangle, _ = tracer.compiled.nearest(rays_from(origin, direction))
    return tracer, origin, direction, t, met, triangle


def test_boxes_hold_their_children_and_all_of_the_mesh(bunny):
    """A child lies within its parent; the first box is the mesh's own, the sphere is round it."""
    tracer = bunny[0]
    mesh = tracer.compiled.meshes[0]
    boxes = shallow_boxes(mesh)
    assert len(boxes.node) == 2**LEVELS - 1
    assert (boxes.parent[1:] < np.arange(1, len(boxes.node))).all()
    assert (boxes.low[1:] >= boxes.low[boxes.parent[1:]] - SLACK).all()
    assert (boxes.high[1:] <= boxes.high[boxes.parent[1:]] + SLACK).all()
    corners = mesh.corners.reshape(-1, 3) + mesh.centre
    np.testing.assert_allclose(boxes.low[0], corners.min(axis=0), atol=SLACK)
    np.testing.assert_allclose(boxes.high[0], corners.max(axis=0), atol=SLACK)
    away = np.linalg.norm(corners - boxes.centre, axis=1)
    np.testing.assert_allclose(away.max(), boxes.radius, atol=SLACK)


def test_a_ray_that_hits_enters_boxes_down_to_the_last_level(bunny):
    """On every level some box that it enters holds the point that it meets."""
    tracer, origin, direction, t, met, _ = bunny
    mesh = tracer.compiled.meshes[0]
    boxes = shallow_boxes(mesh)
    inside = boxes_entered(mesh, boxes, origin, direction, t)
    hit = np.flatnonzero(met == mesh.index)
    assert len(hit) > 50
    point = origin[hit] + t[hit, None] * direction[hit]
    reach = 1e-9  # of a scene some units wide: the point's own rounding
    holds = (point[:, None] >= boxes.low - reach).all(2) & (
        point[:, None] <= boxes.high + reach
    ).all(2)
    level = np.floor(np.log2(np.arange(1, len(boxes.node) + 1))).astype(int)
    for k in range(LEVELS):
        assert (holds & inside[hit])[:, level == k].any(axis=1).all()
    assert crosses_sphere(boxes, origin, direction)[hit].all()


def test_no_box_is_entered_without_its_parent_nor_beyond_the_sphere(bunny):
    """What is entered can have been tested: its parent is entered, and the sphere is crossed."""
    tracer, origin, direction, t, _, _ = bunny
    mesh = tracer.compiled.meshes[0]
    boxes = shallow_boxes(mesh)
    inside = boxes_entered(mesh, boxes, origin, direction, t)
    assert (inside[:, 1:] <= inside[:, boxes.parent[1:]]).all()
    made = mesh.count_tests(origin, direction, t, np.full(len(t), -1, np.int32))
    tested = 1 + inside[:, boxes.parent[1:]].sum(axis=1)
    assert (tested <= made).all()  # the tracer counts these and all further down
    assert (made[~inside[:, 0]] == 1).all()


def test_the_file_holds_every_level_and_gives_the_same_boxes_back(bunny):
    """Runs spell out to what was found, in raster order."""
    tracer = bunny[0]
    data = boxes_of(tracer)
    (mesh,) = data["meshes"]
    assert sorted(map(int, mesh["levels"])) == sorted(tracer.scene.render.resolutions)
    _, origin, direction, t, _, _ = bunny
    target = tracer.compiled.meshes[0]
    inside = boxes_entered(target, shallow_boxes(target), origin, direction, t)
    for runs, column in zip(mesh["levels"][str(N)][1:], inside.T, strict=True):
        assert (spelt(runs, N * N) == column).all()


@pytest.mark.parametrize("text", ["", "0", "1", "0011", "1100", "10101", "0000"])
def test_runs_begin_with_what_is_out(text):
    """Also where the first ray is in, and nothing is written where none is."""
    column = np.array([c == "1" for c in text], bool)
    runs = _runs(column)
    assert (spelt(runs, len(text)) == column).all()
    assert bool(runs) == column.any()


def spelt(runs, count):
    return np.repeat(np.arange(len(runs)) % 2 == 1, runs) if runs else np.zeros(count, bool)
