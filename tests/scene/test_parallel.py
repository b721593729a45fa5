"""Directions are one, corners on a line, below an angle that their lengths do not change."""

import pytest

from raywalk.errors import SourceErrors

SIZES = [1e-12, 1.0, 7.0, 1e12]


def refusals(scene_from, *tables):
    try:
        scene_from(*tables)
    except SourceErrors as errors:
        return str(errors)
    return ""


def apart(sine, size):
    """A vector of this size (times about 1.7), at this angle from (-1, -1, -1), or across it."""
    along = 0.0 if sine == 1.0 else -size
    across = 3**0.5 * sine * size
    return [along + across * share for share in (0.5**0.5, -(0.5**0.5), 0.0)]


@pytest.mark.parametrize("up", [1e-140, *SIZES, 1e99])  # a direction, which may be of any length
@pytest.mark.parametrize("sight", SIZES)
@pytest.mark.parametrize("sine, is_clear", [(6e-10, False), (1.5e-9, True), (1.0, True)])
def test_up_is_clear_of_the_line_of_sight_whatever_their_lengths(
    sine, is_clear, up, sight, scene_from
):
    """Only the angle between them counts; along (1, 1, 1), so that no coordinate is a length."""
    camera = f"[camera]\neye = [0, 0, 0]\ntarget = {[sight] * 3}\nup = {apart(sine, up)}\n"
    assert ("runs along the line of sight" in refusals(scene_from, "", camera)) != is_clear


@pytest.mark.parametrize("long", SIZES)
@pytest.mark.parametrize("short", SIZES)
@pytest.mark.parametrize("sine, is_clear", [(1e-10, False), (3e-9, True), (1.0, True)])
def test_edges_span_an_area_whatever_their_lengths(sine, is_clear, long, short, scene_from):
    """An area light as thin as a tape is one, an edge given twice is none."""
    edges = [[long] * 3, apart(sine, short)]
    lamp = f'[[lights]]\nname = "lamp"\nposition = [0, 3, 0]\nedges = {edges}\n'
    assert ("span no area" in refusals(scene_from, lamp)) != is_clear


@pytest.mark.parametrize("size", [1e-150, 1.0, 7.0, 1e12])
@pytest.mark.parametrize("height, is_one", [(0.7e-14, False), (1.5e-14, True), (0.5, True)])
@pytest.mark.parametrize("turn", range(3))
def test_a_triangle_is_a_line_below_a_height_of_1e_14_of_its_longest_side(
    turn, height, is_one, size, scene_from
):
    """Along (1, 1, 1), so that no coordinate is a side's length; whichever side is the longest."""
    side = size * 3**0.5
    across = (height * side * 0.5**0.5, -height * side * 0.5**0.5, 0.0)
    foot = [size / 2 + c for c in across]
    corners = [[0.0] * 3, [size] * 3, foot]
    a, b, c = corners[turn:] + corners[:turn]
    table = f'[[objects]]\ntype = "triangle"\na = {a}\nb = {b}\nc = {c}\nmaterial = "white"\n'
    assert ("lie on one line" in refusals(scene_from, table)) != is_one
