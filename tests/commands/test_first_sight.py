"""What `raywalk serve` shows of a saved scene before all of it is traced: its grids, exactly."""

from __future__ import annotations

import base64
import gzip
import json
import re
import threading
import urllib.request
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raywalk.commands import build_site
from raywalk.pipeline.first_sight import first_sight
from raywalk.pipeline.parts import trace_parts
from raywalk.pipeline.trace_products import write_products
from raywalk.pipeline.trace_task import trace_into
from raywalk.scene.read import read_scene
from raywalk.site.live import Live
from raywalk.site.serve import server
from raywalk.trace.tree import level_pixels
from raywalk.trace.wavefront import trace_grids
from raywalk.work.digests import key_of
from raywalk.work.store import Store

SIZE, GRIDS = 315, (5, 7, 15, 21)  # 7 and 21 are not whole tiles of 15, nor 15 of 21
SCENE = f"""
version = 1
key = "{{key}}"
title = "Ball"
teaches = "A ball."
camera = {{{{ eye = [0, 0, 5], target = [0, 0, 0] }}}}
render = {{{{ size = {SIZE}, resolutions = {list(GRIDS)}, depth = 3, shadows = true }}}}
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = {{radius}}
material = "mirror"
[[objects]]
name = "floor"
type = "plane"
point = [0, -1, 0]
normal = [0, 1, 0]
material = "white"
[[lights]]
position = [1, 2, 3]
"""


def saved(folder: Path, key: str = "1", radius: float = 0.9) -> Path:
    """A scene's file."""
    place = folder / "scenes" / f"0{key}-ball" / "scene.toml"
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(SCENE.format(key=key, radius=radius), encoding="utf-8")
    return place


def places(folder: Path) -> Namespace:
    """Where a build of these scenes keeps what it makes."""
    return Namespace(scenes=folder / "scenes", out=folder / "dist", work=folder / "work")


def with_a_page(folder: Path, id: str) -> Path:
    page = folder / "dist" / "scenes" / id / "index.html"
    page.parent.mkdir(parents=True)
    page.write_text("<html><body></body></html>", encoding="utf-8")
    return page


def pixels_of(picture: Path) -> np.ndarray:
    return np.array(Image.open(picture).convert("RGB"))


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """One scene's files, traced as a whole and for a first sight."""
    folder = tmp_path_factory.mktemp("sight")
    scene = read_scene(saved(folder))
    for name, more in ("whole", {}), ("first", {"trace": trace_grids}):
        (folder / name).mkdir()
        write_products(scene, folder / name, 2, **more)
    return folder


@pytest.mark.parametrize("n", GRIDS)
@pytest.mark.parametrize("kind", ["js", "json.gz"])
def test_its_grids_are_the_final_ones(both, n, kind):
    """Byte for byte: the rays are those of the whole picture's pixels."""
    name = f"{n}.{kind}"
    assert (both / "first" / name).read_bytes() == (both / "whole" / name).read_bytes()


def test_its_picture_is_the_finest_grid_and_right_at_every_grids_pixels(both):
    whole, first = (pixels_of(both / of / "picture.png") for of in ("whole", "first"))
    assert first.shape == whole.shape
    for n in GRIDS:
        pixels = level_pixels(SIZE, n)
        assert (first.reshape(-1, 3)[pixels] == whole.reshape(-1, 3)[pixels]).all()
    tile = SIZE // max(GRIDS)
    assert (first[: tile // 3, : tile // 3] == whole[tile // 2, tile // 2]).all()


@pytest.mark.parametrize("of", ["a plain scene", "one with a mesh"])
def test_a_trace_that_takes_its_grids_from_it_is_the_same_to_the_byte(of, tmp_path):
    """Pictures, and what was counted over all pixels, are made; all else was there."""
    if of == "a plain scene":
        scene = read_scene(saved(tmp_path).parent)
    else:
        bunny = read_scene(Path("scenes/07-bunny-near"))
        scene = replace(bunny, render=replace(bunny.render, size=SIZE, resolutions=GRIDS))
    folders = {name: tmp_path / name for name in ("whole", "grids", "completed")}
    for folder in folders.values():
        folder.mkdir()
    write_products(scene, folders["whole"], 1)
    write_products(scene, folders["grids"], 1, trace=trace_grids)
    ready = sorted(folders["grids"].iterdir())
    write_products(scene, folders["completed"], 2, ready=ready)
    whole, completed = (
        {path.name: path.read_bytes() for path in folders[name].iterdir()}
        for name in ("whole", "completed")
    )
    assert whole.keys() == completed.keys()
    differ = {name for name in whole if whole[name] != completed[name]}
    assert differ <= {"display.npz"}  # an archive notes when it was written


def test_the_build_that_follows_has_its_grids_and_makes_the_same_trace(tmp_path):
    """By way of the store; of a scene that was not seen first all is made."""
    scene = read_scene(saved(tmp_path).parent)
    with_a_page(tmp_path, "01-ball")
    assert first_sight(places(tmp_path), tmp_path / "sight")
    parts, found = trace_parts(scene), []
    for store in (Store(tmp_path / "work"), Store(tmp_path / "other")):
        trace_into(store, {scene.id: parts}, scene, lambda: 1, lambda *_: None)
        entry = store.get(key_of(parts))
        found.append({path.name: path.read_bytes() for path in entry.files()})
    differ = {name for name in found[0] if found[0][name] != found[1][name]}
    assert found[0].keys() == found[1].keys() and differ <= {"display.npz"}


def test_it_is_for_one_scene_that_has_a_page(tmp_path):
    """Not for what is new, nor for many that code has changed: they are waited for."""
    saved(tmp_path)
    assert not first_sight(places(tmp_path), tmp_path / "no page")
    with_a_page(tmp_path, "01-ball")
    assert first_sight(places(tmp_path), tmp_path / "one")
    shown = {path.name for path in (tmp_path / "one" / "scenes" / "01-ball").iterdir()}
    assert shown >= {"scene.js", "picture.png", *(f"{n}.js" for n in GRIDS)}
    saved(tmp_path, "2")
    with_a_page(tmp_path, "02-ball")
    assert not first_sight(places(tmp_path), tmp_path / "two")


def test_the_figures_in_its_words_are_there_but_for_those_of_the_whole_picture(tmp_path):
    """These are filled in by the build that follows."""
    file = saved(tmp_path)
    step = '[[lesson]]\ntext = "It is {t} far, {bouncing.0} bounce."\n'
    view = "view = { resolution = 15, pixel = [7, 7] }\n"
    file.write_text(file.read_text("utf-8") + step + view, encoding="utf-8")
    with_a_page(tmp_path, "01-ball")
    assert first_sight(places(tmp_path), tmp_path / "sight")
    script = (tmp_path / "sight" / "scenes" / "01-ball" / "scene.js").read_text("latin-1")
    lesson = json.loads(gzip.decompress(base64.b64decode(script.split('"')[3])))["lesson"]
    assert re.search(r"It is \d\.\d\d far, … (<a [^>]*>)?bounce(</a>)?\.", lesson[-1]["html"])


def test_pages_get_it_until_the_build_is_done_or_fails(tmp_path):
    """And every other file as it was built; the site itself is not touched."""
    page = with_a_page(tmp_path, "01-ball")
    page.with_name("15.js").write_text("old", encoding="utf-8")
    page.with_name("boxes.js").write_text("same", encoding="utf-8")
    sight = tmp_path / "sight"
    (sight / "scenes" / "01-ball").mkdir(parents=True)
    (sight / "scenes" / "01-ball" / "15.js").write_text("new", encoding="utf-8")
    live = Live()
    with server(tmp_path / "dist", 0, live, build_site.SITE_SOURCE / "serve") as service:
        threading.Thread(target=service.serve_forever, daemon=True).start()

        def got(name: str) -> bytes:
            address = f"http://127.0.0.1:{service.server_port}/scenes/01-ball/{name}"
            with urllib.request.urlopen(address) as answer:
                return answer.read()

        for end in (live.done, lambda: live.failed("a mistake")):
            live.begin()
            before = live.news.version
            live.first_sight(sight)
            assert live.news.busy and live.news.version == before + 1
            assert (got("15.js"), got("boxes.js")) == (b"new", b"same")
            assert b"reload.js" in got("index.html")
            end()
            assert got("15.js") == b"old"
        service.shutdown()
