"""glTF and GLB: nodes, instances, base colours; what is left out is named; damage is a sentence."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.models.solids import cube, triangles, volume, written

from raywalk.bench.made_scenes import scene_of
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.models.clean import clean
from raywalk.models.faults import ModelFault
from raywalk.models.model import Model
from raywalk.models.read import read_model
from raywalk.models.report import report
from raywalk.models.telling import in_full
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Mesh


def document(**more: Any) -> dict[str, Any]:
    """A cube at a node of its own, its buffer within the file; keys to exchange."""
    body = cube().astype("<f4").tobytes() + triangles().astype("<u2").tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(body).decode()
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "cube"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 96},
            {"buffer": 0, "byteOffset": 96, "byteLength": 72},
        ],
        "buffers": [{"byteLength": 168, "uri": uri}],
        **more,
    }


def glb(made_of: dict[str, Any], cut: int = 0) -> bytes:
    """The same as one binary file."""
    body = base64.b64decode(made_of["buffers"][0]["uri"].split(",")[1])
    made_of = made_of | {"buffers": [{"byteLength": len(body)}]}
    text = json.dumps(made_of).encode()
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(body)
    head = b"glTF" + struct.pack("<II", 2, size)
    whole = head + struct.pack("<I", len(text)) + b"JSON" + text
    whole += struct.pack("<I", len(body)) + b"BIN\0" + body
    return whole[: len(whole) - cut]


def read(folder: Path, made_of: dict[str, Any]) -> Model:
    return read_model(written(folder / "made.gltf", json.dumps(made_of)))


def refused(path: Path) -> str:
    with pytest.raises(ModelFault) as caught:
        clean(read_model(path))
    return str(caught.value)


def test_a_cube_is_a_cube_however_its_buffer_is_kept(tmp_path: Path) -> None:
    """Within the text, beside it, and in a GLB: 12 triangles, closed, of volume 1."""
    within = document()
    body = base64.b64decode(within["buffers"][0]["uri"].split(",")[1])
    written(tmp_path / "the buffer.bin", body)
    beside = document(buffers=[{"byteLength": 168, "uri": "the%20buffer.bin"}])
    models = [
        read(tmp_path, within),
        read(tmp_path, beside),
        read_model(written(tmp_path / "made.glb", glb(within))),
    ]
    for model in models:
        fit = clean(model)
        assert (len(fit.faces), len(fit.vertices), fit.shape.closed) == (12, 8, True)
        assert volume(fit.vertices, fit.faces) == pytest.approx(1, abs=1e-7)
    assert [model.format for model in models] == ["glTF", "glTF", "GLB"]
    assert models[1].beside == (tmp_path / "the buffer.bin",)


def test_nodes_move_turn_and_repeat_their_meshes(tmp_path: Path) -> None:
    """One mesh at three nodes: below a node that is moved and turned, mirrored, and by a matrix."""
    half = float(np.sqrt(0.5))
    nodes = [
        {"children": [1, 2], "translation": [10, 0, 0], "rotation": [0, 0, half, half]},
        {"mesh": 0, "name": "near", "translation": [2, 0, 0]},
        {"mesh": 0, "name": "mirrored", "scale": [-2, 1, 1]},
        {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 50, 1]},
    ]
    model = read(tmp_path, document(nodes=nodes, scenes=[{"nodes": [0, 3]}]))
    assert model.parts == ("near", "mirrored", "node 3")
    centres = [model.vertices[8 * k : 8 * k + 8].mean(axis=0) for k in range(3)]
    expected = [[10, 2, 0], [10, 0, 0], [0, 0, 50]]  # a quarter turn about z takes x to y
    assert np.allclose(centres, expected, rtol=0, atol=1e-12)
    fit = clean(model)
    assert not fit.turned.any()  # the mirrored one was wound back by the reader
    assert volume(fit.vertices, fit.faces) == pytest.approx(4, abs=1e-6)


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ({"nodes": [{"mesh": 7}]}, "it names mesh 7, and there are 0 to 0"),
        ({"scenes": [{"nodes": [3]}]}, "it names node 3, and there are 0 to 0"),
        ({"scene": 2}, "it names scene 2, and there are 0 to 0"),
        ({"accessors": []}, "it names accessor 0, and there is none"),
        ({"bufferViews": []}, "it names bufferView 0, and there is none"),
        ({"nodes": [{"mesh": 0, "matrix": [1, 2]}]}, "node 0: its matrix is not 16 numbers"),
        ({"nodes": [{"mesh": 0, "scale": 2}]}, "node 0: its scale is not 3 numbers"),
        (
            {"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0]}}]},
            "material 0: its baseColorFactor has 2 of 4 numbers",
        ),
        ({"buffers": []}, "it names buffer 0, and there is none"),
        ({"meshes": [{"primitives": [{"attributes": {"NORMAL": 0}}]}]}, "has no POSITION"),
    ],
)
def test_what_is_named_and_not_there_is_said(
    tmp_path: Path, keys: dict[str, Any], said: str
) -> None:
    path = written(tmp_path / "made.gltf", json.dumps(document(**keys)))
    assert said in refused(path) and "export the model again" in refused(path)


def test_without_normals_its_faces_are_flat(tmp_path: Path) -> None:
    """As the specification has it, and as the command says; `smooth = true` averages them: of a
    bent strip by 20 degrees, which the crease of 40 would leave smooth."""
    bent = np.array([[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0.364], [2, 1, 0.364]])
    faces = np.array([[0, 2, 1], [1, 2, 3], [2, 4, 3], [3, 4, 5]])
    body = bent.astype("<f4").tobytes() + faces.astype("<u2").tobytes()
    made_of = document(
        buffers=[{"byteLength": 96, "uri": "data:;base64," + base64.b64encode(body).decode()}]
    )
    made_of["accessors"][0]["count"], made_of["accessors"][1]["count"] = 6, 12
    made_of["bufferViews"] = [
        {"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 24},
    ]  # fmt: skip
    path = written(tmp_path / "bent.gltf", json.dumps(made_of))
    assert "it has none: flat faces, as glTF has it" in "\n".join(
        in_full(report(clean(read_model(path))))
    )
    for smooth, is_flat in ((None, True), (False, True), (True, False)):
        obj = SceneObject("bent", Mesh("bent", path, smooth), 0)
        hits = CompiledScene(scene_of([obj])).hits(
            rays_from(np.array([[0.9, 0.5, 5.0]]), np.array([[0.0, 0.0, -1.0]]))
        )
        assert np.allclose(hits.normal[0], [0, 0, 1], rtol=0, atol=1e-12) == is_flat


def test_base_colours_and_colours_of_vertices_are_read(tmp_path: Path) -> None:
    """Factors of materials, shares of normalised bytes."""
    body = cube().astype("<f4").tobytes() + triangles().astype("<u2").tobytes()
    body += np.tile(np.array([255, 51, 0, 255], np.uint8), 8).tobytes()
    made_of = document(
        materials=[
            {"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.5]}},
            {"pbrMetallicRoughness": {}},
        ],
        buffers=[{"byteLength": 200, "uri": "data:;base64," + base64.b64encode(body).decode()}],
    )
    made_of["meshes"][0]["primitives"][0] |= {"material": 0}
    made_of["meshes"][0]["primitives"][0]["attributes"] |= {"COLOR_0": 2}
    made_of["bufferViews"].append({"buffer": 0, "byteOffset": 168, "byteLength": 32})
    made_of["accessors"].append(
        {"bufferView": 2, "componentType": 5121, "count": 8, "type": "VEC4", "normalized": True}
    )
    model = read(tmp_path, made_of)
    assert [(m.name, m.diffuse, m.opacity) for m in model.materials] == [
        ("red", (1, 0, 0), 0.5), ("material 2", (1, 1, 1), 1),
    ]  # fmt: skip
    assert model.material_of().tolist() == [0] * 12
    assert model.colours is not None and model.colours_of == "vertices"
    assert model.colours.table.tolist() == [[1, 0.2, 0]] * 8


def test_strides_sparse_values_and_strips_are_read(tmp_path: Path) -> None:
    """Places 20 bytes apart, one of them given by itself, and triangles as a strip."""
    places = cube()
    apart = b"".join(row.astype("<f4").tobytes() + b"\xff" * 8 for row in places * [1, 1, 0])
    strip = np.array([0, 1, 2, 3], "<u2").tobytes()
    given = struct.pack("<H", 3) + b"\0\0" + struct.pack("<3f", -0.5, 0.5, 0.25)
    body = apart + strip + given
    uri = "data:;base64," + base64.b64encode(body).decode()
    made_of = document(buffers=[{"byteLength": len(body), "uri": uri}])
    made_of["bufferViews"] = [
        {"buffer": 0, "byteLength": 160, "byteStride": 20},
        {"buffer": 0, "byteOffset": 160, "byteLength": 8},
        {"buffer": 0, "byteOffset": 168, "byteLength": 16},
    ]
    made_of["accessors"][0]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": 2, "componentType": 5123},
        "values": {"bufferView": 2, "byteOffset": 4},
    }
    made_of["accessors"][1]["count"] = 4
    made_of["meshes"][0]["primitives"][0]["mode"] = 5
    model = read(tmp_path, made_of)
    assert model.vertices[3].tolist() == [-0.5, 0.5, 0.25]
    assert model.vertices[:3].tolist() == (places * [1, 1, 0])[:3].tolist()
    assert model.faces.tolist() == [[0, 1, 2], [2, 1, 3]]


def test_what_is_left_out_is_named(tmp_path: Path) -> None:
    """Skins, animations, Draco and what is not known."""
    made_of = document(
        skins=[{}], animations=[{}], extensionsRequired=["KHR_draco_mesh_compression", "X_y"]
    )
    packed = {"POSITION": 2}
    made_of["accessors"].append({"componentType": 5126, "count": 8, "type": "VEC3"})
    made_of["meshes"][0]["primitives"].append(
        {"attributes": packed, "extensions": {"KHR_draco_mesh_compression": {"bufferView": 0}}}
    )
    assert read(tmp_path, made_of).ignored == (
        "triangles compressed by Draco are left out",
        "skins are not used: it is shown in its pose at rest",
        "animations are not used",
        'the extension "X_y" is not known',
    )
    del made_of["meshes"][0]["primitives"][0]
    path = written(tmp_path / "made.gltf", json.dumps(made_of))
    assert refused(path) == (
        "made.gltf: its scene holds no triangle that is read (triangles compressed by Draco); "
        "export it uncompressed, as triangles"
    )


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"buffers": [{"byteLength": 168, "uri": "gone.bin"}]}, ', buffer 0: its file "gone.bin" '
         "is not there; copy it beside the model, or export it as one .glb file"),
        ({"buffers": [{"byteLength": 168, "uri": "data:;base64,AAAA"}]}, ", accessor 0: its 8 "
         "values do not fit into their buffer; it is cut short or damaged: export the model again"),
        ({"nodes": [{"mesh": 0, "children": [0]}]}, ", node 0: it stands below two nodes, or below "
         "itself; the file is damaged: export the model again"),
        ({"nodes": [{"mesh": 7}]}, ": it names mesh 7, and there are 0 to 0; the file is damaged: "
         "export the model again"),
        ({"meshes": 5}, ': its JSON is not that of a glTF file ("meshes is no list"); export the '
         "model again"),
        ({"asset": {"version": "1"}}, ', asset: version "1" is not read; export it as glTF 2.0'),
        ({"asset": 1}, ": its JSON is not that of a glTF file (\"'int' object has no attribute "
         "'get'\"); export the model again"),
    ],
    ids=["no buffer", "short buffer", "circle", "no mesh", "no list", "version", "no table"],
)  # fmt: skip
def test_what_is_wrong_is_one_sentence(
    tmp_path: Path, change: dict[str, Any], sentence: str
) -> None:
    """File, part, value, cause and remedy."""
    path = written(tmp_path / "made.gltf", json.dumps(document(**change)))
    assert refused(path) == "made.gltf" + sentence


@pytest.mark.parametrize("count", [9, 10**6, 10**15])
def test_counts_that_lie_are_told_before_anything_is_made_for_them(
    tmp_path: Path, count: int
) -> None:
    """Of an accessor; an index beyond the vertices too."""
    made_of = document()
    made_of["accessors"][0]["count"] = count
    path = written(tmp_path / "made.gltf", json.dumps(made_of))
    assert refused(path).startswith(f"made.gltf, accessor 0: its {count} values do not fit")
    made_of = document()
    made_of["accessors"][0]["count"] = 4
    path = written(tmp_path / "made.gltf", json.dumps(made_of))
    assert "it names vertex 4, and there are 0 to 3" in refused(path)


def test_a_file_that_is_cut_short_says_so(tmp_path: Path) -> None:
    """As text and binary."""
    whole = glb(document())
    path = written(tmp_path / "made.glb", whole[:-9])
    assert refused(path) == (
        f"made.glb: the file ends at byte {len(whole) - 9}, before the end that it tells; it is "
        "cut short: copy or export it again"
    )
    path = written(tmp_path / "made.gltf", json.dumps(document())[:-9])
    assert refused(path).startswith("made.gltf, line 1: its JSON cannot be read (")
    deep = written(tmp_path / "deep.gltf", "[" * 100_000)
    assert "its JSON cannot be read" in refused(deep)
