"""A thread's instructions and cycles by the processor's own counters, where Linux gives them: in
many virtual machines it does not."""

from __future__ import annotations

import ctypes
import os
import platform
import struct
import sys
from collections.abc import Callable

SYSCALL = {"x86_64": 298, "aarch64": 241}  # perf_event_open
HARDWARE, CYCLES, INSTRUCTIONS = 0, 0, 1  # linux/perf_event.h
ATTRIBUTES = 112  # bytes of PERF_ATTR_SIZE_VER5
FLAGS_AT, NOT_KERNEL, NOT_HYPERVISOR = 40, 1 << 5, 1 << 6


class NoCounters(OSError):
    """There are none; str() says why."""


def counted(action: Callable[[], object]) -> dict[str, int]:
    """What one call takes: {"cycles", "instructions"}. Raises NoCounters."""
    files = {"cycles": _opened(CYCLES), "instructions": _opened(INSTRUCTIONS)}
    try:
        before = {name: _read(file) for name, file in files.items()}
        action()
        return {name: _read(file) - before[name] for name, file in files.items()}
    finally:
        for file in files.values():
            os.close(file)


def _opened(which: int) -> int:
    number = SYSCALL.get(platform.machine())
    if not sys.platform.startswith("linux") or number is None:
        raise NoCounters(f"{platform.system()} on {platform.machine()} has no such call")
    attributes = bytearray(ATTRIBUTES)
    struct.pack_into("<IIQ", attributes, 0, HARDWARE, ATTRIBUTES, which)
    struct.pack_into("<Q", attributes, FLAGS_AT, NOT_KERNEL | NOT_HYPERVISOR)
    library = ctypes.CDLL(None, use_errno=True)
    given = (ctypes.c_char * ATTRIBUTES).from_buffer(attributes)
    file = int(library.syscall(number, given, 0, -1, -1, 0))
    if file < 0:
        raise NoCounters(f"the system refuses them: {os.strerror(ctypes.get_errno())}")
    return file


def _read(file: int) -> int:
    return int(struct.unpack("<Q", os.read(file, 8))[0])
