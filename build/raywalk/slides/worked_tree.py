"""How a ray goes through a mesh's tree of boxes, as figures: what trees of some depth cost it, the
boxes that it asks, in their order and counted."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from raywalk.slides.figure import Cell
from raywalk.slides.stops import Stop
from raywalk.slides.words import numbers, say
from raywalk.slides.worked_figures import MOST_ROWS, Figures, Worked, at_pixel, heading

CUTS = ("none", "sphere", "1", "2", "4", "8", "all")
MISSED, ENTERED, CUT_OFF = range(3)  # as trace/mesh_visits.py has them
WHAT = ("slides.worked.missed", "slides.worked.entered", "slides.worked.cutOff")

Pixel = tuple[int, int]


class Visit(NamedTuple):
    """A box that a ray asks."""

    number: int  # from 1
    what: int
    t: float  # where the ray comes to it; 0 where it misses it
    level: int
    triangles: int  # that are tested: those of a box that is entered and holds no others
    tests: int  # up to this one, boxes and triangles


def visits_of(worked: Worked, pixel: Pixel) -> list[Visit]:
    """In order, in the whole tree."""
    tree: dict[str, Any] = worked["tree"]
    flat = tree["visits"][pixel[1] * tree["n"] + pixel[0]]
    asked = [(tree["boxes"][b], what, t) for b, what, t in zip(*[iter(flat)] * 3, strict=True)]
    visits, tests = list[Visit](), 0
    for k, (box, what, t) in enumerate(asked):
        level, under = box[6:]
        is_leaf = k + 1 == len(asked) or asked[k + 1][0][6] <= level
        triangles = under if what == ENTERED and is_leaf else 0
        tests += 1 + triangles
        visits.append(Visit(k + 1, what, t, level, triangles, tests))
    return visits


def tests_of(worked: Worked, pixel: Pixel, cut: str) -> int:
    tree = worked["tree"]
    found: int = tree["tests"][cut][pixel[1] * tree["n"] + pixel[0]]
    return found


def depth_figures(worked: Worked, stop: Stop, cut: str) -> Figures:
    """Tests of the ray with a tree of this depth and with some of less."""
    until = CUTS.index(cut) + 1
    return _depths(worked, stop, CUTS[max(0, until - MOST_ROWS) : until], cut)


def all_depths(worked: Worked, stop: Stop) -> Figures:
    return _depths(worked, stop, CUTS, "")


def _depths(worked: Worked, stop: Stop, cuts: Sequence[str], own: str) -> Figures:
    rows = [heading(say("slides.worked.depth"), say("slides.worked.tests"))]
    for cut in cuts:
        tests = numbers().grouped(tests_of(worked, stop.pixel, cut))
        rows.append((Cell(say(f"slides.worked.cut.{cut}"), bold=cut == own),
                     Cell(tests, bold=cut == own)))  # fmt: skip
    return Figures(say("slides.worked.depths", **at_pixel(stop)), tuple(rows))


def first_visits(stop: Stop, visits: Sequence[Visit]) -> Figures:
    """Where many are asked the first ones, and the tests of all."""
    if len(visits) <= MOST_ROWS:
        return visit_figures(stop, visits)
    shown = visit_figures(stop, visits[: MOST_ROWS - 1])
    last = (Cell("…"), Cell(), Cell(), Cell(), Cell(str(visits[-1].tests), bold=True))
    return replace(shown, rows=(*shown.rows, last))


def visit_figures(stop: Stop, visits: Sequence[Visit]) -> Figures:
    """Boxes in the order in which they are asked."""
    heads = ("box", "level", "answer", "at", "tests")
    rows = [heading(*(say(f"slides.worked.{key}") for key in heads))]
    rows += [_visit(each) for each in visits]
    return Figures(say("slides.worked.visits", **at_pixel(stop)), tuple(rows))


def _visit(visit: Visit) -> tuple[Cell, ...]:
    what = say(WHAT[visit.what])
    if visit.triangles:
        what = say("slides.worked.tested", what=what, count=visit.triangles)
    at = "" if visit.what == MISSED else numbers().fixed(visit.t, 2)
    return tuple(map(Cell, (str(visit.number), str(visit.level), what, at, str(visit.tests))))


def level_figures(stop: Stop, visits: Sequence[Visit]) -> Figures:
    """How many boxes of each level are asked: levels side by side."""
    asked = Counter(visit.level for visit in visits)
    levels = sorted(asked)
    return Figures(
        say("slides.worked.levels", **at_pixel(stop)),
        (heading(say("slides.worked.level"), *map(str, levels)),
         (Cell(say("slides.worked.asked")), *(Cell(str(asked[k])) for k in levels))),
    )  # fmt: skip


def compared(worked: Worked, n: int, pixels: Sequence[Pixel]) -> Figures:
    """Rays side by side: what became of the boxes that each asks."""
    heads = ("pixel", "missed", "entered", "cutOff", "triangles", "tests")
    rows = [heading(*(say(f"slides.worked.{key}") for key in heads))]
    for pixel in pixels:
        visits = visits_of(worked, pixel)
        counts = Counter(visit.what for visit in visits)
        figures = [*(counts[what] for what in (MISSED, ENTERED, CUT_OFF)),
                   sum(visit.triangles for visit in visits), visits[-1].tests]  # fmt: skip
        name = f"({numbers().listed(map(str, pixel))})"
        rows.append((Cell(name), *(Cell(str(figure)) for figure in figures)))
    return Figures(say("slides.worked.compared", n=n), tuple(rows))
