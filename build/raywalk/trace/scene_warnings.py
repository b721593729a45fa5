"""What an author should know though nothing is wrong: asked by `check` and by `site` alike."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np

from raywalk.geometry.coincide import coinciding, middles_of, objects_at, samples_of
from raywalk.geometry.containment import objects_around
from raywalk.geometry.extent import finite_sphere
from raywalk.geometry.faces import PLANE
from raywalk.geometry.overlap import overlap_warnings
from raywalk.scene.camera import camera_frame, half_width
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Plane
from raywalk.scene.wording import quoted
from raywalk.trace.tree import Visibility
from raywalk.trace.wave import Wave

if TYPE_CHECKING:
    from raywalk.trace.wavefront import Tracer

SAMPLE = 99  # pixels across the picture that is asked what is lit and seen
# Where much is in the way of each ray, fewer are: as many as make this many tests of a ray and an
# object for each light, but not fewer than LEAST across.
TESTS, LEAST = 100_000_000, 33
# What each light gives at each hit is 35 bytes: of thousands of lights fewer rays fit in memory.
FACTORS = 4_000_000
# Less than half a step of an 8-bit colour is nothing.
DARK = 0.5 / 255.0
UPRIGHT = 0.7  # cosine between a normal and the vertical from which on a surface is a floor
MOSTLY = 0.9  # of what the camera's rays meet
MOST_SAID = 20  # warnings of a kind: where there are more, they have one cause


def scene_warnings(tracer: Tracer) -> list[str]:
    """A sentence for everything that is likely not meant."""
    scene = tracer.scene
    found: list[str] = []
    if tracer.compiled.meshes:
        # Only here: a scene without a mesh runs none of it.
        from raywalk.geometry.mesh_report import mesh_warnings

        found += mesh_warnings(scene)
    found += [*_some(overlap_warnings(scene, tracer.compiled)), *no_lamp(scene)]
    middle = middles_of(tracer.compiled)
    side = _pixels_across(scene)
    waves = tracer.waves(np.arange(side * side), side, side)
    kinds: list[Iterable[str]] = [
        _lamps(tracer, waves), _coinciding(tracer), _eye(tracer, middle),
        _under_floor(tracer, waves[0], middle), _outside(tracer, waves, middle),
    ]  # fmt: skip
    return found + [said for kind in kinds for said in _some(list(kind))]


def _some(said: list[str]) -> list[str]:
    """The first of many sentences of one kind, and how many more there are."""
    more = len(said) - MOST_SAID
    return [*said[:MOST_SAID], f"{more:,} more warnings like the last"] if more > 1 else said


def _pixels_across(scene: Scene) -> int:
    depth = 4 if scene.has_glass or any(each.reflect for each in scene.materials) else 1
    a_pixel = max(1, len(scene.objects)) * (1 + len(scene.lights)) * depth
    across = np.clip(np.sqrt(TESTS / a_pixel), LEAST, SAMPLE)
    return int(max(1, min(across, np.sqrt(FACTORS / max(1, len(scene.lights))))))


def no_lamp(scene: Scene) -> list[str]:
    """What needs no tracer to be known."""
    warning = "there is no lamp: only ambient light, mirrors and glass are seen"
    return [] if scene.lights else [warning]


def _is_clear(scene: Scene, obj: SceneObject) -> bool:
    return scene.materials[obj.material].transmit > 0


def _lamps(tracer: Tracer, waves: list[Wave]) -> Iterator[str]:
    """Lamps in bodies that keep their light in, and lamps that light nothing."""
    scene = tracer.scene
    gives = _brightest(tracer, waves)
    eye_in = set(objects_around(tracer.compiled, np.array(scene.camera.eye, float)))
    numbered = list(enumerate(scene.lights))
    for name, group in groupby(numbered, key=lambda each: _lamp_name(each[1].name)):
        rows = [k for k, _ in group]
        around = [
            set(objects_around(tracer.compiled, np.array(scene.lights[k].position, float)))
            for k in rows
        ]
        bodies = [
            scene.objects[k]
            for k in sorted(set.intersection(*around) - eye_in)
            if not isinstance(scene.objects[k].shape, Plane)
            and not (_is_clear(scene, scene.objects[k]) and scene.render.glass_shadows == "pass")
        ]
        if bodies and scene.render.shadows:
            kind = "lets no lamp shine through" if _is_clear(scene, bodies[0]) else "is opaque"
            hint = '; glass_shadows = "pass" would let it' if _is_clear(scene, bodies[0]) else ""
            yield f"the lamp {quoted(name)} is inside {quoted(bodies[0].name)}, which {kind}{hint}"
        elif gives[rows].sum() < DARK:
            yield f"the lamp {quoted(name)} lights nothing that the picture shows"


def _lamp_name(name: str) -> str:
    """An area light's points are "name i/n"."""
    head, _, tail = name.rpartition(" ")
    one, slash, of = tail.partition("/")
    return head if head and slash and one.isdigit() and of.isdigit() else name


def _brightest(tracer: Tracer, waves: list[Wave]) -> np.ndarray:
    """(lights,) the most that each adds to a colour of a pixel."""
    scene, materials = tracer.scene, tracer.materials
    most = np.zeros(len(scene.lights))
    for wave in waves:
        hit = np.flatnonzero(wave.hits.material >= 0)
        which, lit = wave.hits.material[hit], wave.lighting
        weight = lit.local_weight[hit] * wave.share[hit]
        for k, light in enumerate(scene.lights):
            seen = np.isin(lit.visibility[hit, k], (Visibility.REACHED, Visibility.UNTESTED))
            colour = lit.diffuse[hit, k, None] * materials.diffuse[which]
            colour = colour + lit.specular[hit, k, None] * materials.specular[which]
            given = (colour * np.array(light.colour)).max(axis=1) * weight * seen
            most[k] = max(most[k], float(given.max(initial=0.0)))
    return most


def _coinciding(tracer: Tracer) -> Iterator[str]:
    scene = tracer.scene
    pairs, is_all = coinciding(tracer.compiled)
    size = finite_sphere(scene, tracer.compiled)[1]
    apart = 10.0 ** np.floor(np.log10(max(size, 1e-300) / 1e3))
    for seen, hidden in pairs:
        one, other = quoted(scene.objects[seen].name), quoted(scene.objects[hidden].name)
        yield (
            f"{one} and {other} coincide: where they do, {one} is seen and {other} is not; "
            f"moving one by {apart:g} shows which"
        )
    if not is_all:
        yield "so many objects lie in one another that not all were asked whether they coincide"


def _eye(tracer: Tracer, middle: np.ndarray) -> Iterator[str]:
    """An eye on a surface, or on the other side of a plane than all that there is to see."""
    scene, compiled = tracer.scene, tracer.compiled
    eye = np.array(scene.camera.eye, float)
    for k in objects_at(compiled, eye):
        yield f"the camera's eye is on the surface of {quoted(scene.objects[k].name)}"
    table = compiled.primitives
    things = middle[np.isfinite(middle).all(axis=1)]
    lamps = np.array([light.position for light in scene.lights], float).reshape(-1, 3)
    things = np.concatenate([lamps, things])
    for row in np.flatnonzero(table.shape["code"] == PLANE):
        obj = scene.objects[table.object[row]]
        if not len(things) or _is_clear(scene, obj):
            continue
        across = table.to_local[row, 1]
        mine = across @ (eye - table.centre[row])
        theirs = (things - table.centre[row]) @ across
        if mine != 0.0 and (theirs * np.sign(mine) < 0).all():
            side = "under" if abs(across[1]) > 0.7 * np.linalg.norm(across) else "behind"
            side = "above" if side == "under" and eye[1] > table.centre[row][1] else side
            yield f"the camera is {side} {quoted(obj.name)}: everything else is on its other side"


def _under_floor(tracer: Tracer, first: Wave, middle: np.ndarray) -> Iterator[str]:
    """An eye that sees a finite floor from below, a box, a disc, a mesh or several of them, and
    next to nothing else, while all the rest is above it.

    first: the camera's rays, spread over the picture. middle: (objects, 3), NaN of planes.
    """
    scene, hits = tracer.scene, first.hits
    clear, row_of = tracer.compiled.is_clear, tracer.compiled.primitives.row_of
    finite = np.isfinite(middle).all(axis=1)  # what is not is a plane, such as a far wall
    seen = np.flatnonzero(hits.object >= 0)
    seen = seen[finite[hits.object[seen]]]
    if not len(seen) or not len(row_of):
        return
    # Normals face the eye: an underside's points down.
    below = seen[(hits.geometric[seen, 1] < -UPRIGHT) & ~clear[hits.object[seen]]]
    floor, counts = np.unique(hits.object[below], return_counts=True)
    others = finite.copy()
    others[floor] = False
    if len(below) < MOSTLY * len(seen) or not others.any():
        return
    if (middle[others, 1] > hits.point[below, 1].max()).all():
        name = quoted(scene.objects[floor[np.argmax(counts)]].name)
        yield f"the camera is under {name}: everything else is above it"


def _outside(tracer: Tracer, waves: list[Wave], middle: np.ndarray) -> Iterator[str]:
    """Objects that are not in the picture, not in a mirror of it, and throw no shadow into it."""
    scene = tracer.scene
    frame, half = camera_frame(scene.camera), half_width(scene.camera)
    eye = np.array(scene.camera.eye, float)

    def beside(points: np.ndarray) -> np.ndarray:
        """(5, n) bool: behind the eye, and beyond each side of the picture."""
        x, y, z = frame @ (points - eye).T
        return np.array([z <= 0, x > half * z, -x > half * z, y > half * z, -y > half * z])

    away = np.any(beside(middle), axis=0)  # never a plane, which is everywhere
    for wave in waves:
        for met in (wave.hits.object, wave.lighting.blocker):
            away[met[met >= 0]] = False
    surely = _is_beyond(tracer, frame, half, eye)
    for k in np.flatnonzero(away):
        # If all of its points are beyond one side, so is their middle: most need not be asked.
        if surely[k] or beside(samples_of(tracer.compiled, int(k)).point).all(axis=1).any():
            name = quoted(scene.objects[k].name)
            yield f"{name} is outside the picture, and no ray of it meets it"


def _is_beyond(tracer: Tracer, frame: np.ndarray, half: float, eye: np.ndarray) -> np.ndarray:
    """(objects,) bool: a sphere that holds it lies behind the eye or beyond a side of the picture,
    so that none of its points needs to be asked; never a mesh."""
    table = tracer.compiled.primitives
    x, y, z = frame @ (table.centre - eye).T
    beyond = np.maximum(np.abs(x), np.abs(y)) - half * z
    out = np.zeros(len(table.row_of), bool)
    reach = np.sqrt(table.reach_sq)
    out[table.object] = np.maximum(-z, beyond / np.hypot(1.0, half)) > reach
    return out
