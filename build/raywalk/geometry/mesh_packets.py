"""Packets of rays for Embree: 4, 8 or 16 side by side, as many as the processor has lanes for.

A packet is a table (ROWS, lanes) float32 laid out as Embree's RTCRayHit16, 8 or 4.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from raywalk.optics.compiled import kernel, lean

# Rows: where rays start (three), go (three) and end; what they meet, of which we ask one.
ORIGIN, NEAREST, TOWARD, TIME, FARTHEST, MASK, ID, FLAGS = 0, 3, 4, 7, 8, 9, 10, 11
TRIANGLE, GEOMETRY, ROWS = 17, 18, 21
COHERENT = 1 << 16  # RTC_RAY_QUERY_FLAG_COHERENT
ALIGNED = 64  # bytes, for 16 lanes of float32


def _typed(context: Any, function: Any, valid: Any, scene: Any, rays: Any, how: Any) -> Any:
    """A C function of four addresses, by its own address: numba keeps no others in its cache."""

    def written(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        address = ir.IntType(64)
        kind = ir.FunctionType(ir.VoidType(), [address] * 4)
        builder.call(builder.inttoptr(values[0], kind.as_pointer()), values[1:])
        return context.get_dummy_value()

    return types.void(*[types.intp] * 5), written


call: Any = intrinsic(_typed)


@kernel
def aligned(count):
    """(count,) float32, not set, at an address that packets may have."""
    room = np.empty(count + ALIGNED // 4, np.float32)
    skip = (-np.int64(room.ctypes.data) % ALIGNED) // 4
    return room[skip : skip + count]


@kernel
def new_packet(lanes):
    """A packet (ROWS, lanes) of which origin and direction are left to fill in; which lanes
    hold a ray (lanes,) int32; RTCIntersectArguments (16,) int32."""
    rays = aligned(ROWS * lanes).reshape(ROWS, lanes)
    words = rays.view(np.int32)
    for lane in range(lanes):
        rays[NEAREST, lane] = rays[TIME, lane] = 0.0
        words[MASK, lane], words[ID, lane], words[FLAGS, lane] = -1, 0, 0
    how = aligned(16).view(np.int32)
    for k in range(16):
        how[k] = 0
    how[1] = -1  # RTC_FEATURE_FLAG_ALL
    return rays, aligned(lanes).view(np.int32), how


@lean
def ask(query, rays, valid, how, filled, bundle):
    """Fills TRIANGLE of the packet's first rays; GEOMETRY stays -1 of those that meet nothing.

    Rays whose starts and directions, together, spread less than `bundle` go down the tree together.
    """
    words = rays.view(np.int32)
    for lane in range(query.lanes):
        valid[lane] = -1 if lane < filled else 0
        rays[FARTHEST, lane] = np.inf  # where the last one met
        words[GEOMETRY, lane] = -1
    how[0] = COHERENT if spread(rays, filled) < bundle else 0
    call(query.function, valid.ctypes.data, query.scene, rays.ctypes.data, how.ctypes.data)


@lean
def spread(rays, filled):
    """How far the rays' starts and directions lie apart: along each axis, summed."""
    total = np.float32(0.0)
    for k in range(3):
        for row in (ORIGIN + k, TOWARD + k):
            low = high = rays[row, 0]
            for lane in range(1, filled):
                low, high = min(low, rays[row, lane]), max(high, rays[row, lane])
            total += high - low
    return total
