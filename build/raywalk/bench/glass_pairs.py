"""Glass that touches glass, in every way that bodies can: two or three of them, and water."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from pathlib import Path

import numpy as np

from raywalk.bench.families import directions, in_ball, unit_rows
from raywalk.bench.glass_bodies import FLAT, MESHES, SOLIDS, Body, body
from raywalk.bench.made_scenes import scene_of
from raywalk.scene.model import Camera, Material, Scene, SceneObject

KINDS = (*SOLIDS, *MESHES)
GLASS = [
    Material("water", transmit=1.0, ior=1.333, fresnel=True),
    Material("glass", transmit=1.0, ior=1.5168, fresnel=True),
    Material("flint", transmit=1.0, ior=1.62, fresnel=True),
]
EDGE_ON = np.array([[1.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 0.0, 2**0.5]]) / 2**0.5


def top(one: Body) -> np.ndarray:
    """The highest of its points of interest."""
    marks = one.marks()
    return np.asarray(marks[np.argmax(marks[:, 1])])


def bottom(one: Body) -> np.ndarray:
    marks = one.marks()
    return np.asarray(marks[np.argmin(marks[:, 1])])


def stood(one: Body, on: Body, aside: float = 0.0) -> Body:
    """The body moved so that its lowest point is at the other's top, and aside along x."""
    height = top(on)[1] - bottom(one)[1]
    return one.moved(offset=(aside, height, 0.0))


def hung(one: Body, within: Body, size: float) -> Body:
    """The body made smaller, in another, and moved up until their highest points touch."""
    small = one.moved(size)
    return small.moved(offset=top(within) - top(small))


def arrangements(a: Body, b: Body) -> Iterator[tuple[str, list[Body]]]:
    """Name and bodies of each way in which b can touch a."""
    yield "touching", [a, b.moved(EDGE_ON).moved(offset=top(a) - bottom(b.moved(EDGE_ON)))]
    yield "stacked", [a, stood(b, a)]
    if a.kind in FLAT and b.kind in FLAT:
        yield "sharing part of a face", [a, stood(b, a, aside=0.3)]
        yield "side by side", [a, b.moved(offset=(2.0, 0.0, 0.0))]
        yield "nested, sharing a face", [a, hung(b, a, 0.5).moved(offset=(-0.25, 0.0, 0.0))]
    if a.kind != "L mesh":
        yield "nested, touching", [a.moved(2.0), hung(b, a.moved(2.0), 0.5)]
    middle = stood(b, a)
    yield "stacked three deep", [a, middle, stood(a, middle)]
    yield "in water", [drowned(a), a.moved(0.4), stood(b.moved(0.4), a.moved(0.4))]


def drowned(a: Body) -> Body:
    """A body like a, so large that small ones stand in it."""
    return a.moved(4.0, (1.5, 0.0, 0.0) if a.kind != "L mesh" else (1.5, 1.5, 0.0))


def coincident(a: Body, b: Body) -> Iterator[tuple[str, list[Body]]]:
    """Equal bodies in one place, and a body half in water."""
    if {a.kind, b.kind} <= {"box", "mesh"} or a.kind == b.kind:
        yield "in one place", [a, b]
    yield "half in water", [a, b.moved(0.7, (0.0, 1.0, 0.0))]


PLACES: dict[str, tuple[float, float]] = {
    "as it is": (1.0, 0.0),
    "turned": (1.0, 0.3),
    "turned, x 1e-3": (1e-3, 0.0),
    "turned, moved by 1e3": (1.0, 1e3),
}


def placed_somewhere(bodies: list[Body], place: str, rng: np.random.Generator) -> list[Body]:
    """The whole arrangement in one of PLACES."""
    scale, offset = PLACES[place]
    if place == "as it is":
        return bodies
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    return [one.moved(scale * turn, (offset, -offset, 0.5 * offset)) for one in bodies]


def all_pairs(folder: Path) -> Iterator[tuple[str, str, list[Body]]]:
    """Every pair of kinds in every arrangement: the kinds, the way they touch, the bodies."""
    for one, other in product(KINDS, KINDS):
        a, b = body(one, folder), body(other, folder)
        for way, bodies in (*arrangements(a, b), *coincident(a, b)):
            yield f"{one} and {other}", way, bodies


def scene_with(bodies: list[Body], swapped: bool, eye: np.ndarray) -> Scene:
    """A scene of these bodies, each of its own glass; swapped: named in the other order."""
    camera = Camera((eye[0], eye[1], eye[2]), (eye[0], eye[1], eye[2] - 1.0))
    objects = [
        SceneObject(f"{one.kind} {k}", one.shape, k % len(GLASS), one.transform())
        for k, one in enumerate(bodies)
    ]
    return scene_of(objects[::-1] if swapped else objects, materials=GLASS, camera=camera)


def aimed(bodies: list[Body], rng: np.random.Generator, count: int) -> tuple[np.ndarray, ...]:
    """Rays from outside: at random, at corners and edges, at where bodies touch, and along
    the frame of the first body, in which faces and edges are shared."""
    marks = np.concatenate([one.marks() for one in bodies])
    middle = marks.mean(axis=0)
    reach = float(np.linalg.norm(marks - middle, axis=1).max())
    kind = rng.integers(0, 4, count)
    target = middle + 0.8 * reach * in_ball(rng, count)
    at_mark = (kind == 1) | (kind == 2)
    target[at_mark] = marks[rng.integers(0, len(marks), int(at_mark.sum()))]
    target[kind == 2] += (
        reach
        * 10.0 ** rng.uniform(-16, -2, (int((kind == 2).sum()), 1))
        * (directions(rng, int((kind == 2).sum())))
    )
    away = directions(rng, count)
    frame = bodies[0].linear / np.cbrt(abs(np.linalg.det(bodies[0].linear)))
    level = rng.random(count) < 0.3  # in a plane of the frame: along faces, into edges
    flat = away @ frame
    flat[np.arange(count), rng.integers(0, 3, count)] = 0.0
    away[level] = (flat @ frame.T)[level]
    straight = kind == 3
    axes = np.concatenate([frame.T, -frame.T])
    away[straight] = axes[rng.integers(0, 6, int(straight.sum()))]
    target[straight] = marks[rng.integers(0, len(marks), int(straight.sum()))]
    target[straight] += 0.5 * reach * np.round(rng.uniform(-1, 1, (int(straight.sum()), 3)), 1)
    origin = target - 4.0 * reach * unit_rows(away)
    return origin, unit_rows(target - origin)
