"""Vectors for graders: the numbers of `raywalk pixel`, as JSON and as a table."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from dataclasses import fields, replace
from io import StringIO
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
from tests.geometry.by_hand import CHALK, SHAPES, affine, scene_of

import raywalk.homework
from raywalk.homework.rows import as_csv
from raywalk.homework.vectors import GRIDS, KEYS, MEASURED, grid_of, vectors_of
from raywalk.homework.write import as_json
from raywalk.scene.model import Checker, Light, Scene, SceneObject
from raywalk.scene.read import read_scene
from raywalk.scene.shapes import SHAPES as BY_WORD
from raywalk.scene.shapes import Box, Plane
from raywalk.trace.conditioning import is_steady
from raywalk.trace.pixel_tree import pixel_tree
from raywalk.trace.wavefront import Tracer

FOLDER = Path(__file__).parents[2] / "scenes"
SCHEMA = json.loads(
    (Path(raywalk.homework.__file__).parent / "vectors.schema.json").read_text("utf-8")
)
NAMES = ("02-shadows", "03-two-lights", "05-many-bounces", "08-glass", "14-soft-shadows-16")


@pytest.fixture(scope="module", params=NAMES)
def found(request: pytest.FixtureRequest) -> tuple[Scene, dict[str, Any]]:
    """A scene and its vectors, written and read again."""
    scene = read_scene(FOLDER / request.param)
    return scene, json.loads(as_json(vectors_of(Tracer(scene))))


def as_pixel_says(node: dict[str, Any]) -> dict[str, Any]:
    """What the vectors keep of a ray of `raywalk pixel`."""
    kept = {key: node[key] for key in KEYS}
    return kept | {"children": [as_pixel_says(child) for child in node["children"]]}


def test_every_number_is_that_of_raywalk_pixel(found: tuple[Scene, dict[str, Any]]) -> None:
    """To the last digit: all pixels of 5 x 5, every twentieth of the others."""
    scene, vectors = found
    for grid in vectors["grids"]:
        n = grid["n"]
        for entry in grid["pixels"][:: 1 if n == 5 else 20]:
            answer = pixel_tree(scene, n, n, *entry["pixel"])
            assert entry["ray"] == as_pixel_says(answer["tree"])
            step = 255 * np.clip(answer["colour"], 0, 1)
            assert np.abs(np.array(entry["bytes"]) - step).max() <= 0.5


def test_every_pixel_is_there_or_left_out(found: tuple[Scene, dict[str, Any]]) -> None:
    """Each once, in raster order; those that hang on a rounding, and they are few."""
    _, vectors = found
    assert [grid["n"] for grid in vectors["grids"]] == list(GRIDS)
    for grid in vectors["grids"]:
        n, left = grid["n"], grid["left_out"]
        listed = [entry["pixel"] for entry in grid["pixels"]]
        every = [[column, row] for row in range(n) for column in range(n)]
        assert sorted(listed + left, key=lambda at: at[::-1]) == every
        assert listed == [at for at in every if at not in left]
        assert len(left) <= 0.17 * n * n


def test_a_schema_says_what_there_is(found: tuple[Scene, dict[str, Any]]) -> None:
    """The schema is one, the vectors are as it says, and it misses nothing that they have."""
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    # The finest grid has the same kinds of rays, and would take most of the time.
    jsonschema.validate(found[1] | {"grids": found[1]["grids"][:2]}, SCHEMA)
    assert set(SCHEMA["$defs"]["ray"]["properties"]) == {*KEYS, "children"}
    assert set(found[1]["tolerance"]) == set(MEASURED)


def in_order(ray: dict[str, Any]) -> Iterator[dict[str, Any]]:
    yield ray
    for child in ray["children"]:
        yield from in_order(child)


def test_the_table_has_the_same_rays(found: tuple[Scene, dict[str, Any]]) -> None:
    """A row a ray, each with the numbers of its ray in JSON, digit by digit."""
    _, vectors = found
    rows = list(csv.DictReader(StringIO(as_csv(vectors))))
    place = 0
    for grid in vectors["grids"]:
        for entry in grid["pixels"]:
            tree = list(in_order(entry["ray"]))
            for number, ray in enumerate(tree):
                row, place = rows[place], place + 1
                at = [row["n"], row["column"], row["row"], row["ray"]]
                assert at == [str(x) for x in (grid["n"], *entry["pixel"], number)]
                assert (row["parent"] == "") == (number == 0)
                if number:
                    assert ray in tree[int(row["parent"])]["children"]
                assert row["t"] == ("" if ray["t"] is None else repr(ray["t"]))
                assert row["object"] == (ray["object"] or "")
                point = [row[f"point_{axis}"] for axis in "xyz"]
                assert point == ([""] * 3 if ray["point"] is None else [*map(repr, ray["point"])])
                for k, light in enumerate(ray["lights"], 1):
                    assert row[f"light{k}_diffuse"] == repr(light["diffuse"])
                    assert row[f"light{k}_visible"] == str(int(light["visible"]))
    assert place == len(rows)


def test_a_program_that_knows_what_is_given_traces_the_scene() -> None:
    """A scene made of nothing but `given` has the same rays."""
    vectors = vectors_of(Tracer(read_scene(FOLDER / "05-many-bounces")))
    given = vectors["given"]
    materials = {material["name"]: k for k, material in enumerate(given["materials"])}
    objects = []
    for each in given["objects"]:
        kind = BY_WORD[each["type"]]
        shape = kind(**{field.name: each[field.name] for field in fields(kind)})
        objects.append(SceneObject(each["name"], shape, materials[each["material"]]))
    again = scene_of(
        objects, [type(CHALK)(**material) for material in given["materials"]],
        [Light(**light) for light in given["lights"]], given["background"],
        given["camera"]["eye"], given["camera"]["target"], given["camera"]["fov"],
        depth=given["depth"], shadows=given["shadows"],
    )  # fmt: skip
    assert grid_of(Tracer(again), 5) == vectors["grids"][0]


def test_moved_objects_and_checkers_are_told() -> None:
    """A matrix of three rows, and the checker's size and second material."""
    moved = SceneObject("box", Box((0, 0, 0), (1, 1, 1)), 0, affine(np.eye(3), (0, 0.5, 0)))
    floor = SceneObject("floor", Plane((0, -1, 0), (0, 1, 0)), 0, checker=Checker(0.5, 1))
    odd = replace(CHALK, name="odd")
    given = vectors_of(Tracer(scene_of([moved, floor], [CHALK, odd])))["given"]["objects"]
    assert given[0]["matrix"] == [[1, 0, 0, 0], [0, 1, 0, 0.5], [0, 0, 1, 0]]
    assert given[0]["minimum"] == (0, 0, 0) and "checker" not in given[0]
    assert given[1]["checker"] == {"size": 0.5, "odd": "odd"} and "matrix" not in given[1]


def test_what_a_rounding_decides_is_left_out() -> None:
    """The ray along -z touches the ball that lies one radius below it: any program may miss."""
    ball = scene_of([replace(SHAPES["sphere"], center=(0.0, -1.3, 0.0))])  # type: ignore[type-var]
    assert not is_steady(Tracer(ball), 15, np.array([7 * 15 + 7]))[0]
    assert [7, 7] in grid_of(Tracer(ball), 15)["left_out"]
    assert is_steady(Tracer(ball), 15, np.array([0]))[0]


def test_very_many_lamps_leave_the_finest_grid_out() -> None:
    """64 of them at each of 1089 pixels are 70,000 answers."""
    lamps = [Light(f"lamp {k}", (k / 10, 3.0, 1.0)) for k in range(64)]
    vectors = vectors_of(Tracer(scene_of([SHAPES["sphere"]], lights=lamps)))
    assert [grid["n"] for grid in vectors["grids"]] == [5, 15]
