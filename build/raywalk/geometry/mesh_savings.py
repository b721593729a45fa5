"""Counts the rays that never ask a mesh: not needed for tracing, but a lesson."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.bvh import box_entry
from raywalk.geometry.triangle import vector
from raywalk.optics.compiled import kernel


@kernel
def goes_past_box(bvh, local, direction, t_max):
    """Which of n rays do not meet a mesh's box before t_max (n,): (n,) bool.

    local, direction: (n, 3); origins relative to the mesh's centre.
    """
    past = np.empty(local.shape[0], np.bool_)
    for i in range(local.shape[0]):
        o, d = vector(local, i), vector(direction, i)
        past[i] = not box_entry(bvh.low, bvh.high, 0, o, d, t_max[i]) < t_max[i]
    return past
