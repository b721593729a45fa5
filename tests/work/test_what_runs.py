"""What a piece of work really imports and opens while it is made is in its key: asked of Python."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from PIL import Image

from raywalk.commands.slides import traced
from raywalk.pipeline import parts as keys
from raywalk.pipeline import slides as slide_pipeline
from raywalk.scene.read import read_scene
from raywalk.slides.formats import ASKED, KEPT
from raywalk.stops.process import Stops
from raywalk.work.maker import OURS
from raywalk.work.scripts import npm_package
from raywalk.work.store import Store

ROOT = OURS.root
SCENE = """
version = 1
key = "1"
title = "Two things"
teaches = "What is opened."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
size = 63
resolutions = [7, 21]
depth = 2
[[objects]]
name = "ball"
type = "sphere"
center = [-1, 0, 0]
radius = 0.8
material = {ball}
{mesh}
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "One **ray**."
view = {{ resolution = 7, pixel = [2, 3] }}
"""
MESH = '[[objects]]\nname = "bunny"\ntype = "mesh"\nmodel = "bunny"\nmaterial = "white"'
# A textured mirror: surroundings are traced and textures read.
BALL = '{ reflect = 0.6, texture = { file = "four.png" } }'
WATCHED = """
import json, pickle, sys
from importlib import import_module
opened = set()
sys.addaudithook(lambda event, given: event == "open" and opened.add(str(given[0])))
maker, given = sys.argv[1].split(":"), sys.argv[2]
call = getattr(import_module(maker[0]), maker[1])
with open(given, "rb") as file:
    call(*pickle.load(file))
print(json.dumps({"modules": sorted(sys.modules), "opened": sorted(opened)}))
"""


@pytest.fixture(scope="module")
def work_on(tmp_path_factory):
    """`work` of the two kinds of scene, each made once."""
    return cache(lambda mesh: work(tmp_path_factory.mktemp("runs"), mesh))


def work(folder, mesh):
    """Each piece of work on a scene: its maker, what it is given (the folder to fill is "new"),
    and what its key is made of."""
    (folder / "models").symlink_to(ROOT / "models")
    place = folder / "scenes" / "01-things"
    place.mkdir(parents=True)
    text = SCENE.format(mesh=mesh, ball=BALL)
    Image.new("RGB", (2, 2), (9, 90, 200)).save(place / "four.png")
    (place / "scene.toml").write_text(text, encoding="utf-8")
    scene, store, new = read_scene(place), Store(folder / "work"), folder / "new"
    with Stops() as stops:
        source = last(traced(store, scene))
        [plan] = last(slide_pipeline.plans_of(store, stops, [source]))
    slide_pipeline._make(store, (plan,), lambda: 1, lambda *_: None)
    [asked] = store.folder.glob(f"*/{ASKED}")
    trace, wanted = source.traced.folder, json.loads(asked.read_text(encoding="utf-8"))
    sources = slide_pipeline.sources_of(plan)
    wide, decks = slide_pipeline.PUBLISHED, [store.get(plan.key).folder / KEPT]
    language = {"languages": {"en"}}
    makers = {
        "trace": (keys.TRACE, (scene, new, 1), {"shut": keys.shut_for(scene)}),
        "page data": (keys.PAGE_DATA, (scene, trace, new), {}),
        "page pictures": (keys.PAGE_PICTURES, (trace, new), {}),
        "sights": (slide_pipeline.SEE, (scene, wanted, new), {"shut": keys.shut_for(scene)}),
        "slides": (slide_pipeline.WRITE, (sources, wide, new, "en"), language),
        "course": (slide_pipeline.WRITE_COURSE, ([sources], decks, wide, new, "en"), language),
    }
    return folder, {
        piece: (maker, given, maker.parts(**options))
        for piece, (maker, given, options) in makers.items()
    }


def last(steps):
    """What work that tells how it goes returns at its end."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


#: What a scene without a mesh shuts modules out of; all else has one key for all scenes, and the
#: richest scene imports most.
SHUTS = ["trace", "sights"]
ALL = [*SHUTS, "page data", "page pictures", "slides", "course"]


@pytest.mark.parametrize(
    ("mesh", "piece"),
    [*((MESH, piece) for piece in ALL), *(("", piece) for piece in SHUTS)],
    ids=[*ALL, *(f"{piece} without a mesh" for piece in SHUTS)],
)
def test_what_a_piece_of_work_imports_and_opens_is_in_its_key(work_on, mesh, piece):
    """Imports inside functions, fonts, tables and sentences too; models have keys of their own."""
    folder, makers = work_on(mesh)
    maker, given, made_from = makers[piece]
    (folder / f"{piece}.new").mkdir()
    given = [folder / f"{piece}.new" if each == folder / "new" else each for each in given]
    (folder / "given").write_bytes(pickle.dumps(given))
    command = [sys.executable, "-c", WATCHED, f"{maker.module}:{maker.function}", folder / "given"]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=True)
    seen = json.loads(done.stdout)
    for module in seen["modules"]:
        if module.split(".")[0] == "raywalk":
            place = "/".join([*module.split(".")[1:], "__init__.py"])
            assert {place, place.replace("/__init__", "")} & {*made_from["code"]}, module
    behind = {*made_from["code"], *made_from["read"]}
    for path in map(Path, seen["opened"]):
        if not path.is_relative_to(ROOT) or path.suffix == ".py" or "__pycache__" in path.parts:
            continue
        if npm := npm_package(path):
            assert f"npm {npm}" in made_from["packages"], path
        elif ".venv" not in path.parts and not path.is_relative_to(ROOT / "models"):
            assert OURS.name(path) in behind, path
