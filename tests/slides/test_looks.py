"""A step's figure looks as its step says: rasterised without shadows or mirrors, rasterised with
tricks as well as paper can, traced as the picture itself."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image
from tests.slides.conftest import BALLS, LESSON, make

from raywalk.slides.figure import Group, Picture, Polygon, Text, flat
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import say

VIEW = "view = {{ resolution = 7, pixel = [3, 6], rays = [], tiles = 'empty', look = '{}' }}"
LOOKS = ("plain", "approximate", "traced")
STEPS = "".join(f'[[lesson]]\ntext = "It is {look}."\n{VIEW.format(look)}\n' for look in LOOKS)


@pytest.fixture(scope="module")
def lesson(tmp_path_factory: pytest.TempPathFactory) -> Lesson:
    return make(tmp_path_factory.mktemp("looks"), BALLS + STEPS).lesson()


def figures(lesson: Lesson) -> dict[str, Group]:
    return dict(zip(LOOKS, map(lesson.figure, lesson.stops), strict=True))


def view(lesson: Lesson, look: str) -> np.ndarray:
    k = lesson.stops[LOOKS.index(look)].viewpoint
    return np.asarray(Image.open(lesson.views / f"view-{k}.png").convert("RGB"), int)


def test_without_tricks_there_is_no_shadow_and_a_mirror_is_dark(lesson: Lesson) -> None:
    """Seen from one place: what differs is brighter without shadows, or was in the mirror."""
    plain, tricky = view(lesson, "plain"), view(lesson, "approximate")
    change = (plain - tricky).sum(axis=-1)
    assert (change > 60).mean() > 0.005  # shadows on the floor are gone
    assert (change < -60).mean() > 0.005  # the mirror shows nothing
    darker = plain[change < -60]
    assert np.median(darker.max(axis=-1)) <= 26  # of 255: no more than the ambient tenth


def test_a_traced_step_has_the_picture_in_its_place_with_the_pixel_framed(lesson: Lesson) -> None:
    """Where tiles would be: a square, upright, without a second picture in a corner."""
    figure = figures(lesson)["traced"]
    shown = [
        i for i in flat((figure,)) if isinstance(i, Picture) and i.name == say("slides.picture")
    ]
    assert len(shown) == 1
    [picture] = shown
    assert picture.box.width == pytest.approx(picture.box.height, rel=1e-6)
    frames = [i for i in flat((figure,)) if isinstance(i, Polygon) and i.edge == "#f0e442"]
    left = min(x for x, _ in frames[0].points) - picture.box.left
    top = min(y for _, y in frames[0].points) - picture.box.top
    share = picture.box.width / 7
    assert (left / share, top / share) == pytest.approx((3, 6), abs=1e-6)


def test_only_what_is_rasterised_with_tricks_says_where_to_see_it(lesson: Lesson) -> None:
    """A pale view is traced: a shadow map's stairs are not in it."""
    for look, figure in figures(lesson).items():
        said = [i.words for i in flat((figure,)) if isinstance(i, Text)]
        assert (say("slides.seeLive") in said) == (look == "approximate")


def test_a_lamp_with_an_area_is_named_once(tmp_path) -> None:
    lamp = '[[lights]]\nname = "panel"\nposition = [-1, 2, 0]\nedges = [[1, 0, 0], [0, 0, 1]]\n'
    drawn = make(tmp_path, BALLS + lamp + "samples = [3, 3]\n" + LESSON).lesson()
    for stop in drawn.stops:
        words = [i.words for i in flat((drawn.figure(stop),)) if isinstance(i, Text)]
        assert words.count("panel") <= 1 and not any("/9" in each for each in words)
    assert len(drawn.stops[0].figure.lamps) == 11
