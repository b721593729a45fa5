"""Good model files, small, one of each kind: what the fuzzer damages."""

from __future__ import annotations

import base64
import io
import json
import struct
import zipfile

import numpy as np

QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
CORNERS = [[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
TRIANGLES = [
    corner for a, b, c, d in QUADS for corner in ((a, b, c), (a, c, d))
]  # of a cube, outward
CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"


def good_files() -> dict[str, bytes]:
    """A file's name -> its content."""
    stl = [[CORNERS[k] for k in corner] for corner in TRIANGLES]
    return {
        "cube.obj": _obj().encode(),
        "text.stl": _text_stl(stl).encode(),
        "binary.stl": _binary_stl(stl),
        "text.ply": _ply("ascii"),
        "little.ply": _ply("binary_little_endian"),
        "big.ply": _ply("binary_big_endian"),
        "cube.off": _off().encode(),
        "cube.gltf": _gltf()[0],
        "cube.glb": _gltf()[1],
        "cube.3mf": _3mf(),
        "text.3mf": _3mf(zipfile.ZIP_STORED),
    }


def _rows(word: str, rows: list) -> str:
    return "".join(f"{word} {' '.join(map(str, row))}\n" for row in rows)


def _obj() -> str:
    faces = "".join(
        "f " + " ".join(f"{k + 1}/{n % 4 + 1}/{n + 1}" for k in quad) + "\n"
        for n, quad in enumerate(QUADS)
    )
    head = "# a cube\nmtllib cube.mtl\no cube\n" + _rows("v", CORNERS)
    head += _rows("vt", [[0, 0], [0, 1], [1, 1], [1, 0]])
    head += _rows("vn", [[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0], [0, 0, -1], [0, 0, 1]])
    l_shape = _rows("v", [[2, 0, 0], [4, 0, 0], [4, 1, 0], [3, 1, 0], [3, 2, 0], [2, 2, 0]])
    return f"{head}usemtl red\ns 1\n{faces}g notch\ns off\n{l_shape}f -6 -5 -4 -3 -2 -1\nl 1 2\n"


def _text_stl(triangles: list) -> str:
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n" + _rows("vertex", corners) + "endloop\nendfacet\n"
        for corners in triangles
    )
    return f"solid cube\n{facets}endsolid cube\n"


def _binary_stl(triangles: list) -> bytes:
    rows = [[0.0, 0.0, 0.0, *np.ravel(corners).tolist()] for corners in triangles]
    return b"".join(
        [b"a cube".ljust(80), struct.pack("<I", len(rows))]
        + [struct.pack("<12fH", *row, 0x8000) for row in rows]
    )


def _ply(form: str) -> bytes:
    faces = [*QUADS[:3], *TRIANGLES[6:]]
    head = (
        f"ply\nformat {form} 1.0\ncomment a cube\nelement vertex 8\nproperty float x\n"
        "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
        f"property uchar blue\nelement face {len(faces)}\n"
        "property list uchar int vertex_indices\nproperty uchar flags\nend_header\n"
    )
    vertices = [[*corner, 255, 128, 0] for corner in CORNERS]
    if form == "ascii":
        body = "".join(" ".join(map(str, row)) + "\n" for row in vertices)
        body += "".join(" ".join(map(str, (len(face), *face, 1))) + "\n" for face in faces)
        return (head + body).encode()
    order = "<" if "little" in form else ">"
    packed = [struct.pack(f"{order}3f3B", *row) for row in vertices]
    packed += [struct.pack(f"{order}B{len(face)}iB", len(face), *face, 1) for face in faces]
    return head.encode() + b"".join(packed)


def _off() -> str:
    rows: list[list[float]] = [[4, *quad, 255, 0, 0] for quad in QUADS]
    lines = [" ".join(str(number) for number in row) for row in [*CORNERS, *rows]]
    return "\n".join(["OFF", "# a cube", "8 6 12", *lines]) + "\n"


def _gltf() -> tuple[bytes, bytes]:
    """As text with its buffer within, and as GLB."""
    body = np.array(CORNERS, "<f4").tobytes() + np.array(TRIANGLES, "<u2").tobytes()
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 2]}],
        "nodes": [
            {"children": [1], "translation": [0, 1, 0]},
            {"mesh": 0, "rotation": [0, 0, 0.6, 0.8], "scale": [1, 2, -1]},
            {"mesh": 0, "name": "second"},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 96},
            {"buffer": 0, "byteOffset": 96, "byteLength": 72},
        ],
        "skins": [{"joints": [0]}],
    }
    uri = "data:application/octet-stream;base64," + base64.b64encode(body).decode()
    text = json.dumps(document | {"buffers": [{"byteLength": 168, "uri": uri}]}).encode()
    packed = json.dumps(document | {"buffers": [{"byteLength": 168}]}).encode()
    packed += b" " * (-len(packed) % 4)
    size = 28 + len(packed) + len(body)
    head = b"glTF" + struct.pack("<III", 2, size, len(packed)) + b"JSON" + packed
    return text, head + struct.pack("<I", len(body)) + b"BIN\0" + body


def _3mf(packing: int = zipfile.ZIP_DEFLATED) -> bytes:
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in CORNERS)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in TRIANGLES)
    text = (
        f'<?xml version="1.0"?><model unit="millimeter" xmlns="{CORE}"><resources>'
        '<basematerials id="5"><base name="red" displaycolor="#FF0000"/></basematerials>'
        f'<object id="1" name="cube" pid="5" pindex="0"><mesh><vertices>{vertices}</vertices>'
        f'<triangles>{triangles}</triangles></mesh></object><object id="2"><components>'
        '<component objectid="1" transform="1 0 0 0 1 0 0 0 1 2 0 0"/></components></object>'
        '</resources><build><item objectid="1"/><item objectid="2"/></build></model>'
    )
    return packed(text.encode(), packing)


def packed(text: bytes, packing: int = zipfile.ZIP_DEFLATED) -> bytes:
    """A 3MF package of a model's XML."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", packing) as package:
        package.writestr(zipfile.ZipInfo("3D/3dmodel.model"), text, packing)
    return file.getvalue()


def unpacked(package: bytes) -> bytes:
    """The XML of such a package."""
    with zipfile.ZipFile(io.BytesIO(package)) as file:
        return file.read("3D/3dmodel.model")


def resized(glb: bytes) -> bytes:
    """A GLB that tells the length that it has."""
    return glb[:8] + struct.pack("<I", len(glb)) + glb[12:]
