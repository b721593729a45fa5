"""Whole numbers survive being text."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from raywalk.trace_file.symbols import ONE, TWO, write_numbers, zigzag

EDGES = [0, 1, ONE - 1, ONE, TWO - 1, TWO, 93**3 - 1, 93**3, 2**51]
ALPHABET = [chr(code) for code in range(32, 127) if chr(code) not in '"\\']


def numbers_in(text: str) -> Iterator[int]:
    """As FORMAT.md says: below 79 one character, below 1195 two, else 91 or 92 and the digits."""
    places = iter([ALPHABET.index(letter) for letter in text])
    for first in places:
        if first < 79:
            yield first
        elif first < 91:
            yield 79 + (first - 79) * 93 + next(places)
        else:
            number = 0
            for _ in range({91: 3, 92: 8}[first]):
                number = 93 * number + next(places)
            yield number


@given(st.lists(st.integers(-(2**50), 2**50) | st.integers(-100, 100)))
def test_any_residuals_come_back(residuals: list[int]) -> None:
    """0, -1, 1, -2, 2 ... are written as 0, 1, 2, 3, 4 ..."""
    read = numbers_in(write_numbers(zigzag(np.array(residuals, np.int64))))
    assert [v // 2 if v % 2 == 0 else -(v + 1) // 2 for v in read] == residuals


@pytest.mark.parametrize("number", EDGES)
def test_numbers_at_the_borders_of_a_length_come_back(number: int) -> None:
    assert list(numbers_in(write_numbers(np.array([number])))) == [number]
