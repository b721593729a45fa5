"""Textures on meshes: a file's own, where the scene gives no material, and the scene's."""

from __future__ import annotations

import base64
import io
import json
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from tests.models.solids import written
from tests.models.test_gltf import glb

from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.mesh_report import mesh_lines, mesh_warnings
from raywalk.pipeline.cluster import mesh_files, with_meshes
from raywalk.pipeline.parts import trace_parts
from raywalk.scene.model import Scene
from raywalk.work.digests import key_of

# Row 0 on top: a b over c d.
A, B, C, D = [255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]
FOUR = np.array([[A, B], [C, D]], np.uint8)
# A square of side 2 facing +z, its picture upright on it.
CORNERS = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
PLACES = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
OBJ = (
    "mtllib four.mtl\nusemtl paint\n"
    + "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS)
    + "".join(f"vt {u} {v}\n" for u, v in PLACES)
    + "f 1/1 2/2 3/3 4/4\n"
)
MTL = "newmtl paint\nKd {kd}\nmap_Kd {file}\n"
WHERE = [(-0.5, 0.5), (0.5, 0.5), (-0.5, -0.5), (0.5, -0.5)]  # of a, b, c, d
MESH = '[[objects]]\nname = "card"\ntype = "mesh"\nfile = "{file}"\n{more}\n'


@pytest.fixture
def scene(scene_from: Callable[[str], Scene], tmp_path: Path) -> Callable[..., Scene]:
    """A function to the scene of a mesh file; its picture is beside it."""
    Image.fromarray(FOUR).save(tmp_path / "four.png")
    return lambda file="card.obj", more="": scene_from(MESH.format(file=file, more=more))


def seen(made: Scene, places: list[tuple[float, float]] = WHERE) -> list[list[int]]:
    """255 times the base colours where rays along -z meet it."""
    origin = np.array([(x, y, 5.0) for x, y in places])
    compiled = CompiledScene(made)
    found = compiled.base_colours(
        compiled.hits(rays_from(origin, np.tile([0, 0, -1.0], (len(origin), 1))))
    )
    assert found is not None
    return [[round(value) for value in row] for row in (255 * found).tolist()]


def test_a_materials_texture_lies_where_vt_puts_it(
    scene: Callable[..., Scene], tmp_path: Path
) -> None:
    """At the centres of its four pixels; times Kd, which is the material's diffuse. Halfway between
    two the mean."""
    written(tmp_path / "card.obj", OBJ)
    written(tmp_path / "four.mtl", MTL.format(kd="0.5 0.5 0.5", file="four.png"))
    made = scene()
    assert made.materials[0].diffuse == (0.5, 0.5, 0.5)
    assert seen(made) == [A, B, C, D]
    assert seen(made, [(0, 0.5)]) == [[128, 128, 0]]
    assert mesh_warnings(made) == []
    assert mesh_lines(made)[0].endswith("shown in its own materials paint")


@pytest.mark.parametrize("more", ["subdivide = 2", "transform = [{ scale = [1, 1, -1] }]"])
def test_subdivided_and_mirrored_meshes_keep_it_where_it_is(
    scene: Callable[..., Scene], tmp_path: Path, more: str
) -> None:
    """Its middle; Loop's scheme rounds the corners off."""
    written(tmp_path / "card.obj", OBJ)
    written(tmp_path / "four.mtl", MTL.format(kd="1 1 1", file="four.png"))
    near = [(0.3 * x, 0.3 * y) for x, y in WHERE]
    keys = f'{more}\nmaterial = {{ texture = {{ file = "four.png", filter = "nearest" }} }}'
    assert seen(scene(more=keys), near) == [A, B, C, D]


def test_black_does_not_hide_a_texture_nor_does_the_folder_of_another_machine(
    scene: Callable[..., Scene], tmp_path: Path
) -> None:
    """Some programs write Kd 0 0 0 beside map_Kd, and whole paths of their own disk."""
    written(tmp_path / "card.obj", OBJ)
    written(tmp_path / "four.mtl", MTL.format(kd="0 0 0", file="C:\\work\\textures\\four.png"))
    made = scene()
    assert made.materials[0].diffuse == (1.0, 1.0, 1.0)
    assert seen(made) == [A, B, C, D]


@pytest.mark.parametrize(
    ("file", "document"),
    [
        ("gone.png", "the texture gone.png is not there: paint is shown without it"),
        ("card.obj", "the texture card.obj ends in .obj, and is no picture that is read: paint is"),
        ("../up.png", "the texture up.png lies outside of the model's folder: paint is shown"),
    ],
)
def test_a_texture_that_cannot_be_had_is_a_warning_and_the_colour_stays(
    scene: Callable[..., Scene], tmp_path: Path, file: str, document: str
) -> None:
    Image.fromarray(FOUR).save(tmp_path.parent / "up.png")
    written(tmp_path / "card.obj", OBJ)
    written(tmp_path / "four.mtl", MTL.format(kd="0.5 0.4 0.3", file=file))
    made = scene()
    assert made.materials[0].diffuse == (0.5, 0.4, 0.3)
    assert made.objects[0].base is None
    (warning,) = mesh_warnings(made)
    assert warning.startswith(f'"card": {document}')


def test_without_coordinates_a_texture_is_nowhere_and_that_is_said(
    scene: Callable[..., Scene], tmp_path: Path
) -> None:
    """The file's, and the scene's."""
    bare = OBJ.replace("/1", "").replace("/2", "").replace("/3", "").replace("/4", "")
    written(tmp_path / "card.obj", bare)
    written(tmp_path / "four.mtl", MTL.format(kd="1 1 1", file="four.png"))
    (warning,) = mesh_warnings(scene())
    assert "four.png has no places, as the file tells no coordinates for it" in warning
    made = scene(more='material = { like = "white", texture = { file = "four.png" } }')
    assert "card.obj tells no coordinates for a texture" in mesh_warnings(made)[-1]
    assert seen(made) == [[255, 255, 255]] * 4


@pytest.mark.parametrize("names", [("s", "t"), ("u", "v"), ("texture_u", "texture_v")])
def test_a_ply_file_tells_places_for_the_scenes_texture(
    scene: Callable[..., Scene], tmp_path: Path, names: tuple[str, str]
) -> None:
    head = "ply\nformat ascii 1.0\nelement vertex 4\n"
    head += "".join(f"property float {name}\n" for name in (*"xyz", *names))
    head += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    rows = [" ".join(map(str, row)) for row in np.hstack([CORNERS, PLACES]).tolist()]
    written(tmp_path / "card.ply", head + "\n".join([*rows, "4 0 1 2 3", ""]))
    made = scene("card.ply", 'material = { like = "white", texture = { file = "four.png" } }')
    assert seen(made) == [A, B, C, D]


def textured_gltf(image: dict[str, Any], sampler: int | None = None) -> dict[str, Any]:
    """The square, its v from above as glTF has it, its colour a half."""
    places = PLACES * [1, -1] + [0, 1]
    body = CORNERS.astype("<f4").tobytes() + places.astype("<f4").tobytes()
    body += np.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()
    document: dict[str, Any] = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{
            "attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0,
        }]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12},
        ],
        "materials": [{"name": "paint", "pbrMetallicRoughness": {
            "baseColorFactor": [0.5, 0.5, 0.5, 1], "baseColorTexture": {"index": 0},
        }}],
        "textures": [{"source": 0}],
        "images": [image],
    }  # fmt: skip
    if sampler is not None:
        document |= {"samplers": [{"magFilter": sampler}]}
        document["textures"][0]["sampler"] = 0
    data = png_bytes()
    if image.get("bufferView") == 3:
        document["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(body), "byteLength": len(data)}
        )  # fmt: skip
        body += data
    uri = "data:application/octet-stream;base64," + base64.b64encode(body).decode()
    return document | {"buffers": [{"byteLength": len(body), "uri": uri}]}


def png_bytes() -> bytes:
    out = io.BytesIO()
    Image.fromarray(FOUR).save(out, "PNG")
    return out.getvalue()


DATA = "data:image/png;base64," + base64.b64encode(png_bytes()).decode()


@pytest.mark.parametrize(
    "image",
    [{"uri": "four.png"}, {"uri": "%66our.png"}, {"uri": DATA}, {"bufferView": 3}],
    ids=["beside", "escaped", "data", "buffer"],
)  # fmt: skip
@pytest.mark.parametrize("name", ["card.gltf", "card.glb"])
def test_a_gltf_file_brings_its_texture(
    scene: Callable[..., Scene], tmp_path: Path, name: str, image: dict[str, Any]
) -> None:
    """Beside it or within, right side up, times its base colour's factor."""
    document = textured_gltf(image)
    path = tmp_path / name
    path.write_bytes(glb(document) if name.endswith("glb") else json.dumps(document).encode())
    made = scene(name)
    assert seen(made) == [A, B, C, D]
    assert seen(made, [(0, 0.5)]) == [[128, 128, 0]]
    assert made.materials[0].diffuse == (0.5, 0.5, 0.5)
    assert mesh_warnings(made) == []


def test_a_gltf_sampler_may_ask_for_the_nearest_pixel(
    scene: Callable[..., Scene], tmp_path: Path
) -> None:
    written(tmp_path / "card.gltf", json.dumps(textured_gltf({"uri": DATA}, 9728)))
    assert seen(scene("card.gltf"), [(0.01, 0.5)]) == [B]


def test_damaged_pictures_within_a_gltf_file_are_a_warning(
    scene: Callable[..., Scene], tmp_path: Path
) -> None:
    for image in ({"uri": DATA[:80]}, {"uri": DATA[:81]}, {"bufferView": 77}, {}):
        written(tmp_path / "card.gltf", json.dumps(textured_gltf(image)))
        made = scene("card.gltf")
        (warning,) = mesh_warnings(made)
        assert warning.startswith('"card": the texture picture 0 in card.gltf is '), image
        assert made.objects[0].base is None


def test_a_changed_picture_makes_the_scene_anew_and_goes_to_a_worker(
    scene: Callable[..., Scene], tmp_path: Path
) -> None:
    """Its bytes are in the trace's key and among what is sent; with them the scene is the same."""
    ball = '[[objects]]\ntype = "sphere"\ncenter = [0, 3, 0]\nradius = 1\n'
    ball += 'material = { texture = { file = "four.png" } }'
    written(tmp_path / "card.obj", OBJ)
    written(tmp_path / "four.mtl", MTL.format(kd="1 1 1", file="four.png"))
    made = scene(more=ball)
    before = trace_parts(made)
    assert {"four.png of card", "four.png of sphere 1"} <= set(before["models"])
    files = mesh_files(made)
    there = with_meshes(*pickle.loads(pickle.dumps((made, files))), tmp_path / "worker")
    (tmp_path / "four.png").unlink()
    assert seen(there) == [A, B, C, D]
    Image.fromarray(FOUR[::-1]).save(tmp_path / "four.png")
    assert key_of(trace_parts(made)) != key_of(before)
    assert seen(made) == [C, D, A, B]


def test_what_else_a_gltf_texture_asks_for_is_said(
    scene: Callable[..., Scene], tmp_path: Path
) -> None:
    """Other coordinates, and a transform of them; it is shown as if they were not there."""
    document = textured_gltf({"uri": DATA})
    asked = document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
    asked |= {"texCoord": 1, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}}
    written(tmp_path / "card.gltf", json.dumps(document))
    made = scene("card.gltf")
    assert mesh_warnings(made) == [
        '"card": its KHR_texture_transform is not used: textures lie as if it were not there',
        '"card": textures lie by TEXCOORD_0, other coordinates are not used',
    ]
    assert seen(made) == [A, B, C, D]
