"""glTF 2.0, as text with its buffers beside it or within, or binary (GLB): the triangles of all
nodes of the scene where these put them, with base colours.

Our own: trimesh 5.2 says nothing of skins, animations and Draco, which are left out here by name,
and answers damaged files with errors of numpy. Format: Khronos, "glTF 2.0 Specification", 2021.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from raywalk.models.faults import ModelFault, quoted
from raywalk.models.gltf_buffers import Buffers, beside_gltf, entry_of, whole
from raywalk.models.gltf_nodes import Placed, placed_meshes
from raywalk.models.model import FileMaterial, Model, PerCorner
from raywalk.models.ply import cut_strips

TRIANGLES, STRIP, FAN = 4, 5, 6
NEAREST = 9728  # of a sampler's filters
MOST_TRIANGLES = 20_000_000  # also of instances, which cost a file nothing
FLOAT32 = 2.0**-23
# Extensions of primitives and materials that change what is seen; others are of no concern here.
COMPRESSED = {"KHR_draco_mesh_compression": "Draco", "EXT_meshopt_compression": "meshopt"}


def read_gltf(path: Path, data: bytes) -> Model:
    """The model. Raises ModelFault with the part of the file."""
    try:
        return _Reader(path, data).model()
    except (KeyError, IndexError, TypeError, ValueError, AttributeError, OverflowError) as problem:
        # The JSON is not as the specification has it: a number for a list, an index too high.
        said = quoted(str(problem)) if str(problem) else type(problem).__name__
        raise ModelFault(
            path, "", f"its JSON is not that of a glTF file ({said})", "export the model again"
        ) from None


class _Reader:
    def __init__(self, path: Path, data: bytes):
        self.path = path
        document, chunk = parts_of(path, data)
        self.json: dict[str, Any] = document
        self.buffers = Buffers(path, document, chunk)
        self.vertices: list[np.ndarray] = []
        self.faces: list[np.ndarray] = []
        # Of each primitive's vertices, None where it has none.
        self.normals: list[np.ndarray | None] = []
        self.colours: list[np.ndarray | None] = []
        self.textures: list[np.ndarray | None] = []
        self.material: list[np.ndarray] = []
        self.part: list[np.ndarray] = []
        self.parts: dict[str, int] = {}
        self.count = 0
        self.left_out: dict[str, None] = {}

    def model(self) -> Model:
        """All of it."""
        for placed in placed_meshes(self.path, self.json):
            for primitive in self.json["meshes"][placed.mesh]["primitives"]:
                self._add(primitive, placed)
        if not self.faces:
            why = f" ({', '.join(self.left_out)})" if self.left_out else ""
            raise ModelFault(
                self.path, "", f"its scene holds no triangle that is read{why}",
                "export it uncompressed, as triangles",
            )  # fmt: skip
        materials = [
            _material(self.path, self.json, k) for k in range(len(self.json.get("materials", [])))
        ]
        faces, counts = _joined(self.faces), [len(each) for each in self.vertices]
        normals, colours, places = (
            _whole(each, counts, faces) for each in (self.normals, self.colours, self.textures)
        )
        return Model(
            path=self.path,
            format="GLB" if self.path.suffix.lower() == ".glb" else "glTF",
            vertices=_joined(self.vertices),
            faces=faces,
            parts=tuple(self.parts),
            part=np.concatenate(self.part) if len(self.parts) > 1 else None,
            materials=tuple(materials),
            material=np.concatenate(self.material) if materials else None,
            normals=normals,
            flat=normals is None,  # specification 3.7.2.1: "flat normals" where none are given
            texture_places=places,
            colours=colours,
            colours_of="vertices" if colours else "",
            ignored=tuple(self._ignored()),
            grain=FLOAT32,
            unit="metre",
            beside=tuple(beside_gltf(self.path, self.json)),
        )

    def _add(self, primitive: dict[str, Any], placed: Placed) -> None:
        """One primitive's triangles, where a node puts them."""
        extensions = primitive.get("extensions", {})
        packed = [name for key, name in COMPRESSED.items() if key in extensions]
        mode = primitive.get("mode", TRIANGLES)
        attributes = primitive["attributes"]
        if "POSITION" not in attributes:
            raise ModelFault(
                self.path, f"mesh {placed.mesh}", "one of its primitives has no POSITION",
                "it has no place without: export the model again",
            )  # fmt: skip
        if mode not in (TRIANGLES, STRIP, FAN):
            self.left_out["points and lines"] = None
            return
        if packed and "bufferView" not in entry_of(
            self.path, self.json, "accessors", attributes["POSITION"]
        ):
            self.left_out[f"triangles compressed by {packed[0]}"] = None
            return
        at = self.buffers.accessor(attributes["POSITION"], (3,))
        faces = self._faces(primitive, mode, len(at))
        if self.count + len(faces) > MOST_TRIANGLES:
            raise ModelFault(
                self.path, "", f"its nodes place more than {MOST_TRIANGLES} triangles",
                "leave out some of its instances",
            )  # fmt: skip
        linear, offset = placed.matrix[:3, :3], placed.matrix[:3, 3]
        if np.linalg.det(linear) < 0:
            faces = faces[:, ::-1]
        self.vertices.append(at @ linear.T + offset)
        self.normals.append(self._normals(attributes, at, linear))
        self.colours.append(self._attribute(attributes, "COLOR_0", len(at), 3))
        # From the top: a Model's v runs up.
        places = self._attribute(attributes, "TEXCOORD_0", len(at), 2)
        self.textures.append(
            None if places is None else np.column_stack([places[:, 0], 1.0 - places[:, 1]])
        )
        first = sum(len(each) for each in self.vertices[:-1])
        self.faces.append(faces + np.int32(first) if first else faces)
        self.count += len(faces)
        material = -1
        if "material" in primitive:
            material = whole(primitive["material"])
            entry_of(self.path, self.json, "materials", material)
        self.material.append(np.full(len(faces), material, np.int32))
        part = self.parts.setdefault(placed.name, len(self.parts))
        self.part.append(np.full(len(faces), part, np.int32))
        if primitive.get("targets"):
            self.left_out["morph targets"] = None

    def _faces(self, primitive: dict[str, Any], mode: int, count: int) -> np.ndarray:
        index = np.arange(count, dtype=np.int32)
        if "indices" in primitive:
            index = self.buffers.indices(primitive["indices"], count)
        if mode == STRIP:
            return cut_strips(index)
        if mode == FAN:
            last = np.arange(2, max(2, len(index)))
            hub = np.broadcast_to(index[:1], len(last))
            return np.column_stack([hub, index[last - 1], index[last]])
        return index[: len(index) // 3 * 3].reshape(-1, 3)

    def _normals(
        self, attributes: dict[str, Any], at: np.ndarray, linear: np.ndarray
    ) -> np.ndarray | None:
        found = self._attribute(attributes, "NORMAL", len(at), 3)
        if found is None:
            return None
        a, b, c = linear
        return found @ np.array([np.cross(b, c), np.cross(c, a), np.cross(a, b)]).T

    def _attribute(
        self, attributes: dict[str, Any], name: str, count: int, wide: int
    ) -> np.ndarray | None:
        """(count, wide); None where the primitive has none."""
        if name not in attributes:
            return None
        found = self.buffers.accessor(attributes[name], (wide, wide + 1))[:, :wide]
        return found if len(found) == count else None

    def _ignored(self) -> list[str]:
        """What would be seen in another program."""
        ignored = [f"{what} are left out" for what in self.left_out]
        for key, what in (("skins", "skins"), ("animations", "animations"), ("cameras", "cameras")):
            if self.json.get(key):
                ignored.append(f"{what} are not used: it is shown in its pose at rest"
                            if key == "skins" else f"{what} are not used")  # fmt: skip
        textures = [
            surface["baseColorTexture"]
            for each in self.json.get("materials", [])
            if "baseColorTexture" in (surface := each.get("pbrMetallicRoughness", {}))
        ]
        if any("KHR_texture_transform" in each.get("extensions", {}) for each in textures):
            ignored.append(
                "its KHR_texture_transform is not used: textures lie as if it were not there"
            )
        if any(each.get("texCoord", 0) for each in textures):
            ignored.append("textures lie by TEXCOORD_0, other coordinates are not used")
        extensions = self.json.get("extensions", {})
        if "KHR_lights_punctual" in extensions:
            ignored.append("lights are not used: a scene has its own")
        unknown = [
            each for each in self.json.get("extensionsRequired", [])
            if each not in COMPRESSED and each != "KHR_lights_punctual"
        ]  # fmt: skip
        return ignored + [f"the extension {quoted(str(each))} is not known" for each in unknown]


def parts_of(path: Path, data: bytes) -> tuple[dict[str, Any], bytes | memoryview]:
    """The JSON, and of a GLB its binary chunk, which is not copied."""
    chunk: bytes | memoryview = b""
    if data[:4] == b"glTF":
        if len(data) < 20 or int.from_bytes(data[8:12], "little") > len(data):
            raise ModelFault(
                path, "", f"the file ends at byte {len(data)}, before the end that it tells",
                "it is cut short: copy or export it again",
            )  # fmt: skip
        if data[4:8] != b"\2\0\0\0":
            raise ModelFault(path, "header", "it is not of version 2", "export it as glTF 2.0")
        size = int.from_bytes(data[12:16], "little")
        text, rest = data[20 : 20 + size], memoryview(data)[20 + size :]
        if len(rest) >= 8 and bytes(rest[4:8]) == b"BIN\0":
            chunk = rest[8 : 8 + int.from_bytes(rest[:4], "little")]
    else:
        text = data
    try:
        document = json.loads(text)
    except (ValueError, RecursionError) as problem:
        line = getattr(problem, "lineno", 0)
        raise ModelFault(
            path, f"line {line}" if line else "", f"its JSON cannot be read ({problem})"[:200],
            "export the model again",
        ) from None  # fmt: skip
    if not isinstance(document, dict) or "asset" not in document:
        raise ModelFault(path, "", "it has no `asset`: it is no glTF file", "export it as glTF 2.0")
    version = str(document["asset"].get("version", ""))
    if not version.startswith("2."):
        raise ModelFault(path, "asset", f"version {quoted(version)} is not read",
                         "export it as glTF 2.0")  # fmt: skip
    return document, chunk


def _material(path: Path, document: dict[str, Any], index: int) -> FileMaterial:
    entry = entry_of(path, document, "materials", index)
    name = str(entry.get("name") or f"material {index + 1}")
    surface = entry.get("pbrMetallicRoughness", {})
    factor = surface.get("baseColorFactor", [1.0] * 4)
    if len(factor) != 4:
        raise ModelFault(
            path, f"material {index}", f"its baseColorFactor has {len(factor)} of 4 numbers",
            "the file is damaged: export the model again",
        )  # fmt: skip
    r, g, b, a = (min(max(float(x), 0.0), 1.0) for x in factor)
    return FileMaterial(name, (r, g, b), opacity=a, **_texture(path, document, surface))


def _texture(path: Path, document: dict[str, Any], surface: dict[str, Any]) -> dict[str, Any]:
    """Keys of FileMaterial: which picture, where, and how it is looked up."""
    if "baseColorTexture" not in surface:
        return {}
    texture = entry_of(path, document, "textures", surface["baseColorTexture"]["index"])
    if "source" not in texture:  # an extension's format
        return {}
    image = entry_of(path, document, "images", texture["source"])
    sampler = {}
    if "sampler" in texture:
        sampler = entry_of(path, document, "samplers", texture["sampler"])
    uri = str(image.get("uri", ""))
    held = not uri or uri.startswith("data:")
    return {
        "texture": path if held else path.parent / unquote(uri),
        "texture_inside": texture["source"] if held else -1,
        "texture_filter": "nearest" if sampler.get("magFilter") == NEAREST else "bilinear",
    }


def _joined(tables: list[np.ndarray]) -> np.ndarray:
    """One is not copied: of a large file it counts."""
    return tables[0] if len(tables) == 1 else np.concatenate(tables)


def _whole(
    tables: list[np.ndarray | None], counts: list[int], faces: np.ndarray
) -> PerCorner | None:
    """All primitives' in one; where they have none, corners have no row."""
    wide = next((each.shape[1] for each in tables if each is not None), 0)
    if not wide:
        return None
    table = np.concatenate([
        np.full((count, wide), np.nan) if each is None else each
        for each, count in zip(tables, counts, strict=True)
    ])  # fmt: skip
    known = np.isfinite(table).all(axis=1)
    if not known.any():
        return None
    return PerCorner(table, np.where(known[faces], faces, -1))
