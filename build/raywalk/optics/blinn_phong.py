"""Blinn-Phong lighting factors of one point and one light, without colours or shadows.

Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977:
the highlight is the cosine between normal and half vector, to the power of shininess.
"""

from __future__ import annotations

import math

from raywalk.optics.compiled import kernel

BRIGHTEST = 1e300  # times any sum of colours it stays finite


@kernel
def strength(distance, intensity, a0, a1, a2):
    """Light at a distance: intensity / (a0 + a1 D + a2 D^2); 0 where that divides by 0.

    Never infinite, as infinity times a black colour is no number.
    """
    falloff = a0 + a1 * distance + a2 * distance * distance
    return min(intensity / falloff, BRIGHTEST) if falloff > 0.0 else 0.0


@kernel
def diffuse_cosine(nx, ny, nz, lx, ly, lz):
    """max(0, n.l), for unit vectors."""
    return max(0.0, nx * lx + ny * ly + nz * lz)


@kernel
def highlight(nx, ny, nz, lx, ly, lz, ex, ey, ez, shininess):
    """max(0, n.h)^s with h = normalize(l + e); e points to where the ray came from."""
    hx, hy, hz = lx + ex, ly + ey, lz + ez
    length = math.sqrt(hx * hx + hy * hy + hz * hz)
    if length == 0.0:  # light straight behind the surface as seen along the ray
        return 0.0
    cosine = (nx * hx + ny * hy + nz * hz) / length
    return cosine**shininess if cosine > 0.0 else 0.0
