"""Behind the lesson: all that its steps work out, each ray and tile once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from raywalk.scene.model import Scene
from raywalk.slides import worked_average, worked_equation, worked_tree
from raywalk.slides.figure import Table
from raywalk.slides.layout import Box
from raywalk.slides.stops import Stop
from raywalk.slides.worked_figures import Figures, Worked, table_of, view_of

BESIDE, BELOW = 40.0, 18.0  # points between two tables


@dataclass(frozen=True, eq=False)
class Page:
    """One slide's tables."""

    title: str
    tables: tuple[Table, ...]
    stop: Stop
    is_continued: bool


def worked_pages(scene: Scene, stops: Sequence[Stop], worked: Worked, box: Box) -> list[Page]:
    """In the lesson's order."""
    pages: list[Page] = []
    done: set[tuple[str, object]] = set()
    for stop in stops:
        works = view_of(scene, stop).get("works")
        key = (str(works), stop.pixel)
        if not works or stop.kind == "question" or key in done:
            continue
        done.add(key)
        own: list[Page] = []
        for figures in _whole(scene, stop, works, worked):
            own += _pages(figures, box, stop)
        pages += _stacked(own, box)
    return pages


def _whole(scene: Scene, stop: Stop, works: str, worked: Worked) -> list[Figures]:
    if works == "average":
        return [worked_average.all_figures(stop, worked)]
    if works == "equation":
        ray = worked_equation.equation_of(worked, stop)
        return worked_equation.all_figures(scene, stop, ray) if ray else []
    visits = worked_tree.visits_of(worked, stop.pixel)
    return [worked_tree.all_depths(worked, stop), worked_tree.visit_figures(stop, visits)]


def _stacked(pages: list[Page], box: Box) -> list[Page]:
    """One below the other, where both fit on one slide."""
    kept: list[Page] = []
    for page in pages:
        if kept and (down := _bottom(kept[-1]) + BELOW - box.top) + _bottom(page) <= box.bottom:
            lower = tuple(replace(each, box=_down(each.box, down)) for each in page.tables)
            kept[-1] = replace(kept[-1], title=page.title, tables=(*kept[-1].tables, *lower))
        else:
            kept.append(page)
    return kept


def _bottom(page: Page) -> float:
    return max(table.box.bottom for table in page.tables)


def _down(box: Box, by: float) -> Box:
    return box._replace(top=box.top + by)


def _pages(figures: Figures, box: Box, stop: Stop) -> list[Page]:
    """Rows below one another, then beside, then on further slides."""
    head, *rows = figures.rows
    whole = table_of(figures, box.left, box.top)
    most = int(box.height / whole.row_height) - 1
    beside = max(1, int((box.width + BESIDE) / (whole.box.width + BESIDE)))
    parts = [rows[k : k + most] for k in range(0, len(rows), most)]
    pages = []
    for k in range(0, len(parts), beside):
        tables = []
        for column, part in enumerate(parts[k : k + beside]):
            table = table_of(replace(figures, rows=(head, *part)), box.left, box.top)
            left = box.left + column * (whole.box.width + BESIDE)
            at = Box(left, box.top, whole.box.width, table.box.height)
            tables.append(replace(table, box=at, widths=whole.widths, align=whole.align))
        pages.append(Page(figures.name, tuple(tables), stop, k > 0))
    return pages
