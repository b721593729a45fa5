"""Where float64 is not sure whether a ray meets a triangle: decided exactly, in the world.

Objects share corners in the world, not in the coordinates in which each is met fastest.
"""

from __future__ import annotations

import math

from raywalk.geometry.exact_edges import edge_side
from raywalk.optics.compiled import lean

# Places of sizes between this and its inverse need no scaling: their cubes, errors of errors of
# these included, are in range.
FINE = 1e-30


@lean
def exact_hit(o, d, a, a_rest, b, b_rest, c, c_rest, known, error):
    """(t, u, v) with point = (1-u-v) a + u b + v c; t is inf where the ray's line misses.

    Three numbers each; world; the rests are what the corners' float64 leaves over. Either side
    hits, edges count as inside, a line in the triangle's plane misses: as rationals have it.
    known: d . ((b - o) x (c - o)) and so on round the triangle, which are off by `error` at most:
    those that are larger are not worked out again.
    """
    # By a power of two, which rounds nothing: products of three must not leave float64's range.
    away, scale = max(farthest(o, a), max(farthest(o, b), farthest(o, c))), 1.0
    if not FINE < away < 1.0 / FINE:
        scale = math.ldexp(1.0, -math.frexp(away)[1])
    wa, wb, wc = scaled(scaled(known, scale), scale)
    if abs(known[0]) <= error or abs(known[1]) <= error or abs(known[2]) <= error:
        start, p, p_rest = scaled(o, scale), scaled(a, scale), scaled(a_rest, scale)
        q, q_rest = scaled(b, scale), scaled(b_rest, scale)
        r, r_rest = scaled(c, scale), scaled(c_rest, scale)
        sense = surely(known[0], error) + surely(known[1], error) + surely(known[2], error)
        if abs(known[0]) <= error:
            wa = edge_side(start, d, q, q_rest, r, r_rest)
        if sense * wa < 0.0:
            return math.inf, 0.0, 0.0
        if abs(known[1]) <= error:
            wb = edge_side(start, d, r, r_rest, p, p_rest)
        if sense * wb < 0.0:
            return math.inf, 0.0, 0.0
        if abs(known[2]) <= error:
            wc = edge_side(start, d, p, p_rest, q, q_rest)
    if (wa < 0.0 or wb < 0.0 or wc < 0.0) and (wa > 0.0 or wb > 0.0 or wc > 0.0):
        return math.inf, 0.0, 0.0
    total = wa + wb + wc
    if total == 0.0:
        return math.inf, 0.0, 0.0
    u, v, w = wb / total, wc / total, wa / total
    # Along the axis that the ray runs along most.
    x, y, z = abs(d[0]), abs(d[1]), abs(d[2])
    k = 0 if x >= y and x >= z else (1 if y >= z else 2)
    ahead = w * (a[k] - o[k] + a_rest[k]) + u * (b[k] - o[k] + b_rest[k])
    return (ahead + v * (c[k] - o[k] + c_rest[k])) / d[k], u, v


@lean
def surely(known, error):
    """Its sign, or 0 if that is not sure."""
    return math.copysign(1.0, known) if abs(known) > error else 0.0


@lean
def farthest(o, p):
    """Largest coordinate of p - o."""
    return max(abs(p[0] - o[0]), max(abs(p[1] - o[1]), abs(p[2] - o[2])))


@lean
def scaled(p, by):
    """Three numbers, each times the same."""
    return by * p[0], by * p[1], by * p[2]
