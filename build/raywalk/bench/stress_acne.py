"""Shadow acne in the project's scenes, at every decade of scale and of distance from the origin.

The truth of a moved scene is the scene itself, if it is moved exactly: scales are the powers
of two next to the decades, which round nothing, and before a scene is moved by 10, 100 ..
10^7 its eye, lights and translations are rounded to multiples of 2^-28, so that every sum is
a float64 number. Then each pixel's camera ray meets the same point of the same surface, and
each of its shadow rays goes the same way.

An acne pixel is one where a shadow ray is blocked by the very surface it leaves, which is
convex or flat; or where a light that is seen in the scene is blocked in the moved one, or the
other way round (then it is a leak), or another object is met.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from raywalk.bench.cases import Case
from raywalk.bench.made_scenes import placed
from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Camera, Scene
from raywalk.scene.read import read_own_scenes
from raywalk.scene.shapes import Mesh
from raywalk.trace.tree import Visibility
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import STRIP, Tracer

DECADES = range(-6, 7)
SCALES = tuple(2.0 ** round(k * math.log2(10.0)) for k in DECADES)
OFFSETS = tuple(10.0**k for k in range(1, 8))
GRID = 105
FULL = 1155
STEP = 2.0**-28  # 1e7 takes 24 bits before the point: 52 in all


def cases(count: int, seed: int, scenes: Path = Path("scenes")) -> Iterator[Case]:
    """Every scene of the project that can be read."""
    for scene in read_own_scenes(scenes):
        grid = min(GRID, max(5, int(np.sqrt(count / 9))))
        yield from of_scene(scene, grid, seed)
        yield whole_picture(scene, min(FULL, 11 * grid), seed)


def of_scene(scene: Scene, grid: int, seed: int) -> Iterator[Case]:
    """All scales, all offsets, and the farthest offset of the smallest and the largest scale."""
    scene = snapped(scene)
    places = [(scale, 0.0) for scale in SCALES if scale != 1.0]
    places += [(1.0, offset) for offset in OFFSETS]
    places += [(scale, scale * OFFSETS[-1]) for scale in (SCALES[0], SCALES[-1])]
    pixels = np.arange(grid * grid)
    base = Tracer(scene).waves(pixels, grid, grid)
    here, acne, odd = verdicts(base[0]), self_blocked(scene, base), not_finite(base)
    worst = []
    for scale, offset in places:
        moved = Tracer(elsewhere(scene, scale, offset)).waves(pixels, grid, grid)
        wrong = int((verdicts(moved[0]) != here).any(axis=1).sum())
        wrong += self_blocked(scene, moved)
        if wrong:
            worst.append(f"{wrong} at x {scale:g} + {offset:g}")
        acne, odd = acne + wrong, odd + not_finite(moved)
    asked = grid * grid * (len(places) + 1)
    yield Case(
        "the project's scenes", f"{scene.id}, 13 scales to 1e6, 7 offsets to 1e7",
        "acne, leaks, other hits, pixels", 0.0, float(acne), asked, seed, note=", ".join(worst),
    )  # fmt: skip
    yield Case(
        "the project's scenes", f"{scene.id}, the same", "NaN or infinity in outputs",
        0.0, float(odd), asked, seed,
    )  # fmt: skip


def whole_picture(scene: Scene, size: int, seed: int) -> Case:
    """The camera's hits in every pixel of the whole picture, as it is and moved by 10^7."""
    scene = snapped(scene)
    one, other = (Tracer(place, depth=0) for place in (scene, elsewhere(scene, 1.0, OFFSETS[-1])))
    wrong = 0
    for pixels in np.array_split(np.arange(size * size), max(1, size * size // STRIP)):
        here, there = (tracer.waves(pixels, size, size) for tracer in (one, other))
        wrong += int((verdicts(here[0]) != verdicts(there[0])).any(axis=1).sum())
        wrong += self_blocked(scene, here) + self_blocked(scene, there)
    return Case(
        "the project's scenes", f"{scene.id}, {size} x {size}, moved by 1e7",
        "acne, leaks, other hits, pixels", 0.0, float(wrong), 2 * size * size, seed,
    )  # fmt: skip


def verdicts(wave: Wave) -> np.ndarray:
    """(n, 1 + lights) the object each ray met, and which lights its hit sees.

    Behind and blocked are the same darkness, seen from either side of a rounding.
    """
    return np.column_stack([wave.hits.object, wave.lighting.visibility == Visibility.REACHED])


def self_blocked(scene: Scene, waves: list[Wave]) -> int:
    """Shadow rays, after any number of bounces, that the surface they leave blocks.

    Of meshes, which may well shadow themselves, `verdicts` tells. So may the inside of a
    convex shape, which is met where a ray comes out of it.
    """
    convex = np.array([not isinstance(obj.shape, Mesh) for obj in scene.objects])
    found = 0
    for wave in waves:
        own = (wave.hits.object != NOWHERE) & convex[wave.hits.object] & ~wave.hits.inside
        blocked = wave.lighting.visibility == Visibility.BLOCKED
        by_itself = wave.lighting.blocker == wave.hits.object[:, None]
        found += int((blocked & by_itself & own[:, None]).any(axis=1).sum())
    return found


def not_finite(waves: list[Wave]) -> int:
    """NaN and infinities in what the waves bring back."""
    odd = 0
    for wave in waves:
        met = wave.hits.object != NOWHERE
        arrays = (
            wave.colour, wave.lighting.diffuse, wave.lighting.specular, wave.lighting.local,
            wave.weight, wave.rays.direction, wave.hits.point[met], wave.hits.t[met],
        )  # fmt: skip
        odd += sum(int((~np.isfinite(array)).sum()) for array in arrays)
    return odd


def snapped(scene: Scene) -> Scene:
    """The scene with eye, lights and translations on multiples of STEP."""

    def near(point: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = (float(round(c / STEP) * STEP) for c in point)
        return x, y, z

    objects = []
    for obj in scene.objects:
        matrix = obj.transform.copy()
        matrix[:3, 3] = near((matrix[0, 3], matrix[1, 3], matrix[2, 3]))
        objects.append(replace(obj, transform=matrix))
    camera = replace(scene.camera, eye=near(scene.camera.eye), target=near(scene.camera.target))
    lights = tuple(replace(light, position=near(light.position)) for light in scene.lights)
    return replace(scene, camera=camera, lights=lights, objects=tuple(objects))


def elsewhere(scene: Scene, scale: float, offset: float) -> Scene:
    """The scene scaled about the origin, then moved; light falls off over the scaled way."""
    moved = np.array([offset, -offset, offset])
    matrix = placed(scale, moved)

    def there(point: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = scale * np.array(point) + moved
        return float(x), float(y), float(z)

    camera: Camera = replace(
        scene.camera, eye=there(scene.camera.eye), target=there(scene.camera.target)
    )
    lights = tuple(
        replace(
            light, position=there(light.position),
            attenuation=(
                light.attenuation[0], light.attenuation[1] / scale, light.attenuation[2] / scale**2
            ),
        )
        for light in scene.lights
    )  # fmt: skip
    objects = tuple(replace(obj, transform=matrix @ obj.transform) for obj in scene.objects)
    return replace(scene, camera=camera, lights=lights, objects=objects)
