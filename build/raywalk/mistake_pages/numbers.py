"""What comes out at the first ray that differs: the right numbers, and those of the mistake."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from raywalk.mistake_pages.walked import Path, Walked
from raywalk.trace.tree import LIT, Kind, Visibility

# Of numbers near 1: a thousand roundings of float64, far less than any mistake changes.
SAME = 1e-9
MOST = 4  # rows of the first ray that differs: what follows from these is no news


class Row(NamedTuple):
    """One quantity. Numbers as lists, an object as its index, what is not there as None."""

    what: str  # a key of pages.mistakes.what
    light: int | None
    right: Any
    wrong: Any


def numbers_of(right: Walked, wrong: Walked) -> dict[str, Any]:
    """The ray, and rows of what differs; no ray where both trees are the same."""
    differing = first_difference(right, wrong)
    told: dict[str, Any] = {"ray": None, "rows": []}
    if differing is not None:
        path, rows = differing
        row, place = right.rows[path], list(right.rows).index(path)
        told["ray"] = {
            "number": place + 1, "kind": Kind(int(right.tree.kind[row])).name.lower(),
            "start": right.start(row).tolist(), "way": right.way(row).tolist(),
        }  # fmt: skip
        told["rows"] = [each._asdict() for each in rows[:MOST]]
    if right.bytes != wrong.bytes:
        told["rows"].append(Row("bytes", None, right.bytes, wrong.bytes)._asdict())
    return told


def first_difference(right: Walked, wrong: Walked) -> tuple[Path, list[Row]] | None:
    """The path of the first ray, as a card lists them, of which something differs, and what."""
    for path in right.rows:
        if path not in wrong.rows:  # its parent sent it on in one program only, which is told there
            continue
        if rows := [row for row in quantities(right, wrong, path) if differs(row)]:
            return path, rows
    return None


def differs(row: Row) -> bool:
    """Whether both have another answer, roundings aside."""
    if row.right is None or row.wrong is None or not isinstance(row.right, float | list):
        return bool(row.right != row.wrong)
    one, other = np.array(row.right), np.array(row.wrong)
    if np.array_equal(one, other):  # infinities, too
        return False
    return not np.allclose(one, other, rtol=SAME, atol=SAME)


def quantities(right: Walked, wrong: Walked, path: Path) -> Iterator[Row]:
    """Of one ray in the order in which a program finds them."""
    a, b = right.rows[path], wrong.rows[path]
    one, other = right.tree, wrong.tree
    yield Row("way", None, right.way(a).tolist(), wrong.way(b).tolist())
    yield Row("object", None, int(one.object[a]), int(other.object[b]))
    if one.object[a] < 0 or other.object[b] < 0:
        return
    yield Row("t", None, float(one.t[a]), float(other.t[b]))
    yield Row("point", None, one.point[a].tolist(), other.point[b].tolist())
    yield Row("normal", None, one.normal[a].tolist(), other.normal[b].tolist())
    yield from of_lights(right, wrong, a, b)
    for branch, what in ((0, "mirrored"), (1, "through")):
        share_of = (share(each, (*path, branch)) for each in (right, wrong))
        yield Row(what, None, *share_of)
    if not any(len(p) > len(path) and p[: len(path)] == path for p in (*right.rows, *wrong.rows)):
        yield Row("colour", None, one.colour[a].tolist(), other.colour[b].tolist())


def of_lights(right: Walked, wrong: Walked, a: int, b: int) -> Iterator[Row]:
    """What each light gives where a ray ends, and their sum."""
    one, other = right.tree, wrong.tree
    if one.local_weight[a] == 0 and other.local_weight[b] == 0:
        return
    for k in range(len(right.scene.lights)):
        yield Row("seen", k, *(sight(tree, row, k) for tree, row in ((one, a), (other, b))))
        lit = [int(tree.visibility[row, k]) in LIT for tree, row in ((one, a), (other, b))]
        if all(lit):
            yield Row("diffuse", k, float(one.diffuse[a, k]), float(other.diffuse[b, k]))
            yield Row("specular", k, float(one.specular[a, k]), float(other.specular[b, k]))
    yield Row("own", None, one.local[a].tolist(), other.local[b].tolist())
    yield Row("keeps", None, float(one.local_weight[a]), float(other.local_weight[b]))


def sight(tree: Any, row: int, light: int) -> str:
    """What is known of a light, as a key of pages.mistakes.sight."""
    seen = Visibility(int(tree.visibility[row, light]))
    gives = tree.diffuse[row, light] or tree.specular[row, light]
    return "behind" if seen == Visibility.UNTESTED and not gives else seen.name.lower()


def share(program: Walked, path: Path) -> float:
    """Of a ray's colour in what sent it, 0 where none is sent."""
    row = program.rows.get(path)
    return 0.0 if row is None else float(program.tree.weight[row])
