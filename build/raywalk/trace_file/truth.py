"""True values of every number column, in steps: what the encoder rounds and writes."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from raywalk.trace.tree import Kind, RayTree
from raywalk.trace_file import rebuild
from raywalk.trace_file.noting import Ray
from raywalk.trace_file.tables import drawn_hits
from raywalk.trace_file.walk import images_along


class TrueNumbers:
    """Call it with a column's name and the columns rebuilt so far."""

    def __init__(
        self, tree: RayTree, header: dict[str, Any], symbols: dict[str, np.ndarray],
        tile: np.ndarray,
    ):  # fmt: skip
        self.tree, self.header, self.symbols, self.tile = tree, header, symbols, tile
        self.depths = self._depths()
        self.coordinates: np.ndarray | None = None

    def __call__(self, name: str, ray: Ray) -> np.ndarray:
        match = re.fullmatch(r"([a-z]+)(\d*)", name)
        assert match
        column, k = match.groups()
        return np.asarray(getattr(self, f"_{column}")(int(k or 0), ray), float)

    def _depths(self) -> np.ndarray:
        """(images, n * n) 1 / z in steps."""
        header, tree = self.header, self.tree
        slant = rebuild.length(rebuild.camera_steps(header["camera"], header["n"]))
        step = np.array([image["step"] for image in header["images"]])
        along = images_along(header["tables"]["signature"], header["images"])
        depths = np.zeros((len(step), len(slant)))
        ray, place, t = drawn_hits(tree, header["camera"]["eye"])
        image = along[self.symbols["signature"][ray], place]
        depths[image, ray] = slant[ray] / t / step[image]
        return depths

    def _depth(self, k: int, ray: Ray) -> np.ndarray:
        return self.depths[k]

    def _point(self, k: int, ray: Ray) -> np.ndarray:
        if self.coordinates is None:
            self.coordinates = self._all_coordinates(ray["patch"])
        return self.coordinates[k]

    def _all_coordinates(self, patch_of: np.ndarray) -> np.ndarray:
        out = np.zeros((3, len(patch_of)))
        for k, patch in enumerate(self.header["patches"]):
            rows = np.flatnonzero((patch_of == k) & (self.tree.parent >= 0))
            if not len(rows):
                continue
            point = self.tree.point[rows]
            if patch["points"] == "free":
                at = point.T
            else:
                axes = np.array(patch["axes"]).reshape(-1, 3)
                away = point - patch["origin"]
                if patch["points"] == "flat":
                    at = axes @ away.T
                else:
                    at = np.stack(rebuild.to_octahedron(np.linalg.solve(axes.T, away.T).T))
            out[: len(at), rows] = at / patch["step"]
        return out

    def _normal(self, k: int, ray: Ray) -> np.ndarray:
        hit = (self.tree.normal**2).sum(axis=1) > 0
        up = np.where(hit[:, None], self.tree.normal, [0.0, 0.0, 1.0])
        return rebuild.to_octahedron(up)[k] / self.header["steps"]["normal"]

    def _split(self, k: int, ray: Ray) -> np.ndarray:
        """The reflected share; from the refracted child where the reflected was not sent."""
        tree, share = self.tree, np.zeros(len(self.tree.pixel))
        split = np.array([m["split"] for m in self.header["materials"]])
        for kind in (Kind.REFRACTED, Kind.REFLECTED):
            rows = np.flatnonzero(tree.kind == kind)
            parent, weight = tree.parent[rows], tree.weight[rows]
            both = split[tree.material[parent]]
            share[parent] = weight if kind == Kind.REFLECTED else both - weight
        return share / self.header["steps"]["split"]

    def _tests(self, k: int, ray: Ray) -> np.ndarray:
        return self.tree.tests

    def _blocked(self, k: int, ray: Ray) -> np.ndarray:
        position = self.header["lights"][k]["position"]
        to_light = rebuild.length([position[c] - ray["point"][:, c] for c in range(3)])
        return (1 - self.tree.blocked_at[:, k]) * to_light / self.header["steps"]["blocked"]

    def _diffuse(self, k: int, ray: Ray) -> np.ndarray:
        return self.tree.diffuse[:, k] / self.tree.passed[:, k] / self._light_steps()

    def _specular(self, k: int, ray: Ray) -> np.ndarray:
        return self.tree.specular[:, k] / self.tree.passed[:, k] / self._light_steps()

    def _light_steps(self) -> np.ndarray:
        return np.array([*(m["step"] for m in self.header["materials"]), 1.0])[self.tree.material]

    def _tile(self, k: int, ray: Ray) -> np.ndarray:
        return self.tile[:, k]
