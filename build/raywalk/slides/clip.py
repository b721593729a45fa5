"""Cuts lines and areas at a box."""

from __future__ import annotations

from raywalk.slides.figure import Point
from raywalk.slides.layout import Box


def clipped_line(start: Point, end: Point, box: Box) -> tuple[float, float] | None:
    """The shares of the way between which the line is in the box (Liang and Barsky, 1984)."""
    low, high = 0.0, 1.0
    for k in range(2):
        way = end[k] - start[k]
        near, far = (box.left, box.right) if k == 0 else (box.top, box.bottom)
        if way == 0:
            if not near <= start[k] <= far:
                return None
            continue
        a, b = sorted(((near - start[k]) / way, (far - start[k]) / way))
        low, high = max(low, a), min(high, b)
    return (low, high) if low < high else None


def clipped_area(points: list[Point], box: Box) -> list[Point]:
    """The convex polygon's part in the box (Sutherland and Hodgman, 1974); [] if there is none."""
    if all(box.left <= x <= box.right and box.top <= y <= box.bottom for x, y in points):
        return points
    for axis, limit, sign in (
        (0, box.left, 1), (0, box.right, -1), (1, box.top, 1), (1, box.bottom, -1),
    ):  # fmt: skip
        kept: list[Point] = []
        for a, b in zip(points, points[1:] + points[:1], strict=True):
            inside_a, inside_b = (sign * (p[axis] - limit) >= 0 for p in (a, b))
            if inside_a:
                kept.append(a)
            if inside_a != inside_b:
                share = (limit - a[axis]) / (b[axis] - a[axis])
                kept.append((a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])))
        points = kept
        if not points:
            return []
    return points
