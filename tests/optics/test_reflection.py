"""Laws of mirrors and glass: reflection, refraction, total reflection, Fresnel.

Directions are unit and run along the ray; the normal is unit and faces it.
"""

from __future__ import annotations

import math

import mpmath  # type: ignore[import-untyped]
import numpy as np
import pytest
from mpmath import mpf

from raywalk.optics.reflection import (
    fresnel_reflectance,
    reflect,
    refract,
    sine_squared_beyond,
)
from raywalk.optics.scatter import glass_shares, mirror_directions, refracted_directions

COUNT = 1000
UNIT = 4e-16  # a length of 1 after a division and a root: two to four roundings
WATER, GLASS, DIAMOND = 1.333, 1.5168, 2.417
PAIRS = [(1.0, WATER), (1.0, GLASS), (1.0, DIAMOND), (WATER, GLASS), (GLASS, 1.0), (DIAMOND, WATER)]


def unit(v: np.ndarray) -> np.ndarray:
    return np.asarray(v / np.linalg.norm(v, axis=-1, keepdims=True))


def onto_surfaces(rng: np.random.Generator, count: int = COUNT) -> tuple[np.ndarray, np.ndarray]:
    """Random unit directions (n, 3) and normals that face them."""
    direction, normal = unit(rng.normal(size=(count, 3))), unit(rng.normal(size=(count, 3)))
    return direction, np.where((direction * normal).sum(axis=1, keepdims=True) > 0, -normal, normal)


def sine(direction: np.ndarray, normal: np.ndarray) -> np.ndarray:
    return np.linalg.norm(np.cross(direction, normal), axis=-1)


def at_angle(angle: float) -> tuple[float, float, float]:
    """A direction that comes down on the normal (0, 1, 0) at an angle of incidence."""
    return math.sin(angle), -math.cos(angle), 0.0


def reflectance_at(angle: float, n_from: float, n_to: float) -> float:
    """The kernels' reflectance at an angle of incidence; 1 beyond the critical one."""
    s = sine_squared_beyond(*at_angle(angle), 0.0, 1.0, 0.0, n_from, n_to)
    if s > 1.0:
        return 1.0
    return float(fresnel_reflectance(math.cos(angle), math.sqrt(1.0 - s), n_from, n_to))


def true_reflectance(cos_in: mpf, n_from: float, n_to: float) -> mpf:
    """Fresnel's equations to 50 digits, polarisations apart, from the angle alone."""
    n1, n2 = mpf(n_from), mpf(n_to)
    sin_out = n1 / n2 * mpmath.sqrt(1 - cos_in**2)
    if sin_out > 1:
        return mpf(1)
    cos_out = mpmath.sqrt(1 - sin_out**2)
    s = (n1 * cos_in - n2 * cos_out) / (n1 * cos_in + n2 * cos_out)
    p = (n2 * cos_in - n1 * cos_out) / (n2 * cos_in + n1 * cos_out)
    return (s**2 + p**2) / 2


def test_reflected_rays_leave_at_the_angle_they_came(rng: np.random.Generator) -> None:
    """Angle out = angle in, in one plane with the normal, for 1000 directions."""
    d, n = onto_surfaces(rng)
    out = np.array([reflect(*a, *b) for a, b in zip(d, n, strict=True)])
    assert np.abs((out * n).sum(axis=1) + (d * n).sum(axis=1)).max() < 1e-15  # about 6 roundings
    assert np.abs((out * np.cross(d, n)).sum(axis=1)).max() < 1e-15


def test_reflection_keeps_length_one(rng: np.random.Generator) -> None:
    """Unit in, unit out."""
    d, n = onto_surfaces(rng)
    out = np.array([reflect(*a, *b) for a, b in zip(d, n, strict=True)])
    assert np.abs(np.linalg.norm(out, axis=1) - 1).max() < UNIT


def test_reflection_is_reversible(rng: np.random.Generator) -> None:
    """The reflected ray sent back returns where the first came from."""
    d, n = onto_surfaces(rng)
    for a, b in zip(d, n, strict=True):
        back = reflect(*(-np.array(reflect(*a, *b))), *b)
        assert np.abs(np.array(back) + a).max() < 2e-15  # twice the roundings of one reflection


def test_a_thousand_reflections_stay_unit(rng: np.random.Generator) -> None:
    """Renormalising at each bounce: lengths do not drift."""
    d = tuple(unit(rng.normal(size=3)))
    for n in unit(rng.normal(size=(1000, 3))):
        d = reflect(*d, *n)
    assert abs(math.hypot(*d) - 1) < UNIT


@pytest.mark.parametrize(("n_from", "n_to"), PAIRS)
def test_refracted_rays_obey_snell(rng: np.random.Generator, n_from: float, n_to: float) -> None:
    """n1 sin(a1) = n2 sin(a2), in one plane with the normal, for 1000 random directions."""
    d, n = onto_surfaces(rng)
    total = np.array(
        [sine_squared_beyond(*a, *b, n_from, n_to) > 1 for a, b in zip(d, n, strict=True)]
    )
    assert (n_to >= n_from) == (not total.any())  # only entering a thinner medium some are total
    d, n = d[~total], n[~total]
    out = np.array([refract(*a, *b, n_from, n_to) for a, b in zip(d, n, strict=True)])
    # float64; about 10 roundings, of numbers up to 2.4
    np.testing.assert_allclose(n_to * sine(out, n), n_from * sine(d, n), rtol=0, atol=1e-14)
    assert np.abs((out * np.cross(d, n)).sum(axis=1)).max() < 2e-15
    assert ((out * n).sum(axis=1) < 0).all()  # to the far side
    assert np.abs(np.linalg.norm(out, axis=1) - 1).max() < UNIT


@pytest.mark.parametrize(("n_from", "n_to"), PAIRS)
def test_refraction_is_reversible(rng: np.random.Generator, n_from: float, n_to: float) -> None:
    """The refracted ray sent back through the same surface returns where the first came from."""
    d, n = onto_surfaces(rng)
    for a, b in zip(d, n, strict=True):
        if sine_squared_beyond(*a, *b, n_from, n_to) > 1.0:
            continue
        there = refract(*a, *b, n_from, n_to)
        back = refract(*(-np.array(there)), *(-b), n_to, n_from)
        grazing = min(-a @ b, -np.array(there) @ b)
        # 20 roundings, magnified where either side grazes the surface
        assert np.abs(np.array(back) + a).max() < 4e-15 / grazing


@pytest.mark.parametrize(("n_from", "n_to"), PAIRS)
def test_light_at_normal_incidence_goes_straight_on(n_from: float, n_to: float) -> None:
    """No bend, and the reflected share is ((n1 - n2) / (n1 + n2))^2."""
    assert refract(0.0, -1.0, 0.0, 0.0, 1.0, 0.0, n_from, n_to) == (0.0, -1.0, 0.0)
    expected = ((n_from - n_to) / (n_from + n_to)) ** 2
    # relative: the difference n1 - n2 cancels the same way on both sides
    assert reflectance_at(0.0, n_from, n_to) == pytest.approx(expected, rel=1e-14, abs=0)


@pytest.mark.parametrize(("n_from", "n_to"), PAIRS)
def test_fresnel_reflectance_is_exact(n_from: float, n_to: float) -> None:
    """Against 50 digits at 500 angles from 0 to 90 degrees, wherever the angle is clear."""
    for angle in np.linspace(0, math.pi / 2, 501):
        true = true_reflectance(mpmath.cos(mpf(float(angle))), n_from, n_to)
        # 1e-14: about 40 roundings; near the critical angle they grow by 1 / cos(refracted)
        sin_out = min(1.0, n_from / n_to * math.sin(angle))
        slack = 1e-14 / max(math.sqrt(1 - sin_out**2), 1e-8)
        assert abs(reflectance_at(float(angle), n_from, n_to) - float(true)) < slack


@pytest.mark.parametrize(("n_from", "n_to"), PAIRS)
def test_at_brewsters_angle_one_polarisation_is_not_reflected(n_from: float, n_to: float) -> None:
    """At tan a = n2 / n1 what is left is half of ((n1^2 - n2^2) / (n1^2 + n2^2))^2."""
    expected = 0.5 * ((n_from**2 - n_to**2) / (n_from**2 + n_to**2)) ** 2
    assert reflectance_at(math.atan2(n_to, n_from), n_from, n_to) == pytest.approx(
        expected, rel=1e-13, abs=0
    )


@pytest.mark.parametrize(("n_from", "n_to"), PAIRS)
def test_reflectance_is_the_same_both_ways(n_from: float, n_to: float) -> None:
    """Stokes: light going back along the refracted ray is reflected by the same share."""
    for angle in np.linspace(0.01, 1.5, 100):
        sin_out = n_from / n_to * math.sin(angle)
        if sin_out < 0.999:
            there = reflectance_at(float(angle), n_from, n_to)
            back = reflectance_at(math.asin(sin_out), n_to, n_from)
            # asin costs 1 / cos = 22 roundings, twice
            assert abs(there - back) < 1e-14


def test_between_equal_media_nothing_is_reflected() -> None:
    """A border without a change of index is invisible, and grazing it is no 0 / 0."""
    assert reflectance_at(0.7, GLASS, GLASS) < 1e-30
    assert fresnel_reflectance(0.0, 0.0, GLASS, GLASS) == 1.0  # the limit from unequal indices


def test_grazing_a_border_between_equal_media_is_not_total() -> None:
    """sin a = n2 / n1 = 1 exactly is the last angle that goes through; Fresnel gives all back."""
    d, n, one = np.array([[1.0, 0.0, 0.0]] * 2), np.array([[0.0, 1.0, 0.0]] * 2), np.full(2, GLASS)
    kr, kt = np.full(2, 0.2), np.full(2, 0.7)
    reflected, refracted, total = glass_shares(d, n, one, one, kr, kt, np.array([False, True]))
    assert not total.any()
    assert reflected.tolist() == [0.2, 0.2 + 0.7]
    assert refracted.tolist() == [0.7, 0.0]


@pytest.mark.parametrize("k", range(1, 15))
def test_total_reflection_begins_at_the_critical_angle(k: int) -> None:
    """At sin a = n2 / n1 (1 -+ 10^-k) the answer is right, down to 14 digits."""
    for n_from, n_to in [(WATER, 1.0), (GLASS, 1.0), (DIAMOND, 1.0), (GLASS, WATER)]:
        for sign in (-1, 1):
            s = mpf(n_to) / mpf(n_from) * (1 + sign * mpf(10) ** -k)
            d = float(s), -float(mpmath.sqrt(1 - s**2)), 0.0
            found = sine_squared_beyond(*d, 0.0, 1.0, 0.0, n_from, n_to)
            assert (found > 1.0) == (sign > 0)


@pytest.mark.parametrize("k", range(1, 15))
def test_rays_just_below_the_critical_angle_graze_the_far_side(k: int) -> None:
    """cos(refracted) = sqrt(1 - s^2) with s = 1 - 10^-k; error about 1e-16 / itself."""
    for n_from, n_to in [(WATER, 1.0), (GLASS, 1.0), (DIAMOND, 1.0)]:
        s = mpf(n_to) / mpf(n_from) * (1 - mpf(10) ** -k)
        d = float(s), -float(mpmath.sqrt(1 - s**2)), 0.0
        true = float(mpmath.sqrt(1 - (mpf(d[0]) * mpf(n_from) / mpf(n_to)) ** 2))
        out = refract(*d, 0.0, 1.0, 0.0, n_from, n_to)
        assert abs(-out[1] - true) < 1e-15 / true


def test_the_shares_of_a_glass_surface_keep_the_energy(rng: np.random.Generator) -> None:
    """Reflected + refracted = kr + kt at every angle, with Fresnel and without."""
    d, n = onto_surfaces(rng)
    for fresnel in (False, True):
        for n_from, n_to in PAIRS:
            kr, kt = np.full(COUNT, 0.2), np.full(COUNT, 0.7)
            reflected, refracted, total = glass_shares(
                d, n, np.full(COUNT, n_from), np.full(COUNT, n_to), kr, kt, np.full(COUNT, fresnel)
            )
            assert np.abs(reflected + refracted - (kr + kt)).max() < 3e-16  # three roundings
            assert (reflected >= 0).all()
            assert (refracted >= 0).all()
            assert (reflected[total] == kr[0] + kt[0]).all()
            assert (refracted[total] == 0).all()


def test_rays_stay_on_their_side_of_the_true_surface(rng: np.random.Generator) -> None:
    """Whatever an interpolated normal says, mirrors send back and glass lets through."""
    d, g = onto_surfaces(rng)
    n = unit(g + rng.normal(size=g.shape))
    n = np.where((n * d).sum(axis=1, keepdims=True) > 0, -n, n)
    back = mirror_directions(d, n, g)
    assert ((back * g).sum(axis=1) > 0).all()
    ones = np.ones(COUNT)
    on = refracted_directions(d, n, g, ones, GLASS * ones)
    assert ((on * g).sum(axis=1) < 0).all()
    # The interpolated normal decides wherever its ray stays on its side, else the true one.
    for i in range(COUNT):
        r, t = (np.array(f) for f in (reflect(*d[i], *n[i]), refract(*d[i], *n[i], 1.0, GLASS)))
        assert (back[i] == (r if r @ g[i] > 0 else reflect(*d[i], *g[i]))).all()
        assert (on[i] == (t if t @ g[i] < 0 else refract(*d[i], *g[i], 1.0, GLASS))).all()


def test_shares_without_fresnel_are_the_materials_own_and_with_it_the_angles(
    rng: np.random.Generator,
) -> None:
    """Row by row, against the formulas at the row's own angle and indices."""
    d, n = onto_surfaces(rng)
    n_from, n_to = rng.uniform(1.0, 2.5, (2, COUNT))
    kr, kt = rng.uniform(0.0, 0.5, (2, COUNT))
    fresnel = rng.random(COUNT) < 0.5
    reflected, refracted, total = glass_shares(d, n, n_from, n_to, kr, kt, fresnel)
    for i in range(COUNT):
        beyond = n_from[i] / n_to[i] * sine(d[i], n[i]) > 1.0
        share = reflectance_at(math.acos(-d[i] @ n[i]), n_from[i], n_to[i])
        both = kr[i] + kt[i]
        expected = both * share if beyond or fresnel[i] else kr[i]
        assert total[i] == beyond
        # the angle by way of acos costs 1 / cos of it, the refracted one too
        assert reflected[i] == pytest.approx(expected, abs=1e-10)
        assert reflected[i] + refracted[i] == pytest.approx(both, abs=3e-16)
