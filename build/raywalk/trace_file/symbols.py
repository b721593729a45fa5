"""Integers as printable text: one character for a small number, more for a rare large one.

Deflate sees one byte per small residual, which packs better than decimal digits
and commas (FORMAT.md has the figures) and needs no escaping in JSON.
"""

from __future__ import annotations

import numpy as np

from raywalk.trace_file.errors import TraceFileError

ALPHABET = "".join(chr(c) for c in range(32, 127) if chr(c) not in '"\\')
BASE = len(ALPHABET)  # 93
ONE = 79  # numbers below it take one character
TWO = ONE + 12 * BASE  # numbers below it take two
LONG = {91: 3, 92: 8}  # a first character of this index announces so many digits
DIGITS = {text: value for value, text in enumerate(ALPHABET)}


def zigzag(residual: np.ndarray) -> np.ndarray:
    """0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ..."""
    return np.where(residual >= 0, 2 * residual, -2 * residual - 1)


def unzigzag(number: int) -> int:
    return number // 2 if number % 2 == 0 else -(number + 1) // 2


def write_numbers(numbers: np.ndarray) -> str:
    """Non-negative integers below 2**52 as text."""
    return "".join(_word(number) for number in numbers.tolist())


def _word(number: int) -> str:
    if number < ONE:
        return ALPHABET[number]
    if number < TWO:
        high, low = divmod(number - ONE, BASE)
        return ALPHABET[ONE + high] + ALPHABET[low]
    lead, digits = next(pair for pair in LONG.items() if number < BASE ** pair[1])
    text = ""
    for _ in range(digits):
        number, digit = divmod(number, BASE)
        text = ALPHABET[digit] + text
    return ALPHABET[lead] + text


class Reader:
    """Takes numbers from a column's text, one after the other."""

    def __init__(self, name: str, text: str):
        self.name, self.text, self.at = name, text, 0

    def __call__(self) -> int:
        first = self._digit()
        if first < ONE:
            return first
        if first not in LONG:
            return ONE + (first - ONE) * BASE + self._digit()
        number = 0
        for _ in range(LONG[first]):
            number = number * BASE + self._digit()
        return number

    def _digit(self) -> int:
        if self.at >= len(self.text):
            raise TraceFileError("damaged", f"column {self.name} ends too early")
        digit = DIGITS.get(self.text[self.at])
        if digit is None:
            raise TraceFileError("damaged", f"column {self.name} holds a foreign character")
        self.at += 1
        return digit

    def signed(self) -> int:
        return unzigzag(self())

    def finish(self) -> None:
        if self.at != len(self.text):
            raise TraceFileError("damaged", f"column {self.name} is too long")
