"""The numbers of a pixel's rays as tables."""

from __future__ import annotations

from raywalk.slides.figure import Cell, Table
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.stops import Row, Stop
from raywalk.slides.typeface import shortened, width
from raywalk.slides.words import columns, numbers, place, say

ROW = 25.0  # points
SAMPLE = 26.0  # of a ray's line before its number
SWATCH = 16.0
GAP = 18.0  # between columns
NUMBER_GAP = 3.0  # more, between a ray's number and the name of what it hits
MOST_DECIMALS = 3
ROUNDING = 0.01  # points: a column is as wide as its longest name, and a gap added and taken off


def ray_tables(stop: Stop, box: Box) -> list[Table]:
    """All rays, one table for each slide that they take; a name that is whole comes before a third
    decimal."""
    heading = tuple(Cell(word, bold=True) for word in columns())
    for decimals in (MOST_DECIMALS, 2):
        body = [_row(ray, decimals) for ray in stop.rows]
        widths = _widths(body, box.width)
        room = widths[1] - GAP + ROUNDING
        if all(width(row[1].text, SMALLEST) <= room for row in body):
            break
    body = [(row[0], Cell(shortened(row[1].text, SMALLEST, room)), *row[2:]) for row in body]
    fits = int(box.height / ROW) - 1
    parts = [body[k : k + fits] for k in range(0, len(body), fits)]
    return [_table(stop, (heading, *part), widths, box) for part in parts]


def _table(stop: Stop, rows: tuple[tuple[Cell, ...], ...], widths: list[float], box: Box) -> Table:
    frame = Box(box.left, box.top, sum(widths), ROW * len(rows))
    alt = say("slides.tableAlt", **place(stop))
    align = ("left", "left", "right", "right", "right", "right", "right")
    return Table(frame, tuple(widths), align, rows, ROW, SMALLEST, say("slides.table"), alt)


def _met(ray: Row) -> str:
    return ray.object or say("slides.nothing")


def _row(ray: Row, decimals: int) -> tuple[Cell, ...]:
    first, swatch = Cell(str(ray.number), sample=ray.kind), Cell(swatch=ray.shows)
    if ray.t is None:
        return (first, Cell(_met(ray)), Cell(), Cell(), Cell(), Cell(), swatch)
    at = [Cell(_fitting(value, decimals)) for value in (*ray.point, ray.t)]
    return (first, Cell(_met(ray)), *at, swatch)


def _fitting(value: float, decimals: int) -> str:
    """One decimal less for every further digit before the point."""
    digits = len(str(int(abs(value))))
    return numbers().fixed(value, max(0, decimals - max(0, digits - 1)))


def _widths(body: list[tuple[Cell, ...]], whole: float) -> list[float]:
    heading = columns()
    needs = [
        max([width(heading[k], SMALLEST, bold=True), *(width(r[k].text, SMALLEST) for r in body)])
        for k in range(len(heading))
    ]
    # The heading stands above the line's sample, a number beside it.
    numbers = max(width(row[0].text, SMALLEST) for row in body)
    needs[0] = max(width(heading[0], SMALLEST, bold=True), SAMPLE + numbers)
    # Where nothing is met there are no numbers: the headings still stand apart.
    needs[2:-1] = [max(need, width("0.00", SMALLEST)) for need in needs[2:-1]]
    needs[-1] = SWATCH
    wide = [need + GAP for need in needs]
    wide[0] += NUMBER_GAP
    wide[-1] = SWATCH + GAP
    rest = whole - sum(wide[:1] + wide[2:])
    wide[1] = min(wide[1], max(rest, 40.0))
    return wide
