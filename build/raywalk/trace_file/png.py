"""PNG files of the pictures: lossless, small, the same bytes from the same picture.

Filter Up and zlib 6 were 5 % smaller and a third faster than Pillow's defaults on our
pictures (ACCURACY.md); up to 256 colours go into a palette where that is smaller still.
"""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np

from raywalk.trace_file.palette import palette_of
from raywalk.trace_file.script import write_beside

SIGNATURE = b"\x89PNG\r\n\x1a\n"
LEVEL = 6
NO_FILTER, UP = 0, 2
TRUE_COLOUR, PALETTE = 2, 3


def write_png(path: Path, rgb8: np.ndarray) -> None:
    """rgb8: (height, width, 3) uint8, row 0 on top."""
    write_beside(path, png(rgb8))


def png(rgb8: np.ndarray) -> bytes:
    """The smaller of true colour and, where it fits, palette."""
    height, width, _ = rgb8.shape
    tries = [_file(width, height, TRUE_COLOUR, b"", _rows(rgb8.reshape(height, -1), UP))]
    if found := palette_of(rgb8):
        palette, index = found
        data = _rows(index, NO_FILTER)
        tries.append(_file(width, height, PALETTE, palette.tobytes(), data))
    return min(tries, key=len)


def _rows(values: np.ndarray, kind: int) -> bytes:
    """Rows of bytes, each after its filter's number."""
    out = np.empty((values.shape[0], values.shape[1] + 1), np.uint8)
    out[:, 0] = kind
    out[:, 1:] = values
    if kind == UP:
        out[1:, 1:] -= values[:-1]  # modulo 256, as PNG wants it
    return zlib.compress(out.tobytes(), LEVEL)


def _file(width: int, height: int, kind: int, palette: bytes, data: bytes) -> bytes:
    head = struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)
    parts = [(b"IHDR", head)] + ([(b"PLTE", palette)] if palette else [])
    return SIGNATURE + b"".join(_chunk(*part) for part in [*parts, (b"IDAT", data), (b"IEND", b"")])


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
