"""The base colour where a ray meets an object: what its ambient and diffuse are multiplied by."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.geometry.texture_lookup import looked_up
from raywalk.geometry.texture_places import ends_of, places_on
from raywalk.scene.model import BASE_STEPS, Scene, SceneObject, Texture
from raywalk.scene.pictures import PictureFault, read_texture

if TYPE_CHECKING:
    from raywalk.geometry.compiled import Hits
    from raywalk.geometry.mesh_file import Triangles
    from raywalk.geometry.mesh_target import MeshTarget
    from raywalk.geometry.primitives import Primitives


class BaseColours:
    """Of a scene's objects, at any of their points. Immutable; may be asked in threads."""

    def __init__(self, scene: Scene, primitives: Primitives, meshes: list[MeshTarget]):
        """Raises SourceErrors if a texture's file has gone since the scene was read."""
        self._based = {k: obj for k, obj in enumerate(scene.objects) if obj.base}
        self._primitives = primitives
        self._meshes = {mesh.index: mesh for mesh in meshes}
        self._pixels = {
            texture: _pixels(scene, obj, texture)
            for obj in self._based.values()
            if obj.base and (texture := obj.base.texture)
        }

    def at(self, hits: Hits) -> np.ndarray:
        """(n, 3) linear, in steps of 1/BASE_STEPS, halves up; 1 where nothing was met, or an
        object without one."""
        colour = np.ones((len(hits.t), 3))
        for k, obj in self._based.items():
            rows = np.flatnonzero(hits.object == k)
            if not len(rows):
                continue
            if k in self._meshes:
                mesh = self._meshes[k]
                point, triangle = hits.point[rows] - mesh.centre, hits.triangle[rows]
                found = self.on_mesh(obj, mesh.triangles, mesh.corners, triangle, point)
            else:
                found = self.on_shape(obj, self._canonical(k, hits.point[rows]))
            colour[rows] = found
        return np.floor(BASE_STEPS * colour + 0.5) / BASE_STEPS

    def pixels_of(self, texture: Texture) -> np.ndarray:
        """(h, w, 3) uint8, row 0 on top."""
        return self._pixels[texture]

    def on_shape(self, obj: SceneObject, local: np.ndarray) -> np.ndarray:
        """(n, 3) at points (n, 3) in the shape's canonical coordinates."""
        texture = obj.base.texture if obj.base else None
        if texture is None:
            return np.ones((len(local), 3))
        places, ends = places_on(obj.shape, local), ends_of(obj.shape)
        return looked_up(self._pixels[texture], places, texture.filter, texture.repeat, ends)

    def on_mesh(
        self, obj: SceneObject, triangles: Triangles, corners: np.ndarray, triangle: np.ndarray,
        point: np.ndarray,
    ) -> np.ndarray:  # fmt: skip
        """(n, 3) at points (n, 3), relative to the mesh's centre, of its triangles (n,).

        corners: triangles.corners, which takes its time to be put together.
        Where the file tells no colour or no place in the picture it is 1.
        """
        from raywalk.geometry.mesh_corners import interpolated

        assert obj.base
        colour = np.ones((len(point), 3))
        if triangles.colours is not None:
            given = interpolated(corners, triangles.colours, triangle, point)
            colour = np.where(np.isfinite(given), given, 1.0)
        texture, places = obj.base.texture, triangles.places
        if texture and places is not None:
            at = interpolated(corners, places, triangle, point)
            known = np.isfinite(at).all(axis=1)
            found = looked_up(self._pixels[texture], at[known], texture.filter, texture.repeat)
            colour[known] *= found
        return colour

    def _canonical(self, k: int, point: np.ndarray) -> np.ndarray:
        """Points (n, 3) of object k in its canonical coordinates."""
        table, row = self._primitives, self._primitives.row_of[k]
        away = (point - table.centre[row]) - table.centre_rest[row]
        return np.asarray(away @ table.to_local[row].T)


def _pixels(scene: Scene, obj: SceneObject, texture: Texture) -> np.ndarray:
    try:
        return read_texture(texture)
    except PictureFault as fault:
        key, cause = f'objects "{obj.name}".material.texture', f"{texture.path.name} {fault.cause}"
        raise SourceErrors([SourceError(scene.path, key, cause, hint=fault.remedy)]) from None
