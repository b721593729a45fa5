"""A scene compiled for tracing: the only door between the tracer and all geometry."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.geometry.nearest import all_primitives, nearest_among_many, nearest_primitive
from raywalk.geometry.neighbours import neighbours, outermost_first
from raywalk.geometry.primitives import Primitives, compile_primitives, exact_at_edges
from raywalk.geometry.refine import refine_roots
from raywalk.geometry.roots import NOWHERE
from raywalk.geometry.sides import TIE, primitives_beyond
from raywalk.geometry.sphere_tree import MANY, sphere_tree
from raywalk.geometry.surface import Appearance, primitive_surface
from raywalk.optics.compiled import kernel
from raywalk.optics.heap import keep_freed_memory
from raywalk.scene.model import Scene
from raywalk.scene.placement import checker_axes
from raywalk.scene.shapes import Mesh, Plane

if TYPE_CHECKING:
    from raywalk.geometry.base_colour import BaseColours
    from raywalk.geometry.mesh_target import MeshTarget


class Rays(NamedTuple):
    """Rays on their way. Directions are unit except in probes."""

    origin: np.ndarray  # (n, 3) float64 world
    direction: np.ndarray  # (n, 3) float64 world
    leaving: np.ndarray  # (n,) int32: object whose surface a ray starts on, NOWHERE or SOMEWHERE
    inner: np.ndarray  # (n,) bool: it starts to that object's inner side
    triangle: np.ndarray  # (n,) int32: the mesh triangle it starts on, or -1

    def take(self, chosen: np.ndarray) -> Rays:
        """The rays at these indices (or where this mask holds)."""
        return Rays(*rows_of(self, chosen))


class Hits(NamedTuple):
    """What n rays met. Normals are unit and face the incoming ray."""

    t: np.ndarray  # (n,) in units of the direction; inf if nothing is met
    object: np.ndarray  # (n,) int32, NOWHERE if nothing is met
    triangle: np.ndarray  # (n,) int32, of a mesh, else -1
    point: np.ndarray  # (n, 3) on the surface
    normal: np.ndarray  # (n, 3) shading normal
    geometric: np.ndarray  # (n, 3) the surface's own normal
    inside: np.ndarray  # (n,) bool: met from the inner side
    material: np.ndarray  # (n,) int32, -1 if nothing is met

    def take(self, chosen: np.ndarray) -> Hits:
        """The hits at these indices (or where this mask holds)."""
        return Hits(*rows_of(self, chosen))


def rows_of(columns: Iterable[np.ndarray], chosen: np.ndarray) -> Iterator[np.ndarray]:
    """Each column's rows at these indices (or where this mask holds).

    `take` of rows of three is several times as fast as indexing with an array.
    """
    rows = np.flatnonzero(chosen) if chosen.dtype == bool else chosen
    return (column.take(rows, axis=0) for column in columns)


def rays_from(origin: np.ndarray, direction: np.ndarray) -> Rays:
    """Rays that start in free space, such as camera rays."""
    count = len(origin)
    # Whole numbers or another layout in memory: numba would compile every kernel anew for them.
    origin, direction = (np.ascontiguousarray(each, float) for each in (origin, direction))
    nowhere = np.full(count, NOWHERE, np.int32)
    return Rays(origin, direction, nowhere, np.zeros(count, bool), nowhere.copy())


class CompiledScene:
    """Ray queries on a scene. Immutable; queries may run in threads."""

    def __init__(self, scene: Scene):
        keep_freed_memory()
        self.primitives: Primitives = compile_primitives(scene)
        self.rank = _tie_ranks(scene)
        self.appearance = _appearance_of(scene)
        # Only a scene with a mesh pays for trimesh and Embree, at start-up too.
        self.meshes = _compile_meshes(scene)
        vertices = [mesh.triangles.world for mesh in self.meshes]
        self.primitives = exact_at_edges(self.primitives, vertices)
        is_many = len(self.primitives.shape) > MANY
        self.tree = sphere_tree(self.primitives) if is_many else None
        self.base = _base_of(scene, self.primitives, self.meshes)
        self.is_clear = np.array(
            [scene.materials[obj.material].transmit > 0 for obj in scene.objects], bool
        )
        self.neighbours = neighbours(self.primitives, self.meshes, self.is_clear)
        self.outermost_first = outermost_first(scene, self.primitives, self.meshes)

    def nearest(
        self, rays: Rays, t_max: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """t (n,), object (n,), triangle (n,) and (u, v) (n, 2) of the nearest hit before t_max.

        Where a ray has to stop (a shadow ray) it is asked what it meets, and t keeps some more
        roundings.
        """
        t, met, triangle, uv = self._unrefined(rays, t_max)
        if t_max is None:
            every = np.arange(len(t), dtype=np.int32)
            refine_roots(self.primitives, every, rays.origin, rays.direction, rays.leaving, t, met)
        return t, met, triangle, uv

    def _unrefined(
        self, rays: Rays, t_max: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        limit = np.full(len(rays.origin), np.inf) if t_max is None else t_max
        t, met = self._nearest_primitive(rays, limit)
        triangle, uv = np.full(len(t), -1, np.int32), np.zeros((len(t), 2))
        for mesh in self.meshes:
            mesh.meet(
                rays.origin, rays.direction, rays.leaving, rays.triangle, limit, self.rank,
                t, met, triangle, uv,
            )  # fmt: skip
        return t, met, triangle, uv

    def _nearest_primitive(self, rays: Rays, limit: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """t (n,) and object (n,) of the nearest hit before limit (n,), meshes left out."""
        columns = rays.origin, rays.direction, rays.leaving, rays.inner, limit
        if self.tree is None:
            found = nearest_primitive(self.primitives, *columns)
        else:
            endless = np.flatnonzero(np.isinf(self.primitives.reach_sq))
            found = nearest_among_many(self.primitives, self.tree, endless, *columns)
        return found[0], found[1]

    def hits(self, rays: Rays) -> Hits:
        """The nearest hit of each ray with everything shading needs."""
        return self.surface(rays, *self._unrefined(rays))

    def surface(
        self, rays: Rays, t: np.ndarray, met: np.ndarray, triangle: np.ndarray, uv: np.ndarray
    ) -> Hits:
        """The same of rays whose nearest hits are known, as `nearest` gives them where they have
        to stop. t is refined in place."""
        count = len(t)
        point, normal = np.empty((count, 3)), np.empty((count, 3))
        inside, material = np.empty(count, bool), np.empty(count, np.int32)
        primitive_surface(
            self.primitives, self.appearance, rays.origin, rays.direction, rays.leaving, t, met,
            point, normal, inside, material,
        )  # fmt: skip
        geometric = normal
        if self.meshes:
            geometric = normal.copy()
        for mesh in self.meshes:
            mesh.surface(rays.direction, met, triangle, uv, point, normal, geometric, inside)
            material[met == mesh.index] = self.appearance.material[mesh.index]
        return Hits(t, met, triangle, point, normal, geometric, inside, material)

    def base_colours(self, hits: Hits) -> np.ndarray | None:
        """(n, 3) what ambient and diffuse are multiplied by at hits; None: nothing, anywhere."""
        return self.base.at(hits) if self.base else None

    def crossings(self, rays: Rays) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Every hit of rays from free space, nearest first: start (n + 1,), t (h,), object (h,).

        Ray k's hits stand at start[k]:start[k + 1]; where two tie, the first is the one that
        `nearest` names.
        """
        ray, t, met = all_primitives(self.primitives, rays.origin, rays.direction)
        refine_roots(self.primitives, ray, rays.origin, rays.direction, rays.leaving, t, met)
        found = [(ray, t, met)]
        for mesh in self.meshes:
            ray, t = mesh.all_hits(rays.origin, rays.direction)
            found.append((ray, t, np.full(len(t), mesh.index, np.int32)))
        ray, t, met = (np.concatenate(parts) for parts in zip(*found, strict=True))
        order = np.lexsort([self.rank[met], t, ray])
        ray, t, met = ray[order], t[order], met[order]
        order_ties(ray, t, met, self.rank)
        start = np.searchsorted(ray, np.arange(len(rays.origin) + 1))
        return start.astype(np.int32), t, met

    def beyond(
        self, rays: Rays, came: np.ndarray, straight: bool = False
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Which glass rays that start on a surface are in, just beyond their origins: ray (c,),
        object (c,), largest objects first, and whether it is in it (c,) bool.

        Of each ray the object that it leaves and those near it are named; no other can have
        changed there. came: (n,) the distance at which the origins were met, which says how
        close surfaces must be to count as one. straight: rays go on as they came, so the face
        of a mesh that they met tells on which side of it they are.
        """
        found = [
            primitives_beyond(
                self.primitives, self.is_clear, self.neighbours.start, self.neighbours.object,
                rays.origin, rays.direction, rays.leaving, rays.inner,
            )
        ]  # fmt: skip
        found += [
            self._beyond_mesh(mesh, rays, came, straight) for mesh in self.meshes if mesh.glass
        ]
        ray, who, within = (np.concatenate(parts) for parts in zip(*found, strict=True))
        if not self.neighbours.any():
            return ray, who, within
        order = np.argsort(self.outermost_first[who], kind="stable")
        return ray[order], who[order], within[order]

    def _beyond_mesh(
        self, mesh: MeshTarget, rays: Rays, came: np.ndarray, straight: bool
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The same of one mesh: by its normal on a face, by what comes next where in doubt."""
        at = np.flatnonzero(
            (rays.leaving == mesh.index) | self.neighbours.beside(mesh.index)[rays.leaving]
        )
        own = np.where(rays.leaving[at] == mesh.index, rays.triangle[at], -1).astype(np.int32)
        straight = straight and not mesh.triangles.layered
        asked = np.flatnonzero(own < 0) if straight else np.arange(len(at))
        doubtful = asked
        if not mesh.triangles.layered:  # there a face does not tell which side it bounds
            doubtful = asked[
                mesh.in_doubt(
                    rays.origin[at[asked]], rays.direction[at[asked]], own[asked],
                    2.0 * TIE * came[at[asked]],
                )
            ]  # fmt: skip
        within = rays.inner[at]
        unsure = at[doubtful]
        within[doubtful] = mesh.holds(rays.origin[unsure], rays.direction[unsure], own[doubtful])
        known = own >= 0
        known[doubtful] = True
        ray = at[known].astype(np.int32)
        return ray, np.full(len(ray), mesh.index, np.int32), within[known]

    def count_tests(self, rays: Rays, t_max: np.ndarray) -> np.ndarray:
        """(n,) intersection tests a ray needs: every primitive, and each mesh's tree."""
        tests = np.full(len(rays.origin), len(self.primitives.shape), np.int32)
        for mesh in self.meshes:
            own = np.where(rays.leaving == mesh.index, rays.triangle, -1).astype(np.int32)
            tests += mesh.count_tests(rays.origin, rays.direction, t_max, own)
        return tests


@kernel
def order_ties(ray, t, met, rank):
    """Lets the lower rank come first where two tie; rays and distances stay as they are."""
    for k in range(1, ray.shape[0]):
        place = k
        while (
            place > 0 and ray[place - 1] == ray[place] and rank[met[place - 1]] > rank[met[place]]
        ):
            if t[place] - t[place - 1] > TIE * t[place]:
                break
            met[place - 1], met[place] = met[place], met[place - 1]
            place -= 1


def _tie_ranks(scene: Scene) -> np.ndarray:
    """(objects,) int: of surfaces that tie the lowest is met. Opaque ones come first (a glass that
    stands on a floor does not let light through it), then the order of the scene."""
    clear = [scene.materials[obj.material].transmit > 0 for obj in scene.objects]
    order = sorted(range(len(clear)), key=lambda k: clear[k])
    return np.argsort(np.array(order, int))


def _appearance_of(scene: Scene) -> Appearance:
    count = len(scene.objects)
    checker, size, turn = np.full(count, -1, np.int32), np.ones(count), np.ones(count)
    for k, obj in enumerate(scene.objects):
        if obj.checker is None:
            continue
        assert isinstance(obj.shape, Plane)
        normal = np.array(obj.shape.normal, float)
        u, v = checker_axes(normal)
        checker[k], size[k] = obj.checker.material, obj.checker.size
        turn[k] = np.sign(v @ np.cross(u, normal))
    material = np.array([obj.material for obj in scene.objects], np.int32)
    return Appearance(material, checker, size, turn)


def _base_of(scene: Scene, primitives: Primitives, meshes: list[MeshTarget]) -> BaseColours | None:
    """None where no object has a base colour: such a scene imports nothing of it."""
    if not any(obj.base for obj in scene.objects):
        return None
    from raywalk.geometry.base_colour import BaseColours

    return BaseColours(scene, primitives, meshes)


def _compile_meshes(scene: Scene) -> list[MeshTarget]:
    indices = [k for k, obj in enumerate(scene.objects) if isinstance(obj.shape, Mesh)]
    if not indices:
        return []
    from raywalk.geometry.mesh_kept import mesh_target

    targets, problems = [], []
    for k in indices:
        obj = scene.objects[k]
        try:
            glass = scene.materials[obj.material].transmit > 0
            targets.append(mesh_target(scene, k, glass))
        except SourceErrors as raised:
            problems += raised.errors
            continue
        if glass and not targets[-1].triangles.closed:
            problems.append(_open_glass(scene, targets[-1]))
    if problems:
        raise SourceErrors(problems)
    return targets


def _open_glass(scene: Scene, mesh: MeshTarget) -> SourceError:
    from raywalk.geometry.mesh_file import where_open

    name = scene.objects[mesh.index].name
    return SourceError(
        scene.path,
        f"objects[{mesh.index}].material",
        f'"{name}" is an open mesh ({where_open(mesh.triangles)}), and light would enter glass '
        "that it never leaves",
        allowed="glass (transmit > 0) needs a closed mesh",
        hint="close it in the program that made it; a larger `weld` joins corners that are near",
    )
