"""From JSON bytes to the two files a level is published as."""

from __future__ import annotations

import base64
import gzip
import zlib

FORMAT, VERSION = "raywalk-trace", 2
GZIP = 31  # window bits that make zlib write a gzip frame; it notes no time
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


def unpack(written: bytes) -> bytes:
    """The JSON bytes in what `script` made."""
    return gzip.decompress(base64.b64decode(written.split(b'"')[3]))
