"""What tracing a scene did, and what it did not have to do."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, fields
from typing import Any

import numpy as np

from raywalk.geometry.compiled import CompiledScene, Rays
from raywalk.geometry.roots import NOWHERE
from raywalk.geometry.savings import tests_saved
from raywalk.scene.model import Scene
from raywalk.trace.tree import Kind, Visibility
from raywalk.trace.wave import Wave

# What is counted where rays are recorded.
OF_KEPT = ("kept_pixels", "tests", "tests_saved", "mesh_rays", "mesh_rays_saved")


@dataclass
class Tally:
    """Counts over a picture; the last four over its kept rays only, shadow rays not among them."""

    pixels: int = 0
    kept_pixels: int = 0  # those that some frustum resolution uses: their trees are kept
    rays: np.ndarray = field(default_factory=lambda: np.zeros(len(Kind), np.int64))  # by Kind
    faint: int = 0  # rays not sent on: their share in the pixel is too small
    shadow: int = 0  # shadow rays shot
    turned: int = 0  # not shot: the surface is turned away from the light
    colourless: int = 0  # not shot: the surface has no colour of its own
    dark: int = 0  # not shot: the light gives nothing
    unshadowed: int = 0  # not shot: the scene has no shadows
    tests: int = 0  # exact tests with primitives
    tests_saved: int = 0  # not made: the ray passes by the sphere round the primitive
    mesh_rays: int = 0  # pairs of a ray and a mesh
    mesh_rays_saved: int = 0  # not asked: the ray passes by the box round the mesh

    def add(self, other: Tally) -> None:
        """Counts another strip in."""
        for each in fields(self):
            setattr(self, each.name, getattr(self, each.name) + getattr(other, each.name))

    def as_dict(self) -> dict[str, Any]:
        """As JSON values; rays by the names of their kinds."""
        return asdict(self) | {"rays": {kind.name.lower(): int(self.rays[kind]) for kind in Kind}}


def tally_wave(scene: Scene, asked: tuple[bool, ...], wave: Wave) -> Tally:
    """All rays of one of a strip's waves."""
    tally = Tally(rays=np.bincount(wave.kind, minlength=len(Kind)), faint=wave.faint)
    seen = np.bincount(wave.lighting.visibility.reshape(-1), minlength=len(Visibility))
    tally.turned = int(seen[Visibility.BEHIND])
    tally.shadow = int(seen[Visibility.BLOCKED] + seen[Visibility.REACHED])
    hit = wave.hits.object != NOWHERE
    own = wave.lighting.local_weight > 0.0
    tally.colourless = int(np.count_nonzero(hit & ~own)) * sum(asked)
    if scene.render.shadows:
        tally.dark = int(np.count_nonzero(own)) * asked.count(False)
    else:
        tally.unshadowed = int(np.count_nonzero(own)) * len(asked)
    return tally


def tally_tests(compiled: CompiledScene, rays: Rays, t: np.ndarray) -> Tally:
    """What bounding volumes spare kept rays; t: (n,) where each ends."""
    saved = tests_saved(compiled.primitives, rays.origin, rays.direction)
    tally = Tally(
        tests=len(t) * len(compiled.primitives.shape) - saved,
        tests_saved=saved,
        mesh_rays=len(t) * len(compiled.meshes),
    )
    if compiled.meshes:
        from raywalk.geometry.mesh_savings import goes_past_box

        for mesh in compiled.meshes:
            local = rays.origin - mesh.centre
            tally.mesh_rays_saved += int(goes_past_box(mesh.bvh, local, rays.direction, t).sum())
    return tally
