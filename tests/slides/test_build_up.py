"""A step's rays one by one: where there are many, those that go on come before those to lights."""

from __future__ import annotations

from itertools import pairwise

from tests.slides.course import course_decks

from raywalk.slides.build_up import MOST
from raywalk.slides.figure import Group, Line, Slide, flat
from raywalk.slides.palette import KINDS


def built_before(slides: list[Slide], title: str) -> list[Slide]:
    return [slide for slide in slides if slide.kind == "build" and slide.title == title]


def kinds_on(slide: Slide) -> set[str]:
    figure = next(i for i in slide.items if isinstance(i, Group) and i.is_figure)
    return {i.colour for i in flat(figure.items) if isinstance(i, Line)} & set(KINDS)


def test_a_ray_that_goes_into_glass_is_built_up_and_not_only_those_to_lights():
    """Four slides once went to the mirrored part's shadow rays, and the bent one never came."""
    for each in course_decks():
        if each.deck.id != "08-glass":
            continue
        firsts = [slide for slide in each.slides if slide.figure and slide.kind == "step"]
        built = built_before(each.slides, firsts[0].title)
        assert len(built) == MOST
        assert "refracted" in kinds_on(built[-1]) and "refracted" not in kinds_on(built[0])
        assert all(kinds_on(few) <= kinds_on(more) for few, more in pairwise(built))


def test_with_few_rays_each_shadow_ray_has_its_slide():
    """Scene 3: a camera ray and one to each of two lights."""
    for each in course_decks():
        if each.deck.id == "03-two-lights":
            [first, *_] = [slide for slide in each.slides if slide.figure]
            camera, one_light = built_before(each.slides, first.title)
            assert kinds_on(camera) == {"camera"} and "reached" in kinds_on(one_light)
