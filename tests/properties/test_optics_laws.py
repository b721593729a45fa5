"""Laws of reflection and refraction for any directions and indices."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from raywalk.optics.reflection import (
    fresnel_reflectance,
    reflect,
    refract,
    sine_squared_beyond,
)

ALWAYS_THE_SAME = settings(derandomize=True, deadline=None, max_examples=200)
part = st.floats(-1.0, 1.0, allow_nan=False)
index = st.floats(1.0, 3.0)


@st.composite
def meetings(draw) -> tuple[np.ndarray, np.ndarray]:
    """A unit direction and a unit normal that faces it."""
    d, n = (np.array(draw(st.tuples(part, part, part))) for _ in range(2))
    assume(np.linalg.norm(d) > 1e-3 and np.linalg.norm(n) > 1e-3)
    d, n = d / np.linalg.norm(d), n / np.linalg.norm(n)
    return d, -n if d @ n > 0 else n


@ALWAYS_THE_SAME
@given(meetings())
def test_mirrors_keep_the_angle_and_the_plane(meeting) -> None:
    """r.n = -d.n, r x n = d x n, |r| = 1: to a few roundings."""
    d, n = meeting
    r = np.array(reflect(*d, *n))
    assert abs(r @ n + d @ n) < 1e-15
    assert np.abs(np.cross(r, n) - np.cross(d, n)).max() < 1e-15
    assert abs(np.linalg.norm(r) - 1.0) < 4e-16


@ALWAYS_THE_SAME
@given(meetings())
def test_a_mirror_undoes_itself(meeting) -> None:
    """The reflected ray sent back comes out where the first came from."""
    d, n = meeting
    r = np.array(reflect(*d, *n))
    assert np.abs(np.array(reflect(*-r, *n)) + d).max() < 2e-15


@ALWAYS_THE_SAME
@given(meetings(), index, index)
def test_refraction_obeys_snell(meeting, n_from: float, n_to: float) -> None:
    """n1 d x n = n2 r x n as vectors: angle and plane at once. Total reflection is left out."""
    d, n = meeting
    assume(sine_squared_beyond(*d, *n, n_from, n_to) <= 1.0)
    r = np.array(refract(*d, *n, n_from, n_to))
    assert np.abs(n_from * np.cross(d, n) - n_to * np.cross(r, n)).max() < 3e-15  # indices to 3
    assert r @ n <= 0.0
    assert abs(np.linalg.norm(r) - 1.0) < 4e-16


@ALWAYS_THE_SAME
@given(meetings(), index, index)
def test_light_goes_the_same_way_back(meeting, n_from: float, n_to: float) -> None:
    """Helmholtz reciprocity, away from the critical angle, where rounding is magnified."""
    d, n = meeting
    assume(sine_squared_beyond(*d, *n, n_from, n_to) < 0.9 and abs(d @ n) > 0.05)
    r = np.array(refract(*d, *n, n_from, n_to))
    back = np.array(refract(*-r, *-n, n_to, n_from))
    # The way back magnifies errors by at most the ratio of the cosines, here 20 times.
    assert np.abs(back + d).max() < 2e-14


@ALWAYS_THE_SAME
@given(st.floats(1e-6, 1.0), index, index)
def test_reflectance_is_a_share_and_the_same_both_ways(
    cos_in: float, n_from: float, n_to: float
) -> None:
    """0 <= R <= 1, and Stokes: R from one side at one angle = R from the other at the other."""
    sine_sq = (n_from / n_to) ** 2 * (1.0 - cos_in**2)
    assume(sine_sq <= 1.0)
    cos_out = math.sqrt(1.0 - sine_sq)
    share = fresnel_reflectance(cos_in, cos_out, n_from, n_to)
    assert 0.0 <= share <= 1.0
    assert abs(share - fresnel_reflectance(cos_out, cos_in, n_to, n_from)) < 1e-15


@ALWAYS_THE_SAME
@given(index, index)
def test_reflectance_straight_on_is_the_schoolbook_number(n_from: float, n_to: float) -> None:
    """((n1 - n2) / (n1 + n2))^2."""
    expected = ((n_from - n_to) / (n_from + n_to)) ** 2
    assert abs(fresnel_reflectance(1.0, 1.0, n_from, n_to) - expected) < 1e-16
