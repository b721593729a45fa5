"""Transform steps multiply as they are written."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

# Transparent, so that it may be scaled over the camera.
SPHERE = (
    '[[objects]]\ntype = "sphere"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = "water"\n'
    "transform = {}\n"
)


@pytest.fixture
def moved(scene_from):
    """A function from a transform to where it takes a point."""

    def move(transform, point):
        [obj] = scene_from(SPHERE.format(transform)).objects
        return (obj.transform @ [*point, 1])[:3]

    return move


def test_the_leftmost_step_is_applied_last(moved):
    """T S p = t + s p, not s (t + p)."""
    assert_allclose(moved("[{ translate = [1, 2, 3] }, { scale = 2 }]", (1, 1, 1)), (3, 4, 5))
    assert_allclose(moved("[{ scale = 2 }, { translate = [1, 2, 3] }]", (1, 1, 1)), (4, 6, 8))


@pytest.mark.parametrize(
    "axis, expected",
    [('"x"', (0, 0, 1)), ("[2, 0, 0]", (0, 0, 1)), ('"z"', (-1, 0, 0)), ('"y"', (0, 1, 0))],
)
def test_rotations_are_right_handed(axis, expected, moved):
    """A quarter turn of +y about x gives +z, whatever the axis vector's length."""
    turned = moved(f"[{{ rotate = {{ axis = {axis}, degrees = 90 }} }}]", (0, 1, 0))
    assert_allclose(turned, expected, rtol=0, atol=1e-15)  # cos 90 deg is 6e-17 in float64


def test_a_scale_may_have_three_factors_and_mirror(moved):
    """Along x, y and z; a negative one turns left into right."""
    assert_allclose(moved("[{ scale = [-1, 2, 3] }]", (1, 1, 1)), (-1, 2, 3))


@pytest.mark.parametrize("last", ["", ", [0, 0, 0, 1]"])
def test_a_matrix_may_have_three_rows_or_four(last, moved):
    """The fourth says nothing."""
    rows = f"[[1, 2, 0, 5], [0, 1, 0, 6], [0, 0, 1, 7]{last}]"
    assert_allclose(moved(f"[{{ matrix = {rows} }}]", (1, 1, 1)), (8, 7, 8))


@pytest.mark.parametrize("scale", ["1e-30", "1e30", "[1e-9, 1, 1e9]"])
def test_no_scale_is_mistaken_for_a_flattening(scale, moved):
    """Whether a matrix is singular is judged against its own scale."""
    assert moved(f"[{{ scale = {scale} }}]", (1, 0, 0))[0] > 0


def test_a_transform_cannot_be_changed_afterwards(scene_from):
    """A scene is shared by everything that reads it."""
    [obj] = scene_from(SPHERE.format("[{ scale = 2 }]")).objects
    with pytest.raises(ValueError, match="read-only"):
        obj.transform[0, 0] = 1.0
    assert isinstance(obj.transform, np.ndarray)
