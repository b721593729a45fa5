"""Sums and products carry their errors exactly: fractions are the truth."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from raywalk.geometry.along_ray import point_along, product_error, sharp_product, sum_error

HALF_A_DIGIT = 2.0**-53  # of a float64's own size: what its rounding leaves open
# What is left of errors that are summed in float64 themselves: some 20 roundings of roundings.
SECOND_ORDER = 20 * HALF_A_DIGIT**2


def numbers(rng: np.random.Generator, *shape: int) -> np.ndarray:
    """Of both signs, over 24 powers of 2."""
    return rng.normal(size=shape) * 2.0 ** rng.integers(-12, 12, shape)


def assert_rounded_once(found: float, true: Fraction, terms: Fraction) -> None:
    """terms: the sum of the sizes of what cancels."""
    slack = HALF_A_DIGIT * abs(true) * (1 + Fraction(1, 1000)) + Fraction(SECOND_ORDER) * terms
    assert abs(Fraction(found) - true) <= slack


def test_a_sum_or_product_and_its_error_are_exact(rng: np.random.Generator) -> None:
    """To the last bit, 1000 pairs of any sizes."""
    for a, b in numbers(rng, 1000, 2).tolist():
        assert Fraction(a) + Fraction(b) == Fraction(a + b) + Fraction(sum_error(a, b, a + b))
        assert Fraction(a) * Fraction(b) == Fraction(a * b) + Fraction(product_error(a, b, a * b))


def test_a_point_beside_a_far_centre_is_rounded_once(rng: np.random.Generator) -> None:
    """o + t d - (c + rest), where all but the last few digits cancel."""
    for _ in range(300):
        c, d = rng.normal(size=(2, 3)) * 1000.0
        t, off, rest = rng.random(), rng.normal(size=3) * 1e-9, rng.normal(size=3) * 1e-14
        o = c - t * d + off
        found = point_along(*o, *d, t, *c, *rest)
        for k in range(3):
            terms = [
                Fraction(o[k]),
                Fraction(t) * Fraction(d[k]),
                -Fraction(c[k]),
                -Fraction(rest[k]),
            ]
            assert_rounded_once(
                found[k], sum(terms, Fraction(0)), sum(map(abs, terms), Fraction(0))
            )


def test_a_row_that_cancels_is_rounded_once(rng: np.random.Generator) -> None:
    """Matrix and rest times a vector that is all but at right angles to each row."""
    for _ in range(300):
        vector = rng.normal(size=3)
        matrix = rng.normal(size=(2, 3, 3))
        matrix[1, :, 2] = -(matrix[1, :, :2] @ vector[:2]) / vector[2]
        rest = matrix * rng.uniform(-1.0, 1.0, (2, 3, 3)) * HALF_A_DIGIT
        found = sharp_product(matrix, rest, 1, *vector)
        for r in range(3):
            terms = [
                (Fraction(matrix[1, r, j]) + Fraction(rest[1, r, j])) * Fraction(vector[j])
                for j in range(3)
            ]
            assert_rounded_once(
                found[r], sum(terms, Fraction(0)), sum(map(abs, terms), Fraction(0))
            )
