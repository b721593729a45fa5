"""From JSON bytes to the two files a level is published as, and back."""

from __future__ import annotations

import base64
import zlib

from raywalk.trace_file.errors import TraceFileError

FORMAT, VERSION = "raywalk-trace", 2
GZIP = 31  # window bits that make zlib write and read a gzip frame; it notes no time
# Blocks of 2^13 symbols: columns change often. Over the ten scenes' files 0.4 % smaller than
# zlib's usual 2^14; the best of three ways for each file would be 0.2 % smaller for three times
# the time.
MEMORY = 7


def pack(json_bytes: bytes) -> bytes:
    """gzip. Same input, same bytes."""
    deflate = zlib.compressobj(9, zlib.DEFLATED, GZIP, MEMORY)
    return deflate.compress(json_bytes) + deflate.flush()


def script(name: str, packed: bytes) -> bytes:
    """A classic script, which also runs from file://, that hands over what `pack` made."""
    text = base64.b64encode(packed).decode("ascii")
    return f'raywalkReceive("{name}","{text}")\n'.encode()


def unpack(data: bytes) -> bytes:
    """JSON bytes from a .json.gz or a .js file."""
    if data[:2] != b"\x1f\x8b":
        data = _from_script(data)
    try:
        inflate = zlib.decompressobj(GZIP)
        text = inflate.decompress(data) + inflate.flush()
    except zlib.error as error:
        raise TraceFileError("damaged", f"the gzip part is damaged: {error}") from error
    if not inflate.eof:
        raise TraceFileError("damaged", "the gzip part ends too early")
    return text


def _from_script(data: bytes) -> bytes:
    parts = data.split(b'"')
    if not data.startswith(b"raywalkReceive(") or len(parts) != 5:
        raise TraceFileError("not-a-trace", "neither a .json.gz nor a .js trace file")
    try:
        return base64.b64decode(parts[3], validate=True)
    except ValueError as error:
        raise TraceFileError("damaged", "the base64 part is damaged") from error
