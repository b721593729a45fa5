"""A sweep's stops are the scene with another value, and nothing else."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.cases import cases

from raywalk.pipeline.parts import trace_parts
from raywalk.pipeline.sweeps import stop_parts, sweeps_here
from raywalk.pipeline.trace_task import trace_into
from raywalk.scene.model import Scene, Sweep
from raywalk.scene.read import read_scene
from raywalk.scene.sweeps import picture_side
from raywalk.site.scene_data import Display
from raywalk.site.stop_data import stop_data
from raywalk.sweeps.differences import as_differences, whole_again
from raywalk.sweeps.trace_stop import write_stop
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import Tracer, trace_picture
from raywalk.trace_file.container import unpack
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of
from raywalk.work.digests import key_of
from raywalk.work.progress import say_nothing
from raywalk.work.store import Store

# 165 = 3 * 5 * 11: it has both grids, and is traced in no time.
SCENE = """\
version = 1
title = "A test"
teaches = "Something."

[camera]
eye = [0, 0, 5]
target = [0, 0, 0]

[render]
size = 165
resolutions = [15, 33]
depth = 2

[materials.glass]
like = "glass"
ior = 1.5

[[objects]]
name = "ball"
type = "sphere"
center = [0, 0.5, 0]
radius = 0.8
material = "glass"

[[objects]]
name = "floor"
type = "plane"
point = [0, -1, 0]
normal = [0, 1, 0]
material = { diffuse = [0.8, 0.4, 0.2], ambient = [0.1, 0.1, 0.1], reflect = 0.2 }

[[objects]]
name = "block"
type = "box"
minimum = [-0.5, -0.5, -0.5]
maximum = [0.5, 0.5, 0.5]
material = "coloured"
transform = [{ translate = [1, -0.5, -1] }, { rotate = { axis = "y", degrees = 20 } }]

[[lights]]
position = [-2, 3, 2]

[[lights]]
name = "panel"
position = [1, 3, 1]
edges = [[1, 0, 0], [0, 0, 1]]
samples = [2, 1]
intensity = 0.4
"""
SWEEPS = """
[[sweeps]]
name = "lamp height"
varies = 'lights."light 1".position'
from = [-2, 1, 2]
to = [-2, 3, 2]
stops = 3

[[sweeps]]
name = "refraction"
varies = "materials.glass.ior"
values = [1.0, 1.5, 2.4]

[[sweeps]]
name = "turn"
varies = "objects.block.transform.1.rotate.degrees"
values = [20, 65]

[[sweeps]]
name = "bounces"
varies = "render.depth"
from = 0
to = 2
stops = 3

[[sweeps]]
name = "zoom"
varies = "camera.fov"
values = [30, 45]

[[sweeps]]
name = "round"
varies = "camera.eye"
about = [0, 0, 0]
from = 0
to = 90
stops = 2

[[sweeps]]
name = "place"
varies = "objects.ball.center.0"
values = [0, 0.25]
across = { varies = "objects.ball.center.2", values = [-0.5, 0] }

[[sweeps]]
name = "points"
varies = "lights.panel.samples"
values = [[1, 1], [2, 1], [2, 2]]
"""
# The scene without its own field of view has 45 degrees all the same; a sweep wants it written.
WITH_SWEEPS = SCENE.replace("target = [0, 0, 0]", "target = [0, 0, 0]\nfov = 45", 1) + SWEEPS


def scene_of(text: str, folder: Path) -> Scene:
    folder.mkdir(exist_ok=True)
    (folder / "scene.toml").write_text(text, encoding="utf-8")
    return read_scene(folder)


@pytest.fixture(scope="module", name="swept")
def swept_scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    return scene_of(WITH_SWEEPS, tmp_path_factory.mktemp("swept"))


STOPS = {
    "lamp height": 3, "refraction": 3, "turn": 2, "bounces": 3, "zoom": 2, "round": 2, "place": 4,
    "points": 3,
}  # fmt: skip
EACH_STOP = [(sweep, stop) for sweep, stops in STOPS.items() for stop in range(stops)]
FEW = [
    ("lamp height", 0),
    ("refraction", 2),
    ("turn", 1),
    ("round", 1),
    ("place", 1),
    ("points", 2),
]


@pytest.mark.parametrize("which", cases(EACH_STOP, FEW))
def test_every_stop_equals_a_fresh_trace_of_the_scene_with_that_value(
    swept: Scene, tmp_path: Path, which: tuple[str, int]
) -> None:
    """Byte for byte: both grids' files, and the picture's pixels."""
    name, stop = which
    [sweep] = [each for each in swept.sweeps if each.name == name]
    write_stop(sweep.stops[stop], sweep.resolutions, sweep.picture, tmp_path, 2)
    fresh = scene_at(sweep, stop, tmp_path / swept.id)
    traced = trace_picture(Tracer(fresh, least_share=LEAST_SHARE))
    for n in (15, 33):
        written = gzip.decompress((tmp_path / f"{n}.json.gz").read_bytes())
        assert written == encode(level_of(traced.tree, n), fresh, traced.picture)
    [picture] = tmp_path.glob("picture.*")
    assert np.array_equal(np.asarray(Image.open(picture).convert("RGB")), traced.picture)


def scene_at(sweep: Sweep, stop: int, folder: Path) -> Scene:
    """The scene whose author had written this value: by what its text says, not by what we do."""
    column = stop % len(sweep.values)
    value = sweep.values[column]
    places, rows = {0: [0, 0, 5], 90: [5, 0, 0]}, {0: -0.5, 1: 0}
    said = str(list(value)) if isinstance(value, tuple) else str(value)
    old, new = {
        "lamp height": ("position = [-2, 3, 2]", f"position = {said}"),
        "refraction": ("ior = 1.5", f"ior = {said}"),
        "turn": ("degrees = 20", f"degrees = {said}"),
        "bounces": ("depth = 2", f"depth = {said}"),
        "zoom": ("fov = 45", f"fov = {said}"),
        "round": ("eye = [0, 0, 5]", f"eye = {places.get(value)}"),
        "points": ("samples = [2, 1]", f"samples = {said}"),
        "place": ("center = [0, 0.5, 0]", f"center = [{said}, 0.5, {rows.get(stop // 2)}]"),
    }[sweep.name]
    text = WITH_SWEEPS.split("[[sweeps]]")[0]
    assert text.count(old) == 1
    return scene_of(text.replace(old, new), folder)


def test_the_scenes_own_value_is_one_of_the_stops(swept: Scene) -> None:
    """That stop's trace is the scene's own, which is not made from other parts."""
    assert [each.own for each in swept.sweeps] == [2, 1, 0, 2, 1, 0, 2, 1]
    for sweep in swept.sweeps:
        own = sweep.stops[sweep.own]
        assert trace_parts(own)["scene"] == trace_parts(swept)["scene"]


def test_a_pictures_pixels_are_a_third_of_the_pictures() -> None:
    """385 of 1155; all of a picture that has no such part."""
    assert [picture_side(size) for size in (1155, 165, 3465, 1024)] == [385, 165, 385, 1024]


def test_differences_become_whole_again_and_are_never_longer(rng: np.random.Generator) -> None:
    """Keys and columns come, go and change."""
    tables = []
    for _ in range(12):
        columns = {f"c{k}": "x" * int(rng.integers(3)) for k in range(4) if rng.random() < 0.8}
        keys = {f"k{k}": int(rng.integers(2)) for k in range(4) if rng.random() < 0.8}
        tables.append({**keys, **({"columns": columns} if rng.random() < 0.9 else {})})
    given = as_differences(tables)
    assert whole_again(json.loads(json.dumps(given))) == tables
    for table, each in zip(tables, given, strict=True):
        assert len(json.dumps(each)) <= len(json.dumps({"whole": table}))


def test_only_stops_whose_value_changed_are_traced_again(tmp_path: Path) -> None:
    """Another last stop: the others are kept, and so is the scene's trace."""
    store = Store(tmp_path / "work")
    text = WITH_SWEEPS.split('\n[[sweeps]]\nname = "refraction"')[0]

    def built(text: str) -> tuple[dict[str, bool], str]:
        scene = scene_of(text, tmp_path / "02-test")
        [sweep] = scene.sweeps
        before = {key_of(stop_parts(each, sweep)): False for each in sweep.stops}
        before = {key: store.find(key) is not None for key in before}
        parts = trace_parts(scene)
        trace_into(store, {scene.id: parts}, scene, 2, say_nothing)
        sweeps_here(store, scene, store.get(key_of(parts)))
        return before, key_of(parts)

    first, trace = built(text)
    steps = "from = [-2, 1, 2]\nto = [-2, 3, 2]\nstops = 3"
    listed = "values = [[-2, 3, 2], [-2, 2, 2], [-2, 0.5, 2]]"
    second, again = built(text.replace(steps, listed))
    assert not any(first.values())
    assert list(second.values()) == [True, True, False]
    assert trace == again


def test_what_is_published_holds_every_stops_bytes(tmp_path: Path) -> None:
    """<n>.js gives back each stop's canonical JSON; stops.js what moved, and nothing else."""
    store = Store(tmp_path / "work")
    scene = scene_of(WITH_SWEEPS, tmp_path / "02-test")
    parts = trace_parts(scene)
    trace_into(store, {scene.id: parts}, scene, 2, say_nothing)
    found = sweeps_here(store, scene, store.get(key_of(parts)))
    assert set(found) == {name.replace(" ", "-") for name in STOPS}
    for sweep in scene.sweeps:
        entry = found[sweep.id]
        for n in sweep.resolutions:
            given = json.loads(unpack((entry.folder / f"{n}.js").read_bytes()))["stops"]
            for stop, table in zip(sweep.stops, whole_again(given), strict=True):
                kept = store.get(key_of(stop_parts(stop, sweep))).folder / f"{n}.json.gz"
                text = json.dumps(table, sort_keys=True, separators=(",", ":"), allow_nan=False)
                assert text.encode() == gzip.decompress(kept.read_bytes())
        moved = json.loads(unpack((entry.folder / "stops.js").read_bytes()))["stops"]
        assert set(moved[sweep.own]) == {"picture"}
        changed = {"lamp-height": "lights", "refraction": "materials", "turn": "objects",
                   "bounces": "depth", "zoom": "camera", "round": "camera",
                   "place": "objects", "points": "lights"}[sweep.id]  # fmt: skip
        others = [set(each) for k, each in enumerate(moved) if k != sweep.own]
        assert all(each == {"picture", changed} for each in others)


def test_names_are_not_among_what_is_other_at_a_stop(swept: Scene) -> None:
    """They are the scene's, in whatever language it is shown."""
    [sweep] = [each for each in swept.sweeps if each.name == "lamp height"]
    display = Display(np.zeros(3), 1.0, {})
    data = stop_data(sweep.stops[0], swept, display, "x.webp")
    assert data["lights"] == [{"position": (-2.0, 1.0, 2.0)}, {}, {}]


def test_where_a_lamp_has_other_points_all_lights_of_the_stop_are_told(swept: Scene) -> None:
    """By name, so that they stand in place of the scene's; each has its own place and strength."""
    [sweep] = [each for each in swept.sweeps if each.name == "points"]
    display = Display(np.zeros(3), 1.0, {})
    one, own, four = (stop_data(stop, swept, display, "x.webp") for stop in sweep.stops)
    assert "lights" not in own
    assert [each["name"] for each in one["lights"]] == ["light 1", "panel"]
    assert [each["name"] for each in four["lights"]][1:] == [f"panel {k}/4" for k in (1, 2, 3, 4)]
    assert all(set(each) == {"name", "position", "colour", "intensity", "attenuation"}
               for each in four["lights"])  # fmt: skip
