"""Python and the viewer decode every file to the same bits."""

from __future__ import annotations

import base64
import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import NAMES, encoded_scene

from raywalk.trace_file.container import pack
from raywalk.trace_file.decode import COLUMNS, DecodedTrace, read_trace

ROOT = Path(__file__).parents[2]
PRINTER = ROOT / "tests" / "viewer" / "trace" / "columns-as-bytes.mjs"
BUILT = sorted((ROOT / "dist" / "scenes").glob("*/*.json.gz"))
needs_node = pytest.mark.skipif(
    shutil.which("node") is None or not (ROOT / "node_modules" / "esbuild").exists(),
    reason="node and its packages are not installed",
)


def decoded_by_viewer(files: list[Path]) -> list[dict[str, np.ndarray]]:
    run = subprocess.run(
        ["node", PRINTER, *files], capture_output=True, text=True, check=True, cwd=ROOT
    )
    return [
        {
            name: np.frombuffer(
                base64.b64decode(column["base64"]), column["type"].removesuffix("Array").lower()
            )
            for name, column in json.loads(line).items()
        }
        for line in run.stdout.splitlines()
    ]


def assert_same_bits(python: DecodedTrace, viewer: dict[str, np.ndarray]) -> None:
    assert set(viewer) == set(COLUMNS)
    for name, column in viewer.items():
        mine = getattr(python, name).astype(column.dtype).reshape(-1)
        assert mine.tobytes() == column.tobytes(), f"column {name} differs"


@needs_node
def test_both_decoders_give_the_same_bits(tmp_path: Path) -> None:
    """Course scenes, glass, and random scenes, as 64-bit patterns."""
    files = []
    for name in NAMES:
        files.append(tmp_path / f"{name}.json.gz")
        files[-1].write_bytes(pack(encoded_scene(name).json))
    for name, viewer in zip(NAMES, decoded_by_viewer(files), strict=True):
        assert_same_bits(encoded_scene(name).trace, viewer)


@needs_node
def test_both_decoders_agree_on_every_built_trace() -> None:
    """Every scene, every frustum resolution of dist/."""
    assert BUILT, "there is no built site: run `make` first"
    for path in BUILT:
        assert_same_bits(read_trace(path), decoded_by_viewer([path])[0])
