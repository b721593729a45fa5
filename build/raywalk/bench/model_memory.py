"""What reading one large model takes at its peak. Run as a process of its own.

    python -m raywalk.bench.model_memory NAME MEGABYTES

Writes a torus of about so many megabytes in the format that NAME ends in, reads and cleans it and
makes its report as `raywalk model` does, and prints the file's bytes and the peak's growth.
"""

from __future__ import annotations

import json
import struct
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from typing import IO

import numpy as np

from raywalk.bench.model_files import CORE, good_files
from raywalk.bench.speed_memory import peak_of_this_process
from raywalk.models.kept import read_cleaned
from raywalk.models.report import report
from raywalk.models.telling import in_full
from raywalk.optics.heap import hand_back_freed_memory

#: A file's name -> about how many bytes it has a triangle: half a vertex, and a face.
BYTES = {
    "large.obj": 42.0, "large.off": 41.0, "text.stl": 230.0, "binary.stl": 50.0,
    "text.ply": 41.0, "binary.ply": 19.0, "large.glb": 18.0, "large.3mf": 16.0,
}  # fmt: skip
ROUND = 0.4  # radius of the torus's tube
SOME = 4096  # rows that are written at a time


def torus(triangles: int) -> tuple[np.ndarray, np.ndarray]:
    """(v, 3) float32 corners and (f, 3) int32 of about so many triangles, closed."""
    n = max(3, round((triangles / 2) ** 0.5))
    one, other = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    a, b = 2 * np.pi * one / n, 2 * np.pi * other / n
    away = 1 + ROUND * np.cos(b)
    at = np.stack([away * np.cos(a), away * np.sin(a), ROUND * np.sin(b)], axis=-1)
    index = np.arange(n * n, dtype=np.int32).reshape(n, n)
    right, down = np.roll(index, -1, axis=1), np.roll(index, -1, axis=0)
    both = np.roll(right, -1, axis=0)
    faces = np.stack([index, down, both, index, both, right], axis=-1)
    return at.reshape(-1, 3).astype(np.float32), faces.reshape(-1, 3)


def write(path: Path, triangles: int) -> None:
    """A torus in the format that the name says."""
    corners, faces = torus(triangles)
    kind = path.suffix.removeprefix(".")
    if kind == "3mf":
        with (
            zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as package,
            package.open("3D/3dmodel.model", "w", force_zip64=True) as file,
        ):
            _write_3mf(file, corners, faces)
        return
    with path.open("wb") as file:
        if kind == "obj":
            _rows(file, "v %.6g %.6g %.6g\n", corners)
            _rows(file, "f %d %d %d\n", faces + 1)
        elif kind == "off":
            file.write(f"OFF\n{len(corners)} {len(faces)} 0\n".encode())
            _rows(file, "%.6g %.6g %.6g\n", corners)
            _rows(file, "3 %d %d %d\n", faces)
        elif kind == "stl":
            _write_stl(file, corners[faces], path.name.startswith("text"))
        elif kind == "ply":
            _write_ply(file, corners, faces, path.name.startswith("text"))
        else:
            _write_glb(file, corners, faces)


def _rows(file: IO[bytes], form: str, rows: np.ndarray) -> None:
    for k in range(0, len(rows), SOME):
        some = rows[k : k + SOME]
        file.write((form * len(some) % tuple(some.ravel().tolist())).encode())


def _write_stl(file: IO[bytes], triangles: np.ndarray, as_text: bool) -> None:
    if as_text:
        form = "facet normal 0 0 0\nouter loop\n" + 3 * "vertex %.6g %.6g %.6g\n"
        file.write(b"solid torus\n")
        _rows(file, form + "endloop\nendfacet\n", triangles.reshape(-1, 9))
        file.write(b"endsolid torus\n")
        return
    file.write(b"a torus".ljust(80) + struct.pack("<I", len(triangles)))
    rows = np.zeros(len(triangles), [("normal", "<f4", 3), ("at", "<f4", (3, 3)), ("rest", "<u2")])
    rows["at"] = triangles
    file.write(rows.tobytes())


def _write_ply(file: IO[bytes], corners: np.ndarray, faces: np.ndarray, as_text: bool) -> None:
    form = "ascii" if as_text else "binary_little_endian"
    file.write(
        f"ply\nformat {form} 1.0\nelement vertex {len(corners)}\nproperty float x\n"
        f"property float y\nproperty float z\nelement face {len(faces)}\n"
        "property list uchar int vertex_indices\nend_header\n".encode()
    )
    if as_text:
        _rows(file, "%.6g %.6g %.6g\n", corners)
        _rows(file, "3 %d %d %d\n", faces)
        return
    rows = np.zeros(len(faces), [("count", "u1"), ("at", "<i4", 3)])
    rows["count"], rows["at"] = 3, faces
    file.write(corners.astype("<f4").tobytes() + rows.tobytes())


def _write_glb(file: IO[bytes], corners: np.ndarray, faces: np.ndarray) -> None:
    places, index = corners.astype("<f4").tobytes(), faces.astype("<u4").tobytes()
    form = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3"},
            {"bufferView": 1, "componentType": 5125, "count": faces.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(places)},
            {"buffer": 0, "byteOffset": len(places), "byteLength": len(index)},
        ],
        "buffers": [{"byteLength": len(places) + len(index)}],
    }).encode()  # fmt: skip
    form += b" " * (-len(form) % 4)
    size = len(places) + len(index)
    file.write(b"glTF" + struct.pack("<III", 2, 28 + len(form) + size, len(form)) + b"JSON" + form)
    file.write(struct.pack("<I", size) + b"BIN\0" + places + index)


def _write_3mf(file: IO[bytes], corners: np.ndarray, faces: np.ndarray) -> None:
    file.write(
        f'<?xml version="1.0"?><model unit="millimeter" xmlns="{CORE}"><resources>'
        '<object id="1"><mesh><vertices>'.encode()
    )
    _rows(file, '<vertex x="%.6g" y="%.6g" z="%.6g"/>', corners)
    file.write(b"</vertices><triangles>")
    _rows(file, '<triangle v1="%d" v2="%d" v3="%d"/>', faces)
    file.write(
        b'</triangles></mesh></object></resources><build><item objectid="1"/></build></model>'
    )


def main(name: str, megabytes: float) -> dict[str, int]:
    """Bytes of the file, its triangles, and by how many bytes the peak grew."""
    hand_back_freed_memory()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / "cube.mtl").write_bytes(b"newmtl red\nKd 1 0 0\n")
        for small, content in good_files().items():  # packages imported
            if Path(small).suffix == Path(name).suffix:
                (folder / small).write_bytes(content)
                _read(folder / small)
        path = folder / name
        # In a process of its own: what writing takes is not what reading takes.
        _written(path, round(megabytes * 1e6 / BYTES[name]))
        before = peak_of_this_process()
        triangles = _read(path)
        return {
            "bytes": path.stat().st_size, "triangles": triangles,
            "grown": peak_of_this_process() - before,
        }  # fmt: skip


def _written(path: Path, triangles: int) -> None:
    code = (
        "from pathlib import Path; import sys; from raywalk.bench.model_memory import write; "
        "write(Path(sys.argv[1]), int(sys.argv[2]))"
    )
    subprocess.run([sys.executable, "-c", code, str(path), str(triangles)], check=True)


def _read(path: Path) -> int:
    cleaned = read_cleaned(path)
    found = report(cleaned)
    list(in_full(found))
    return len(cleaned.faces)


if __name__ == "__main__":
    print(json.dumps(main(sys.argv[1], float(sys.argv[2]))))
