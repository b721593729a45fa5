"""Families of rays, each from its own seed."""

from __future__ import annotations

import numpy as np

Pair = tuple[np.ndarray, np.ndarray]  # origins and directions, (n, 3) float64 each


def unit_rows(rows: np.ndarray) -> np.ndarray:
    """Each row divided by its length."""
    return np.asarray(rows / np.sqrt((rows**2).sum(axis=1, keepdims=True)))


def directions(rng: np.random.Generator, count: int) -> np.ndarray:
    """(n, 3) evenly over the unit sphere."""
    return unit_rows(rng.normal(size=(count, 3)))


def in_ball(rng: np.random.Generator, count: int) -> np.ndarray:
    """(n, 3) evenly in the unit ball."""
    return directions(rng, count) * np.cbrt(rng.uniform(size=(count, 1)))


def towards(origin: np.ndarray, target: np.ndarray) -> Pair:
    """Rays from points to points; directions of unit length."""
    return origin, unit_rows(target - origin)


def around(rng: np.random.Generator, count: int, distance: float = 5.0, aim: float = 1.1) -> Pair:
    """From a sphere of this radius to points in a ball round the origin: hits and misses."""
    return towards(distance * directions(rng, count), aim * in_ball(rng, count))


def incoherent(rng: np.random.Generator, count: int, reach: float = 3.0) -> Pair:
    """From anywhere in a ball to anywhere: what mirrors and glass make of camera rays."""
    return reach * in_ball(rng, count), directions(rng, count)


def coherent(side: int, eye: tuple[float, float, float], spread: float) -> Pair:
    """A camera's rays, row by row, looking along -z; spread is the tangent of half the view."""
    along = spread * (2.0 * (np.arange(side) + 0.5) / side - 1.0)
    x, y = np.meshgrid(along, -along)
    aim = np.stack([x.ravel(), y.ravel(), -np.ones(side * side)], axis=1)
    return np.tile(np.array(eye), (side * side, 1)), unit_rows(aim)


def axis_parallel(rng: np.random.Generator, count: int, distance: float = 5.0) -> Pair:
    """Along +-x, +-y, +-z: two components of the direction are exactly zero."""
    axis, sign = rng.integers(0, 3, count), rng.choice([-1.0, 1.0], count)
    rows = np.arange(count)
    direction, origin = np.zeros((count, 3)), rng.uniform(-1.2, 1.2, (count, 3))
    direction[rows, axis] = sign
    origin[rows, axis] = -distance * sign
    return origin, direction


def from_inside(rng: np.random.Generator, count: int, reach: float = 0.4) -> Pair:
    """From inside a ball, in all directions."""
    return reach * in_ball(rng, count), directions(rng, count)


def perpendicular(rng: np.random.Generator, axis: np.ndarray) -> np.ndarray:
    """(n, 3) unit rows square to the given unit rows, at random angles about them."""
    other = directions(rng, len(axis))
    return unit_rows(other - (other * axis).sum(axis=1, keepdims=True) * axis)


def grazing(rng: np.random.Generator, count: int, nearest: float = 1e-9) -> Pair:
    """Past the unit sphere's silhouette, inside and outside, by 1e-1 down to `nearest`."""
    direction = directions(rng, count)
    off = perpendicular(rng, direction)
    miss = 10.0 ** rng.uniform(np.log10(nearest), -1.0, count) * rng.choice([-1.0, 1.0], count)
    return off * (1.0 + miss[:, None]) - 4.0 * direction, direction
