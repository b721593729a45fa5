"""Coordinates of outlines are written as ReportLab writes them."""

from __future__ import annotations

import pytest
from reportlab.lib.rl_accel import fp_str
from reportlab.pdfgen.canvas import Canvas

from raywalk.slides.pdf import _Outlines, number


def test_a_number_is_written_as_reportlab_writes_it(rng):
    """Of 20,000 rounded to a hundredth, on a slide and beside it."""
    for value in rng.uniform(-2000.0, 2000.0, 20_000):
        assert number(value) == fp_str(round(value, 2))


@pytest.mark.parametrize("value", [0.0, -0.0, 0.004, -0.004, 0.25, -0.25, 1.0, 100.0, 7.1])
def test_zeros_that_say_nothing_are_left_out(value):
    """None before the point, none at the end, no minus before a nought."""
    assert number(value) == fp_str(round(value, 2))


def test_outlines_are_the_code_of_a_path():
    """Two of them, closed."""
    outlines = [[(0.0, 1.5), (2.25, 3.0), (4.0, 0.5)], [(5.0, 5.0), (6.0, 7.0)]]
    path = Canvas("never written").beginPath()
    for first, *others in outlines:
        path.moveTo(*first)
        for point in others:
            path.lineTo(*point)
        path.close()
    written = _Outlines([(number(x), number(y)) for x, y in each] for each in outlines)
    assert written.getCode() == path.getCode()
