"""From JSON bytes to the two files a level is published as."""

from __future__ import annotations

import base64
import gzip
import os
import re
import zlib
from pathlib import Path

FORMAT, VERSION = "raywalk-trace", 3
GZIP = 31  # window bits that make zlib write a gzip frame; it notes no time
# Blocks of 2^13 symbols: what texts hold changes often.
MEMORY, MOST_MEMORY = 7, 9
# A text of a trace file is alike from end to end, and unlike the next: it has blocks of its own,
# that each has the code that fits it. Looking for short repeats in noise does harm (Z_FILTERED),
# but in the smallest files. The ten scenes' at 105 are 4.5 % smaller than `pack` makes them.
LONG_TEXT = re.compile(rb'"[^"]{400,}"')
SMALL = 65_536  # bytes; up to it both ways are tried


def pack(json_bytes: bytes) -> bytes:
    """gzip. Same input, same bytes."""
    deflate = zlib.compressobj(9, zlib.DEFLATED, GZIP, MEMORY)
    return deflate.compress(json_bytes) + deflate.flush()


def pack_texts(json_bytes: bytes) -> bytes:
    """gzip of JSON with long texts. Same input, same bytes."""
    filtered = _packed_apart(json_bytes, zlib.Z_FILTERED)
    if len(json_bytes) > SMALL:
        return filtered
    return min(filtered, _packed_apart(json_bytes, zlib.Z_DEFAULT_STRATEGY), key=len)


def _packed_apart(json_bytes: bytes, way: int) -> bytes:
    """Each long text in blocks of its own."""
    deflate = zlib.compressobj(9, zlib.DEFLATED, GZIP, MOST_MEMORY, way)
    parts, at = [], 0
    for text in LONG_TEXT.finditer(json_bytes):
        for end in (text.start() + 1, text.end() - 1):
            parts += [deflate.compress(json_bytes[at:end]), deflate.flush(zlib.Z_BLOCK)]
            at = end
    return b"".join([*parts, deflate.compress(json_bytes[at:]), deflate.flush()])


def script(name: str, packed: bytes) -> bytes:
    """A classic script, which also runs from file://, that hands over what `pack` made."""
    text = base64.b64encode(packed).decode("ascii")
    return f'raywalkReceive("{name}","{text}")\n'.encode()


def unpack(written: bytes) -> bytes:
    """The JSON bytes in what `script` made."""
    return gzip.decompress(base64.b64decode(written.split(b'"')[3]))


MARK = 16  # last characters of base64: gzip's checksum and length of what it packed


def mark_of(path: Path) -> str:
    """By what a page knows a script's data again: those of another build have another."""
    return path.read_bytes().rsplit(b'"', 2)[1][-MARK:].decode("ascii")


def write_beside(path: Path, data: bytes) -> None:
    """The file appears whole or not at all."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        beside.write_bytes(data)
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)


def write_script(path: Path, name: str, json_bytes: bytes) -> None:
    """raywalkReceive("<name>","<base64 of the gzip of the JSON>") as a classic script."""
    write_packed(path, name, pack(json_bytes))


def write_packed(path: Path, name: str, packed: bytes) -> None:
    """The same of JSON that is packed already."""
    write_beside(path, script(name, packed))
