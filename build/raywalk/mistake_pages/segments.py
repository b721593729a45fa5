"""The rays of two programs as segments: those that both have, and those of one alone."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from raywalk.mistake_pages.walked import Walked
from raywalk.trace.tree import Kind, Visibility

SAME = 1e-6  # of a length: far less than is seen, far more than rounding


class Segment(NamedTuple):
    """A ray, or a shadow ray as far as it goes."""

    start: np.ndarray  # (3,)
    end: np.ndarray  # (3,)
    kind: str  # as ray_kinds.json names lines
    who: str  # "both", "right" or "wrong"


def segments_of(right: Walked, wrong: Walked) -> list[Segment]:
    """Those of both programs first, so that what differs is drawn over them."""
    mine, theirs = list(lines_of(right)), list(lines_of(wrong))
    both = [each for each in mine if any(is_same(each, other) for other in theirs)]
    only = [
        Segment(*line, who)
        for who, own, others in (("right", mine, theirs), ("wrong", theirs, mine))
        for line in own
        if not any(is_same(line, other) for other in others)
    ]
    return [*(Segment(*line, "both") for line in both), *only]


Line = tuple[np.ndarray, np.ndarray, str]


def lines_of(program: Walked) -> Iterator[Line]:
    """Of one program. One without an end is left out: what a direction of no length gives."""
    tree = program.tree
    for row in program.rows.values():
        start, end = program.start(row), tree.point[row]
        if np.isfinite(end).all():
            yield start, end, Kind(int(tree.kind[row])).name.lower()
            yield from shadow_lines(program, row)


def shadow_lines(program: Walked, row: int) -> Iterator[Line]:
    """The shadow rays from where a ray ends."""
    tree, start = program.tree, program.tree.point[row]
    for k, light in enumerate(program.scene.lights):
        seen, to = tree.visibility[row, k], np.array(light.position)
        if seen == Visibility.REACHED:
            yield start, to, "reached"
        elif seen == Visibility.BLOCKED:
            yield start, start + tree.blocked_at[row, k] * (to - start), "blocked"


def is_same(one: Line, other: Line) -> bool:
    """Whether both are one line of one kind."""
    near = SAME * (1 + float(np.abs(one[1] - one[0]).max()))
    return one[2] == other[2] and all(
        np.abs(a - b).max() <= near for a, b in zip(one[:2], other[:2], strict=True)
    )
