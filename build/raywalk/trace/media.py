"""Which glass a ray travels in: a stack of the objects it has entered, the last on top.

The medium is the one entered most recently; leaving an object takes it out of the stack
wherever it stands, so overlapping glass behaves as if the later entered one displaced the
earlier. A scene without glass has stacks of width 0 and pays nothing.
"""

from __future__ import annotations

import numpy as np

from raywalk.optics.compiled import kernel
from raywalk.scene.model import Scene

DEEPEST = 16  # objects inside one another at most


def stack_width(scene: Scene) -> int:
    """Places a stack needs: one an object that light can enter."""
    clear = sum(scene.materials[obj.material].transmit > 0 for obj in scene.objects)
    return min(int(clear), DEEPEST)


def stacks_holding(entered: list[int], width: int, count: int) -> np.ndarray:
    """(count, width) int32 stacks that all hold these objects, outermost first; -1 is free."""
    stack = np.full(width, -1, np.int32)
    stack[: len(entered)] = entered[:width]
    return np.tile(stack, (count, 1))


@kernel
def indices_before(stacks, who, inside, ior_of):
    """(n,) index of refraction that rays come from, which meet object `who` (n,).

    inside: (n,) bool, true where the ray leaves it. Outside everything the index is 1.
    """
    before = indices_in(stacks, ior_of)
    for i in range(stacks.shape[0]):
        if inside[i] and stacks[i, 0] < 0:
            before[i] = ior_of[who[i]]  # left without having been entered: a lone border
    return before


@kernel
def resolve_media(stacks, ray, who, within):
    """Takes out of stacks (n, w) what rays are not in any more, and adds what they are in now.

    ray, who, within: (c,) each, largest objects first, as CompiledScene.beyond says: of several
    bodies entered at once the smallest comes to lie on top.
    """
    for enters in (False, True):
        for k in range(ray.shape[0]):
            # Element by element: views of rows would cost more than the search.
            if within[k] == enters and holds(stacks, ray[k], who[k]) != enters:
                enter_or_leave(stacks[ray[k]], who[k], enters)


@kernel
def holds(stacks, row, who):
    """Whether an object is in a row's stack."""
    place = 0
    while place < stacks.shape[1] and stacks[row, place] != who:
        place += 1
    return place < stacks.shape[1]


@kernel
def indices_in(stacks, ior_of):
    """(n,) index of refraction of the medium on top of each stack."""
    indices = np.ones(stacks.shape[0])  # outside everything
    for i in range(stacks.shape[0]):
        held = 0
        while held < stacks.shape[1] and stacks[i, held] >= 0:
            held += 1
        if held > 0:
            indices[i] = ior_of[stacks[i, held - 1]]
    return indices


@kernel
def enter_or_leave(stack, who, enters):
    """Puts an object on top of a stack, or takes it out wherever it stands."""
    width, held = stack.shape[0], 0
    while held < width and stack[held] >= 0:
        held += 1
    if enters:
        if held < width:
            stack[held] = who
        return
    place = held - 1
    while place >= 0 and stack[place] != who:
        place -= 1
    if place >= 0:
        for k in range(place, held - 1):
            stack[k] = stack[k + 1]
        stack[held - 1] = -1
