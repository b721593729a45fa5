"""Meshes: what Embree proposes and float64 decides, against brute force over all triangles."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import trimesh
from tests.geometry.by_hand import affine, mesh_of, scene_of, unit, write_ply

from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rays_from
from raywalk.geometry.mesh_nearest import NONE, settle_all
from raywalk.geometry.mesh_target import MeshTarget
from raywalk.scene.model import SceneObject

BUNNY = Path(__file__).parents[2] / "models" / "bunny.ply"
EPS = np.finfo(float).eps


@pytest.fixture(scope="module")
def bunny() -> CompiledScene:
    """The course's bunny, flat, as its file has it."""
    return CompiledScene(scene_of([mesh_of(BUNNY)]))


@pytest.fixture
def compile_mesh(tmp_path: Path) -> Callable[..., CompiledScene]:
    """A scene of one mesh given by its vertices and faces."""

    def compiled(
        vertices: np.ndarray, faces: np.ndarray, transform: np.ndarray | None = None,
        smooth: bool = False, weld: float | None = None,
    ) -> CompiledScene:  # fmt: skip
        path = write_ply(tmp_path / "made.ply", np.asarray(vertices, float), np.asarray(faces))
        matrix = np.eye(4) if transform is None else transform
        mesh = mesh_of(path, smooth, weld=weld)
        return CompiledScene(scene_of([SceneObject("made", mesh, 0, matrix)]))

    return compiled


def ball(subdivisions: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """A unit sphere of triangles, closed and convex."""
    made = trimesh.creation.icosphere(subdivisions)
    return unit(np.asarray(made.vertices, float)), np.asarray(made.faces)


def world_corners(mesh: MeshTarget) -> np.ndarray:
    return mesh.corners + mesh.centre


def brute_force(
    mesh: MeshTarget, origin: np.ndarray, direction: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Nearest certain hit and nearest possible hit (n,) of each ray: all triangles, float64,
    Moeller and Trumbore. Certain: 1e-9 of barycentric room to the edges; possible: -1e-9."""
    a, b, c = mesh.corners.transpose(1, 0, 2)
    one, other = b - a, c - a
    certain, possible = np.empty(len(origin)), np.empty(len(origin))
    for part in np.array_split(np.arange(len(origin)), max(1, len(origin) // 100)):
        d, o = direction[part, None], (origin[part] - mesh.centre)[:, None]
        p = np.cross(d, other[None])
        with np.errstate(divide="ignore", invalid="ignore"):
            inverse = 1 / (p * one).sum(axis=2)
            s = o - a
            u = (s * p).sum(axis=2) * inverse
            q = np.cross(s, one[None])
            v = (d * q).sum(axis=2) * inverse
            t = (other * q).sum(axis=2) * inverse
            room = np.minimum(np.minimum(u, v), 1 - u - v)
        ahead = t > 0
        certain[part] = np.where(ahead & (room > 1e-9), t, np.inf).min(axis=1)
        possible[part] = np.where(ahead & (room > -1e-9), t, np.inf).min(axis=1)
    return certain, possible


def by_tree(mesh: MeshTarget, origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """t (n,) by the float64 tree alone."""
    count = len(origin)
    nothing, nowhere = np.full(count, -1, np.int32), np.full(count, np.inf)
    t = nowhere.copy()
    settle_all(
        mesh.tables, origin, direction, nothing, nothing, nowhere, np.zeros(1, int),
        np.arange(count), np.full(count, NONE, np.int32), t, nothing.copy(), nothing.copy(),
        np.empty((count, 2)),
    )  # fmt: skip
    return t


def around(mesh: MeshTarget, rng: np.random.Generator, count: int) -> np.ndarray:
    """Points on a sphere of 3 sizes round the mesh."""
    return np.asarray(mesh.centre + 3 * mesh.size * unit(rng.normal(size=(count, 3))))


def on_vertices_and_edges(
    mesh: MeshTarget, rng: np.random.Generator, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Random vertices (n, 3), and random points on edges (n, 3)."""
    corners = world_corners(mesh)
    who, side = rng.integers(len(corners), size=count), rng.integers(3, size=count)
    share = rng.random(size=(count, 1))
    start, end = corners[who, side], corners[who, (side + 1) % 3]
    return start, share * start + (1 - share) * end


def off_the_hits(
    compiled: CompiledScene, rays: Rays, rng: np.random.Generator, outwards: bool
) -> tuple[Rays, Hits]:
    """Rays from hits to a random side direction: outwards back where it came from, or inwards."""
    hits = compiled.hits(rays)
    met = hits.object >= 0
    hits = Hits(*(column[met] for column in hits))
    sign = 1.0 if outwards else -1.0
    flat = unit(np.cross(hits.geometric, rng.normal(size=hits.geometric.shape)))
    steep = 10.0 ** rng.uniform(-6, 0, size=(len(flat), 1))
    direction = unit(flat + sign * steep * hits.geometric)
    return Rays(
        hits.point, direction, hits.object, hits.inside ^ (not outwards), hits.triangle
    ), hits


def test_the_tree_gives_what_brute_force_gives(
    rng: np.random.Generator, bunny: CompiledScene
) -> None:
    """1500 rays, a third aimed at vertices and edges: the float64 tree's t is the nearest of all
    3,674 triangles, to 1e-13 of the distance where hits are certain."""
    mesh = bunny.meshes[0]
    vertices, edges = on_vertices_and_edges(mesh, rng, 250)
    low, high = world_corners(mesh).min(axis=(0, 1)), world_corners(mesh).max(axis=(0, 1))
    target = np.concatenate([vertices, edges, rng.uniform(low, high, size=(1000, 3))])
    origin = around(mesh, rng, 1500)
    direction = unit(target - origin)
    certain, possible = brute_force(mesh, origin, direction)
    t = by_tree(mesh, origin, direction)
    assert (t <= certain * (1 + 1e-13)).all()
    assert (t >= possible * (1 - 1e-13)).all()
    assert (certain[500:] == possible[500:]).mean() > 0.99  # the margin hides nothing


@pytest.mark.parametrize("place", ["far", "inside", "along an axis", "1e-5 away", "1e-7 away"])
def test_embree_and_float64_together_miss_nothing(
    rng: np.random.Generator, bunny: CompiledScene, place: str
) -> None:
    """20,000 rays aimed exactly at vertices and edges, from far and near: every one finds the
    triangle and the t of the float64 tree, to the last bit. Embree alone loses 1.3 %."""
    mesh = bunny.meshes[0]
    target = np.concatenate(on_vertices_and_edges(mesh, rng, 10_000))
    origin = {
        "far": around(mesh, rng, 20_000),
        "inside": mesh.centre + 0.02 * rng.normal(size=(20_000, 3)),
        "along an axis": target + 5 * np.eye(3)[rng.integers(3, size=20_000)],
        "1e-5 away": target + 1e-5 * unit(rng.normal(size=(20_000, 3))),
        "1e-7 away": target + 1e-7 * unit(rng.normal(size=(20_000, 3))),
    }[place]
    direction = unit(target - origin)
    found = bunny.nearest(rays_from(origin, direction))
    assert (found[0] == by_tree(mesh, origin, direction)).all()


def test_a_closed_mesh_has_no_hole(
    rng: np.random.Generator, compile_mesh: Callable[..., CompiledScene]
) -> None:
    """From the middle of a ball of 1,280 triangles 50,000 rays at its vertices and as many at its
    edges all meet it where they aim, to 1e-13."""
    compiled = compile_mesh(*ball())
    vertices, edges = on_vertices_and_edges(compiled.meshes[0], rng, 50_000)
    target = np.concatenate([vertices, edges])
    origin = np.tile([0.01, -0.02, 0.03], (len(target), 1))
    hits = compiled.nearest(rays_from(origin, target - origin))
    np.testing.assert_allclose(hits[0], 1.0, rtol=0, atol=1e-13)


@pytest.mark.parametrize("kind", ["torus", "soup", "spike", "fan"])
def test_odd_meshes_are_met_as_the_tree_says(
    rng: np.random.Generator, compile_mesh: Callable[..., CompiledScene], kind: str
) -> None:
    """A torus, triangles that cut each other, a spike of 1e-3 rad, a fan of needles: 20,000 rays
    at random, at vertices and at edges agree with the float64 tree to the last bit."""
    if kind == "torus":
        made = trimesh.creation.torus(1.0, 0.3, 48, 24)
        vertices, faces = np.asarray(made.vertices), np.asarray(made.faces)
    elif kind == "soup":
        vertices, faces = rng.normal(size=(600, 3)), np.arange(600).reshape(-1, 3)
    else:
        turn = np.linspace(0, 2 * np.pi, 64, endpoint=False)
        wide = 1e-3 if kind == "spike" else 1.0
        rim = np.stack([wide * np.cos(turn), 0 * turn + 0.1 * (kind == "fan"), wide * np.sin(turn)])
        vertices = np.concatenate([[[0, 1 if kind == "spike" else 0, 0]], rim.T])
        faces = np.array([[0, 1 + k, 1 + (k + 1) % 64] for k in range(64)])
    compiled = compile_mesh(vertices, faces)
    mesh = compiled.meshes[0]
    at, on = on_vertices_and_edges(mesh, rng, 5_000)
    corners = world_corners(mesh)
    share = rng.dirichlet(np.ones(3), size=10_000)
    within = (corners[rng.integers(len(corners), size=10_000)] * share[:, :, None]).sum(axis=1)
    target = np.concatenate([at, on, within])
    origin = around(mesh, rng, len(target))
    direction = unit(target - origin)
    found = compiled.nearest(rays_from(origin, direction))[0]
    assert (found == by_tree(mesh, origin, direction)).all()


@pytest.mark.parametrize("gap", [1e-4, 1e-6, 1e-8, 1e-10])
def test_sheets_close_together_keep_their_order(
    rng: np.random.Generator, compile_mesh: Callable[..., CompiledScene], gap: float
) -> None:
    """Two parallel squares in one mesh, seen from both sides: the nearer one is met, down to gaps
    that float32 does not see (6e-8), where their corners are not to be joined (weld = 0)."""
    square = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    vertices = np.concatenate([square, square + np.array([0, 0, gap])])
    compiled = compile_mesh(vertices, np.concatenate([faces, faces + 4]), weld=0.0)
    target = rng.uniform(-1, 1, size=(4000, 3)) * [1, 1, 0]
    origin = target + 3 * unit(rng.normal(size=(4000, 3)))
    origin[np.abs(origin[:, 2]) < 0.01, 2] = 0.01
    t, _, triangle, _ = compiled.nearest(rays_from(origin, unit(target - origin)))
    upper = (compiled.meshes[0].corners[triangle, 0, 2] > 0) == (gap > 0)
    met = np.isfinite(t)
    assert met.mean() > 0.99
    assert (upper[met] == (origin[met, 2] > 0)).all()


@pytest.mark.parametrize("aspect", [1e4, 1e6, 1e8, 1e10])
def test_slivers_are_met(
    rng: np.random.Generator, compile_mesh: Callable[..., CompiledScene], aspect: float
) -> None:
    """Rays at the inside of a triangle 1 long and 1 / aspect high meet it, all of them; slanted
    ones where they aim, to 1e-16 times the aspect: so much of a place along it is rounding."""
    vertices = np.array([[-0.5, 0, 0], [0.5, 0, 0], [0.1, 1 / aspect, 0]])
    compiled = compile_mesh(vertices, np.array([[0, 1, 2]]))
    share = 0.1 + 0.7 * rng.dirichlet(np.ones(3), size=2000)
    target = share @ vertices
    down = np.tile([0.0, 0.0, -1.0], (2000, 1))
    assert (compiled.nearest(rays_from(target - 2 * down, down))[0] == 2.0).all()
    # Slanted from close by: from far the direction's rounding would aim beside the sliver.
    slanted = target + 1e-6 * unit(rng.normal(size=(2000, 3)) - 2 * down)
    t = compiled.nearest(rays_from(slanted, unit(target - slanted)))[0]
    np.testing.assert_allclose(t, 1e-6, rtol=0, atol=1e-16 * aspect)


def test_a_small_part_of_a_big_mesh_is_met(
    rng: np.random.Generator, compile_mesh: Callable[..., CompiledScene]
) -> None:
    """A ball of radius 1e-7 beside a triangle 1 in size: float32 knows nothing of its shape, yet
    every ray meets it where the tree says."""
    vertices, faces = ball(2)
    big = np.array([[0.5, 0, 0], [1, 0, 0], [1, 1, 0]])
    compiled = compile_mesh(
        np.concatenate([1e-7 * vertices, big]),
        np.concatenate([faces, [[len(vertices), len(vertices) + 1, len(vertices) + 2]]]),
    )
    origin = unit(rng.normal(size=(5000, 3)))
    direction = unit(1e-7 * rng.normal(size=(5000, 3)) * 0.5 - origin)
    found = compiled.nearest(rays_from(origin, direction))[0]
    assert (found == by_tree(compiled.meshes[0], origin, direction)).all()
    assert np.isfinite(found).mean() > 0.5


PLACES = [(1e-6, 0.0), (1.0, 0.0), (1e6, 0.0), (1.0, 1e5), (1.0, 1e7)]


@pytest.mark.parametrize(("scale", "offset"), PLACES)
def test_a_ray_never_hits_again_the_mesh_it_leaves(
    rng: np.random.Generator, compile_mesh: Callable[..., CompiledScene], scale: float,
    offset: float,
) -> None:  # fmt: skip
    """Reintersect: 3000 rays off a convex mesh, a third from hits at vertices and edges, outwards
    meet nothing; inwards all of them meet the far wall, at every scale and place."""
    place = affine(scale * np.eye(3), offset * np.array([1.0, -0.7, 0.4]))
    compiled = compile_mesh(*ball(), place)
    mesh = compiled.meshes[0]
    assert mesh.triangles.closed
    anywhere = mesh.centre + mesh.size * 0.5 * rng.normal(size=(2000, 3))
    target = np.concatenate([*on_vertices_and_edges(mesh, rng, 500), anywhere])
    origin = around(mesh, rng, 3000)
    rays = rays_from(origin, unit(target - origin))
    out, hits = off_the_hits(compiled, rays, rng, outwards=True)
    assert len(out.origin) > 2000
    assert not hits.inside.any()  # at an outline's edge too, where front and back face tie
    assert (compiled.nearest(out)[1] == -1).all()
    into, _ = off_the_hits(compiled, rays, rng, outwards=False)
    # The origin's own rounding, up to 2e-9 at 1e7, may put a grazing one outside.
    rounding = 8 * EPS * (offset + scale) / scale
    steep = np.abs((into.direction * unit(into.origin - mesh.centre)).sum(axis=1)) > 1e3 * rounding
    missed = compiled.nearest(into)[1] < 0
    assert not (missed & steep & (np.arange(len(missed)) > 1000)).any()


def test_rays_in_a_narrow_crease_do_not_slip_through(
    rng: np.random.Generator, compile_mesh: Callable[..., CompiledScene]
) -> None:
    """Two walls meet at 0.01 rad. From points of one wall, down to 1e-7 from the crease, a ray
    straight up meets the other wall at height x sin(0.01): Embree's start would lie behind it."""
    steep = 0.01
    vertices = np.array(
        [[0, 0, -1], [0, 0, 1], [1, 0, 0], [np.cos(steep), np.sin(steep), 0]], float
    )
    compiled = compile_mesh(vertices, np.array([[0, 1, 2], [0, 1, 3]]))
    x = 10.0 ** rng.uniform(-7, -1, size=2000)
    origin = np.stack([x, np.full(2000, -1e-3), np.zeros(2000)], axis=1)
    floor = compiled.hits(rays_from(origin, np.tile([0.0, 1.0, 0.0], (2000, 1))))
    assert (floor.object == 0).all()
    up = Rays(
        floor.point,
        np.tile([0.0, 1.0, 0.0], (2000, 1)),
        floor.object,
        ~floor.inside,
        floor.triangle,
    )
    t = compiled.nearest(up)[0]
    np.testing.assert_allclose(t, x * np.tan(steep), rtol=1e-6)


def test_a_mesh_far_out_is_the_same_mesh(rng: np.random.Generator) -> None:
    """The bunny moved by 1e7, with 20,000 rays whose origins lie as they do near the middle: the
    same triangles at the same distances, to 1e-13, though the mesh's centre out there is rounded
    to 1e-9: what that leaves over is in its corners."""
    move = np.array([1e7, -1e7, 1e7])
    here = CompiledScene(scene_of([SceneObject("b", mesh_of(BUNNY), 0)]))
    there = CompiledScene(scene_of([SceneObject("b", mesh_of(BUNNY), 0, affine(np.eye(3), move))]))
    centre, far_centre = here.meshes[0].centre, there.meshes[0].centre
    far_origin = far_centre + 4 * unit(rng.normal(size=(20_000, 3)))
    origin = far_origin - move  # exact: a difference of numbers this near to each other
    direction = unit(centre + 0.5 * rng.normal(size=(20_000, 3)) - origin)
    near = here.nearest(rays_from(origin, direction))
    far = there.nearest(rays_from(far_origin, direction))
    assert (near[2] == far[2]).all()
    met = near[2] >= 0
    np.testing.assert_allclose(far[0][met], near[0][met], rtol=1e-13)


@pytest.mark.parametrize("bad", [np.nan, np.inf, 0.0])
def test_rays_that_are_none_disturb_no_others(bunny: CompiledScene, bad: float) -> None:
    """NaN, infinite and zero directions and NaN origins meet nothing; the others what they met."""
    origin = np.tile([-0.2, 1.0, 5.0], (4, 1))
    direction = np.tile([0.0, 0.0, -1.0], (4, 1))
    direction[1], origin[2] = bad, bad if bad != 0.0 else np.nan
    t, met, _, _ = bunny.nearest(rays_from(origin, direction))
    assert met.tolist() == [0, -1, -1, 0]
    assert t[0] == t[3]


def test_all_crossings_stand_in_order_and_begin_with_the_nearest(
    rng: np.random.Generator, bunny: CompiledScene
) -> None:
    """t ascends along each ray, its first is nearest()'s to the last bit, and a ray from outside
    leaves a closed mesh as often as it enters: an even number."""
    mesh = bunny.meshes[0]
    origin = around(mesh, rng, 5000)
    target = np.concatenate([mesh.centre + 0.5 * rng.normal(size=(4000, 3)),
                             *on_vertices_and_edges(mesh, rng, 500)])  # fmt: skip
    rays = rays_from(origin, unit(target - origin))
    start, t, met = bunny.crossings(rays)
    nearest = bunny.nearest(rays)[0]
    counts = np.diff(start)
    assert (met == 0).all()
    assert ((counts > 0) == np.isfinite(nearest)).all()
    assert (t[start[:-1][counts > 0]] == nearest[counts > 0]).all()
    for a, b in itertools.pairwise(start):
        assert (np.diff(t[a:b]) >= 0).all()
    assert (counts[:4000] % 2 == 0).all()


def test_a_crossing_at_a_shared_edge_counts_once(
    compile_mesh: Callable[..., CompiledScene],
) -> None:
    """A cube of 12 triangles seen along the axis: the middle ray runs through two diagonals, and
    meets the cube twice, not four times; so does a ray through a corner's three faces."""
    box = trimesh.creation.box((2, 2, 2))
    compiled = compile_mesh(np.asarray(box.vertices), np.asarray(box.faces))
    origin = np.array([[0.0, 0.0, 5.0], [5.0, 5.0, 5.0]])
    start, t, _ = compiled.crossings(
        rays_from(origin, np.array([[0, 0, -1.0], [-1.0, -1.0, -1.0]]))
    )
    assert np.diff(start).tolist() == [2, 2]
    assert t.tolist() == [4.0, 6.0, 4.0, 6.0]
