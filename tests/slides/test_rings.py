"""What a step points at has a ring and its name on its slide."""

from __future__ import annotations

import numpy as np
import pytest

from raywalk.slides.figure import Group, Polygon, Slide, Text, flat

STEP = """[[lesson]]
text = "Look at the red ball, and at the lamp."
view = { resolution = 7, pixel = [2, 4], highlight = [NAMES], OBSERVER }
"""
ABOVE = "observer = { eye = [0, 1, 7], target = [0, 0, 0] }"
#: Straight ahead of an observer who looks at it, so that its outline is a circle about it.
AIMED = "observer = { eye = [0.8, -0.5, 7.6], target = [0.8, -0.5, 0.6] }"


def figure_of(made, step: str, observer: str = ABOVE) -> tuple[Slide, Group]:
    step = step.replace("OBSERVER", observer)
    [slide] = [each for each in made(step).deck("16:9").slides if each.kind == "step"]
    assert slide.figure is not None
    return slide, slide.figure


def rings(figure: Group, name: str) -> list[Polygon]:
    return [each for each in flat((figure,)) if isinstance(each, Polygon) and each.name == name]


@pytest.mark.parametrize("names", [["red ball"], ["mirror", "red ball"]])
def test_each_object_that_is_named_has_a_ring_and_its_name(made, names):
    step = STEP.replace("NAMES", ", ".join(f'"{name}"' for name in names))
    _, figure = figure_of(made, step)
    words = [each.words for each in flat((figure,)) if isinstance(each, Text)]
    for name in names:
        ground, ring = rings(figure, name)
        assert ground.edge == "ground" and ring.edge == "accent" and ring.fill is None
        assert ground.edge_width > ring.edge_width
        assert name in words


def test_a_ball_seen_straight_on_has_a_circle_as_large_as_it_looks(made):
    """Radius 0.5 from 7 away: sine 1/14, so its tangent is 1 / sqrt(14^2 - 1) of the focal
    length; the ring is 3 + 5 points outside of that."""
    step = STEP.replace("NAMES", '"red ball"')
    _, figure = figure_of(made, step, AIMED)
    ring, _ = rings(figure, "red ball")
    points = np.array(ring.points)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    radii = np.hypot(*(points - middle).T)
    box = figure.items[0].box  # the shaded view fills the frame
    [stop] = made(step.replace("OBSERVER", AIMED)).lesson().stops
    focal = min(box.width, box.height) / 2 / np.tan(np.radians(stop.observer["fov"] / 2))
    assert radii == pytest.approx(focal / np.sqrt(14**2 - 1) + 8, abs=1e-6)
    assert middle == pytest.approx([box.left + box.width / 2, box.top + box.height / 2], abs=1e-6)


def test_a_lamp_has_a_ring_and_its_name_only_once(made):
    _, figure = figure_of(made, STEP.replace("NAMES", '"light 2"'))
    assert rings(figure, "light 2")
    words = [each.words for each in flat((figure,)) if isinstance(each, Text)]
    assert words.count("light 2") == 1


def test_a_step_that_points_at_nothing_has_no_ring(made):
    _, figure = figure_of(made, STEP.replace("highlight = [NAMES], ", ""))
    assert not [each for each in flat((figure,)) if getattr(each, "edge", None) == "accent"]
