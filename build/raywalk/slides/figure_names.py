"""What a step's figure points at and names: rings round things, and words beside them."""

from __future__ import annotations

from raywalk.scene.lights import lamp_of
from raywalk.slides.clip import clipped_area
from raywalk.slides.drawing import Drawing, hits
from raywalk.slides.figure import Item, Point, Polygon
from raywalk.slides.labels import Label
from raywalk.slides.stops import ChosenLine, Ring
from raywalk.slides.words import numbers, say

RING_WIDTH = 2.6
MOST_NUMBERS = 9


def rings_of(drawing: Drawing) -> list[Item]:
    """Round what the step points at, on a ground that sets it off."""
    rings: list[Item] = []
    for ring in drawing.stop.figure.rings:
        if shown := _in_frame(drawing, ring):
            rings += [
                Polygon(shown, None, edge, width, name=ring.name)
                for edge, width in (("ground", RING_WIDTH + 2), ("accent", RING_WIDTH))
            ]
    return rings


def _in_frame(drawing: Drawing, ring: Ring) -> tuple[Point, ...]:
    box = drawing.box
    return tuple(clipped_area([(box.left + x, box.top + y) for x, y in ring.outline], box))


def _ring_names(drawing: Drawing) -> list[Label]:
    """At the top of each ring; a lamp has its name already."""
    named = [ring for ring in drawing.stop.figure.rings if not ring.is_lamp]
    shown = [(ring.name, _in_frame(drawing, ring)) for ring in named]
    return [
        Label(name, (sum(x for x, _ in at) / len(at), min(y for _, y in at)), bold=True)
        for name, at in shown
        if at
    ]


def labels_of(drawing: Drawing) -> list[Label]:
    """The most important first: the first hit's place, ray numbers, camera, lights, normals."""
    stop = drawing.stop
    labels = _ring_names(drawing)
    if stop.is_camera and stop.filled:
        # The tiles hide what the others would name.
        return labels + _light_names(drawing)
    if 1 < len(stop.rows) <= MOST_NUMBERS:
        for line in sorted(stop.chosen, key=lambda line: line.ray):
            if line.light < 0 and (at := _middle(drawing, line)):
                labels.append(Label(str(line.ray), at, bold=True))
    if not stop.is_camera and (eye := drawing.point(stop.figure.eye)):
        labels.append(Label(say("stage.camera"), eye))
    labels += _light_names(drawing)
    first = next(iter(hits(stop)), None)
    if first and (at := drawing.point(first.end)):
        labels.append(Label(numbers().vector(first.to), at))
    return labels


def _light_names(drawing: Drawing) -> list[Label]:
    """A light with an area is named once."""
    names: dict[str, Point] = {}
    for lamp in drawing.stop.figure.lamps:
        if at := drawing.point(lamp.at):
            names.setdefault(lamp_of(lamp.name), at)
    return [Label(name, at) for name, at in names.items()]


def _middle(drawing: Drawing, line: ChosenLine) -> Point | None:
    """The middle of what is seen of a ray, for its number."""
    found = drawing.line(line.whole)
    if not found:
        return None
    at, (first, last) = found
    middle = at[0] + (0.45 * first + 0.55 * last) * (at[1] - at[0])
    return (float(middle[0]), float(middle[1]))
