"""Frustum resolutions whose rays are rays of the picture.

An n x n frustum shares its rays with the size x size picture where size / n is an
odd whole number: only then is there a pixel in the middle of each tile.
"""

from __future__ import annotations

from raywalk.scene.problems import Problems
from raywalk.scene.schema import DEFAULT_RESOLUTIONS, RenderTable
from raywalk.scene.wording import joined, show


def fits(resolution: int, size: int) -> bool:
    return size % resolution == 0 and (size // resolution) % 2 == 1


def resolutions_of(table: RenderTable, problems: Problems) -> tuple[int, ...]:
    """The scene's resolutions, ascending; what does not fit is noted as a problem."""
    at = ("render", "resolutions")
    possible = [n for n in range(1, table.size + 1) if fits(n, table.size)]
    allowed = f"allowed: {joined(map(str, possible))}"
    if table.resolutions is None:
        default = tuple(n for n in DEFAULT_RESOLUTIONS if n in possible)
        if not default:
            message = f"missing: none of the default ones fits size = {table.size}"
            problems.add(at, message, allowed=allowed)
        return default
    seen: set[int] = set()
    for i, n in enumerate(table.resolutions):
        if n not in possible:
            message = f"{n} does not divide size = {table.size} by an odd number"
            problems.add((*at, i), message, allowed=allowed)
        elif n in seen:
            problems.add((*at, i), f"{show(n)} stands here a second time")
        seen.add(n)
    return tuple(sorted(table.resolutions))
