"""The tree as a lesson shows it is the one that the tracer counts in."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from raywalk.geometry.compiled import rays_from
from raywalk.scene.read import read_scene
from raywalk.trace.camera import camera_directions
from raywalk.trace.mesh_visits import CUT_OFF, ENTERED, MISSED, tree_of
from raywalk.trace.wavefront import Tracer

SCENES = Path(__file__).parents[2] / "scenes"
N = 15


@pytest.fixture(scope="module", params=["06-bunny-far", "07-bunny-near"])
def tracer(request):
    return Tracer(read_scene(SCENES / request.param))


@pytest.fixture(scope="module")
def tree(tracer):
    return tree_of(tracer, N)


def walk(tree, ray):
    """(box, what, t) by visit."""
    flat = tree["visits"][ray]
    return [(tree["boxes"][int(flat[k])], flat[k + 1], flat[k + 2]) for k in range(0, len(flat), 3)]


def test_the_whole_tree_costs_what_is_counted(tracer, tree):
    """`tests` of a trace file, for each camera ray."""
    camera = tracer.scene.camera
    direction = camera_directions(camera, N, N, np.arange(N * N))
    rays = rays_from(np.tile(np.array(camera.eye, float), (N * N, 1)), direction)
    t = tracer.compiled.nearest(rays)[0]
    assert tree["tests"]["all"] == tracer.compiled.count_tests(rays, t).tolist()


def test_rays_of_the_lessons_cost_what_they_say():
    """Far: one passes by, one slips past the ears, one hits; near: in the middle."""
    far = tree_of(Tracer(read_scene(SCENES / "06-bunny-far")), N)["tests"]["all"]
    near = tree_of(Tracer(read_scene(SCENES / "07-bunny-near")), N)["tests"]["all"]
    assert [far[row * N + column] for column, row in ((12, 10), (8, 2), (6, 3))] == [1, 17, 49]
    assert near[8 * N + 8] == 42
    assert max(far) == far[2 * N + 7] == 114  # the dearest, which the lesson asks for


def test_a_box_is_visited_only_after_its_parent_was_entered(tree):
    """Level by level: no visit is more than one level below the last box that was entered."""
    for ray in range(N * N):
        entered = {0}
        for box, what, _ in walk(tree, ray):
            level = box[6]
            assert level - 1 in entered
            entered = {each for each in entered if each < level}
            if what == ENTERED:
                entered.add(level)


def test_what_a_visit_says_is_true_of_the_box(tracer, tree):
    """Entered before the hit, missed, or begun behind it: by the schoolbook's slabs, 2e-3 off for
    the five digits that corners are written with, seen at a slant."""
    camera = tracer.scene.camera
    eye = np.array(camera.eye)
    direction = camera_directions(camera, N, N, np.arange(N * N))
    t_hit = tracer.compiled.nearest(rays_from(np.tile(eye, (N * N, 1)), direction))[0]
    seen = set()
    for ray in range(N * N):
        for box, what, t in walk(tree, ray):
            along = np.where(direction[ray] == 0, 1e-30, direction[ray])
            sides = (np.reshape(box[:6], (2, 3)) - eye) / along
            into, out = sides.min(axis=0).max(), sides.max(axis=0).min()
            seen.add(what)
            if what == MISSED:
                assert into > out - 2e-3 or out < 2e-3
            else:
                assert into <= out + 2e-3 and t == pytest.approx(max(into, 0.0), abs=2e-3)
                assert (t > t_hit[ray] - 2e-3) if what == CUT_OFF else (t <= t_hit[ray] + 2e-3)
    assert seen == {MISSED, ENTERED, CUT_OFF}


def test_every_cut_is_cheaper_or_none(tree):
    """Without a tree all triangles are tested; the sphere adds its own question."""
    triangles = tree["triangles"]
    assert set(tree["tests"]["none"]) == {triangles}
    assert set(tree["tests"]["sphere"]) <= {1, triangles + 1}
    assert tree["boxes"][0][7] == triangles  # all are in the root
    for cut in ("1", "2", "4", "8"):
        assert sum(tree["tests"]["all"]) <= sum(tree["tests"][cut])
