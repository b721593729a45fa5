"""Memory that a process keeps between one strip of rays and the next, or hands back."""

from __future__ import annotations

import ctypes
from functools import cache

# glibc's malloc.h: names of what mallopt sets.
TRIM_THRESHOLD, MMAP_THRESHOLD = -1, -3
KEPT = 256 << 20  # bytes at the end of the heap; a scene at 1155 x 1155 frees less than that
TABLE = 1 << 20  # bytes of an array that is handed back as soon as it is freed
LARGE = 32 << 20  # bytes of one array, the most that glibc takes


@cache
def keep_freed_memory() -> bool:
    """Whether freed arrays stay with this process; asked once.

    A strip makes and drops some dozens of arrays of 0.1 to 1 MB. By default glibc hands such memory
    back to the system, which has to clear it page by page when the next strip asks: that takes as
    long as meeting the rays does. Other C libraries have other ways, and stay as they are.
    """
    return _set(MMAP_THRESHOLD, LARGE) and _set(TRIM_THRESHOLD, KEPT)


def hand_back_freed_memory() -> bool:
    """Whether large tables leave this process once they are freed, whatever was freed before.

    By default glibc keeps more and more of them, up to 32 MB each, between others that are still
    used: reading a model then takes a fifth more than all its tables at their peak.
    """
    return _set(MMAP_THRESHOLD, TABLE)


def _set(what: int, value: int) -> bool:
    try:
        libc = ctypes.CDLL(None)
        libc.gnu_get_libc_version  # noqa: B018 - other libraries may mean something else by mallopt
        return bool(libc.mallopt(what, value))
    except (OSError, AttributeError, TypeError):
        return False
