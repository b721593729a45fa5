"""Where rays go on from mirrors and glass, and with what share of the colour."""

from __future__ import annotations

import numpy as np

from raywalk.optics.compiled import kernel
from raywalk.optics.reflection import (
    fresnel_reflectance,
    reflect,
    refract,
    sine_squared_beyond,
)


@kernel
def mirror_directions(direction, normal, geometric):
    """(n, 3) reflected directions, always to the outer side of the geometric surface.

    Where an interpolated normal would send a ray into the surface, the surface's own
    normal mirrors it.
    """
    out = np.empty_like(direction)
    for i in range(direction.shape[0]):
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        gx, gy, gz = geometric[i, 0], geometric[i, 1], geometric[i, 2]
        x, y, z = reflect(dx, dy, dz, normal[i, 0], normal[i, 1], normal[i, 2])
        if x * gx + y * gy + z * gz <= 0.0:
            x, y, z = reflect(dx, dy, dz, gx, gy, gz)
        out[i, 0], out[i, 1], out[i, 2] = x, y, z
    return out


@kernel
def refracted_directions(direction, normal, geometric, n_from, n_to):
    """(n, 3) refracted directions into the surface; n_from, n_to: (n,) indices of refraction."""
    out = np.empty_like(direction)
    for i in range(direction.shape[0]):
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        gx, gy, gz = geometric[i, 0], geometric[i, 1], geometric[i, 2]
        nx, ny, nz = normal[i, 0], normal[i, 1], normal[i, 2]
        x, y, z = refract(dx, dy, dz, nx, ny, nz, n_from[i], n_to[i])
        if x * gx + y * gy + z * gz >= 0.0:
            x, y, z = refract(dx, dy, dz, gx, gy, gz, n_from[i], n_to[i])
        out[i, 0], out[i, 1], out[i, 2] = x, y, z
    return out


@kernel
def glass_shares(direction, normal, n_from, n_to, reflect_share, transmit_share, fresnel):
    """Shares of the reflected and of the refracted ray, and whether reflection is total.

    All (n,). Total reflection moves the whole refracted share to the reflected ray; with
    `fresnel` the exact unpolarised reflectance splits the sum of both.
    """
    count = direction.shape[0]
    reflected, refracted = np.empty(count), np.empty(count)
    total = np.empty(count, np.bool_)
    for i in range(count):
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        nx, ny, nz = normal[i, 0], normal[i, 1], normal[i, 2]
        both = reflect_share[i] + transmit_share[i]
        sine_sq = sine_squared_beyond(dx, dy, dz, nx, ny, nz, n_from[i], n_to[i])
        total[i] = sine_sq > 1.0
        if total[i]:
            reflected[i], refracted[i] = both, 0.0
        elif fresnel[i]:
            cos_in = -(dx * nx + dy * ny + dz * nz)
            share = fresnel_reflectance(cos_in, np.sqrt(1.0 - sine_sq), n_from[i], n_to[i])
            reflected[i], refracted[i] = both * share, both * (1.0 - share)
        else:
            reflected[i], refracted[i] = reflect_share[i], transmit_share[i]
    return reflected, refracted, total
