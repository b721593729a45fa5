"""Text files as other programs write them: any line end, byte order mark, encoding."""

from __future__ import annotations

import re
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path

from raywalk.models.faults import ModelFault, quoted

# Microsoft's runtime writes numbers that are none like this: 1.#QNAN, -1.#IND00, 1.#INF.
NO_NUMBER = re.compile(rb"[+-]?1\.?#(QNAN|SNAN|IND|INF|nan|inf)\w*", re.IGNORECASE)
DECIMAL_COMMA = re.compile(rb"[+-]?\d*,\d+([eE][+-]?\d+)?")
HEAD = 1 << 16


def one_encoding(data: bytes) -> bytes:
    """Without byte order mark, lines ended by \\n; of UTF-16 its UTF-8."""
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16", "replace").encode()
    data = data.removeprefix(b"\xef\xbb\xbf")
    if b"\r" in data[:HEAD] and b"\n" not in data[:HEAD]:
        data = data.replace(b"\r", b"\n")
    return data


def lines(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Each line with its number, from 1. A list of them would weigh several times the file."""
    return enumerate(BytesIO(data), 1)


def name_of(words: bytes) -> str:
    """A name: UTF-8, else Latin-1 as older programs write."""
    try:
        return words.strip().decode("utf-8")
    except UnicodeDecodeError:
        return words.strip().decode("latin-1")


def a_number(word: bytes, path: Path, line: int, what: str = "a number") -> float:
    """Raises ModelFault, which knows what usually is the cause."""
    try:
        return float(word)
    except ValueError:
        if NO_NUMBER.fullmatch(word):
            return float("nan")
        raise ModelFault(path, f"line {line}", *why_no_number(word, what)) from None


def why_no_number(word: bytes, what: str = "a number") -> tuple[str, str]:
    """Cause and remedy."""
    if DECIMAL_COMMA.fullmatch(word):
        point = word.replace(b",", b".").decode()
        return (
            f"{quoted(word)} has a decimal comma",
            f"decimals have a point ({point}): export it again with English number formats, "
            "or replace the commas",
        )
    if "\u2212".encode() in word:
        return f"{quoted(word)} has a minus sign that is a dash", "write it as a hyphen (-)"
    return f"{quoted(word)} is not {what}", "correct the line, or export the model again"
