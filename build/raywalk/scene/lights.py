"""Lights: named point lights, and area lights as grids of point lights."""

from __future__ import annotations

import re
from dataclasses import fields

import numpy as np

from raywalk.scene.model import Light
from raywalk.scene.schema import LightTable
from raywalk.scene.shapes import Triple

DEFAULT_SAMPLES = (4, 4)
POINT = re.compile(r" \d+/\d+$")  # what follows an area light's name in those of its points


def point_lights(table: LightTable, name: str) -> list[Light]:
    """The point lights that a [[lights]] table stands for, together as bright as it says."""
    positions = sample_points(table)
    count = len(positions)
    alike = {key.name: getattr(table, key.name) for key in fields(Light)}
    alike["intensity"] = table.intensity / count
    names = [name] if count == 1 else [f"{name} {number + 1}/{count}" for number in range(count)]
    return [
        Light(**alike | {"name": each, "position": position})
        for each, position in zip(names, positions, strict=True)
    ]


def lamp_of(name: str) -> str:
    """A light by the name that its file gives it: an area light's points are one."""
    return POINT.sub("", name)


def sample_points(table: LightTable) -> list[Triple]:
    """The light's place, or the centres of equal cells of its parallelogram, row by row."""
    if table.edges is None:
        return [table.position]
    across, along = table.samples or DEFAULT_SAMPLES
    corner, edge_a, edge_b = (np.array(v) for v in (table.position, *table.edges))
    if table.size != 1:
        corner = corner + (1 - table.size) / 2 * (edge_a + edge_b)
        edge_a, edge_b = table.size * edge_a, table.size * edge_b
    return [
        _triple(corner + (i + 0.5) / across * edge_a + (j + 0.5) / along * edge_b)
        for j in range(along)
        for i in range(across)
    ]


def _triple(vector: np.ndarray) -> Triple:
    x, y, z = map(float, vector)
    return x, y, z
