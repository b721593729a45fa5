"""Edges of triangles: how many use each, which way; and what hangs together by them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

SIDES = 1 << 18  # that are sorted at a time
SAMPLE = 1 << 16  # of them from which parts of that size are guessed


class Edges(NamedTuple):
    """Sides of f triangles, three each, sorted so that those of one edge follow one another."""

    side: np.ndarray  # (3 f,) int32: 3 * triangle + which side
    along: np.ndarray  # (3 f,) int8: 1 from the lower vertex to the higher, -1 back
    start: np.ndarray  # (e,) int32: where each edge's sides begin
    uses: np.ndarray  # (e,) int32: how many there are


def edges_of(faces: np.ndarray) -> Edges:
    """faces: (f, 3) vertices.

    Of a large model these tables are most of what there is at once: numbers of 32 bits are enough
    (a file of 2 GB has fewer vertices), and only some edges at a time are sorted, in 64.
    """
    begin = faces.astype(np.int32, copy=False).reshape(-1)
    low = np.empty(len(begin), np.int32)
    for first in range(0, len(low), SIDES):
        which = np.arange(first, min(first + SIDES, len(low)))
        low[which[0] : which[-1] + 1] = np.minimum(begin[which], begin[_next(which)])
    side, along = np.empty(len(low), np.int32), np.empty(len(low), np.int8)
    # As large as could be: what is not written to takes no memory.
    start, edges, filled = np.empty(len(low), np.int32), 0, 0
    for which in _some_at_a_time(low):
        one, other = begin[which], begin[_next(which)]
        key = np.minimum(one, other).astype(np.int64)
        key <<= 32
        key += np.maximum(one, other)
        order = np.argsort(key, kind="stable")
        key = key[order]
        is_first = np.full(len(key), True)
        is_first[1:] = key[1:] != key[:-1]
        upto = filled + len(which)
        side[filled:upto] = which[order]
        along[filled:upto] = np.where((one < other)[order], 1, -1)
        found = np.flatnonzero(is_first)
        start[edges : edges + len(found)] = found + filled
        edges, filled = edges + len(found), upto
    del low
    start = start[:edges]
    return Edges(side, along, start, np.diff(start, append=np.int32(len(side))))


def _next(side: np.ndarray) -> np.ndarray:
    """The next side of each one's triangle, counted as 3 * triangle + which."""
    return np.asarray(side + 1 - 3 * (side % 3 == 2), side.dtype)


def _some_at_a_time(low: np.ndarray) -> Iterator[np.ndarray]:
    """Indices of sides in parts of about SIDES, by their lower vertices (n,): an edge's sides are
    in one part, and parts ascend."""
    parts = -(-len(low) // SIDES)
    if parts < 2:
        yield np.arange(len(low))
        return
    some = np.sort(low[:: max(1, len(low) // SAMPLE)])
    cuts = np.unique(some[np.arange(1, parts) * len(some) // parts]).tolist()
    for first, cut in zip([0, *cuts], [*cuts, int(low.max()) + 1], strict=True):
        yield np.flatnonzero((low >= first) & (low < cut))


def ends_of(edges: Edges, faces: np.ndarray, which: np.ndarray) -> np.ndarray:
    """(k, 2) vertices, the lower first, of these edges (a mask or indices) of these faces."""
    side, corner = edges.side[edges.start[which]], faces.reshape(-1)
    return np.sort(np.column_stack([corner[side], corner[_next(side)]]), axis=1)


def open_edges(edges: Edges, faces: np.ndarray) -> np.ndarray:
    """(k, 2) vertices of edges at which an odd number of triangles meet: surfaces end there."""
    return ends_of(edges, faces, edges.uses % 2 == 1)


def unpaired(edges: Edges) -> Edges:
    """Those at which not just two triangles meet."""
    chosen = np.flatnonzero(edges.uses != 2)
    uses = edges.uses[chosen]
    start = np.cumsum(uses) - uses
    kept = np.repeat(edges.start[chosen] - start, uses) + np.arange(uses.sum())
    return Edges(edges.side[kept], edges.along[kept], start, uses)


def balanced(edges: Edges) -> bool:
    """Whether each edge is passed as often to as fro: then the surface is closed."""
    if not len(edges.start):
        return True
    return not np.add.reduceat(edges.along.astype(np.int64), edges.start).any()


def neighbours_of(edges: Edges) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Triangles (p,) and (p,) that share an edge with nobody else, and (p,) bool: they are wound
    against each other."""
    first = edges.start[edges.uses == 2]
    one, along = gathered(edges.side, first), gathered(edges.along, first)
    first += 1
    other, back = gathered(edges.side, first), gathered(edges.along, first)
    one //= 3
    other //= 3
    return one, other, along == back


def gathered(table: np.ndarray, index: np.ndarray) -> np.ndarray:
    """table[index], of a few at a time: numpy makes 64 bits of every index first."""
    out = np.empty(len(index), table.dtype)
    for k in range(0, len(index), SIDES):
        out[k : k + SIDES] = table[index[k : k + SIDES]]
    return out


def joined(
    count: int, one: np.ndarray, other: np.ndarray, turned: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Things that hang together: the lowest of each's group (n,), whether it is turned against
    that (n,) bool, and which ties (p,) bool contradict the others.

    one, other: (p,) ties; turned: (p,) bool, whether a tie turns. Each round hangs every group
    that has a lower neighbour below it, so that they at least halve (Shiloach and Vishkin, 1982).
    """
    root, parity = np.arange(count, dtype=np.int32), np.zeros(count, bool)
    at, to, across = one, other, turned  # in the first round each is alone
    while True:
        live = at != to
        if not live.all():
            at, to, across = at[live], to[live], across[live]
        if not len(at):
            break
        high, low = np.maximum(at, to), np.minimum(at, to)
        # Of several the last one counts, in both.
        for k in range(0, len(high), SIDES):
            some = slice(k, k + SIDES)
            root[high[some]], parity[high[some]] = low[some], across[some]
        while ((further := gathered(root, root)) != root).any():
            parity ^= gathered(parity, root)
            root = further
        del at, to, across, high, low  # of a large model they weigh more than what stays
        at, to = gathered(root, one), gathered(root, other)
        across = gathered(parity, one) ^ gathered(parity, other) ^ turned
    torn = gathered(parity, one) ^ gathered(parity, other) ^ turned
    return root, parity, torn
