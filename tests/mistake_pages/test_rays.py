"""The rays and numbers that pages of mistakes show are those of the tracers."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

from raywalk.mistake_pages.best import best_scenes
from raywalk.mistake_pages.clarity import clarity_in
from raywalk.mistake_pages.numbers import numbers_of
from raywalk.mistake_pages.segments import segments_of
from raywalk.mistake_pages.telling import telling_pixel, traced
from raywalk.mistake_pages.walked import Walked, walked
from raywalk.mistakes.tracer import picture
from raywalk.trace.conditioning import is_steady
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import Tracer
from raywalk.words.numbers import Numbers

from ..mistakes.course import scene

N = 15
SOME = {
    "01-shading": ("far-root", "cosine-absolute", "half-not-unit"),
    "03-two-lights": ("t-of-own-scale", "shadow-acne", "mirrored"),
    "04-one-bounce": ("mirror-reversed", "depth-one-too-few", "shadows-forgotten"),
    "08-glass": ("total-black", "not-bent-at-exit", "no-fresnel"),
}
EACH = [(name, mistake) for name, some in SOME.items() for mistake in some]


def both(name: str, mistake: str) -> tuple[Walked, Walked]:
    one = scene(name)
    pixel = telling_pixel(one, N, traced(one, N, frozenset()), mistake)
    assert pixel is not None
    return walked(one, N, pixel), walked(one, N, pixel, frozenset([mistake]))


@pytest.mark.parametrize(("name", "mistake"), EACH)
def test_a_pixel_is_told_as_the_pictures_show_it(name: str, mistake: str) -> None:
    """Both programs' bytes are those of their pictures, and they differ."""
    right, wrong = both(name, mistake)
    assert right.bytes != wrong.bytes
    for program, made in ((right, frozenset()), (wrong, frozenset([mistake]))):
        shown = picture(scene(name), N, made).bytes.reshape(-1, 3)[right.pixel]
        assert tuple(shown.tolist()) == program.bytes


@pytest.mark.parametrize("name", SOME)
def test_right_numbers_are_the_pipelines_own(name: str) -> None:
    """The tracer that makes scenes' pages finds the same rays: colours, distances and points of the
    telling pixels within 1e-9, which is what a test's six digits hang on."""
    tracer = Tracer(scene(name), least_share=LEAST_SHARE)
    for mistake in SOME[name]:
        right = both(name, mistake)[0]
        waves = tracer.waves(np.array([right.pixel]), N, N)
        assert_allclose(waves[0].colour[0], right.tree.colour[0], rtol=0, atol=1e-9)
        mine = right.tree
        for depth, wave in enumerate(waves):
            here = mine.depth == depth
            order = np.lexsort([wave.hits.t])  # both list a depth's rays in an order of their own
            own = np.lexsort([mine.t[here]])
            assert_allclose(wave.hits.t[order], mine.t[here][own], rtol=0, atol=1e-9)
            assert (wave.hits.object[order] == mine.object[here][own]).all()


@pytest.mark.parametrize("name", SOME)
def test_pixels_that_tell_are_well_conditioned(name: str) -> None:
    """Right programs in other languages find the same there."""
    pixels = np.array([both(name, mistake)[0].pixel for mistake in SOME[name]])
    assert is_steady(Tracer(scene(name), least_share=LEAST_SHARE), N, pixels).all()


@pytest.mark.parametrize(("name", "mistake"), EACH)
def test_numbers_are_those_of_the_first_ray_that_differs(name: str, mistake: str) -> None:
    """Of the rays that a card lists before it, both trees have the same; each row shows another
    right number than wrong one; the last are the bytes."""
    right, wrong = both(name, mistake)
    told = numbers_of(right, wrong)
    assert told["rows"][-1]["what"] == "bytes"
    assert all(row["right"] != row["wrong"] for row in told["rows"])
    for path in list(right.rows)[: told["ray"]["number"] - 1]:
        a, b = right.rows[path], wrong.rows[path]
        for column in ("object", "t", "diffuse", "visibility"):
            one, other = getattr(right.tree, column)[a], getattr(wrong.tree, column)[b]
            assert np.array_equal(one, other), (path, column)
    row = right.rows[list(right.rows)[told["ray"]["number"] - 1]]
    values = {"t": right.tree.t[row], "point": right.tree.point[row].tolist()}
    for each in told["rows"]:
        if each["what"] in values:
            assert each["right"] == values[each["what"]]


def test_lines_of_both_programs_are_drawn_once() -> None:
    """A missing bounce: all lines of the wrong program are also the right one's."""
    segments = segments_of(*both("04-one-bounce", "depth-one-too-few"))
    assert {each.who for each in segments} == {"both", "right"}


def test_the_scene_that_shows_it_is_chosen_first_among_equals() -> None:
    """An earlier scene, unless a later one shows it far more plainly; and no scene in which it is
    seen in hardly any pixel."""

    def told(clear: float, is_seen: bool) -> dict[str, object]:
        return {"mistakes": {"far-root": [0.1, clear, is_seen]}}

    of = {"a": told(0.9, False), "b": told(0.1, True), "c": told(0.3, True), "d": told(0.5, True)}
    shown = best_scenes(of, {})
    assert shown["far-root"].best == "c" and shown["far-root"].all == ("b", "c", "d")
    assert set(shown) == {"far-root"}
    for named, best in ("b", "b"), ("d", "d"), ("a", "c"):  # a scene that says so, if it is seen
        assert best_scenes(of, {named: ("far-root",)})["far-root"].best == best


def test_what_shows_is_asked_of_a_small_picture() -> None:
    """Mirror images do in a scene that is none; what changes nothing is not told at all."""
    found = clarity_in(scene("03-two-lights"))
    assert found["mirrored"].is_seen and "total-black" not in found


def test_numbers_are_written_as_the_language_writes_them() -> None:
    """Six digits with a comma, and vectors parted by semicolons."""
    assert Numbers(",", " ", "; ").fixed(-0.5, 6) == "\u22120,500000"
