"""A camera inside something opaque is refused, one beside it is not."""

from __future__ import annotations

import numpy as np
import pytest
from tests.geometry.by_hand import SHAPES, SOLIDS, random_affine, unit

from raywalk.bench.truth import true_hits
from raywalk.scene.checks import is_strictly_inside
from raywalk.scene.model import SceneObject
from raywalk.scene.placement import UNMOVED, placement

# Shares of the way to the surface, and whether one is inside there.
WAYS = ((0.5, True), (0.75, True), (1 - 1e-10, True), (1 + 1e-10, False))


@pytest.mark.parametrize("is_moved", [True, False], ids=["moved", "as it is"])
@pytest.mark.parametrize("kind", SOLIDS)
def test_a_place_is_inside_up_to_the_surface(
    rng: np.random.Generator, kind: str, is_moved: bool
) -> None:
    """From the middle outwards in 60 directions: inside until a ten-billionth before the surface,
    outside from as much behind it. One that nothing moves is asked by a sphere round it first."""
    obj = SceneObject(kind, SHAPES[kind], 0, random_affine(rng) if is_moved else UNMOVED)
    middle = placement(obj)[1]
    for direction in unit(rng.normal(size=(60, 3))):
        [hit] = true_hits(obj, middle, direction)
        for share, expected in WAYS:
            place = middle + share * float(hit.t) * direction
            assert is_strictly_inside(place.tolist(), obj) == expected


@pytest.mark.parametrize("kind", sorted(set(SHAPES) - set(SOLIDS)))
def test_what_is_open_hides_no_camera(rng: np.random.Generator, kind: str) -> None:
    """Planes, discs, triangles, tubes: wherever the eye is."""
    obj = SceneObject(kind, SHAPES[kind], 0)
    assert not any(is_strictly_inside(place, obj) for place in rng.normal(size=(200, 3)).tolist())
