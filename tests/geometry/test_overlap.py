"""Overlapping glass is named; nested and touching glass is not."""

from __future__ import annotations

import pytest
from tests.geometry.by_hand import CLEAR, scene_of

from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.overlap import overlap_warnings
from raywalk.scene.shapes import Box, Cone, Cylinder, Plane, Sphere

BALL = Sphere((0.0, 0.0, 0.0), 1.0)
PAIRS = {
    "nested balls": (BALL, Sphere((0.2, 0.0, 0.0), 0.5), False),
    "balls apart": (BALL, Sphere((5.0, 0.0, 0.0), 0.5), False),
    "balls that touch": (BALL, Sphere((2.0, 0.0, 0.0), 1.0), False),
    "the same ball twice": (BALL, BALL, False),
    "boxes face to face": (
        Box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)), Box((1.0, -1.0, -1.0), (2.0, 1.0, 1.0)), False,
    ),
    "a ball under water": (Plane((0.0, 2.0, 0.0), (0.0, 1.0, 0.0)), BALL, False),
    "balls that overlap": (BALL, Sphere((1.5, 0.0, 0.0), 1.0), True),
    "a rod through a ball": (BALL, Cylinder((-3.0, 0.0, 0.0), (3.0, 0.0, 0.0), 0.3), True),
    "a cone that pierces a ball": (BALL, Cone((0.0, -0.5, 0.0), (0.0, 2.0, 0.0), 0.4), True),
    "a cone in a ball": (BALL, Cone((0.0, -0.5, 0.0), (0.0, 0.9, 0.0), 0.4), False),
    "a cone whose tip touches a ball": (BALL, Cone((0.0, 3.0, 0.0), (0.0, 1.0, 0.0), 1.0), False),
    "a ball half under water": (Plane((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)), BALL, True),
}  # fmt: skip


@pytest.mark.parametrize("name", PAIRS)
def test_only_glass_that_shares_a_part_without_order_is_warned_of(name):
    """With both names, once a pair."""
    one, other, overlaps = PAIRS[name]
    scene = scene_of([one, other], materials=[CLEAR])
    warnings = overlap_warnings(scene, CompiledScene(scene))
    assert len(warnings) == int(overlaps)
    if overlaps:
        assert all(obj.name in warnings[0] for obj in scene.objects)
