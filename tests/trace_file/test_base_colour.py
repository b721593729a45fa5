"""Base colours go into a trace file exactly where an object has one, and cost nothing elsewhere."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import Encoded, decode
from test_schema import VALIDATOR
from tests.models.solids import QUADS, cube

from raywalk.scene.model import BASE_STEPS, Scene
from raywalk.scene.read import read_scene
from raywalk.stops.pixel_rays import as_json, describe
from raywalk.trace.pixel_tree import pixel_tree
from raywalk.trace.tree import LIT, RayTree
from raywalk.trace.wavefront import Traced, trace_scene
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of

N = 21
SCENE = """version = 1
title = "A coloured cube before a mirror"
teaches = "Something."
[camera]
eye = [1, 2, 5]
target = [0, 0, 0]
[render]
size = 63
resolutions = [21]
[[objects]]
name = "cube"
type = "mesh"
file = "cube.off"
[[objects]]
name = "floor"
type = "plane"
point = [0, -0.5, 0]
normal = [0, 1, 0]
material = { diffuse = [0.6, 0.5, 0.4], reflect = 0.3 }
[[lights]]
position = [3, 4, 5]
intensity = 1.3
[[lights]]
position = [-3, 1, 5]
colour = [0.2, 0.5, 0.3]
"""


def coloured_off(rng: np.random.Generator) -> str:
    """A cube with a random colour at each corner."""
    colours = rng.integers(0, 256, (8, 3)).tolist()
    rows = [
        " ".join(map(str, (*at, *colour)))
        for at, colour in zip(cube().tolist(), colours, strict=True)
    ]
    faces = [f"4 {' '.join(map(str, quad))}" for quad in QUADS.tolist()]
    return "\n".join(["COFF", "8 6 0", *rows, *faces])


@pytest.fixture
def traced(tmp_path: Path, rng: np.random.Generator) -> tuple[Scene, Traced]:
    (tmp_path / "cube.off").write_text(coloured_off(rng))
    (tmp_path / "scene.toml").write_text(SCENE)
    scene = read_scene(tmp_path)
    return scene, trace_scene(scene)


def test_base_colours_come_back_as_they_were_used(traced: tuple[Scene, Traced]) -> None:
    """Bit for bit, of rays from the camera and the mirror; colours add up from them."""
    scene, found = traced
    level = level_of(found.tree, N)
    json_bytes = encode(level, scene, found.picture)
    trace = decode(json_bytes, scene.id, N)
    VALIDATOR.validate(json.loads(json_bytes))
    assert level.base is not None
    assert (trace.base == level.base).all()
    on_cube = level.object == 0
    assert (level.depth[on_cube] == 1).any()
    assert len(np.unique(level.base[on_cube], axis=0)) > 40
    assert (level.base[~on_cube] == 1).all()
    assert np.abs(trace.colour - level.colour).max() <= trace.header["errors"]["colour"]


def test_the_trees_sum_holds_with_base_colours(traced: tuple[Scene, Traced]) -> None:
    """local = B ambient + sum over lights V (diffuse B Kd + specular Ks) of each hit."""
    scene, found = traced
    tree = found.tree
    expected = sum_of(tree, scene)
    hit = tree.object >= 0
    assert np.allclose(tree.local[hit], expected[hit], rtol=0, atol=4e-16)  # in another order


def sum_of(tree: RayTree, scene: Scene) -> np.ndarray:
    assert tree.base is not None
    ambient, kd, ks = (
        np.array([getattr(m, name) for m in scene.materials])[tree.material]
        for name in ("ambient", "diffuse", "specular")
    )
    total = tree.base * ambient
    for k, light in enumerate(scene.lights):
        lit = np.isin(tree.visibility[:, k], LIT)[:, None]
        shine = tree.diffuse[:, k, None] * tree.base * kd + tree.specular[:, k, None] * ks
        total = total + lit * shine * light.colour
    return np.asarray(total)


def test_both_commands_tell_the_base_colour_as_a_number(traced: tuple[Scene, Traced]) -> None:
    """`inspect` out of the file what `pixel` traces: the cube's in steps, none of the floor."""
    scene, found = traced
    level = level_of(found.tree, N)
    trace = decode(encode(level, scene, found.picture), scene.id, N)
    seen = set()
    for column, row in ((10, 10), (10, 13), (3, 18)):
        stored = as_json(trace, (column, row))["tree"]
        fresh = pixel_tree(scene, 63, 63, 3 * column + 1, 3 * row + 1)["tree"]
        assert stored["baseColour"] == fresh["base_colour"]
        seen.add(stored["objectName"])
        if stored["objectName"] == "cube":
            assert all(BASE_STEPS * value % 1 == 0 for value in stored["baseColour"])
            assert "base colour (" in describe(trace, (column, row))
        else:
            assert stored["baseColour"] is None
    assert seen == {"cube", "floor"}


def test_a_scene_without_them_has_not_a_byte_of_them(encoded: Encoded) -> None:
    header = json.loads(encoded.json)
    assert not [name for name in header["columns"] if name.startswith("base")]
    assert not [patch for patch in header["patches"] if "base" in patch]
    assert encoded.tree.base is None
    assert (encoded.trace.base == 1).all()
