"""A step at which something has moved is followed by a slide with some of the sweep's stops."""

from __future__ import annotations

import numpy as np

from raywalk.slides.figure import Group, Polygon

from .course import CourseDeck, course_decks


def strips_of(deck: CourseDeck) -> list[Group]:
    """Those of its slides."""
    return [
        item
        for slide in deck.slides
        for item in slide.items
        if isinstance(item, Group) and item.alt.startswith(item.name + ": ")
    ]


def test_a_strip_has_two_to_five_stops_one_of_them_the_steps_own_with_the_numbers_of_its_picture():
    found = 0
    for deck in course_decks():
        told = [stop for stop in deck.lesson.stops if stop.moved and stop.kind != "question"]
        for stop in deck.lesson.stops:
            assert (stop.strip is not None) == (stop in told), deck.name
        strips = strips_of(deck)
        assert len(strips) == len(told), deck.name
        for strip in strips:  # the step's own stop is framed
            assert sum(isinstance(i, Polygon) and i.edge == "chosen" for i in strip.items) == 1
        for stop in told:
            assert stop.strip and stop.picture
            assert 2 <= len(stop.strip.pictures) <= 5
            [here] = [each for each in stop.strip.pictures if each.is_here]
            if here.n == stop.picture.n:  # the scene's own stop has finer grids
                assert np.array_equal(here.tiles, stop.picture.tiles)
            found += 1
    assert found
