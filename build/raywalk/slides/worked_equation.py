"""Where a camera ray meets spheres, as figures: the ray, points of it, and b, c, D and the roots of
each sphere. No letter comes before the lesson's words have had it."""

from __future__ import annotations

import re
from typing import Any

from raywalk.scene.formula import FORMULA
from raywalk.scene.model import Scene
from raywalk.slides.figure import Cell
from raywalk.slides.stops import Stop
from raywalk.slides.words import numbers, say
from raywalk.slides.worked_curve import colour_of
from raywalk.slides.worked_figures import MOST_ROWS, Figures, Worked, at_pixel, heading, view_of

HALF_WAY = 2.0  # units from the eye: a point of the ray between eye and hit
SMALL = 0.01  # of a discriminant: it is written with four decimals, else with two

Json = dict[str, Any]


def equation_of(worked: Worked, stop: Stop) -> Json | None:
    """What was worked out for the stop's ray."""
    found = (
        each for each in worked.get("equations", ())
        if each["n"] == stop.n and tuple(each["pixel"]) == stop.pixel
    )  # fmt: skip
    return next(found, None)


def key_figures(scene: Scene, stop: Stop, ray: Json) -> Figures:
    """Of the spheres that the step is about; of the ray, as long as nothing is said of spheres."""
    letters = letters_until(scene, stop.step)
    if "b" not in letters:
        return ray_figures(stop, ray, with_points="t" in letters)
    return _spheres(scene, stop, _meant(scene, stop, ray), has_roots="D" in letters)


def key_curves(scene: Scene, stop: Stop, ray: Json) -> list[Json]:
    """The spheres whose curve a stop shows: of those it is about, once D has been told of."""
    return _meant(scene, stop, ray) if "D" in letters_until(scene, stop.step) else []


def _meant(scene: Scene, stop: Stop, ray: Json) -> list[Json]:
    names = view_of(scene, stop).get("highlight") or ()
    spheres = [each for each in ray["spheres"] if scene.objects[each["object"]].name in names]
    return spheres[:MOST_ROWS]


def all_figures(scene: Scene, stop: Stop, ray: Json) -> list[Figures]:
    """The ray, and every sphere."""
    return [ray_figures(stop, ray), _spheres(scene, stop, ray["spheres"], has_roots=True)]


def letters_until(scene: Scene, step: int) -> set[str]:
    """Those that stand in formulas of the lesson's words up to a step."""
    letters: set[str] = set()
    for each in scene.lesson[: step + 1]:
        for match in FORMULA.finditer(each.text):
            latex = match["whole"] or match["one"]
            letters |= set(re.sub(r"\\\w+", "", latex))
    return letters


def ray_figures(stop: Stop, ray: Json, with_points: bool = False) -> Figures:
    """The eye and the direction; points of the ray: on its way, and where it meets something."""
    rows = [heading("", "x", "y", "z")]
    rows += [_vector(name, ray[key]) for name, key in (("o", "origin"), ("d", "direction"))]
    ends = [each["t"][0] for each in ray["spheres"] if each["t"]]
    for t in [HALF_WAY, *([min(ends)] if ends else [])] if with_points else []:
        at = [o + t * d for o, d in zip(ray["origin"], ray["direction"], strict=True)]
        rows.append(_vector(f"o + {numbers().fixed(t, 2)} d", at))
    return Figures(say("slides.worked.ray", **at_pixel(stop)), tuple(rows))


def _vector(name: str, at: list[float]) -> tuple[Cell, ...]:
    return (Cell(name), *(Cell(numbers().number(value)) for value in at))


def _spheres(scene: Scene, stop: Stop, spheres: list[Json], has_roots: bool) -> Figures:
    heads = ["", "", "b", "c", *(("D", "t₁", "t₂") if has_roots else ())]
    rows = [heading(*heads), *(_sphere(scene, each, has_roots) for each in spheres)]
    return Figures(say("slides.worked.equation", **at_pixel(stop)), tuple(rows))


def _sphere(scene: Scene, sphere: Json, has_roots: bool) -> tuple[Cell, ...]:
    """As the page writes them."""
    obj, discriminant = scene.objects[sphere["object"]], sphere["discriminant"]
    cells = [
        Cell(swatch=colour_of(scene, sphere)), Cell(obj.name),
        Cell(numbers().fixed(sphere["b"], 2)), Cell(numbers().fixed(sphere["c"], 2)),
    ]  # fmt: skip
    if has_roots:
        digits = 4 if abs(discriminant) < SMALL else 2
        cells.append(Cell(numbers().fixed(discriminant, digits), bold=True))
        roots = [numbers().number(t) for t in sphere["t"]]
        cells += [Cell(root) for root in roots or ("–", "–")]
    return tuple(cells)
