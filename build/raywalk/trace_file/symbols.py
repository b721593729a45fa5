"""Integers as printable text: one character for a small number, more for a rare large one.

Deflate sees one byte per small residual, which packs better than decimal digits
and commas (FORMAT.md has the figures) and needs no escaping in JSON.
"""

from __future__ import annotations

import numpy as np

ALPHABET = "".join(chr(c) for c in range(32, 127) if chr(c) not in '"\\')
BASE = len(ALPHABET)  # 93
ONE = 79  # numbers below it take one character
TWO = ONE + 12 * BASE  # numbers below it take two
LONG = {91: 3, 92: 8}  # a first character of this index announces so many digits


def zigzag(residual: np.ndarray) -> np.ndarray:
    """0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ..."""
    return np.where(residual >= 0, 2 * residual, -2 * residual - 1)


def write_numbers(numbers: np.ndarray) -> str:
    """Non-negative integers below 2**52 as text."""
    numbers = np.asarray(numbers, np.int64)
    if not len(numbers):
        return ""
    if numbers.max() < ONE:
        return LETTERS[numbers].tobytes().decode("ascii")
    length = np.full(len(numbers), 1 + LONG[92])
    for most, size in ((BASE ** LONG[91], 1 + LONG[91]), (TWO, 2), (ONE, 1)):
        length[numbers < most] = size
    start = np.cumsum(length) - length
    text = np.empty(int(length.sum()), np.uint8)
    for size in (1, 2, 1 + LONG[91], 1 + LONG[92]):
        rows = np.flatnonzero(length == size)
        text[start[rows, None] + np.arange(size)] = LETTERS[_digits(numbers[rows], size)]
    return text.tobytes().decode("ascii")


LETTERS = np.frombuffer(ALPHABET.encode("ascii"), np.uint8)


def _digits(numbers: np.ndarray, size: int) -> np.ndarray:
    """(n, size) places in the alphabet of numbers that take `size` characters."""
    if size == 1:
        return numbers[:, None]
    if size == 2:
        high, low = np.divmod(numbers - ONE, BASE)
        return np.stack([ONE + high, low], axis=1)
    lead = next(first for first, digits in LONG.items() if digits == size - 1)
    digits = numbers[:, None] // BASE ** np.arange(size - 2, -1, -1) % BASE
    return np.concatenate([np.full((len(numbers), 1), lead), digits], axis=1)
