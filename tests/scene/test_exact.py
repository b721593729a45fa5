"""Numbers of a scene that are worked out once are right to float64's last digit."""

from __future__ import annotations

from decimal import Decimal, localcontext

import mpmath  # type: ignore[import-untyped]
import numpy as np
import pytest
from mpmath import mpf

from raywalk.bench.truth import turned, vector
from raywalk.scene.exact import DIGITS, cosine, sine, with_rest
from raywalk.scene.model import SceneObject
from raywalk.scene.placement import placement
from raywalk.scene.shapes import Ellipsoid


@pytest.mark.parametrize(
    "degrees", [0.0, 1e-9, 30.0, 45.0, 46.0, 90.0, 135.3, 180.0, 270.0, 359.9, -20.0, 1e6 + 0.3]
)
def test_sines_have_45_digits(degrees: float) -> None:
    """In all quadrants, and after many turns; the last 5 of 50 digits are the series' own."""
    angle = mpf(degrees) * mpmath.pi / 180
    with localcontext(prec=DIGITS):
        assert abs(mpf(str(sine(degrees))) - mpmath.sin(angle)) < mpf(10) ** -45
        assert abs(mpf(str(cosine(degrees))) - mpmath.cos(angle)) < mpf(10) ** -45


def test_quarter_turns_are_exact() -> None:
    """sin 30 and cos 60 are one half, cos 90 is nothing."""
    assert (sine(30.0), cosine(60.0), cosine(90.0), sine(180.0)) == (0.5, 0.5, 0.0, 0.0)


def test_a_number_and_its_rest_are_the_number() -> None:
    """1/3 in float64, and what it lacks: together 30 digits."""
    with localcontext(prec=DIGITS):
        third = np.array([Decimal(1) / 3], object)
        both = sum(Decimal(float(part[0])) for part in with_rest(third))
        assert abs(both - third[0]) < Decimal(10) ** -30


def test_a_turned_ellipsoid_is_placed_to_the_last_digit() -> None:
    """Each entry of the matrix is the float64 next to the true one: half a step at most."""
    shape = Ellipsoid((0.1, 0.2, 0.3), (0.9, 0.5, 0.7), (20.0, 35.0, -50.0))
    linear, centre = placement(SceneObject("e", shape, 0))
    columns = [vector(axis) for axis in np.eye(3)]
    for axis in range(3):
        columns = [turned(column, axis, shape.rotation[axis]) for column in columns]
    for i in range(3):
        for j in range(3):
            entry = mpf(columns[j][i]) * mpf(shape.radii[j])
            assert abs(entry - mpf(linear[i, j])) <= np.spacing(abs(linear[i, j])) / 2
    assert centre.tolist() == [0.1, 0.2, 0.3]
