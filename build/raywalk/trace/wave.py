"""One depth of a strip's rays: what was shot, what it met, what it brings back."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from raywalk.geometry.compiled import Hits, Rays
from raywalk.optics.compiled import kernel
from raywalk.trace.bounce import Bounced


class Lighting(NamedTuple):
    """What the hits of a wave know of each light; columns as in RayTree."""

    visibility: np.ndarray  # (n, L) uint8
    blocker: np.ndarray  # (n, L) int32
    blocked_at: np.ndarray  # (n, L)
    passed: np.ndarray  # (n, L)
    diffuse: np.ndarray  # (n, L)
    specular: np.ndarray  # (n, L)
    local: np.ndarray  # (n, 3)
    local_weight: np.ndarray  # (n,)
    base: np.ndarray | None  # (n, 3), None where no object has a base colour


class Met(NamedTuple):
    """The rays of one depth and what they hit, before any light."""

    shot: Bounced  # its `faint`: rays that these do not send on
    hits: Hits


@dataclass(eq=False)
class Wave:
    """All rays of one depth, branch by branch: reflected rays come first, then refracted ones."""

    rays: Rays
    parent: np.ndarray  # (n,) int32: row in the wave before
    kind: np.ndarray  # (n,) uint8
    weight: np.ndarray  # (n,)
    share: np.ndarray  # (n,)
    media: np.ndarray  # (n, w) int32
    faint: int  # rays that it does not send on: their share would be too small
    hits: Hits
    lighting: Lighting
    colour: np.ndarray  # (n, 3), final once the waves behind have been gathered

    def brings(self) -> Brought:
        """What gathering needs of it."""
        return Brought(self.parent, self.weight, self.colour)


class Brought(NamedTuple):
    """What a wave's rays bring back to those that sent them."""

    parent: np.ndarray  # (n,) int32: row in the wave before
    weight: np.ndarray  # (n,)
    colour: np.ndarray  # (n, 3)


def gather(waves: Sequence[Wave | Brought]) -> None:
    """Makes the colours of waves, the first one first, final: from the deepest to the first."""
    for after, before in pairwise(reversed(waves)):
        add_children(before.colour, after.parent, after.weight, after.colour)


@kernel
def add_children(colour, parent, weight, child_colour):
    """Adds weight * child colour to each child's parent, in the children's order."""
    for i in range(parent.shape[0]):
        for c in range(3):
            colour[parent[i], c] += weight[i] * child_colour[i, c]
