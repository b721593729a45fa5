"""Damaged, foreign and outdated files are refused with a code, never half read."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Encoded

from raywalk.trace_file.checksum import checksum
from raywalk.trace_file.container import pack, script, unpack
from raywalk.trace_file.decode import decode, read_trace
from raywalk.trace_file.errors import TraceFileError
from raywalk.trace_file.write import write_level


def changed(data: bytes, **parts: Any) -> bytes:
    return json.dumps(json.loads(data) | parts).encode()


def code_of(data: bytes, **expected: Any) -> str:
    with pytest.raises(TraceFileError) as error:
        decode(data, **expected)
    return error.value.code


def test_another_version_is_refused_as_such(glass: Encoded) -> None:
    assert code_of(changed(glass.json, version=1)) == "version"


def test_another_kind_of_json_is_no_trace(glass: Encoded) -> None:
    assert code_of(b"[]") == "not-a-trace"
    assert code_of(changed(glass.json, format="else")) == "not-a-trace"


def test_another_scene_or_resolution_is_refused(glass: Encoded) -> None:
    assert code_of(glass.json, scene="01-shading") == "scene"
    assert code_of(glass.json, n=7) == "scene"


def test_a_changed_character_is_noticed(glass: Encoded) -> None:
    columns = dict(json.loads(glass.json)["columns"])
    columns["point0"] = "!" + columns["point0"][1:]
    assert code_of(changed(glass.json, columns=columns)) == "damaged"


@pytest.mark.parametrize("part", ["tables", "patches", "images", "materials", "steps", "camera"])
def test_a_header_without_a_part_is_damaged(glass: Encoded, part: str) -> None:
    header = json.loads(glass.json)
    del header[part]
    assert code_of(json.dumps(header).encode()) == "damaged"


@pytest.mark.parametrize("name", ["signature", "surface", "depth0", "point1", "split", "tile2"])
@pytest.mark.parametrize("cut", ["shorter", "longer", "missing"])
def test_a_column_of_another_length_is_damaged(glass: Encoded, name: str, cut: str) -> None:
    """Even with a checksum that matches."""
    header = json.loads(glass.json)
    text = header["columns"].pop(name)
    if cut != "missing":
        header["columns"][name] = text[:-1] if cut == "shorter" else text + " "
    header["crc32"] = checksum(header)
    assert code_of(json.dumps(header).encode()) == "damaged"


def test_fewer_rays_than_announced_are_damaged(glass: Encoded) -> None:
    rays = json.loads(glass.json)["rays"]
    assert code_of(changed(glass.json, rays=rays + 1)) == "damaged"
    assert code_of(changed(glass.json, rays=rays - 1)) == "damaged"


def test_a_cut_gzip_is_damaged(glass: Encoded) -> None:
    for cut in (10, 1000, -1):
        with pytest.raises(TraceFileError) as error:
            unpack(pack(glass.json)[:cut])
        assert error.value.code == "damaged"


def test_both_published_files_hold_the_same_trace(glass: Encoded, tmp_path: Path) -> None:
    n = glass.trace.n
    write_level(tmp_path, glass.tree, n, glass.scene, glass.picture)
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"{n}.js", f"{n}.json.gz"]
    one, two = read_trace(tmp_path / f"{n}.js"), read_trace(tmp_path / f"{n}.json.gz")
    np.testing.assert_array_equal(one.colour, two.colour)
    start = f'raywalkReceive("{glass.scene.id}/{n}","'
    assert (tmp_path / f"{n}.js").read_text().startswith(start)


def test_packing_twice_gives_the_same_bytes(glass: Encoded) -> None:
    assert pack(glass.json) == pack(glass.json)
    assert pack(glass.json)[4:8] == bytes(4), "no time of writing"
    assert unpack(script("a/5", pack(glass.json))) == glass.json


def test_a_file_of_another_kind_is_no_trace() -> None:
    with pytest.raises(TraceFileError) as error:
        unpack(b"<!doctype html>")
    assert error.value.code == "not-a-trace"
