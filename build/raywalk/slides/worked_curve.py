"""t² + 2bt + c of spheres along a ray, as a drawing: where a curve crosses the line, the ray goes
into the sphere or out of it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.slides.figure import Dot, Group, Item, Line, Run, Text, hex_of
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.words import say

WIDE, HIGH = 280.0, 108.0  # of the drawing
LOW, ABOVE = -1.2, 3.0  # the least value that it shows, and how much more than a curve's least
BEFORE, BEHIND = 4.6, 2.4  # t before the first lowest point: room for words; behind the last one
STEPS = 48  # of a curve; at this size no corner is seen
PEN, ROOT = 2.0, 4.0  # a curve's width, a root's radius
OF = "t² + 2bt + c"

Json = dict[str, Any]


def curves(scene: Scene, spheres: Sequence[Json], left: float, top: float) -> Group:
    """Each sphere's curve in its colour, over the line where the value is 0."""
    lowest = [-each["b"] for each in spheres]  # there t² + 2bt + c is least
    begin, end = min(lowest) - BEFORE, max(lowest) + BEHIND
    most = ABOVE - min(0.0, *(each["discriminant"] for each in spheres))

    def across(t: float) -> float:
        return left + (t - begin) / (end - begin) * WIDE

    def down(value: float) -> float:
        return top + (most - value) / (most - LOW) * HIGH

    zero = Line((left, down(0)), (left + WIDE, down(0)), "rule", 1.2, name="0")
    items: list[Item] = [zero]
    for sphere in spheres:
        paint = colour_of(scene, sphere)
        t = np.linspace(begin, end, STEPS)
        y = t * t + 2 * sphere["b"] * t + sphere["c"]
        points = [(across(a), down(b)) for a, b in zip(t.tolist(), y.tolist(), strict=True)]
        items += [
            Line(one, two, paint, PEN, name=OF)
            for one, two in pairwise(points)
            if min(one[1], two[1]) >= top
        ]
        items += [Dot((across(t), down(0)), ROOT, paint, "ink", "t") for t in sphere["t"]]
    items += [_word(OF, left, top), _word("t", left + WIDE - SMALLEST / 2, down(0))]
    return Group(OF, say("worked.equation.curves"), tuple(items))


def colour_of(scene: Scene, sphere: Json) -> str:
    """A sphere's own, #rrggbb."""
    paint = scene.materials[scene.objects[sphere["object"]].material].diffuse
    return hex_of([round(255 * min(1.0, part)) for part in paint])


def _word(text: str, left: float, top: float) -> Text:
    return Text(Box(left, top, WIDE, SMALLEST * 1.15), ((Run(text),),), SMALLEST, leading=1.15)
