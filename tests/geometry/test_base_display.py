"""What the stage draws of objects with a base colour: the surface, its colours where they are."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.geometry.by_hand import scene_of
from tests.models.solids import written

from raywalk.geometry.base_display import (
    TILE,
    painted_mesh,
    painted_shape,
    plane_tile,
)
from raywalk.geometry.compiled import CompiledScene
from raywalk.scene.model import Base, SceneObject, Texture
from raywalk.scene.shapes import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Ellipsoid,
    Mesh,
    Plane,
    Shape,
    Sphere,
    Triangle,
)

SHAPES = [
    Sphere((0, 0, 0), 2.0), Ellipsoid((1, 0, 0), (1, 2, 3), (10, 20, 30)),
    Box((-1, -2, -3), (1, 1, 1)), Disc((0, 1, 0), (1, 2, 3), 2.0),
    Triangle((0, 0, 0), (2, 0, 0.5), (0, 3, 1)), Cylinder((0, 0, 0), (0, 2, 0), 0.5),
    Cylinder((0, 0, 0), (0, 0, 1), 2.0, False), Cone((0, 0, 0), (0, 2, 0), 1.0, 0.3),
    Cone((0, 0, 0), (1, 0, 2), 1.0, 0.0),
]  # fmt: skip


def textured(
    shape: Shape, folder: Path, rng: np.random.Generator
) -> tuple[SceneObject, CompiledScene]:
    picture = np.kron(rng.integers(0, 256, (3, 4, 3)), np.ones((4, 4, 1), int)).astype(np.uint8)
    Image.fromarray(picture).save(folder / "some.png")
    obj = SceneObject("it", shape, 0, base=Base(texture=Texture(folder / "some.png")))
    return obj, CompiledScene(scene_of([obj]))


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.word)
def test_a_shape_is_drawn_outwards_with_the_colours_of_its_places(
    shape: Shape, tmp_path: Path, rng: np.random.Generator
) -> None:
    """Its triangles lie on the surface, run anticlockwise round their normals, and each vertex has
    the texture's colour there, of 255, but next to an edge or a seam."""
    obj, compiled = textured(shape, tmp_path, rng)
    assert compiled.base
    drawn = painted_shape(obj, compiled.base)
    height = shape.canonical.height
    if height is not None:
        assert max(abs(height(*point)) for point in drawn.vertices.tolist()) <= 1e-12
    a, b, c = drawn.vertices[drawn.faces].transpose(1, 0, 2)
    facing = np.cross(b - a, c - a)
    has_area = np.linalg.norm(facing, axis=1) > 1e-9
    assert drawn.normals is not None
    assert np.allclose(np.linalg.norm(drawn.normals, axis=1), 1, rtol=0, atol=1e-9)
    towards = (facing[:, None] * drawn.normals[drawn.faces]).sum(axis=2)[has_area]
    assert (towards > 0).all()
    found = 255 * compiled.base.on_shape(obj, drawn.vertices)
    off = np.abs(found - drawn.colours).max(axis=1)
    assert np.mean(off <= 0.51) > 0.8
    assert len(drawn.faces) < 12_000


def test_a_meshs_few_triangles_are_cut_for_a_picture_and_colours_alone_need_no_cut(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    """A square of two becomes 2,048 with the picture on them; faces of two colours keep theirs."""
    text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"
    path = written(tmp_path / "card.obj", text)
    obj, compiled = textured(Mesh("card.obj", path), tmp_path, rng)
    assert compiled.base
    drawn = painted_mesh(obj, compiled.base, compiled.meshes[0].triangles)
    assert len(drawn.faces) == 2 * 4**5
    places = drawn.vertices + compiled.meshes[0].centre
    texture = obj.base.texture if obj.base else None
    assert texture
    pixels = compiled.base.pixels_of(texture)
    inner = np.flatnonzero((np.abs(places[:, :2] - 0.5) < 0.45).all(axis=1))
    row, column = ((1 - places[inner, 1]) * 12).astype(int), (places[inner, 0] * 16).astype(int)
    centre = (np.abs(row % 4 - 1.5) < 1) & (np.abs(column % 4 - 1.5) < 1)
    assert centre.sum() > 100
    assert np.abs(drawn.colours[inner][centre].astype(int) - pixels[row, column][centre]).max() <= 1

    two = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n"
    mesh = Mesh("two.off", written(tmp_path / "two.off", two))
    painted = SceneObject("it", mesh, 0, base=Base(colours=True))
    compiled = CompiledScene(scene_of([painted]))
    assert compiled.base
    drawn = painted_mesh(painted, compiled.base, compiled.meshes[0].triangles)
    shown = drawn.colours[drawn.faces]
    assert len(drawn.faces) == 2
    assert (shown == shown[:, :1]).all()
    assert sorted(shown[:, 0].tolist()) == [[0, 0, 255], [255, 0, 0]]
    assert len(drawn.vertices) == 6  # those of the shared edge are in two colours


def test_a_planes_tile_is_its_picture_made_small_where_it_lies(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    """Row 0 below; the axes lead from its point to (u, v), whatever its transform."""
    matrix = np.eye(4)
    matrix[:3, :3] = np.diag([2.0, 1.0, 3.0])
    matrix[:3, 3] = [5, 0, 0]
    big = rng.integers(0, 256, (2 * TILE, 3, 3)).astype(np.uint8)
    Image.fromarray(big).save(tmp_path / "big.png")
    base = Base(texture=Texture(tmp_path / "big.png", repeat=(0.5, 4.0)))
    obj = SceneObject("floor", Plane((0, -1, 0), (0, 1, 0)), 0, matrix, base=base)
    compiled = CompiledScene(scene_of([obj]))
    assert compiled.base
    tile, axes = plane_tile(obj, compiled.base)
    pairs = big[::-1].astype(float).reshape(TILE, 2, 3, 3).mean(axis=1)
    assert np.abs(tile - pairs).max() <= 0.5
    # A picture is 1/0.5 own units wide, which is twice as much in the world; its top is at -z.
    assert np.allclose(axes, [[0.25, 0, 0], [0, 0, -4 / 3]], rtol=0, atol=1e-15)


def test_a_scan_keeps_its_vertices(tmp_path: Path) -> None:
    """Each has one colour: none becomes several."""
    text = "COFF\n4 2 0\n0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 8 7\n"
    mesh = Mesh("scan.off", written(tmp_path / "scan.off", text + "3 0 1 2\n3 0 2 3\n"))
    obj = SceneObject("it", mesh, 0, base=Base(colours=True))
    compiled = CompiledScene(scene_of([obj]))
    assert compiled.base
    drawn = painted_mesh(obj, compiled.base, compiled.meshes[0].triangles)
    assert drawn.faces.tolist() == compiled.meshes[0].triangles.faces.tolist()
    assert sorted(drawn.colours.tolist()) == [[0, 0, 255], [0, 255, 0], [9, 8, 7], [255, 0, 0]]
