"""What lesson "What is a ray?" works out, against the schoolbook's own words for it."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt
from pathlib import Path
from pickle import dumps, loads

import pytest

from raywalk.scene.read import read_scene
from raywalk.trace.equations import equations_of
from raywalk.trace.wavefront import Tracer

SCENE = Path(__file__).parents[2] / "scenes" / "01-shading"
RED, GREEN, BLUE = 0, 1, 2


@pytest.fixture(scope="module")
def worked():
    """By pixel of the 15 x 15 grid, the sphere's index."""
    pixels = [(15, column, row) for column in range(15) for row in range(15)]
    scene = loads(dumps(read_scene(SCENE)))  # as a process that traces is handed it
    rays = equations_of(Tracer(scene), pixels)
    return {tuple(ray["pixel"]): ray for ray in rays}


def sphere(worked, pixel, index):
    [found] = [each for each in worked[pixel]["spheres"] if each["object"] == index]
    return found


@pytest.mark.parametrize(
    ("pixel", "index", "discriminant", "roots"),
    [
        ((0, 0), BLUE, "-2.66", []),
        ((9, 10), RED, "0.0014", ["3.993", "4.069"]),
        ((4, 3), BLUE, "0.327", ["4.461", "5.604"]),
    ],
)
def test_three_rays_are_as_the_lesson_says(worked, pixel, index, discriminant, roots):
    """Found before by another tracer, written with as many digits."""
    found = sphere(worked, pixel, index)
    digits = len(discriminant.partition(".")[2])
    assert f"{found['discriminant']:.{digits}f}" == discriminant
    assert [f"{t:.3f}" for t in found["t"]] == roots


def test_the_grazing_ray_goes_on_to_the_green_sphere(worked):
    assert f"{sphere(worked, (9, 10), GREEN)['t'][0]:.3f}" == "5.114"


def test_every_number_is_that_of_the_quadratic_formula(worked):
    """b, c and D in rationals of the very float64 directions; |d| is 1 but for 2 roundings, and D
    loses as many as it is small against b^2."""
    for ray in worked.values():
        o, d = ([Fraction(v) for v in ray[key]] for key in ("origin", "direction"))
        for each in ray["spheres"]:
            away = [a - Fraction(m) for a, m in zip(o, each["centre"], strict=True)]
            b = sum(q * v for q, v in zip(away, d, strict=True))
            c = sum(q * q for q in away) - Fraction(each["radius"]) ** 2
            assert each["b"] == pytest.approx(float(b), abs=1e-14)
            assert each["c"] == pytest.approx(float(c), abs=1e-13)
            assert each["discriminant"] == pytest.approx(float(b * b - c), abs=2e-14)


def test_the_sign_decides_and_the_roots_solve_the_equation(worked):
    """Two roots exactly where D is not below 0: -b -+ sqrt(D), equal where the ray touches."""
    for ray in worked.values():
        for each in ray["spheres"]:
            assert len(each["t"]) == (2 if each["discriminant"] >= 0 else 0)
            if each["t"]:
                half = sqrt(each["discriminant"])
                roots = [-each["b"] - half, -each["b"] + half]
                assert each["t"] == pytest.approx(roots, abs=1e-12)  # D's error over 2 sqrt(D)
