"""The nearest triangle of one mesh: Embree proposes, float64 decides.

Embree works on a float32 copy, centred and scaled to unit size, with rays that start
where they enter its box: so neither the scene's scale nor its distance from the origin
matters. What float32 cannot decide (a hit close to an edge, a grazed triangle, surfaces
almost touching, a proposal that float64 refuses) is traced again in the float64 tree.
"""

from __future__ import annotations

import numpy as np

from raywalk.geometry.bvh import Bvh, box_entry, build_bvh, bvh_all, bvh_nearest
from raywalk.geometry.float32_copy import GAP, MITRE, STEEPEST, covers, trusted_above
from raywalk.geometry.mesh_file import Triangles
from raywalk.geometry.mesh_sides import holds_ahead, is_near, leaves, outline_hit
from raywalk.geometry.sides import POINT_ERROR
from raywalk.geometry.triangle import height_over, shear, triangle_hit, triangle_normal, vector
from raywalk.optics.compiled import kernel

# In the unit-sized copy, where float32 steps are 6e-8:
LIFT = 1e-6  # how far a ray that leaves the mesh starts off it for Embree
EARLIER = 2e-6  # how far before its origin any other ray starts
ROOM = 2.0 * MITRE  # or round the mesh's box: covers and walls do not reach so far
# Error bounds: a ray that starts closer to another face than this is asked where it goes.
DOUBT = 16.0
# Cosine below which rounding, far from the origin too, may take a ray through a face it runs along.
ALONG = 1e-9


class MeshTarget:
    """One mesh object, ready for ray queries. Immutable; queries may run in threads."""

    def __init__(self, index: int, triangles: Triangles, glass: bool = False):
        from embreex import rtcore_scene
        from embreex.mesh_construction import TriangleMesh

        self.index = index  # of the object in Scene.objects
        self.triangles = triangles
        self.glass = glass  # rays may be in it
        self.centre = triangles.centre
        self.corners = triangles.corners
        low, high, skip, first, held, order = build_bvh(self.corners)
        self.bvh = Bvh(
            low, high, skip, first, held, order,
            triangles.faces, triangles.world, triangles.world_rest, triangles.off,
        )  # fmt: skip
        self.scale = 1.0 / float(np.abs(triangles.vertices[triangles.faces]).max())
        self.size = 1.0 / self.scale
        self._embree = rtcore_scene.EmbreeScene(robust=True)
        unit, self._stands_for = covers(self.corners * self.scale, triangles.faces)
        # Kept alive by the scene; everything is added before the first query, as Embree needs.
        self._mesh = TriangleMesh(self._embree, unit)
        self._roomy = np.stack(
            [self.bvh.low[:1] - ROOM * self.size, self.bvh.high[:1] + ROOM * self.size]
        )
        self._trusted = trusted_above(self.corners, self.scale, self.bvh)

    def nearest(
        self, origin: np.ndarray, direction: np.ndarray, t_max: np.ndarray, own: np.ndarray,
        on_other: np.ndarray, on_any: bool = False,
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:  # fmt: skip
        """t (n,), triangle (n,) and barycentric (u, v) (n, 2) before t_max; inf and -1 if none.

        origin, direction: (n, 3) float64 world; own: (n,) the triangle a ray starts on, or -1;
        on_other: (n,) bool, it starts on another object, which may touch this one; on_any: or on
        this one, on a triangle that nobody knows.
        """
        count = len(origin)
        t, triangle = np.full(count, np.inf), np.full(count, -1, np.int32)
        uv = np.zeros((count, 2))
        inside = np.empty((count, 3), np.float64)
        starts = np.empty((count, 3), np.float32)
        crossing = enter_box(
            self.bvh, self._roomy, self.corners, self.centre, self.scale, origin, direction,
            t_max, own, inside, starts,
        )  # fmt: skip
        if not len(crossing):
            return t, triangle, uv
        touching = np.zeros(count, np.bool_)
        if self.glass or on_any:
            touching = start_close(
                self.bvh, self.corners, self.centre, origin, on_other & (own < 0), GAP * self.size
            )
        proposed = self._propose(starts[: len(crossing)], direction[crossing])
        redo = decide(
            self.corners, self._trusted, self.triangles.closed, inside, direction, t_max, own,
            touching, crossing, proposed, t, triangle, uv,
        )  # fmt: skip
        redo_in_float64(
            self.bvh, self.corners, self.centre, self.glass, origin, inside, direction, t_max, own,
            touching, redo, t, triangle, uv,
        )  # fmt: skip
        return t, triangle, uv

    def in_doubt(
        self, origin: np.ndarray, direction: np.ndarray, own: np.ndarray, error: np.ndarray
    ) -> np.ndarray:
        """Rays (c,) int of which the face they start on does not tell where they go: they start
        off another object, at an edge, or along the face.

        error: (n,) how far apart surfaces may be that count as one.
        """
        return doubtful(
            self.bvh, self.corners, self.centre, self._trusted, origin, direction, own,
            np.maximum(error, DOUBT * self.bound_at(origin)),
        )  # fmt: skip

    def holds(self, origin: np.ndarray, direction: np.ndarray, own: np.ndarray) -> np.ndarray:
        """(n,) bool: whether rays that start on a surface are in this closed mesh from there on.

        They are if they next come out of it. So what a ray is in and what it will meet agree,
        however rounding has placed surfaces that touch. Where its shells lie in one another, what
        comes next may be an inner one's: all that come are counted.
        """
        count = len(origin)
        if self.triangles.layered:
            return in_any_shell(self.bvh, self.corners, self.centre, origin, direction, own)
        nowhere = np.full(count, np.inf)
        _, triangle, _ = self.nearest(origin, direction, nowhere, own, np.full(count, True))
        return next_leaves(self.corners, triangle, direction)

    def all_hits(self, origin: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Every hit of rays from free space: ray (h,) and t (h,), by ray, nearest first."""
        return every_hit(self.bvh, self.corners, origin, origin - self.centre, direction)

    def count_tests(
        self, origin: np.ndarray, direction: np.ndarray, t_max: np.ndarray, own: np.ndarray
    ) -> np.ndarray:
        """(n,) boxes and triangles that the bounding-volume tree tests for each ray."""
        return tests_made(
            self.bvh, self.corners, origin, origin - self.centre, direction, t_max, own,
            self.bound(origin),
        )  # fmt: skip

    def surface(
        self, direction: np.ndarray, met: np.ndarray, triangle: np.ndarray, uv: np.ndarray,
        point: np.ndarray, normal: np.ndarray, geometric: np.ndarray, inside: np.ndarray,
    ) -> None:  # fmt: skip
        """Fills the last four arguments for the rays that met this mesh."""
        smooth = self.triangles.normals
        mesh_surface(
            self.corners, self.triangles.normal_rows,
            np.zeros((0, 3)) if smooth is None else smooth, self.centre,
            direction, met, self.index, triangle, uv, point, normal, geometric, inside,
        )  # fmt: skip

    def bound_at(self, origin: np.ndarray) -> np.ndarray:
        """(n,) how far each point may be off this mesh, world units."""
        reach = np.abs(origin).sum(axis=1) + np.abs(self.centre).sum() + self.size
        return np.asarray(POINT_ERROR * reach)

    def bound(self, origin: np.ndarray) -> float:
        """How far a point on this mesh may be off it, world units."""
        reach = np.abs(origin).sum(axis=1).max(initial=0.0)
        return float(POINT_ERROR * (reach + np.abs(self.centre).sum() + self.size))

    def _propose(self, starts: np.ndarray, directions: np.ndarray) -> np.ndarray:
        toward = directions.astype(np.float32)
        met = np.asarray(self._embree.run(starts, toward, query="INTERSECT"))
        return np.where(met < 0, np.int32(-1), self._stands_for[met])


@kernel
def enter_box(bvh, roomy, corners, centre, scale, origin, direction, t_max, own, local, starts):
    """Indices of the rays that cross the mesh's box before t_max.

    Fills local (n, 3), origins relative to the mesh's centre and, of rays that leave a triangle,
    on its plane; and starts (crossing, 3), where
    Embree's ray begins in the unit-sized copy: just off the triangle it leaves, else a little
    before its origin or where it enters `roomy` (2, 1, 3), the box with ROOM around it, so that
    rounding takes it behind no triangle and no wall.
    """
    crossing = np.empty(origin.shape[0], np.int64)
    filled = 0
    for i in range(origin.shape[0]):
        for k in range(3):
            local[i, k] = origin[i, k] - centre[k]
        if own[i] >= 0:
            onto_plane(corners, own[i], local, i)
        o, d = vector(local, i), vector(direction, i)
        length_sq = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
        # NaN passes every box test, and costs Embree as much as hundreds of other rays.
        if not 0.0 < length_sq < np.inf or np.isnan(o[0] + o[1] + o[2]):
            continue
        entry = box_entry(bvh.low, bvh.high, 0, o, d, t_max[i])
        if not entry < np.inf:
            continue
        side, n = 0.0, (0.0, 0.0, 0.0)
        if own[i] >= 0:
            n = triangle_normal(corners, own[i])
            side = LIFT if n[0] * d[0] + n[1] * d[1] + n[2] * d[2] > 0.0 else -LIFT
        else:
            entry = box_entry(roomy[0], roomy[1], 0, o, d, np.inf)
            entry -= EARLIER / (scale * np.sqrt(length_sq))
        for k in range(3):
            starts[filled, k] = (o[k] + entry * d[k]) * scale + side * n[k]
        crossing[filled] = i
        filled += 1
    return crossing[:filled]


@kernel
def onto_plane(corners, k, local, i):
    """Moves a start local[i] onto the plane of the triangle k that it leaves.

    Far from the origin a world point is off its triangle by 1e-16 of that distance. A ray that
    leaves flatly from so far below would run on inside, and meet a neighbour from behind.
    """
    height = height_over(vector(local, i), corners, k)
    nx, ny, nz = triangle_normal(corners, k)
    local[i, 0] -= height * nx
    local[i, 1] -= height * ny
    local[i, 2] -= height * nz


@kernel
def decide(
    corners, trusted, closed, local, direction, t_max, own, touching, crossing, proposed,
    t, triangle, uv,
):  # fmt: skip
    """Takes the proposals that float32 cannot have got wrong; returns the rays left open.

    closed: of an open mesh a ray that runs flat along it may meet nothing else, where float32 loses
    it. trusted: (triangles, 3) barycentric coordinates above which a hit is certain; touching: (n,)
    whether a ray starts so close to the mesh that float32 may place it behind it.
    """
    redo = np.empty(crossing.shape[0], np.int64)
    open_cases = 0
    for place in range(crossing.shape[0]):
        i, who = crossing[place], proposed[place]
        o, d = vector(local, i), vector(direction, i)
        unseen = who < 0 and not closed
        if unseen or touching[i] or (own[i] >= 0 and not starts_clear(corners, trusted, own[i], o)):
            redo[open_cases] = i
            open_cases += 1
            continue
        if who < 0:
            continue
        kx, ky, kz, sx, sy, sz = shear(d[0], d[1], d[2])
        distance, u, v = triangle_hit(o, corners, who, kx, ky, kz, sx, sy, sz)
        clear = is_clear(trusted, who, u, v)
        if who == own[i] or not clear or not distance > 0.0 or is_grazed(corners, who, d):
            redo[open_cases] = i
            open_cases += 1
        elif distance < t_max[i]:
            t[i], triangle[i], uv[i, 0], uv[i, 1] = distance, who, u, v
    return redo[:open_cases]


@kernel
def is_clear(trusted, k, u, v):
    """Whether a place on triangle k is far enough from its edges, and from other triangles."""
    return 1.0 - u - v > trusted[k, 0] and u > trusted[k, 1] and v > trusted[k, 2]


@kernel
def is_grazed(corners, k, d):
    """Whether a direction runs so flat along triangle k that float32 loses the depth of a hit."""
    nx, ny, nz = triangle_normal(corners, k)
    along = nx * d[0] + ny * d[1] + nz * d[2]
    return along * along < STEEPEST * STEEPEST * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2])


@kernel
def is_along(corners, k, d):
    """Whether a direction runs along triangle k but for rounding."""
    nx, ny, nz = triangle_normal(corners, k)
    return abs(nx * d[0] + ny * d[1] + nz * d[2]) <= ALONG


@kernel
def starts_clear(corners, trusted, k, at):
    """Whether a point of triangle k lies where nothing else is so close that LIFT could skip it."""
    nx, ny, nz = triangle_normal(corners, k)
    kx, ky, kz, sx, sy, sz = shear(nx, ny, nz)
    _, u, v = triangle_hit(at, corners, k, kx, ky, kz, sx, sy, sz)  # straight down on its plane
    return is_clear(trusted, k, u, v)


@kernel
def origin_bound(o, centre):
    """How far a ray's origin, relative to the mesh's centre, may be off the surface it is on."""
    reach = abs(o[0]) + abs(o[1]) + abs(o[2])
    return POINT_ERROR * (reach + 2.0 * (abs(centre[0]) + abs(centre[1]) + abs(centre[2])))


@kernel
def redo_in_float64(
    bvh,
    corners,
    centre,
    glass,
    origin,
    local,
    direction,
    t_max,
    own,
    touching,
    redo,
    t,
    triangle,
    uv,
):
    """Traces rays again in the float64 tree and overwrites their results."""
    for i in redo:
        o, d, bound = vector(local, i), vector(direction, i), 0.0
        if own[i] >= 0 or touching[i]:
            bound = origin_bound(o, centre)
        start = vector(origin, i)
        distance, who, u, v, _ = bvh_nearest(bvh, corners, start, o, d, t_max[i], own[i], bound)
        if who >= 0:
            distance, who, u, v = outline_hit(
                bvh, corners, glass, start, o, d, own[i], bound, distance, who, u, v
            )
        t[i], triangle[i], uv[i, 0], uv[i, 1] = distance, who, u, v


@kernel
def start_close(bvh, corners, centre, origin, asked, radius):
    """(n,) bool: which of the asked points lie this close to a mesh."""
    close = np.zeros(origin.shape[0], np.bool_)
    for i in range(origin.shape[0]):
        if asked[i]:
            o = (origin[i, 0] - centre[0], origin[i, 1] - centre[1], origin[i, 2] - centre[2])
            close[i] = is_near(bvh, corners, o, radius, -1)
    return close


@kernel
def doubtful(bvh, corners, centre, trusted, origin, direction, own, error):
    """Indices of the rays that start this close to a triangle other than their own, or along
    their own."""
    asked, filled = np.empty(origin.shape[0], np.int64), 0
    for i in range(origin.shape[0]):
        o = (origin[i, 0] - centre[0], origin[i, 1] - centre[1], origin[i, 2] - centre[2])
        flat = own[i] >= 0 and is_along(corners, own[i], vector(direction, i))
        if not flat and own[i] >= 0 and starts_clear(corners, trusted, own[i], o):
            continue
        if flat or is_near(bvh, corners, o, error[i], own[i]):
            asked[filled] = i
            filled += 1
    return asked[:filled]


@kernel
def next_leaves(corners, triangle, direction):
    """(n,) bool: whether rays pass the triangle they meet next outwards; not if they meet none."""
    answer = np.zeros(triangle.shape[0], np.bool_)
    for i in range(triangle.shape[0]):
        if triangle[i] >= 0:
            answer[i] = leaves(corners, triangle[i], vector(direction, i))
    return answer


@kernel
def in_any_shell(bvh, corners, centre, origin, direction, own):
    """(n,) bool: whether rays are in a mesh of several layers, just beyond their origins."""
    answer = np.zeros(origin.shape[0], np.bool_)
    local = np.empty((1, 3))
    for i in range(origin.shape[0]):
        for k in range(3):
            local[0, k] = origin[i, k] - centre[k]
        if own[i] >= 0:
            onto_plane(corners, own[i], local, 0)
        o, d = vector(local, 0), vector(direction, i)
        answer[i] = holds_ahead(bvh, corners, o, d, own[i], origin_bound(o, centre))
    return answer


@kernel
def every_hit(bvh, corners, origin, local, direction):
    """All hits of each ray: index (h,) and t (h,), nearest first."""
    found, entering = np.empty(corners.shape[0]), np.empty(corners.shape[0], np.bool_)
    total = 0
    for i in range(local.shape[0]):
        start, o, d = vector(origin, i), vector(local, i), vector(direction, i)
        total += bvh_all(bvh, corners, start, o, d, found, entering)
    ray, t = np.empty(total, np.int32), np.empty(total)
    filled = 0
    for i in range(local.shape[0]):
        start, o, d = vector(origin, i), vector(local, i), vector(direction, i)
        n = bvh_all(bvh, corners, start, o, d, found, entering)
        ray[filled : filled + n], t[filled : filled + n] = i, found[:n]
        filled += n
    return ray, t


@kernel
def tests_made(bvh, corners, origin, local, direction, t_max, own, bound):
    """Boxes and triangles tested per ray."""
    tests = np.empty(local.shape[0], np.int32)
    for i in range(local.shape[0]):
        at_surface = bound if own[i] >= 0 else 0.0
        _, _, _, _, tests[i] = bvh_nearest(
            bvh, corners, vector(origin, i), vector(local, i), vector(direction, i), t_max[i],
            own[i], at_surface,
        )  # fmt: skip
    return tests


@kernel
def mesh_surface(
    corners, rows, normals, centre, direction, met, index, triangle, uv,
    point, normal, geometric, inside,
):  # fmt: skip
    """Fills point, shading normal, geometric normal and side of rays that met object `index`.

    Both normals face the incoming ray; the side is the geometric one's. An interpolated
    normal that still looks away at a silhouette is bent back until it is square to the ray.
    normals: (n, 3), or (0, 3) for a flat mesh; rows: (f, 3) of its corners' normals.
    """
    for i in range(direction.shape[0]):
        if met[i] != index:
            continue
        k, u, v = triangle[i], uv[i, 0], uv[i, 1]
        w = 1.0 - u - v
        for c in range(3):
            mean = w * corners[k, 0, c] + u * corners[k, 1, c] + v * corners[k, 2, c]
            point[i, c] = centre[c] + mean
        gx, gy, gz = triangle_normal(corners, k)
        d = vector(direction, i)
        inside[i] = gx * d[0] + gy * d[1] + gz * d[2] > 0.0
        sign = -1.0 if inside[i] else 1.0
        geometric[i, 0], geometric[i, 1], geometric[i, 2] = sign * gx, sign * gy, sign * gz
        nx, ny, nz = sign * gx, sign * gy, sign * gz
        if normals.shape[0] > 0:
            nx, ny, nz = smooth_normal(normals, rows, k, u, v, sign, d, nx, ny, nz)
        normal[i, 0], normal[i, 1], normal[i, 2] = nx, ny, nz


@kernel
def smooth_normal(normals, rows, k, u, v, sign, d, gx, gy, gz):
    """Unit interpolated normal on the ray's side; the geometric one g where that has no length."""
    a, b, c, w = rows[k, 0], rows[k, 1], rows[k, 2], 1.0 - u - v
    x = sign * (w * normals[a, 0] + u * normals[b, 0] + v * normals[c, 0])
    y = sign * (w * normals[a, 1] + u * normals[b, 1] + v * normals[c, 1])
    z = sign * (w * normals[a, 2] + u * normals[b, 2] + v * normals[c, 2])
    away = x * d[0] + y * d[1] + z * d[2]
    if away > 0.0:
        x, y, z = x - away * d[0], y - away * d[1], z - away * d[2]
    length = np.sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length) if length > 0.0 else (gx, gy, gz)
