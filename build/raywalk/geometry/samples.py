"""Points all over a shape's surface, and whether points lie on it: for warnings, which ask many."""

from __future__ import annotations

import math

import numpy as np

from raywalk.geometry.faces import (
    BOX,
    CYLINDER,
    DISC,
    PLANE,
    SPHERE,
    TRIANGLE,
    TUBE,
    face_normal,
    height,
    is_near,
    is_solid,
    side_width,
)
from raywalk.geometry.roots import to_local
from raywalk.geometry.solids import solid_interval
from raywalk.optics.compiled import kernel

SAMPLES = 400  # a surface: what two share by less than a few hundredths of both may be missed
# As a share of the coordinates' sizes: surfaces this close are one to a person, and to the tracer
# from a little further away.
CLOSE = 1e-9
PARALLEL = 1.0 - 1e-9  # cosine from which two surfaces face one way
MARGIN = 1.0 - 1e-6  # canonical coordinates beyond belong to an edge
# A surface that is smooth all over is another one wholly or nowhere: a few points tell.
FEW = 4


@kernel
def canonical_sample(shape, k):
    """Canonical point k of a surface, well inside its faces; none is of an endless plane.

    At irregular places (R2 sequence: Roberts, The Unreasonable Effectiveness of Quasirandom
    Sequences, 2018).
    """
    u, v = ((k + 1) * 0.7548776662466927) % 1.0, ((k + 1) * 0.5698402909980532) % 1.0
    if shape.code == TRIANGLE:
        return (1.0 - u, 1.0 - v, 0.0) if u + v > 1.0 else (u, v, 0.0)
    angle = 2.0 * math.pi * v
    if shape.code == DISC:
        radius = math.sqrt(u)
        return radius * math.cos(angle), radius * math.sin(angle), 0.0
    z = 2.0 * u - 1.0
    if shape.code == TUBE:
        width = side_width(shape, z)
        return width * math.cos(angle), width * math.sin(angle), z
    ring = math.sqrt(1.0 - z * z)
    x, y = ring * math.cos(angle), ring * math.sin(angle)
    _, reach = solid_interval(shape, 0.0, 0.0, 0.0, x, y, z)
    return reach * x, reach * y, reach * z


@kernel
def canonical_normal(shape, x, y, z):
    """Outward, of any length; of a flat shape, whichever way it faces."""
    if shape.code == PLANE:
        return 0.0, 1.0, 0.0
    if shape.code == DISC or shape.code == TRIANGLE:
        return 0.0, 0.0, 1.0
    return face_normal(shape, x, y, z)


@kernel
def world_normal(primitives, row, x, y, z):
    """The unit outward normal at a canonical surface point."""
    nx, ny, nz = canonical_normal(primitives.shape[row], x, y, z)
    m = primitives.to_local[row]
    ax = nx * m[0, 0] + ny * m[1, 0] + nz * m[2, 0]
    ay = nx * m[0, 1] + ny * m[1, 1] + nz * m[2, 1]
    az = nx * m[0, 2] + ny * m[1, 2] + nz * m[2, 2]
    length = math.sqrt(ax * ax + ay * ay + az * az)
    return ax / length, ay / length, az / length


@kernel
def world_samples(primitives, row, count):
    """(count, 3) points of a row's surface and their unit outward normals."""
    point, normal = np.empty((count, 3)), np.empty((count, 3))
    for k in range(count):
        x, y, z = canonical_sample(primitives.shape[row], k)
        wx, wy, wz = to_local(primitives.to_world[row], x, y, z)
        point[k, 0] = primitives.centre[row, 0] + wx
        point[k, 1] = primitives.centre[row, 1] + wy
        point[k, 2] = primitives.centre[row, 2] + wz
        normal[k, 0], normal[k, 1], normal[k, 2] = world_normal(primitives, row, x, y, z)
    return point, normal


@kernel
def middles(primitives, count):
    """(p, 3) the mean of some points of each row's surface; a plane's centre."""
    out = primitives.centre.copy()
    for row in range(len(out)):
        if primitives.shape[row].code != PLANE:
            point, _ = world_samples(primitives, row, count)
            for axis in range(3):
                out[row, axis] = point[:, axis].mean()
    return out


@kernel
def is_on(primitives, row, px, py, pz):
    """Whether a world point lies on a row's surface, but not at its edges; and the point there in
    canonical coordinates."""
    shape, m, c = primitives.shape[row], primitives.to_local[row], primitives.centre[row]
    x, y, z = to_local(m, px - c[0], py - c[1], pz - c[2])
    size = abs(px) + abs(py) + abs(pz) + abs(c[0]) + abs(c[1]) + abs(c[2])
    for i in range(3):  # np.abs(..).max() makes an array at every call
        for j in range(3):
            size = max(size, abs(primitives.to_world[row, i, j]))
    near = is_near(shape, x, y, z, CLOSE * primitives.stretch[row] * size)
    if shape.code == DISC:
        near = near and x * x + y * y < MARGIN
    elif shape.code == TRIANGLE:
        near = near and min(x, min(y, 1.0 - x - y)) > 1.0 - MARGIN
    elif shape.code == TUBE:
        near = near and abs(z) < MARGIN
    return near, x, y, z


@kernel
def points_on(primitives, row, points):
    """Which of (n, 3) world points lie on a row's surface, (n,) bool, and its unit outward normal
    there (n, 3)."""
    on, normal = np.zeros(len(points), np.bool_), np.zeros((len(points), 3))
    for i in range(len(points)):
        on[i], x, y, z = is_on(primitives, row, points[i, 0], points[i, 1], points[i, 2])
        if on[i]:
            normal[i, 0], normal[i, 1], normal[i, 2] = world_normal(primitives, row, x, y, z)
    return on, normal


@kernel
def rows_under(primitives, x, y, z):
    """(p,) bool: on which rows' surfaces a world point lies."""
    out = np.zeros(len(primitives.shape), np.bool_)
    for row in range(len(out)):
        out[row] = is_on(primitives, row, x, y, z)[0]
    return out


@kernel
def canonical_samples(shape, out):
    """Writes the first points of a surface to out (n, 3)."""
    for k in range(len(out)):
        out[k, 0], out[k, 1], out[k, 2] = canonical_sample(shape, k)


@kernel
def lies_in(primitives, samples, one, other):
    """Whether a part of row one's surface lies in row other's, the same way round; surfaces that
    are open face both ways. samples: (SAMPLES, 3) canonical points of row one's."""
    shape, facing = primitives.shape[one], primitives.shape[other]
    if shape.code == PLANE:
        return False
    both = not (is_solid(shape) and (is_solid(facing) or facing.code == PLANE))
    count = FEW if shape.code == SPHERE and facing.code == SPHERE else SAMPLES
    for k in range(count):
        x, y, z = samples[k, 0], samples[k, 1], samples[k, 2]
        wx, wy, wz = to_local(primitives.to_world[one], x, y, z)
        c = primitives.centre[one]
        near, lx, ly, lz = is_on(primitives, other, c[0] + wx, c[1] + wy, c[2] + wz)
        if near:
            ax, ay, az = world_normal(primitives, one, x, y, z)
            bx, by, bz = world_normal(primitives, other, lx, ly, lz)
            cosine = ax * bx + ay * by + az * bz
            if (abs(cosine) if both else cosine) > PARALLEL:
                return True
    return False


@kernel
def faces_of(primitives):
    """(p, 6, 4) the planes that each row has faces in, unit normal and level, and their numbers
    (p,): of those without any, of what is round alone, it is 0."""
    count = len(primitives.shape)
    planes, number = np.zeros((count, 6, 4)), np.zeros(count, np.int64)
    for row in range(count):
        code = primitives.shape[row].code
        if code == SPHERE or code == TUBE:
            continue
        for axis in range(3):
            if code != BOX and axis != (1 if code == PLANE else 2):
                continue
            n = primitives.to_local[row, axis]
            length = math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
            c = primitives.centre[row]
            middle = (n[0] * c[0] + n[1] * c[1] + n[2] * c[2]) / length
            for sign in (-1.0, 1.0):
                is_flat_shape = code != BOX and code != CYLINDER
                if is_flat_shape and sign < 0.0:
                    continue
                at = number[row]
                planes[row, at, :3] = n / length
                planes[row, at, 3] = middle + (0.0 if is_flat_shape else sign / length)
                number[row] += 1
    return planes, number


# Levels of one plane, by two objects far from the origin, as a share of their sizes.
ONE_PLANE = 1e-6


@kernel
def may_share(primitives, planes, number, sizes, one, other):
    """Whether two rows are curved alike or have faces in one plane: nothing else can coincide.

    sizes: (p,) how large the coordinates of a row's points are.
    """
    a, b = primitives.shape[one].code, primitives.shape[other].code
    if a == SPHERE or b == SPHERE:
        return a == b
    if (a == TUBE or a == CYLINDER) and (b == TUBE or b == CYLINDER):
        return True
    bound = ONE_PLANE * max(sizes[one], sizes[other])
    for i in range(number[one]):
        for j in range(number[other]):
            cosine = 0.0
            for axis in range(3):
                cosine += planes[one, i, axis] * planes[other, j, axis]
            sign = 1.0 if cosine > 0.0 else -1.0
            apart = planes[one, i, 3] - sign * planes[other, j, 3]
            if sign * cosine > 1.0 - ONE_PLANE and abs(apart) <= bound:
                return True
    return False


@kernel
def which_share(primitives, planes, number, sizes, pairs, most):
    """(m,) bool: of which pairs of rows a part of their surfaces is one; and how many pairs were
    looked at, up to `most` closely."""
    out = np.zeros(len(pairs), np.bool_)
    asked = 0
    # Points of the last pair's surfaces, which the next one's often are alike.
    samples, codes, tips = np.empty((2, SAMPLES, 3)), np.full(2, -1), np.zeros(2)
    for k in range(len(pairs)):
        one, other = pairs[k, 0], pairs[k, 1]
        if not may_share(primitives, planes, number, sizes, one, other):
            continue
        if asked == most:
            return out, k
        asked += 1
        for way in range(2):
            row = pairs[k, way]
            shape = primitives.shape[row]
            if shape.code != PLANE and (codes[way] != shape.code or tips[way] != shape.tip):
                canonical_samples(shape, samples[way])
                codes[way], tips[way] = shape.code, shape.tip
            out[k] = out[k] or lies_in(primitives, samples[way], row, pairs[k, 1 - way])
    return out, len(pairs)


@kernel
def which_cut(primitives, away, pairs, touching):
    """(m,) bool: of which pairs of rows, solids or planes, one's surface lies partly in the other.

    away: (n, 3) directions from a body's centre to points of its surface.
    touching: closer to a surface than this, in shares of its body's size, is on it.
    """
    out = np.zeros(len(pairs), np.bool_)
    for k in range(len(pairs)):
        for way in range(2):
            one, other = pairs[k, way], pairs[k, 1 - way]
            shape = primitives.shape[one]
            if shape.code == PLANE:
                continue
            within = beyond = False
            for i in range(len(away)):
                x, y, z = away[i, 0], away[i, 1], away[i, 2]
                _, reach = solid_interval(shape, 0.0, 0.0, 0.0, x, y, z)
                wx, wy, wz = to_local(primitives.to_world[one], reach * x, reach * y, reach * z)
                level = level_over(
                    primitives, other,
                    primitives.centre[one, 0] + wx,
                    primitives.centre[one, 1] + wy,
                    primitives.centre[one, 2] + wz,
                )  # fmt: skip
                within = within or level < -touching
                beyond = beyond or level > touching
            out[k] = out[k] or (within and beyond)
    return out


@kernel
def level_over(primitives, row, px, py, pz):
    """How far a world point is outside of a solid, about in shares of its size; over a plane."""
    c = primitives.centre[row]
    x, y, z = to_local(primitives.to_local[row], px - c[0], py - c[1], pz - c[2])
    if primitives.shape[row].code == PLANE:
        return y
    return height(primitives.shape[row], x, y, z)
