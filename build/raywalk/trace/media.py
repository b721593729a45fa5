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
    """(count, width) int16 stacks that all hold these objects, outermost first; -1 is free."""
    stack = np.full(width, -1, np.int16)
    stack[: len(entered)] = entered[:width]
    return np.tile(stack, (count, 1))


@kernel
def cross_border(stacks, who, inside, ior_of):
    """Indices of refraction before and after the border, (n,) each, and the new stacks.

    stacks: (n, w); who: (n,) object met; inside: (n,) bool, true where the ray leaves it;
    ior_of: (objects,). Outside everything the index is 1.
    """
    count, width = stacks.shape
    n_from, n_to, after = np.ones(count), np.ones(count), stacks.copy()
    for i in range(count):
        held = 0
        while held < width and stacks[i, held] >= 0:
            held += 1
        if held > 0:
            n_from[i] = ior_of[stacks[i, held - 1]]
        elif inside[i]:
            n_from[i] = ior_of[who[i]]  # left without having been entered: a lone border
        if not inside[i]:
            if held < width:
                after[i, held] = who[i]
                held += 1
        else:
            place = held - 1
            while place >= 0 and stacks[i, place] != who[i]:
                place -= 1
            if place >= 0:
                for k in range(place, held - 1):
                    after[i, k] = stacks[i, k + 1]
                after[i, held - 1] = -1
                held -= 1
        if held > 0:
            n_to[i] = ior_of[after[i, held - 1]]
    return n_from, n_to, after
