"""A picture as the check reads it: its rows, each by what it differs from the one above it.

The filter "up" of PNG (W3C PNG, section 9.2) for all rows, without the format around it: what
gzip makes of it is as small, and browsers unpack it themselves, in a tenth of the time that it
takes a library in a page to read a PNG.
"""

from __future__ import annotations

import numpy as np

from raywalk.trace_file.container import pack, unpack


def packed_rows(picture: np.ndarray) -> bytes:
    """Of (n, n, 3) uint8."""
    return pack(np.diff(picture, axis=0, prepend=np.zeros_like(picture[:1])).tobytes())


def rows_of(script: bytes) -> np.ndarray:
    """(n, n, 3) uint8, of a script that hands over what packed_rows made."""
    differences = np.frombuffer(unpack(script), np.uint8)
    n = round((len(differences) / 3) ** 0.5)
    return np.cumsum(differences.reshape(n, n, 3), axis=0, dtype=np.uint8)
