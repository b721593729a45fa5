"""Parts and materials of a mesh file: objects that a scene dresses by name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.models.solids import QUADS, cube, obj_text, written

from raywalk.errors import SourceErrors
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.mesh_display import display_triangles, one_normal_each
from raywalk.geometry.mesh_report import mesh_lines, mesh_warnings
from raywalk.scene.model import BASE_STEPS, Scene

MTL = "newmtl red\nKd 0.9 0.1 0.1\nKs 0.5 0.5 0.5\nNs 30\nnewmtl green\nKd 0.1 0.8 0.1\nd 0.4\n"
TWO = (
    "mtllib two.mtl\no left\nusemtl red\n" + obj_text(cube(at=(-1, 0, 0)), QUADS)
    + "o right\nusemtl green\n" + obj_text(cube(at=(1, 0, 0)), QUADS, 9)
)  # fmt: skip


@pytest.fixture
def scene(scene_from: Callable[[str], Scene], tmp_path: Path) -> Callable[[str], Scene]:
    """A function from a mesh's keys to the scene of two cubes that has them."""
    written(tmp_path / "two.obj", TWO)
    written(tmp_path / "two.mtl", MTL)
    return lambda keys: scene_from(
        f'[[objects]]\nname = "model"\ntype = "mesh"\nfile = "two.obj"\n{keys}\n'
    )


def dressed(made: Scene) -> dict[str, tuple[str, tuple[float, ...]]]:
    """Of each object by name: its material's name and diffuse colour."""
    used = {obj.name: made.materials[obj.material] for obj in made.objects}
    return {name: (material.name, material.diffuse) for name, material in used.items()}


def test_a_files_materials_are_used_where_the_scene_gives_none(
    scene: Callable[[str], Scene],
) -> None:
    """An object each, in its colour; the ambient is a tenth of that."""
    made = scene("")
    assert dressed(made) == {
        "model, red": ("red", (0.9, 0.1, 0.1)), "model, green": ("green", (0.1, 0.8, 0.1)),
    }  # fmt: skip
    red = made.materials[made.objects[0].material]
    assert red.ambient == pytest.approx((0.09, 0.01, 0.01))
    assert (red.specular, red.shininess, red.transmit) == ((0.5, 0.5, 0.5), 30, 0)


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        ('material = "white"', {"model": "white"}),
        ('materials = { red = "glass" }', {"model, red": "glass", "model, green": "green"}),
        ('materials = { left = "mirror" }', {"model, left": "mirror", "model, green": "green"}),
        (
            'material = "white"\nmaterials = { right = { like = "water" } }',
            {"model, rest": "white", "model, right": "model, right"},
        ),
        (
            'materials = { red = "mirror", left = "glass" }',  # a part goes before a material
            {"model, left": "glass", "model, green": "green"},
        ),
    ],
)
def test_parts_and_materials_are_dressed_by_name(
    scene: Callable[[str], Scene], keys: str, expected: dict[str, str]
) -> None:
    """What no name is given for is in `material`, or in the file's own."""
    made = scene(keys)
    assert {name: material for name, (material, _) in dressed(made).items()} == expected


def test_the_objects_are_the_triangles_of_their_names(scene: Callable[[str], Scene]) -> None:
    """Each a closed cube on its side, which may be of glass."""
    compiled = CompiledScene(scene('materials = { red = "glass" }'))
    left, right = compiled.meshes
    assert (left.triangles.closed, right.triangles.closed) == (True, True)
    assert np.allclose([left.centre, right.centre], [[-1, 0, 0], [1, 0, 0]], rtol=0, atol=1e-15)
    assert [len(mesh.triangles.faces) for mesh in (left, right)] == [12, 12]


def test_a_piece_of_a_closed_surface_is_open(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """A cube with one face of another material: that face cannot be of glass."""
    text = obj_text(cube(), QUADS).replace("f 1", "usemtl paint\nf 1", 1)
    written(tmp_path / "one.obj", text.replace("f 5", "usemtl rest\nf 5", 1))
    keys = 'file = "one.obj"\nmaterials = { paint = "glass" }\n'
    made = scene_from(f'[[objects]]\ntype = "mesh"\n{keys}')
    with pytest.raises(SourceErrors, match=r'"mesh 1, paint" is an open mesh \(4 open edges'):
        CompiledScene(made)


def test_a_name_that_the_file_does_not_have_is_refused_with_those_it_has(
    scene: Callable[[str], Scene],
) -> None:
    """With the nearest one; and a file without materials wants one."""
    with pytest.raises(SourceErrors) as caught:
        scene('materials = { rde = "glass" }')
    message = str(caught.value)
    assert "objects[0].materials.rde: two.obj has no part or material of that name" in message
    assert 'did you mean "red"?  known: red, green, left, right' in message


def test_a_file_without_materials_wants_one_of_the_scene(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """The key is named."""
    written(tmp_path / "bare.obj", obj_text(cube(), QUADS))
    with pytest.raises(SourceErrors) as caught:
        scene_from('[[objects]]\ntype = "mesh"\nfile = "bare.obj"\n')
    message = str(caught.value)
    assert "objects[0].material: missing: bare.obj tells no material of its own" in message


def test_a_broken_file_is_told_where_it_is_read(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """With the object's key, the line and the remedy."""
    written(tmp_path / "bad.obj", "v 0 0\n")
    with pytest.raises(SourceErrors) as caught:
        scene_from('[[objects]]\ntype = "mesh"\nfile = "bad.obj"\n')
    assert 'objects[0].file: bad.obj, line 1: "v 0 0" has 2 of' in str(caught.value)


@pytest.mark.parametrize("name", ["x" * 5000, "a\\u0000b", "x" * 300 + ".obj", "a\\u0000.obj"])
def test_names_that_no_file_can_have_are_files_that_are_not_there(
    scene_from: Callable[[str], Scene], name: str
) -> None:
    """5,000 characters, or a zero."""
    with pytest.raises(SourceErrors, match=r"objects\[0\]\.file: "):
        scene_from(f'[[objects]]\ntype = "mesh"\nfile = "{name}"\nmaterial = "white"\n')


def test_what_is_not_used_is_said(scene: Callable[[str], Scene]) -> None:
    """Materials where the scene gives one; transparency where it does not."""
    assert mesh_warnings(scene('material = "white"')) == [
        '"model": the materials of two.obj, red and green, are not used, as the scene gives one: '
        "leave `material` out to see them, or dress them by name in `materials`"
    ]
    assert mesh_warnings(scene("")) == [
        '"model": green is transparent in the file, and opaque here: give it a glass in `materials`'
    ]
    assert mesh_lines(scene("")) == [
        '"model": two.obj, OBJ: 24 triangles, 16 corners, 2 parts, 2 materials, closed; shown in '
        "its own materials red and green"
    ]
    assert mesh_lines(scene('materials = { red = "glass" }'))[0].endswith(
        "shown red in glass and green in green"
    )


def test_the_material_file_is_one_that_the_mesh_needs(
    scene: Callable[[str], Scene], tmp_path: Path
) -> None:
    """So that a build notes when it changes, and a cluster gets it."""
    (mesh,) = {obj.shape for obj in scene('material = "white"').objects}
    assert mesh.beside == (tmp_path / "two.mtl",)


def coloured_ply(colours: list[str], of: str = "face") -> str:
    """A cube with a colour on each of its faces, or vertices."""
    channels = "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
    ends = ["", ""]
    ends[of == "face"] = channels
    head = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
    head += f"property float z\n{ends[0]}element face 6\n"
    head += f"property list uchar int vertex_indices\n{ends[1]}end_header\n"
    rows = [" ".join(map(str, row)) for row in cube().tolist()]
    faces = [f"4 {' '.join(map(str, quad))}" for quad in QUADS.tolist()]
    message = rows if of == "vertex" else faces
    message[:] = [f"{row} {colour}" for row, colour in zip(message, colours, strict=True)]
    return head + "\n".join([*rows, *faces]) + "\n"


FACES = ["255 0 0", "0 255 0", "0 0 255", "255 255 0", "0 255 255", "51 51 51"]


def base_at(made: Scene, origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """The base colours of what rays meet first."""
    compiled = CompiledScene(made)
    found = compiled.base_colours(compiled.hits(rays_from(origin, direction)))
    assert found is not None
    return found


def test_colours_of_faces_shade_what_a_ray_meets(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """From six sides six colours, each exactly as its 8 bits; one object, in a white material."""
    written(tmp_path / "six.ply", coloured_ply(FACES))
    made = scene_from('[[objects]]\nname = "die"\ntype = "mesh"\nfile = "six.ply"\n')
    assert [obj.name for obj in made.objects] == ["die"]
    sides = np.array([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]], float)
    seen = base_at(made, 4 * sides + [0.1, 0.1, 0.1], -sides)
    assert seen.tolist() == [[int(word) / 255 for word in colour.split()] for colour in FACES]
    (material,) = made.materials
    assert (material.diffuse, material.ambient) == ((1, 1, 1), (0.1, 0.1, 0.1))
    assert mesh_warnings(made) == []
    assert mesh_lines(made)[0].endswith("; shown in the colours of its faces")


@pytest.mark.parametrize("scale", ["1", "[1, 1, -1]"])
def test_colours_of_vertices_are_linear_between_them(
    scene_from: Callable[[str], Scene], tmp_path: Path, scale: str
) -> None:
    """Red grows from one side of a cube to the other: between them it is the share of the way,
    wherever a diagonal runs, mirrored or not."""
    reds = [f"{255 * (z > 0)} 0 0" for _, _, z in cube().tolist()]
    written(tmp_path / "eight.ply", coloured_ply(reds, "vertex"))
    keys = f"transform = [{{ scale = {scale} }}]"
    made = scene_from(f'[[objects]]\ntype = "mesh"\nfile = "eight.ply"\n{keys}\n')
    high = np.linspace(-0.49, 0.49, 9)
    eyes = np.column_stack([np.full(len(high), 4.0), np.full(len(high), 0.123), high])
    red = base_at(made, eyes, np.tile([-1.0, 0, 0], (len(high), 1)))[:, 0]
    expected = 0.5 + high * (1 if scale == "1" else -1)
    assert np.abs(red - expected).max() <= 0.5001 / BASE_STEPS  # half a step of a base colour


@pytest.mark.parametrize("rounds", [1, 2, 3])
def test_subdivided_triangles_keep_their_places_colours(
    scene_from: Callable[[str], Scene], tmp_path: Path, rounds: int
) -> None:
    """Loop's scheme leaves a regular flat net flat, and in its middle where it is: so a colour that
    grows with x still does."""
    side = 9
    x, y = np.meshgrid(np.arange(side), np.arange(side), indexing="ij")
    corner = (x[:-1, :-1] * side + y[:-1, :-1]).reshape(-1)
    rows = [f"{i} {j} 0 {25 * i} 0 0" for i, j in zip(x.flat, y.flat, strict=True)]
    faces = [
        f"3 {a} {b} {c}"
        for k in corner.tolist()
        for a, b, c in ((k, k + side, k + side + 1), (k, k + side + 1, k + 1))
    ]
    text = "\n".join(["COFF", f"{side**2} {len(faces)} 0", *rows, *faces])
    written(tmp_path / "net.off", text)
    keys = f'type = "mesh"\nfile = "net.off"\nsubdivide = {rounds}\n'
    made = scene_from(f"[[objects]]\n{keys}")
    along = np.linspace(3.03, 4.97, 20)
    eyes = np.column_stack([along, np.full(20, 4.321), np.full(20, 5.0)])
    red = base_at(made, eyes, np.tile([0, 0, -1.0], (20, 1)))[:, 0]
    assert np.abs(red - 25 * along / 255).max() <= 0.5001 / BASE_STEPS


def test_colours_are_not_used_where_the_scene_gives_a_material(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """And that is said."""
    written(tmp_path / "six.ply", coloured_ply(FACES))
    made = scene_from('[[objects]]\ntype = "mesh"\nfile = "six.ply"\nmaterial = "white"\n')
    assert mesh_warnings(made) == [
        '"mesh 1": the colours of its faces are not used, as the scene gives a material: leave it '
        "out to see them"
    ]


def test_all_colours_are_kept_however_many(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """Of 3,000 triangles in as many colours each has its own, in one material."""
    rng = np.random.default_rng(13)
    places, colours = rng.normal(size=(9000, 3)), rng.integers(0, 256, (3000, 3))
    text = "OFF\n9000 3000 0\n" + "\n".join(" ".join(map(str, row)) for row in places.tolist())
    text += "\n" + "\n".join(
        f"3 {3 * k} {3 * k + 1} {3 * k + 2} " + " ".join(map(str, colour))
        for k, colour in enumerate(colours.tolist())
    )
    written(tmp_path / "many.off", text)
    made = scene_from('[[objects]]\ntype = "mesh"\nfile = "many.off"\n')
    assert len(made.materials) == 1
    compiled = CompiledScene(made)
    (mesh,) = compiled.meshes
    middle = mesh.corners.mean(axis=1) + mesh.centre
    away = rng.normal(size=middle.shape)
    hits = compiled.hits(rays_from(middle + 1e-3 * away, -away))
    found = compiled.base_colours(hits)
    assert found is not None
    assert (hits.triangle >= 0).all()
    assert (255 * found == colours[hits.triangle]).all()
    assert mesh_warnings(made) == []


def test_a_corner_with_several_normals_is_drawn_as_a_vertex_for_each(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """A cube whose file gives each face its own: 24 vertices, each with its face's normal."""
    sides = [(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in cube().tolist())
    text += "".join(f"vn {x} {y} {z}\n" for x, y, z in sides)
    for k, quad in enumerate(QUADS.tolist()):
        text += "f " + " ".join(f"{corner + 1}//{k + 1}" for corner in quad) + "\n"
    written(tmp_path / "crate.obj", text)
    made = scene_from('[[objects]]\ntype = "mesh"\nfile = "crate.obj"\nmaterial = "white"\n')
    triangles = display_triangles(made, made.objects[0])
    vertices, faces, normals = one_normal_each(triangles)
    assert normals is not None
    assert (len(vertices), len(normals)) == (24, 24)
    a, b, c = vertices[faces].transpose(1, 0, 2)
    facing = np.cross(b - a, c - a)
    assert np.allclose(normals[faces], facing[:, None], rtol=0, atol=1e-12)  # of length 1 already


def test_no_part_has_the_name_of_another_object(
    scene: Callable[[str], Scene], tmp_path: Path
) -> None:
    """What a person has named keeps its name, whether it stands before or behind; a part that is
    called as what is left over is not mixed up with that."""
    ball = '[[objects]]\nname = "model, red"\ntype = "sphere"\ncenter = [0, 3, 0]\nradius = 1\n'
    made = scene(ball + 'material = "white"')
    assert [obj.name for obj in made.objects] == ["model, red 2", "model, green", "model, red"]
    written(tmp_path / "two.obj", TWO.replace("o left", "o rest"))
    made = scene('material = "white"\nmaterials = { rest = "mirror" }')
    assert sorted(dressed(made).items()) == [
        ("model, rest", ("mirror", (0.0, 0.0, 0.0))), ("model, rest 2", ("white", (1.0, 1.0, 1.0))),
    ]  # fmt: skip
    assert len({obj.name for obj in made.objects}) == len(made.objects)
