"""Embree's library, as kernels call it (`mesh_packets.py`): float32 triangles in its own tree.

The wheel of embreex carries Intel's library; embreex itself asks it for one ray after the other.
Asked for 16 at a time, with a hint when these run close together, it is three times as fast.
So the few C functions that this takes are named here (Embree's API reference, version 4).
"""

from __future__ import annotations

import ctypes
import weakref
from ctypes import c_char_p, c_int, c_size_t, c_ssize_t, c_uint, c_void_p
from functools import lru_cache
from importlib.metadata import files
from typing import Any, NamedTuple

import numpy as np

# Of rtcore_common.h, rtcore_buffer.h, rtcore_device.h, rtcore_geometry.h and rtcore_scene.h.
TRIANGLES, INDEX_BUFFER, VERTEX_BUFFER, UINT3, FLOAT3 = 0, 0, 1, 0x5003, 0x9003
ROBUST = 4
NATIVE_PACKETS = {16: 34, 8: 33}  # lanes -> the property that says whether a device has them

FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "rtcNewDevice": (c_void_p, [c_char_p]),
    "rtcGetDeviceProperty": (c_ssize_t, [c_void_p, c_int]),
    "rtcGetDeviceError": (c_int, [c_void_p]),
    "rtcNewScene": (c_void_p, [c_void_p]),
    "rtcSetSceneFlags": (None, [c_void_p, c_int]),
    "rtcCommitScene": (None, [c_void_p]),
    "rtcReleaseScene": (None, [c_void_p]),
    "rtcNewGeometry": (c_void_p, [c_void_p, c_int]),
    "rtcSetNewGeometryBuffer": (
        c_void_p, [c_void_p, c_int, c_uint, c_int, c_size_t, c_size_t],
    ),
    "rtcCommitGeometry": (None, [c_void_p]),
    "rtcAttachGeometry": (c_uint, [c_void_p, c_void_p]),
    "rtcReleaseGeometry": (None, [c_void_p]),
}  # fmt: skip


class Query(NamedTuple):
    """What a kernel needs to ask a scene: the C function, the scene, how many rays at a time."""

    function: int
    scene: int
    lanes: int


class EmbreeScene:
    """Triangles (m, 3, 3) float32 in Embree's tree, as long as this object lives."""

    def __init__(self, triangles: np.ndarray):
        library = _library()
        scene = library.rtcNewScene(_device())
        weakref.finalize(self, library.rtcReleaseScene, scene)
        library.rtcSetSceneFlags(scene, ROBUST)
        geometry = library.rtcNewGeometry(_device(), TRIANGLES)
        count = len(triangles)
        for kind, form, rows in (
            (VERTEX_BUFFER, FLOAT3, triangles.reshape(-1, 3).astype(np.float32, copy=False)),
            (INDEX_BUFFER, UINT3, np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)),
        ):
            room = library.rtcSetNewGeometryBuffer(geometry, kind, 0, form, 12, len(rows))
            _refuse_error("no memory for a mesh")
            ctypes.memmove(room, np.ascontiguousarray(rows).ctypes.data, rows.nbytes)
        library.rtcCommitGeometry(geometry)
        library.rtcAttachGeometry(scene, geometry)
        library.rtcReleaseGeometry(geometry)
        library.rtcCommitScene(scene)
        _refuse_error("a mesh's tree could not be built")
        lanes = _lanes()
        function = ctypes.cast(getattr(library, f"rtcIntersect{lanes}"), c_void_p).value
        assert function is not None
        self.query = Query(function, scene, lanes)


@lru_cache(maxsize=1)
def _library() -> ctypes.CDLL:
    """The library in embreex's wheel, its functions with their types."""
    import embreex  # whose wheel it is: a mesh's trace is made anew with another

    found = [file for file in files("embreex") or [] if "embree4" in file.name]
    if len(found) != 1:
        raise RuntimeError(f"embreex {embreex.__name__} holds {len(found)} libraries of Embree 4")
    library = ctypes.CDLL(str(found[0].locate()))
    for name, (result, arguments) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


@lru_cache(maxsize=1)
def _device() -> int:
    """One for the process, kept to its end."""
    device = _library().rtcNewDevice(None)
    if not device:
        raise RuntimeError("Embree does not run on this processor")
    return int(device)


def _lanes() -> int:
    """As many rays at a time as this processor has lanes for: others are asked one by one."""
    for lanes, asked in NATIVE_PACKETS.items():
        if _library().rtcGetDeviceProperty(_device(), asked):
            return lanes
    return 4


def _refuse_error(what: str) -> None:
    code = _library().rtcGetDeviceError(_device())
    if code:
        raise RuntimeError(f"Embree: {what} (error {code})")
