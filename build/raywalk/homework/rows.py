"""The same vectors as a table: a row a ray."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from io import StringIO
from typing import Any

from raywalk.homework.vectors import rays_in_order

XYZ, RGB = ("x", "y", "z"), ("red", "green", "blue")
# Of three numbers each, empty where a ray leaves the scene.
TRIPLES = {"direction": XYZ, "point": XYZ, "normal": XYZ, "local": RGB, "colour": RGB}
SINGLE = ("kind", "weight", "object", "inside", "t", "local_weight")
OF_A_LIGHT = ("visible", "diffuse", "specular")


def as_csv(vectors: dict[str, Any]) -> str:
    """A header, then pixels grid by grid, the rays of each in the order of `rays_in_order`.

    Yes and no are 1 and 0; what there is not is empty. Numbers have all their digits.
    """
    out = StringIO()
    write = csv.writer(out, lineterminator="\n")
    write.writerow(head(vectors))
    lights = len(vectors["given"]["lights"])
    for grid in vectors["grids"]:
        for pixel in grid["pixels"]:
            for ray, (parent, node) in enumerate(rays_in_order(pixel["ray"])):
                above = "" if parent < 0 else parent
                write.writerow([grid["n"], *pixel["pixel"], ray, above, *cells(node, lights)])
    return out.getvalue()


def head(vectors: dict[str, Any]) -> list[str]:
    """The columns' names; lights are counted from 1, as `given` lists them."""
    lights = range(1, 1 + len(vectors["given"]["lights"]))
    return [
        "n", "column", "row", "ray", "parent", *SINGLE,
        *(f"{name}_{part}" for name, parts in TRIPLES.items() for part in parts),
        *(f"light{k}_{name}" for k in lights for name in OF_A_LIGHT),
    ]  # fmt: skip


def cells(node: dict[str, Any], lights: int) -> Iterator[object]:
    """One ray's."""
    for name in SINGLE:
        yield cell(node[name])
    for name in TRIPLES:
        yield from (cell(part) for part in node[name] or [None] * 3)
    asked = node["lights"] or [dict.fromkeys(OF_A_LIGHT)] * lights
    for light in asked:
        yield from (cell(light[name]) for name in OF_A_LIGHT)


def cell(value: object) -> object:
    """As a table has it."""
    if value is None:
        return ""
    return int(value) if isinstance(value, bool) else value
