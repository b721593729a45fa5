"""What `make` built into dist/: every scene, every grid, and how much goes over the wire."""

from __future__ import annotations

import gzip
import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raywalk.scene.read import read_scenes
from raywalk.site.sizes import check, kept, read_budgets
from raywalk.stops.decoded import read_trace
from raywalk.stops.process import Stops
from raywalk.trace.tree import SHOT
from raywalk.trace_file.container import mark_of, unpack

DIST = Path(__file__).parent.parent / "dist"
SCENES = read_scenes(Path(__file__).parent.parent / "scenes")
OWN = [scene for scene in SCENES if not scene.base]  # the others are lessons on these
COURSE = [scene for scene in SCENES if scene.key in tuple("1234567")]


def folder(scene):
    place = DIST / "scenes" / scene.id
    assert place.is_dir(), f"{scene.id} is not in dist/: run `make` first"
    return place


@pytest.fixture(scope="module")
def read():
    """A function that reads one of a scene's grids, the finest once for all tests."""
    with Stops() as stops:
        finest = cache(lambda scene: read_trace(path_of(scene, finest_of(scene)), stops))
        yield (
            lambda scene, n: (
                finest(scene) if n == finest_of(scene) else read_trace(path_of(scene, n), stops)
            )
        )


def finest_of(scene):
    return max(scene.render.resolutions)


def path_of(scene, n):
    return folder(scene) / f"{n}.json.gz"


@pytest.mark.parametrize("scene", OWN, ids=lambda scene: scene.id)
def test_every_tile_of_every_grid_is_the_pictures_pixel_at_its_centre(scene, read):
    """The invariant the site rests on, over all scenes and levels, to the last bit."""
    size = scene.render.size
    picture = np.asarray(Image.open(folder(scene) / "picture.png").convert("RGB"))
    assert picture.shape == (size, size, 3)
    for n in scene.render.resolutions:
        step = size // n
        centres = picture[step // 2 :: step, step // 2 :: step]
        tiles = read(scene, n).tiles.reshape(n, n, 3)
        np.testing.assert_array_equal(tiles, centres)


def test_traces_take_at_most_2_2_bytes_a_ray_over_all_scenes(read):
    """At the finest level, gzipped; a ray is a camera, reflected, refracted or shadow ray."""
    size = rays = 0
    for scene in OWN:
        path, trace = path_of(scene, finest_of(scene)), read(scene, finest_of(scene))
        shadow = int(np.isin(trace.visibility[trace.object >= 0], SHOT).sum())
        size, rays = size + path.stat().st_size, rays + trace.count + shadow
    print(f"{size / rays:.2f} bytes a ray over {rays} rays")
    assert size / rays <= 2.2


@pytest.mark.parametrize("scene", COURSE, ids=lambda scene: scene.id)
def test_the_first_view_of_a_scene_takes_at_most_200_kb_besides_the_picture(scene):
    """Page, style, viewer, scene data and its first grid, as a host sends them (gzip); not what
    comes when it is asked for, which has its own budgets."""
    place = folder(scene)
    level = scene.lesson[0].view.get("resolution") or 15
    sent = [place / "index.html", place / "scene.js", place / f"{level}.js"]
    assets = [*(DIST / "assets").glob("*.js"), *(DIST / "assets").glob("*.css")]
    sent += [path for path in assets if not path.name.startswith(("part-", "kiosk-", "check-"))]
    size = sum(len(gzip.compress(path.read_bytes(), 6)) for path in sent)
    print(f"{scene.id}: {size / 1000:.0f} KB")
    assert size <= 200_000


@pytest.mark.parametrize("scene", OWN, ids=lambda scene: scene.id)
def test_a_scenes_data_name_every_script_of_their_build(scene):
    """So an open page never draws what a later upload put in their place."""
    there = folder(scene)
    beside = {
        path.relative_to(there).with_suffix("").as_posix() for path in there.rglob("*.js")
    } - {"scene"}
    data = json.loads(unpack((there / "scene.js").read_bytes()))
    assert set(data["files"]) == {name for name in beside if not name.startswith("words-")}
    for name, mark in data["files"].items():
        assert mark_of(there / f"{name}.js") == mark
    assert len(set(data["files"].values())) == len(data["files"])


LESSONS = [scene for scene in SCENES if scene.base]


@pytest.mark.parametrize("scene", LESSONS, ids=lambda scene: scene.id)
def test_a_lesson_on_a_scene_copies_none_of_its_files(scene):
    """Its page loads that scene's picture and rays from where they are."""
    names = {path.name for path in folder(scene).iterdir()}
    assert {"index.html", "scene.js", "words-de.js"} <= names
    assert not {name for name in names if name.endswith((".gz", ".png", ".webp"))}
    data = json.loads(unpack((folder(scene) / "scene.js").read_bytes()))
    assert data["of"] == scene.base.id and "objects" not in data
    page = (folder(scene) / "index.html").read_text(encoding="utf-8")
    assert f"scenes/{scene.base.id}/picture.png" in page


def test_our_own_course_keeps_all_budgets():
    """Also those of scenes, of which somebody else's build is only told."""
    assert kept(DIST)
    assert check(DIST, kept(DIST), read_budgets()) == []
