"""Two directions are one to the eye below an angle of 1e-9, however long they are given."""

import pytest

from raywalk.errors import SourceErrors

SIZES = [1e-12, 1.0, 7.0, 1e12]


def refusals(scene_from, *tables):
    try:
        scene_from(*tables)
    except SourceErrors as errors:
        return str(errors)
    return ""


@pytest.mark.parametrize("up", SIZES)
@pytest.mark.parametrize("sight", SIZES)
@pytest.mark.parametrize("sine, is_clear", [(3e-10, False), (3e-9, True), (1.0, True)])
def test_up_is_clear_of_the_line_of_sight_whatever_their_lengths(
    sine, is_clear, up, sight, scene_from
):
    """Only the angle between them counts; sideways of both axes, and either sign."""
    along = 0.0 if sine == 1.0 else -up
    camera = (
        f"[camera]\neye = [0, 0, 0]\ntarget = [0, 0, {sight!r}]\n"
        f"up = [{0.6 * sine * up!r}, {0.8 * sine * up!r}, {along!r}]\n"
    )
    assert ("runs along the line of sight" in refusals(scene_from, "", camera)) != is_clear


@pytest.mark.parametrize("long", SIZES)
@pytest.mark.parametrize("short", SIZES)
@pytest.mark.parametrize("sine, is_clear", [(3e-10, False), (3e-9, True), (1.0, True)])
def test_edges_span_an_area_whatever_their_lengths(sine, is_clear, long, short, scene_from):
    """An area light as thin as a tape is one, an edge given twice is none."""
    along = 0.0 if sine == 1.0 else -short
    lamp = (
        '[[lights]]\nname = "lamp"\nposition = [0, 3, 0]\n'
        f"edges = [[{long!r}, 0, 0], [{along!r}, 0, {sine * short!r}]]\n"
    )
    assert ("span no area" in refusals(scene_from, lamp)) != is_clear
