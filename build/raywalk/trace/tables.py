"""Materials and lights as arrays, which the kernels read.

The last row of the materials is nothing at all: a ray that meets no object has material
-1, which reads that row, so that no stage needs a special case for it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.scene.model import Material, Scene


class Materials(NamedTuple):
    """One row a material."""

    ambient: np.ndarray  # (m, 3)
    diffuse: np.ndarray  # (m, 3)
    specular: np.ndarray  # (m, 3)
    shininess: np.ndarray  # (m,)
    reflect: np.ndarray  # (m,)
    transmit: np.ndarray  # (m,)
    ior: np.ndarray  # (m,)
    fresnel: np.ndarray  # (m,) bool


class Lights(NamedTuple):
    """One row a light."""

    position: np.ndarray  # (l, 3) world
    colour: np.ndarray  # (l, 3)
    intensity: np.ndarray  # (l,)
    attenuation: np.ndarray  # (l, 3): a0, a1, a2


def compile_materials(scene: Scene) -> Materials:
    """Arrays of the scene's materials, and nothing as the last one."""
    rows = (*scene.materials, Material("nothing"))
    kinds = {"fresnel": bool}
    return Materials(*(
        np.array([getattr(m, name) for m in rows], kinds.get(name, float))
        for name in Materials._fields
    ))  # fmt: skip


def compile_lights(scene: Scene) -> Lights:
    """Arrays of the scene's lights."""
    rows = scene.lights
    return Lights(
        _triples([light.position for light in rows]),
        _triples([light.colour for light in rows]),
        np.array([light.intensity for light in rows], float),
        _triples([light.attenuation for light in rows]),
    )


def _triples(values: list) -> np.ndarray:
    return np.array(values, float).reshape(-1, 3)
