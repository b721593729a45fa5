"""Whole numbers survive being text."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from raywalk.trace_file.errors import TraceFileError
from raywalk.trace_file.symbols import ONE, TWO, Reader, write_numbers, zigzag

EDGES = [0, 1, ONE - 1, ONE, TWO - 1, TWO, 93**3 - 1, 93**3, 2**51]


@given(st.lists(st.integers(-(2**50), 2**50) | st.integers(-100, 100)))
def test_any_residuals_come_back(residuals: list[int]) -> None:
    reader = Reader("test", write_numbers(zigzag(np.array(residuals, np.int64))))
    assert [reader.signed() for _ in residuals] == residuals
    reader.finish()


@pytest.mark.parametrize("number", EDGES)
def test_numbers_at_the_borders_of_a_length_come_back(number: int) -> None:
    reader = Reader("test", write_numbers(np.array([number])))
    assert reader() == number
    reader.finish()


@pytest.mark.parametrize("text", ["", "~", '"', "é"])
def test_text_that_is_no_number_is_damaged(text: str) -> None:
    with pytest.raises(TraceFileError):
        Reader("test", text)()
