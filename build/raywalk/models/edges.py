"""Edges of triangles: how many use each, which way; and what hangs together by them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Edges(NamedTuple):
    """Sides of f triangles, three each, sorted so that those of one edge follow one another."""

    side: np.ndarray  # (3 f,) int32: 3 * triangle + which side
    along: np.ndarray  # (3 f,) int8: 1 from the lower vertex to the higher, -1 back
    start: np.ndarray  # (e,) int32: where each edge's sides begin
    uses: np.ndarray  # (e,) int32: how many there are
    ends: np.ndarray  # (e, 2) int32 vertices


def edges_of(faces: np.ndarray) -> Edges:
    """faces: (f, 3) vertices."""
    many = int(faces.max(initial=0)) + 1
    small = faces.astype(np.int32)  # half the memory; a file of 2 GB has fewer vertices
    begin, end = small.reshape(-1), np.roll(small, -1, axis=1).reshape(-1)
    forth = begin < end
    key = np.minimum(begin, end).astype(np.int64)
    key *= many
    key += np.maximum(begin, end, out=begin)
    del small, begin, end
    side = np.argsort(key, kind="stable").astype(np.int32)
    key = key[side]
    is_first = np.full(len(key), True)
    is_first[1:] = key[1:] != key[:-1]
    start = np.flatnonzero(is_first).astype(np.int32)
    del is_first
    uses = np.diff(start, append=np.int32(len(key)))
    key = key[start]
    ends = np.empty((len(key), 2), np.int32)
    ends[:, 0], ends[:, 1] = key // many, key % many
    del key
    along = np.where(forth[side], np.int8(1), np.int8(-1))
    return Edges(side, along, start, uses, ends)


def open_edges(edges: Edges) -> np.ndarray:
    """(k, 2) vertices of edges at which an odd number of triangles meet: surfaces end there."""
    return edges.ends[edges.uses % 2 == 1]


def balanced(edges: Edges) -> bool:
    """Whether each edge is passed as often to as fro: then the surface is closed."""
    if not len(edges.start):
        return True
    return not np.add.reduceat(edges.along.astype(np.int64), edges.start).any()


def neighbours_of(edges: Edges) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Triangles (p,) and (p,) that share an edge with nobody else, and (p,) bool: they are wound
    against each other."""
    first = edges.start[edges.uses == 2]
    one, other = edges.side[first] // 3, edges.side[first + 1] // 3
    return one, other, edges.along[first] == edges.along[first + 1]


def joined(
    count: int, one: np.ndarray, other: np.ndarray, turned: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Things that hang together: the lowest of each's group (n,), whether it is turned against
    that (n,) bool, and which ties (p,) bool contradict the others.

    one, other: (p,) ties; turned: (p,) bool, whether a tie turns. Each round hangs every group
    that has a lower neighbour below it, so that they at least halve (Shiloach and Vishkin, 1982).
    """
    root, parity = np.arange(count, dtype=np.int32), np.zeros(count, bool)
    while True:
        at, to = root[one], root[other]
        live = at != to
        if not live.any():
            break
        across = (parity[one] ^ parity[other] ^ turned)[live]
        high, low = np.maximum(at, to)[live], np.minimum(at, to)[live]
        # Of several the last one counts, in both.
        root[high], parity[high] = low, across
        while (root[root] != root).any():
            parity ^= parity[root]
            root = root[root]
    torn = parity[one] ^ parity[other] ^ turned
    return root, parity, np.asarray(torn, bool)
