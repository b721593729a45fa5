"""Shells: what hangs together by its edges. Each is turned right by itself: closed ones outwards,
hollows in them inwards."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.models.edges import (
    Edges,
    edges_of,
    gathered,
    joined,
    neighbours_of,
    open_edges,
    unpaired,
)

# Points of a shell that are asked whether another holds it.
ASKED = 9
# Triangles times points that are asked at most: a second.
MOST_WORK = 2e7
MOST_SHELLS = 3000
MANY = 1 << 16  # triangles that are looked at together


@dataclass(frozen=True, eq=False)
class Shell:
    """Triangles that hang together."""

    triangles: np.ndarray  # (k,) rows of faces
    closed: bool
    volume: float  # six times, signed as the file winds it; 0 of what is open
    box: np.ndarray  # (2, 3)
    within: int = -1  # the smallest shell that holds it, -1 if none does
    is_hollow: bool = False  # turned inwards: it bounds a hollow of the one that holds it


@dataclass(frozen=True, eq=False)
class Turned:
    """Faces wound as they should be."""

    faces: np.ndarray  # (f, 3)
    turned: np.ndarray  # (f,) bool: against the file
    shells: tuple[Shell, ...]
    overlapping: tuple[tuple[int, int], ...]  # shells of which a part lies in the other
    is_unknown: bool  # too many shells to tell which lie in which
    open_ends: np.ndarray  # (k, 2) vertices of edges at which the surface ends

    @property
    def closed(self) -> bool:
        return all(shell.closed for shell in self.shells)

    @property
    def layered(self) -> bool:
        """Whether a place may lie in several shells at once: what is inside must be counted."""
        nested = any(shell.within >= 0 and not shell.is_hollow for shell in self.shells)
        return nested or bool(self.overlapping) or self.is_unknown


def turn_outwards(vertices: np.ndarray, faces: np.ndarray, part: np.ndarray) -> Turned:
    """part: (f,) int, which named part a triangle is of: shells of one part keep their sense to
    each other, so that what is inside out as a whole keeps its hollows."""
    edges = edges_of(faces)
    open_ends, pairs = open_edges(edges, faces), neighbours_of(edges)
    edges = unpaired(edges)  # no more is asked of, and of large models the others weigh most
    label, against, faulty = _wound_alike(pairs, len(faces))
    del pairs
    groups = _groups(label)
    is_closed = _closed(edges, label, against, groups, faulty)
    del label
    faces, turned = faces.copy(), against.copy()
    faces[against] = faces[against][:, ::-1]
    shells = _shells(vertices, faces, groups, is_closed)
    within, overlapping, is_unknown = _nested(vertices, faces, shells)
    senses = _senses(shells, within, part)
    wrong = [s.triangles for s, sense in zip(shells, senses, strict=True) if sense * s.volume < 0]
    if wrong:
        chosen = np.concatenate(wrong)
        faces[chosen] = faces[chosen][:, ::-1]
        turned[chosen] ^= True
    made = tuple(
        Shell(s.triangles, s.closed, s.volume, s.box, within[k], senses[k] < 0)
        for k, s in enumerate(shells)
    )
    return Turned(faces, turned, made, tuple(overlapping), is_unknown, open_ends)


def _wound_alike(
    pairs: tuple[np.ndarray, np.ndarray, np.ndarray], count: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Label (f,) of each triangle's group, which to turn (f,) bool so that all neighbours of a
    group agree, the fewer ones, and the groups' labels in which none can agree.

    pairs: as `neighbours_of` has it.
    """
    one, other, against = pairs
    label, parity, torn = joined(count, one, other, against)
    more = np.zeros(count, np.int32)  # that are turned, than that are not
    np.add.at(more, label, np.where(parity, np.int8(1), np.int8(-1)))
    turn = parity ^ gathered(more > 0, label)
    faulty = np.unique(label[one[torn]])
    if len(faulty):
        turn[np.isin(label, faulty)] = False  # a Moebius strip has no two sides
    return label, turn, faulty


def _groups(label: np.ndarray) -> list[np.ndarray]:
    order = np.argsort(label, kind="stable").astype(np.int32)
    if not len(order):
        return []
    return np.split(order, np.flatnonzero(np.diff(label[order])) + 1)


def _closed(
    edges: Edges, label: np.ndarray, against: np.ndarray, groups: list[np.ndarray],
    faulty: np.ndarray,
) -> list[bool]:  # fmt: skip
    """Whether each group's triangles pass each of their edges as often to and fro.

    edges: those that are not of two. Others agree, or their group is faulty.
    """
    bad = set(label[edges.side[edges.start[edges.uses == 1]] // 3].tolist())
    bad |= set(faulty.tolist())
    crowded = np.repeat(edges.uses > 2, edges.uses)
    if crowded.any():
        # Of several groups at an edge each is asked by itself.
        face = edges.side[crowded] // 3
        edge = np.repeat(np.flatnonzero(edges.uses > 2), edges.uses[edges.uses > 2])
        along = np.where(against[face], -edges.along[crowded], edges.along[crowded])
        pair = np.column_stack([edge, label[face]])
        _, row = np.unique(pair, axis=0, return_inverse=True)
        sums = np.bincount(row.reshape(-1), weights=along)
        bad |= set(label[face[sums[row.reshape(-1)] != 0]].tolist())
    return [int(label[group[0]]) not in bad for group in groups]


def _shells(
    vertices: np.ndarray, faces: np.ndarray, groups: list[np.ndarray], is_closed: list[bool]
) -> list[Shell]:
    """Every group with its box and volume, all at once: a tree has 100,000 leaves."""
    order, starts = np.concatenate(groups), np.cumsum([0, *map(len, groups)])[:-1]
    boxes, of_each = np.empty((len(groups), 2, 3)), np.empty(len(order))
    some = [slice(k, k + MANY) for k in range(0, len(order), MANY)]
    for k, axis in enumerate(vertices.T):
        for end, least in ((0, np.minimum), (1, np.maximum)):
            for part in some:
                least.reduce(axis[faces[order[part]]], axis=1, out=of_each[part])
            boxes[:, end, k] = least.reduceat(of_each, starts)
    whose = np.repeat(np.arange(len(groups), dtype=np.int32), [len(group) for group in groups])
    middle = boxes.mean(axis=1)
    for part in some:
        of_each[part] = _six_volumes(vertices[faces[order[part]]] - middle[whose[part], None])
    volumes = np.where(is_closed, np.add.reduceat(of_each, starts), 0.0)
    return [
        Shell(*each) for each in zip(groups, is_closed, volumes.tolist(), list(boxes), strict=True)
    ]


def _six_volumes(corners: np.ndarray) -> np.ndarray:
    """(f,) six times the volume of each pyramid from the origin to a triangle (f, 3, 3)."""
    a, b, c = corners.transpose(1, 0, 2)
    return np.asarray((a * np.cross(b, c)).sum(axis=1))


def _nested(
    vertices: np.ndarray, faces: np.ndarray, shells: list[Shell]
) -> tuple[list[int], list[tuple[int, int]], bool]:
    """For each shell the smallest closed one that holds it, or -1; pairs that cut each other; and
    whether there are too many to tell."""
    within = [-1] * len(shells)
    closed = [k for k, shell in enumerate(shells) if shell.closed]
    if len(closed) < 2:
        return within, [], False
    boxes = np.array([shells[k].box for k in closed])
    if len(closed) > MOST_SHELLS:
        return within, [], True
    meet = (boxes[:, None, 0] < boxes[None, :, 1]).all(axis=2)
    pairs = [(a, b) for a, b in np.argwhere(meet & meet.T).tolist() if a != b]
    work = sum(min(ASKED, len(shells[closed[a]].triangles)) * len(shells[closed[b]].triangles)
               for a, b in pairs)  # fmt: skip
    if work > MOST_WORK:
        return within, [], True
    overlapping = set()
    for a, b in pairs:
        inner, outer = closed[a], closed[b]
        share = _share_within(vertices, faces, shells[inner], shells[outer])
        if share == 1.0:
            best = within[inner]
            if best < 0 or abs(shells[outer].volume) < abs(shells[best].volume):
                within[inner] = outer
        elif share > 0.0:
            overlapping.add((min(inner, outer), max(inner, outer)))
    return within, sorted(overlapping), False


def _share_within(vertices: np.ndarray, faces: np.ndarray, inner: Shell, outer: Shell) -> float:
    """Of some points on a shell the share that lies in another; its own surface does not count."""
    step = max(1, len(inner.triangles) // ASKED)
    points = vertices[faces[inner.triangles[::step]]].mean(axis=1)[:ASKED]
    corners = vertices[faces[outer.triangles]]
    turns = np.abs([turns_round(corners, point) for point in points])
    clear = np.abs(turns - np.round(turns)) < 0.25
    return float((turns[clear] > 0.5).mean()) if clear.any() else 0.0


def turns_round(corners: np.ndarray, point: np.ndarray) -> float:
    """How often a closed mesh (f, 3, 3) goes round a point: the sum of its triangles' solid angles
    (van Oosterom and Strackee, "The solid angle of a plane triangle", 1983)."""
    a, b, c = (corners - point).transpose(1, 0, 2)
    la, lb, lc = (np.linalg.norm(each, axis=1) for each in (a, b, c))
    above = (a * np.cross(b, c)).sum(axis=1)
    below = la * lb * lc + (a * b).sum(axis=1) * lc + (b * c).sum(axis=1) * la
    below += (c * a).sum(axis=1) * lb
    return float(np.arctan2(above, below).sum() / (2.0 * np.pi))


def _senses(shells: list[Shell], within: list[int], part: np.ndarray) -> list[int]:
    """1 for shells that are to face outwards, -1 for hollows, 0 where there is no outside."""
    senses = []
    for k, shell in enumerate(shells):
        around = k
        while within[around] >= 0:
            around = within[around]
        if not shell.closed:
            senses.append(0)
        elif around == k:
            senses.append(1)
        elif shells[around].volume >= 0:
            senses.append(1 if shell.volume >= 0 else -1)
        else:
            same = part[shell.triangles[0]] == part[shells[around].triangles[0]]
            senses.append(-1 if shell.volume > 0 and same else 1)
    return senses
