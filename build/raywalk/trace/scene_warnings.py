"""What an author should know though nothing is wrong: asked by `check` and by `site` alike."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np

from raywalk.geometry.coincide import coinciding, samples_of, surface_at
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

# Of scenes with more objects it is not asked: every pair would be.
MOST_OBJECTS = 1_000
SAMPLE = 99  # pixels across the picture that is asked what is lit and seen
# Less than half a step of an 8-bit colour is nothing.
DARK = 0.5 / 255.0


def scene_warnings(tracer: Tracer) -> list[str]:
    """A sentence for everything that is likely not meant."""
    scene = tracer.scene
    found: list[str] = []
    if tracer.compiled.meshes:
        # Only here: a scene without a mesh runs none of it.
        from raywalk.geometry.mesh_report import mesh_warnings

        found += mesh_warnings(scene)
    found += [*overlap_warnings(scene, tracer.compiled), *no_lamp(scene)]
    if len(scene.objects) > MOST_OBJECTS:
        return found
    waves = tracer.waves(np.arange(SAMPLE * SAMPLE), SAMPLE, SAMPLE)
    found += _lamps(tracer, waves)
    found += _coinciding(tracer)
    found += _eye(tracer)
    found += _outside(tracer, waves)
    return found


def no_lamp(scene: Scene) -> list[str]:
    """What needs no tracer to be known."""
    told = "there is no lamp: only ambient light, mirrors and glass are seen"
    return [] if scene.lights else [told]


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
    for seen, hidden in coinciding(scene, tracer.compiled):
        one, other = quoted(scene.objects[seen].name), quoted(scene.objects[hidden].name)
        size = finite_sphere(scene, tracer.compiled)[1]
        apart = 10.0 ** np.floor(np.log10(max(size, 1e-300) / 1e3))
        yield (
            f"{one} and {other} coincide: where they do, {one} is seen and {other} is not; "
            f"moving one by {apart:g} shows which"
        )


def _eye(tracer: Tracer) -> Iterator[str]:
    """An eye on a surface, or on the other side of a floor than all that there is to see."""
    scene, compiled = tracer.scene, tracer.compiled
    eye = np.array(scene.camera.eye, float)
    for k, obj in enumerate(scene.objects):
        on, _ = surface_at(compiled, k, eye[None])
        if on[0]:
            yield f"the camera's eye is on the surface of {quoted(obj.name)}"
    table = compiled.primitives
    things = [np.array(light.position, float) for light in scene.lights]
    things += [
        samples_of(compiled, k).point.mean(axis=0)
        for k, obj in enumerate(scene.objects)
        if not isinstance(obj.shape, Plane)
    ]
    for row in np.flatnonzero(table.shape["code"] == PLANE):
        obj = scene.objects[table.object[row]]
        if not things or _is_clear(scene, obj):
            continue
        across = table.to_local[row, 1]
        mine = across @ (eye - table.centre[row])
        theirs = (np.array(things) - table.centre[row]) @ across
        if mine != 0.0 and (theirs * np.sign(mine) < 0).all():
            side = "under" if abs(across[1]) > 0.7 * np.linalg.norm(across) else "behind"
            side = "above" if side == "under" and eye[1] > table.centre[row][1] else side
            yield (f"the camera is {side} {quoted(obj.name)}: everything else is on its other side")


def _outside(tracer: Tracer, waves: list[Wave]) -> Iterator[str]:
    """Objects that are not in the picture, not in a mirror of it, and throw no shadow into it."""
    scene = tracer.scene
    met = np.unique(np.concatenate([wave.hits.object for wave in waves]))
    blockers = np.unique(np.concatenate([wave.lighting.blocker.ravel() for wave in waves]))
    frame, half = camera_frame(scene.camera), half_width(scene.camera)
    eye = np.array(scene.camera.eye, float)
    for k, obj in enumerate(scene.objects):
        if k in met or k in blockers:
            continue
        points = samples_of(tracer.compiled, k).point
        x, y, z = frame @ (points - eye).T
        sides = [z <= 0, x > half * z, -x > half * z, y > half * z, -y > half * z]
        if any(side.all() for side in sides):  # of an endless plane there are no points
            yield f"{quoted(obj.name)} is outside the picture, and no ray of it meets it"
