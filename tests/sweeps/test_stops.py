"""A sweep's stops are the scene with another value, and nothing else."""

from __future__ import annotations

import gzip
import json
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.cases import cases

from raywalk.pipeline.parts import trace_parts
from raywalk.pipeline.sweeps import Tally, stop_parts, sweeps_chain, sweeps_here
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
from raywalk.work.explain import in_runs
from raywalk.work.pool import Job
from raywalk.work.progress import say_nothing
from raywalk.work.store import Entry, Store

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

[[sweeps]]
name = "paint"
varies = "objects.floor.material.diffuse"
values = [[0.8, 0.4, 0.2], [0.1, 0.4, 0.9]]

[[sweeps]]
name = "floor"
varies = "objects.floor.point.1"
values = [-1, -2]
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
    "points": 3, "paint": 2, "floor": 2,
}  # fmt: skip
EACH_STOP = [(sweep, stop) for sweep, stops in STOPS.items() for stop in range(stops)]
FEW = [
    ("lamp height", 0),
    ("refraction", 2),
    ("turn", 1),
    ("round", 1),
    ("place", 1),
    ("points", 2),
    ("paint", 1),
    ("floor", 1),
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
        "paint": ("diffuse = [0.8, 0.4, 0.2]", f"diffuse = {said}"),
        "floor": ("point = [0, -1, 0]", f"point = [0, {said}, 0]"),
        "place": ("center = [0, 0.5, 0]", f"center = [{said}, 0.5, {rows.get(stop // 2)}]"),
    }[sweep.name]
    text = WITH_SWEEPS.split("[[sweeps]]")[0]
    assert text.count(old) == 1
    return scene_of(text.replace(old, new), folder)


def test_the_scenes_own_value_is_one_of_the_stops(swept: Scene) -> None:
    """That stop's trace is the scene's own, which is not made from other parts."""
    assert [each.own for each in swept.sweeps] == [2, 1, 0, 2, 1, 0, 2, 1, 0, 0]
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


def explained(store: Store, scene: Scene, entry: Entry) -> tuple[list[str], list[int], Tally]:
    """What a build that explains itself says of a scene's sweeps; of each how many stops it traced,
    counted where they are; and what it tells of them at its end."""
    tally, told, counts = Tally(), [], []
    chain, done = sweeps_chain(store, scene, entry, tally), None
    with suppress(StopIteration):
        while True:
            said = chain.send(done)
            if isinstance(said, str):
                told.append(said)
            done = None
            if isinstance(said, Job):
                before = set(store.folder.iterdir())
                done = said.work(said.task, 2, say_nothing)
                counts.append(len(set(store.folder.iterdir()) - before))
    return told, counts, tally


def test_only_stops_whose_value_changed_are_traced_again_and_explained(tmp_path: Path) -> None:
    """Another last stop, and later another in the middle: the others are kept, and so is the
    scene's trace."""
    store = Store(tmp_path / "work", True)
    text = WITH_SWEEPS.split('\n[[sweeps]]\nname = "refraction"')[0]

    def built(text: str) -> tuple[list[str], list[int], str]:
        scene = scene_of(text, tmp_path / "02-test")
        parts = trace_parts(scene)
        trace_into(store, {scene.id: parts}, scene, 2, say_nothing)
        told, counts, tally = explained(store, scene, store.get(key_of(parts)))
        return [*told, key_of(parts)], counts, tally.told()

    steps = "from = [-2, 1, 2]\nto = [-2, 3, 2]\nstops = 3"
    first = built(text)
    listed = text.replace(steps, "values = [[-2, 3, 2], [-2, 2, 2], [-2, 0.5, 2]]")
    second = built(listed)
    third = built(listed.replace("[-2, 2, 2]", "[-2, 2.25, 2]"))
    again = built(listed)
    assert [counts for _, counts, _ in (first, second, third, again)] == [[3], [1], [1], []]
    assert second[2] == "3 stops: 1 traced, 2 unchanged"
    assert again[2] == "3 stops: 0 traced, 3 unchanged"
    assert {told[-1] for told, _, _ in (first, second, third, again)} == {first[0][-1]}
    said = "\n".join(third[0])
    assert '02-test: "lamp height": tracing 1 of 3 stops' in said
    why = '02-test: stop 2 of "lamp height" made: lights[0].position [-2.0, '
    assert why in said and "-> [-2.0, 2.25, 2.0]\n" in said
    assert '02-test: stops 1, 3 of "lamp height" unchanged' in said
    assert any(each.startswith("02-test: stop 1 of") and each.endswith("was never made before")
               for each in first[0])  # fmt: skip
    assert not any("stop" in each for each in again[0][:-1])


def test_stops_are_told_in_runs() -> None:
    assert [in_runs(each) for each in ([], [1], [1, 2], [1, 2, 3], [1, 2, 4, 6, 7, 8])] == [
        "", "1", "1, 2", "1 to 3", "1, 2, 4, 6 to 8",
    ]  # fmt: skip


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
                   "place": "objects", "points": "lights", "paint": "materials",
                   "floor": "objects"}[sweep.id]  # fmt: skip
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
