"""Damaged, foreign and outdated files are refused and say why, never half read."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import STOPS, Encoded, decode

from raywalk.errors import SourceErrors
from raywalk.stops.decoded import read_trace
from raywalk.trace_file.container import pack, pack_texts, script, unpack
from raywalk.trace_file.encode import checksum, write_level


def changed(data: bytes, **parts: Any) -> bytes:
    return json.dumps(json.loads(data) | parts).encode()


def refusal(data: bytes, **expected: Any) -> str:
    """Which names the file."""
    with pytest.raises(SourceErrors, match=r"\.json\.gz: ") as error:
        decode(data, **expected)
    return str(error.value)


@pytest.mark.parametrize("version", [1, 2, 4])
def test_another_version_is_refused_as_such(glass: Encoded, version: int) -> None:
    said = refusal(changed(glass.json, version=version))
    assert f"written as version {version}, this reads 3" in said


def test_another_kind_of_json_is_no_trace(glass: Encoded) -> None:
    assert '"format" is not' in refusal(b"[]")
    assert '"format" is not' in refusal(changed(glass.json, format="else"))


def test_another_scene_or_resolution_is_refused(glass: Encoded) -> None:
    assert "not 01-shading" in refusal(glass.json, scene="01-shading")
    assert "holds n 21, not 7" in refusal(glass.json, n=7)


def test_a_changed_character_is_noticed(glass: Encoded) -> None:
    columns = dict(json.loads(glass.json)["columns"])
    columns["numbersa"] = "!" + columns["numbersa"][1:]
    assert "checksum" in refusal(changed(glass.json, columns=columns))


@pytest.mark.parametrize("part", ["tables", "patches", "images", "materials", "steps", "camera"])
def test_a_header_without_a_part_is_damaged(glass: Encoded, part: str) -> None:
    header = json.loads(glass.json)
    del header[part]
    assert "the header lacks something" in refusal(json.dumps(header).encode())


@pytest.mark.parametrize(
    "name", ["signature", "surface", "visibility0", "numbersa", "numbersj", "noise"]
)
@pytest.mark.parametrize("cut", ["shorter", "longer", "missing"])
def test_a_text_of_another_length_is_refused(glass: Encoded, name: str, cut: str) -> None:
    """Even with a checksum that matches; what notices it first depends on what was lost."""
    assert "damaged: " in refusal(with_text_cut(glass.json, name, cut))


def with_text_cut(data: bytes, name: str, cut: str) -> bytes:
    header = json.loads(data)
    text = header["columns"].pop(name)
    if cut != "missing":
        header["columns"][name] = text[:-1] if cut == "shorter" else text + " "
    header["crc32"] = checksum(header)
    return json.dumps(header).encode()


def test_fewer_rays_than_announced_are_damaged(glass: Encoded) -> None:
    rays = json.loads(glass.json)["rays"]
    for other in (rays + 1, rays - 1):
        assert f"its {other} rays" in refusal(changed(glass.json, rays=other))


@pytest.mark.parametrize("cut", [10, 1000, -1])
def test_a_cut_gzip_is_damaged(glass: Encoded, tmp_path: Path, cut: int) -> None:
    path = tmp_path / "21.json.gz"
    path.write_bytes(pack(glass.json)[:cut])
    with pytest.raises(SourceErrors, match="or a damaged one"):
        read_trace(path, STOPS)


def test_both_published_files_hold_the_same_trace(glass: Encoded, tmp_path: Path) -> None:
    n = glass.trace.n
    write_level(tmp_path, glass.tree, n, glass.scene, glass.picture)
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"{n}.js", f"{n}.json.gz"]
    one, two = (read_trace(tmp_path / f"{n}.{end}", STOPS) for end in ("js", "json.gz"))
    np.testing.assert_array_equal(one.colour, two.colour)
    start = f'raywalkReceive("{glass.scene.id}/{n}","'
    assert (tmp_path / f"{n}.js").read_text().startswith(start)


@pytest.mark.parametrize("pack", [pack, pack_texts])
def test_packing_twice_gives_the_same_bytes(glass: Encoded, pack: Callable[[bytes], bytes]) -> None:
    packed = pack(glass.json)
    assert pack(glass.json) == packed
    assert packed[4:8] == bytes(4), "no time of writing"
    assert gzip.decompress(packed) == unpack(script("a/5", packed)) == glass.json


@pytest.mark.parametrize("name", ["page.html", "other.js"])
def test_a_file_of_another_kind_is_no_trace(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text("<!doctype html>")
    with pytest.raises(SourceErrors, match=r"no \.json\.gz or \.js file of a trace"):
        read_trace(tmp_path / name, STOPS)
