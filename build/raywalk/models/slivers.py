"""Triangles without an area that fill a joint: a corner of one face on another's edge.

CAD programs write them so that every edge has two triangles. Left out alone they would open the
surface there; so the face behind such a sliver gets its corner, and is two triangles.
"""

from __future__ import annotations

import numpy as np

from raywalk.models.edges import Edges, edges_of

ROUNDS = 32  # of slivers one behind the other
MOST = 20_000  # slivers that are looked at


def without_slivers(
    vertices: np.ndarray, faces: np.ndarray, source: np.ndarray, has_area: np.ndarray
) -> tuple[np.ndarray, np.ndarray, int]:
    """Faces (f, 3) and their source (f,) without slivers that fill a joint, and how many went.

    has_area: (f,) bool.
    """
    flat = ~has_area & (np.diff(np.sort(faces, axis=1), axis=1) > 0).all(axis=1)
    gone = 0
    for _ in range(ROUNDS):
        if not 0 < flat.sum() <= MOST:
            break
        faces = faces.copy()
        dead, added, whose = _one_round(vertices, faces, flat)
        if not dead:
            break
        left = np.full(len(faces), True)
        left[dead] = False
        faces = np.concatenate([faces[left], np.array(added, faces.dtype)])
        source = np.concatenate([source[left], source[whose]])
        flat = np.concatenate([flat[left], np.zeros(len(added), bool)])
        gone += len(dead)
    return faces, source, gone


def _one_round(
    vertices: np.ndarray, faces: np.ndarray, flat: np.ndarray
) -> tuple[list[int], list[np.ndarray], list[int]]:
    """Slivers that are not needed any more, second halves of faces behind them, and which faces
    those were; the first halves are put in their place."""
    edges = edges_of(faces)
    edge_of = np.empty(3 * len(faces), np.int64)
    edge_of[edges.side] = np.repeat(np.arange(len(edges.uses)), edges.uses)
    dead: list[int] = []
    added: list[np.ndarray] = []
    whose: list[int] = []
    cut: set[int] = set()
    for sliver in np.flatnonzero(flat).tolist():
        side, corner = _longest(vertices, faces[sliver])
        behind = _across(edges, edge_of, 3 * sliver + side)
        face, start = divmod(behind, 3)
        if behind < 0 or flat[face] or face in cut or corner in faces[face]:
            continue
        halves = np.array([faces[face], faces[face]])
        halves[0, start] = halves[1, (start + 1) % 3] = corner
        faces[face] = halves[0]
        added.append(halves[1])
        whose.append(face)
        dead.append(sliver)
        cut.add(face)
    return dead, added, whose


def _longest(vertices: np.ndarray, face: np.ndarray) -> tuple[int, int]:
    """Its longest side, and the corner that lies on that."""
    at = vertices[face]
    side = int(((np.roll(at, -1, axis=0) - at) ** 2).sum(axis=1).argmax())
    return side, int(face[(side + 2) % 3])


def _across(edges: Edges, edge_of: np.ndarray, side: int) -> int:
    """The other side of an edge that two triangles share, or -1."""
    edge = edge_of[side]
    if edges.uses[edge] != 2:
        return -1
    one, other = edges.side[edges.start[edge] : edges.start[edge] + 2].tolist()
    return int(other if one == side else one)
