"""A frustum resolution is read out of the one trace."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import decode
from scenes_for_tests import mirrors
from tiny_tracer import trace_tiny

from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of


@pytest.mark.parametrize("n", [3, 7, 21])
def test_a_levels_tiles_are_the_pictures_pixels_at_shared_centres(n: int) -> None:
    """Tile (i, j) is pixel (i k + (k - 1) / 2, j k + (k - 1) / 2), k = 63 / n."""
    scene = mirrors(63)
    tree, picture = trace_tiny(scene)
    level = level_of(tree, n)
    k = 63 // n
    centres = np.arange(n) * k + (k - 1) // 2
    trace = decode(encode(level, scene, picture))
    np.testing.assert_array_equal(trace.tiles.reshape(n, n, 3), picture[np.ix_(centres, centres)])
    np.testing.assert_array_equal(trace.pixel[: n * n], np.arange(n * n))
    np.testing.assert_array_equal(level.hits_t, tree.hits_t[_hits_of(tree, level.pixel[: n * n])])


def _hits_of(tree, pixels):  # type: ignore[no-untyped-def]
    return np.concatenate([np.arange(*tree.hits_start[[p, p + 1]]) for p in pixels])


def test_children_stay_with_their_parents() -> None:
    tree, _ = trace_tiny(mirrors(63))
    level = level_of(tree, 21)
    below = level.parent >= 0
    np.testing.assert_array_equal(level.pixel[below], level.pixel[level.parent[below]])


@pytest.mark.parametrize("n", [2, 10, 42])
def test_a_resolution_without_shared_centres_is_refused(n: int) -> None:
    """63 / n is not odd and whole."""
    tree, _ = trace_tiny(mirrors(63))
    with pytest.raises(ValueError, match="odd quotient"):
        level_of(tree, n)
