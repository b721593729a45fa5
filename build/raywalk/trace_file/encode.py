"""A level's ray tree as canonical JSON. FORMAT.md says what the parts mean."""

from __future__ import annotations

import json
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.trace.tree import RayTree
from raywalk.trace_file.container import pack_texts, write_beside, write_packed
from raywalk.trace_file.header import begin_header, picture_vectors
from raywalk.trace_file.measure import measured_errors
from raywalk.trace_file.noting import Noting, Ray
from raywalk.trace_file.patches import split_into_patches
from raywalk.trace_file.precision import finite_extent
from raywalk.trace_file.walk import walk


def encode(
    level: RayTree, scene: Scene, picture: np.ndarray, frame: dict[str, Any] | None = None
) -> bytes:
    """JSON bytes of one level (see level_of); picture: (size, size, 3) uint8; frame: as written."""
    header, _ = written(level, scene, picture, frame)
    return json.dumps(header, sort_keys=True, separators=(",", ":"), allow_nan=False).encode()


def written(
    tree: RayTree, scene: Scene, picture: np.ndarray, frame: dict[str, Any] | None = None
) -> tuple[dict[str, Any], Ray]:
    """What the file holds, and the columns as every reader will have them.

    frame: what spans the picture, as `picture_vectors` has it, where that is not the scene's camera
    (rays of a program with a mistake in it).
    """
    tile = picture.reshape(-1, 3)[tree.pixel[: tree.cameras]]
    extent = finite_extent(tree, scene)
    patches, patch_of = split_into_patches(tree.object, tree.point, tree.normal, extent)
    header, symbols = begin_header(
        tree, scene, extent, patches, patch_of, frame or picture_vectors(scene)
    )
    noting = Noting(symbols)
    ray = walk(header, noting, tree, tile)
    header["columns"], header["predictors"] = noting.columns(), noting.predictors
    header["same"] = noting.same
    header["errors"] = measured_errors(tree, header, ray, tile)
    header["crc32"] = checksum(header)
    return header, ray


def checksum(header: dict[str, Any]) -> int:
    """Damage is noticed: one CRC-32 over the columns in the order of their names."""
    columns = header["columns"]
    return zlib.crc32("".join(columns[name] for name in sorted(columns)).encode())


def write_level(folder: Path, level: RayTree, n: int, scene: Scene, picture: np.ndarray) -> None:
    """<n>.json.gz for anyone, <n>.js for the viewer, which cannot fetch from file://."""
    packed = pack_texts(encode(level, scene, picture))
    write_beside(folder / f"{n}.json.gz", packed)
    write_packed(folder / f"{n}.js", f"{scene.id}/{n}", packed)
