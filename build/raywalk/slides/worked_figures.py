"""Figures that a step works out, as rows of cells, and how these are laid out as a table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from raywalk.scene.model import Scene
from raywalk.slides.figure import Cell, Table
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.stops import Stop
from raywalk.slides.typeface import width

ROW = 25.0
GAP = 16.0  # between columns
SWATCH = 18.0
MOST_ROWS = 4  # under the heading, on a step's own slide

Worked = Mapping[str, Any]  # worked.js: "equations", "tree", "average"


@dataclass(frozen=True)
class Figures:
    """A table to be: its first row is the heading, its first words stand at the left."""

    name: str
    rows: tuple[tuple[Cell, ...], ...]

    @property
    def in_words(self) -> str:
        """For who does not see it: each row's figures with what they are."""
        heads = [cell.text for cell in self.rows[0]]
        said = (
            ", ".join(
                f"{head} {cell.text}".strip()
                for head, cell in zip(heads, row, strict=True)
                if cell.text
            )
            for row in self.rows[1:]
        )
        return f"{self.name}: {'; '.join(said)}."


def view_of(scene: Scene, stop: Stop) -> dict[str, Any]:
    """What a stop shows, as the lesson's file has it."""
    stops = scene.lesson[stop.step].stops()
    _, view = stops[stop.kind == "answer"]
    return view


def at_pixel(stop: Stop) -> dict[str, int]:
    """The slots of a table's name."""
    return {"x": stop.pixel[0], "y": stop.pixel[1]}


def table_of(figures: Figures, left: float, top: float, size: float = SMALLEST) -> Table:
    """As wide as its words are."""
    row = ROW * size / SMALLEST
    columns = list(zip(*figures.rows, strict=True))
    widths = tuple(
        max(SWATCH if cell.swatch else width(cell.text, size, cell.bold) for cell in column) + GAP
        for column in columns
    )
    align = tuple("left" if k < first_figure(figures) else "right" for k in range(len(columns)))
    frame = Box(left, top, sum(widths), row * len(figures.rows))
    return Table(
        frame, widths, align, figures.rows, row, size, figures.name, figures.in_words
    )  # fmt: skip


def first_figure(figures: Figures) -> int:
    """The first column that holds figures; those before it hold names and swatches."""
    return next(
        (
            k
            for k, cell in enumerate(figures.rows[1])
            if cell.text[:1].isdigit() or cell.text[:1] in "−?"
        ),
        len(figures.rows[0]),
    )


def heading(*words: str) -> tuple[Cell, ...]:
    return tuple(Cell(word, bold=True) for word in words)
