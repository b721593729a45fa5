"""PNG files of the pictures: lossless, small, the same bytes from the same picture.

One filter for all rows, Up or Sub: which is smaller is found by a quick trial (zlib 4 at a
quarter of the rows). Measured over the ten pictures of the course: Up alone at zlib 6 2.10 MB,
the better of both at 8 8 % less, at 9 9 % for twice the time; a filter chosen row by row saves
less.
Up to 256 colours go into a palette where that is smaller still.
"""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np

from raywalk.trace_file.container import write_beside

SIGNATURE = b"\x89PNG\r\n\x1a\n"
LEVEL, QUICK = 8, 4
MEMORY = 9
BAND = 8  # rows of a quick trial's bands
NO_FILTER, SUB, UP = 0, 1, 2
CHANNELS = 3
TRUE_COLOUR, PALETTE = 2, 3


def write_png(path: Path, rgb8: np.ndarray) -> None:
    """rgb8: (height, width, 3) uint8, row 0 on top."""
    write_beside(path, png(rgb8))


def png(rgb8: np.ndarray) -> bytes:
    """The smaller of true colour and, where it fits, palette."""
    height, width, _ = rgb8.shape
    rows = rgb8.reshape(height, -1)
    filtered = _filtered(rows, min((UP, SUB), key=lambda kind: _quick_size(rows, kind)))
    tries = [_file(width, height, TRUE_COLOUR, b"", _deflated(filtered, LEVEL))]
    del filtered  # the picture's size: not to be held beside the palette's indices
    if found := palette_of(rgb8):
        palette, index = found
        data = _deflated(_filtered(index, NO_FILTER), LEVEL)
        tries.append(_file(width, height, PALETTE, palette.tobytes(), data))
    return min(tries, key=len)


def _quick_size(rows: np.ndarray, kind: int) -> int:
    """What a quarter of the rows would take, in bands of neighbours."""
    band = (np.arange(len(rows)) // BAND) % 4 == 0
    return len(_deflated(_filtered(rows, kind)[band], QUICK))


def _filtered(values: np.ndarray, kind: int) -> np.ndarray:
    """Rows of bytes, each after its filter's number."""
    out = np.empty((values.shape[0], values.shape[1] + 1), np.uint8)
    out[:, 0] = kind
    out[:, 1:] = values
    if kind == UP:
        out[1:, 1:] -= values[:-1]  # modulo 256, as PNG wants it
    if kind == SUB:
        out[:, 1 + CHANNELS :] -= values[:, :-CHANNELS]
    return out


def _deflated(data: np.ndarray, level: int) -> bytes:
    deflate = zlib.compressobj(level, zlib.DEFLATED, zlib.MAX_WBITS, MEMORY)
    return deflate.compress(data.data) + deflate.flush()


def _file(width: int, height: int, kind: int, palette: bytes, data: bytes) -> bytes:
    head = struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)
    parts = [(b"IHDR", head)] + ([(b"PLTE", palette)] if palette else [])
    return SIGNATURE + b"".join(_chunk(*part) for part in [*parts, (b"IDAT", data), (b"IEND", b"")])


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


MOST = 256  # colours of a PNG's palette
ROWS = 64  # of the picture looked at together


def palette_of(rgb8: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
    """The colours (k, 3) uint8 in ascending order and each pixel's index (height, width) uint8;
    None if there are more than MOST. rgb8: (height, width, 3) uint8. Strip by strip: no array of
    all pixels is sorted."""
    colours = np.empty(0, np.uint32)
    for top in range(0, len(rgb8), ROWS):
        colours = np.union1d(colours, _packed(rgb8[top : top + ROWS]))
        if len(colours) > MOST:
            return None
    index = np.empty(rgb8.shape[:2], np.uint8)
    for top in range(0, len(rgb8), ROWS):
        index[top : top + ROWS] = np.searchsorted(colours, _packed(rgb8[top : top + ROWS]))
    parts = [colours >> 16, colours >> 8 & 255, colours & 255]
    return np.stack(parts, axis=1).astype(np.uint8), index


def _packed(rows: np.ndarray) -> np.ndarray:
    """(height, width) uint32: red, green, blue in one number."""
    wide = rows.astype(np.uint32)
    return np.asarray(wide[..., 0] << 16 | wide[..., 1] << 8 | wide[..., 2])
