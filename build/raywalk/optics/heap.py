"""Memory that a process keeps between one strip of rays and the next."""

from __future__ import annotations

import ctypes
from functools import cache

# glibc's malloc.h: names of what mallopt sets.
TRIM_THRESHOLD, MMAP_THRESHOLD = -1, -3
KEPT = 256 << 20  # bytes at the end of the heap; a scene at 1155 x 1155 frees less than that
LARGE = 32 << 20  # bytes of one array, the most that glibc takes


@cache
def keep_freed_memory() -> bool:
    """Whether freed arrays stay with this process; asked once.

    A strip makes and drops some dozens of arrays of 0.1 to 1 MB. By default glibc hands such memory
    back to the system, which has to clear it page by page when the next strip asks: that takes as
    long as meeting the rays does. Other C libraries have other ways, and stay as they are.
    """
    try:
        libc = ctypes.CDLL(None)
        libc.gnu_get_libc_version  # noqa: B018 - other libraries may mean something else by mallopt
        return bool(libc.mallopt(MMAP_THRESHOLD, LARGE)) and bool(
            libc.mallopt(TRIM_THRESHOLD, KEPT)
        )
    except (OSError, AttributeError, TypeError):
        return False
