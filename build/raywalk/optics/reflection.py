"""Mirror reflection, refraction and the Fresnel reflectance of one ray at one surface.

Vectors are three scalars, so that numba keeps them in registers. `direction` is unit
and points along the ray, `normal` is unit and faces the incoming ray (d.n <= 0).
"""

from __future__ import annotations

import math

from raywalk.optics.compiled import kernel


@kernel
def reflect(dx, dy, dz, nx, ny, nz):
    """Unit mirror direction d - 2 (d.n) n, renormalised so that 1000 bounces stay unit."""
    twice = 2.0 * (dx * nx + dy * ny + dz * nz)
    rx, ry, rz = dx - twice * nx, dy - twice * ny, dz - twice * nz
    length = math.sqrt(rx * rx + ry * ry + rz * rz)
    return rx / length, ry / length, rz / length


@kernel
def sine_squared_beyond(dx, dy, dz, nx, ny, nz, n_from, n_to):
    """sin^2 of the refracted angle by Snell; above 1 the ray is totally reflected.

    sin^2 comes from |d x n|^2, not 1 - cos^2: near the critical angle the latter would
    cost half the digits at grazing incidence.
    """
    cx = dy * nz - dz * ny
    cy = dz * nx - dx * nz
    cz = dx * ny - dy * nx
    ratio = n_from / n_to
    return ratio * ratio * (cx * cx + cy * cy + cz * cz)


@kernel
def refract(dx, dy, dz, nx, ny, nz, n_from, n_to):
    """Unit refracted direction (Glassner, An Introduction to Ray Tracing, 1989, ch. 2).

    Only for rays that are not totally reflected: ask sine_squared_beyond first.
    """
    ratio = n_from / n_to
    cos_in = -(dx * nx + dy * ny + dz * nz)
    sine_sq = sine_squared_beyond(dx, dy, dz, nx, ny, nz, n_from, n_to)
    cos_out = math.sqrt(max(0.0, 1.0 - sine_sq))
    # Tangent and normal parts apart: the tangent is d + cos n, shortened by the ratio.
    rx = ratio * (dx + cos_in * nx) - cos_out * nx
    ry = ratio * (dy + cos_in * ny) - cos_out * ny
    rz = ratio * (dz + cos_in * nz) - cos_out * nz
    length = math.sqrt(rx * rx + ry * ry + rz * rz)
    return rx / length, ry / length, rz / length


@kernel
def fresnel_reflectance(cos_in, cos_out, n_from, n_to):
    """Exact share of unpolarised light that a dielectric border reflects (0..1).

    cos_in, cos_out: cosines of the angles of incidence and refraction. Born and Wolf,
    Principles of Optics, 7th ed., sec. 1.5.2, mean of equations (21a) and (21b) squared.
    At grazing incidence, where both would be 0 / 0 between equal indices, it is 1.
    """
    if cos_in <= 0.0:
        return 1.0
    across = (n_from * cos_in - n_to * cos_out) / (n_from * cos_in + n_to * cos_out)
    along = (n_to * cos_in - n_from * cos_out) / (n_to * cos_in + n_from * cos_out)
    return 0.5 * (across * across + along * along)
