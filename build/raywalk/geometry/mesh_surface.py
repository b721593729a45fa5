"""Where rays met a mesh: point, normals, side."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.triangle import triangle_normal, vector
from raywalk.optics.compiled import lean


@lean
def mesh_surface(
    corners, rows, normals, centre, direction, met, index, triangle, uv,
    point, normal, geometric, inside,
):  # fmt: skip
    """Fills point, shading normal, geometric normal and side of rays that met object `index`.

    Both normals face the incoming ray; the side is the geometric one's. An interpolated
    normal that still looks away at a silhouette is bent back until it is square to the ray.
    normals: (n, 3), or (0, 3) for a flat mesh; rows: (f, 3) of its corners' normals.
    """
    for i in range(direction.shape[0]):
        if met[i] != index:
            continue
        k, u, v = triangle[i], uv[i, 0], uv[i, 1]
        w = 1.0 - u - v
        for c in range(3):
            mean = w * corners[k, 0, c] + u * corners[k, 1, c] + v * corners[k, 2, c]
            point[i, c] = centre[c] + mean
        gx, gy, gz = triangle_normal(corners, k)
        d = vector(direction, i)
        inside[i] = gx * d[0] + gy * d[1] + gz * d[2] > 0.0
        sign = -1.0 if inside[i] else 1.0
        geometric[i, 0], geometric[i, 1], geometric[i, 2] = sign * gx, sign * gy, sign * gz
        nx, ny, nz = sign * gx, sign * gy, sign * gz
        if normals.shape[0] > 0:
            nx, ny, nz = smooth_normal(normals, rows, k, u, v, sign, d, nx, ny, nz)
        normal[i, 0], normal[i, 1], normal[i, 2] = nx, ny, nz


@lean
def smooth_normal(normals, rows, k, u, v, sign, d, gx, gy, gz):
    """Unit interpolated normal on the ray's side; the geometric one g where that has no length."""
    a, b, c, w = rows[k, 0], rows[k, 1], rows[k, 2], 1.0 - u - v
    x = sign * (w * normals[a, 0] + u * normals[b, 0] + v * normals[c, 0])
    y = sign * (w * normals[a, 1] + u * normals[b, 1] + v * normals[c, 1])
    z = sign * (w * normals[a, 2] + u * normals[b, 2] + v * normals[c, 2])
    away = x * d[0] + y * d[1] + z * d[2]
    if away > 0.0:
        x, y, z = x - away * d[0], y - away * d[1], z - away * d[2]
    length = np.sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length) if length > 0.0 else (gx, gy, gz)
