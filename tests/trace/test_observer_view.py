"""What an observer sees, and what is hidden from it."""

from __future__ import annotations

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal

from raywalk.scene.read import read_scene
from raywalk.trace.observer_view import (
    Observer,
    Walls,
    hidden_points,
    hidden_stretches,
    shaded_view,
)
from raywalk.trace.wavefront import Tracer

ROOM = """
version = 1
title = "Room"
teaches = "A ball in a room."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "white"
[[objects]]
name = "glass"
type = "sphere"
center = [0, 3, 0]
radius = 1
material = "glass"
[[objects]]
name = "back wall"
type = "plane"
point = [0, 0, -4]
normal = [0, 0, 1]
material = "white"
[[lights]]
position = [0, 5, 5]
"""


def tracer(folder) -> Tracer:
    (folder / "scene.toml").write_text(ROOM, encoding="utf-8")
    return Tracer(read_scene(folder))


def test_a_line_behind_a_ball_is_hidden_between_the_cones_edges(tmp_path):
    """Seen from (0, 0, d), a unit ball hides of the plane z = -1 a disc of radius
    (d + 1) / sqrt(d^2 - 1): the cone that touches the ball."""
    d = 10.0
    edge = (d + 1) / np.sqrt(d**2 - 1)
    line = np.array([[[-4.0, 0, -1], [4, 0, -1]]])
    [stretches] = hidden_stretches(tracer(tmp_path), np.array([0, 0, d]), line)
    # 48 samples and 14 halvings: within 8 / 48 / 2^14 = 1e-5 world units, 1.3e-6 of the line.
    assert_allclose(stretches, [[0.5 - edge / 8, 0.5 + edge / 8]], rtol=0, atol=2e-6)


def test_a_line_before_the_ball_is_seen_and_one_that_ends_in_it_is_cut(tmp_path):
    """The part inside the ball is behind its surface."""
    eye = np.array([0.0, 0, 10])
    before = [[-4, 0, 2], [4, 0, 2]]
    into = [[0, 0.5, 4], [0, 0.5, -4]]  # nearly along the sight: enters at z = sqrt(3) / 2
    lines = np.array([before, into], float)
    seen, cut = hidden_stretches(tracer(tmp_path), eye, lines)
    assert seen == []
    assert len(cut) == 1 and cut[0][1] == 1.0
    # The sight through (0, 0.5, z) touches the ball a little before the line itself does.
    assert 4 - 8 * cut[0][0] > np.sqrt(0.75) - 0.05


def test_glass_hides_nothing(tmp_path):
    points = np.array([[0.0, 3, -2], [0, 3, 0], [0, 0, -2]])
    hidden = hidden_points(tracer(tmp_path), np.array([0.0, 3, 10]), points)
    assert hidden.tolist()[:2] == [False, False]


def test_a_wall_seen_from_behind_is_cut_away(tmp_path):
    """The camera is before the wall, the observer behind it: the ball shows, the wall does not."""
    behind = np.array([0.0, 0, -12])
    room = tracer(tmp_path)
    assert Walls(room, behind).cut.tolist() == [False, False, True]
    assert not hidden_points(room, behind, np.array([[0.0, 0, -2]])).any()
    assert hidden_points(room, behind, np.array([[0.0, 0, 2]])).all()


def test_an_eye_in_whole_numbers_sees_what_it_sees_in_others(tmp_path):
    """JSON writes 2.0 as 2: where rays went on behind a wall that is cut outwards, their starts
    were rounded to whole numbers, and a slide of the dragon's room was a jumble."""
    room, views = tracer(tmp_path), []
    for kind in (int, float):
        eye, right, up, forward = (
            np.array(v, kind) for v in ([1, 1, -9], [-1, 0, 0], [0, 1, 0], [0, 0, 1])
        )
        assert Walls(room, eye).cut.any(), "it stands behind the wall"
        views.append(shaded_view(room, Observer(eye, right, up, forward, 60.0, 48, 30)))
    assert len(np.unique(views[1][..., :3])) > 20, "there is something to see"
    assert_array_equal(*views)
