"""A small scene with its trace, its sights and its deck, made once for all tests here."""

from __future__ import annotations

import atexit
from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar, cast

import pytest

from raywalk.commands.slides import traced
from raywalk.pipeline.slides import plans_of, sources_of
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene
from raywalk.slides.deck import Sources, scene_deck
from raywalk.slides.figure import Deck
from raywalk.slides.layout import LAYOUTS
from raywalk.slides.step_slide import Lesson
from raywalk.stops.process import Stops
from raywalk.work.store import Store

Result = TypeVar("Result")
STOPS = Stops()  # one node process for all of these tests: to start it takes longer than to ask
atexit.register(STOPS.__exit__, None, None, None)

BALLS = """
version = 1
key = "4"
title = "Two balls"
teaches = "A mirror sends the ray on."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
size = 63
resolutions = [7, 21]
depth = 4
[[objects]]
name = "mirror"
type = "sphere"
center = [-0.6, 0, 0]
radius = 0.7
material = "mirror"
[[objects]]
name = "red ball"
type = "sphere"
center = [0.8, -0.5, 0.6]
radius = 0.5
material = { like = "coloured", diffuse = [1, 0, 0] }
[[objects]]
name = "floor"
type = "plane"
point = [0, -1, 0]
normal = [0, 1, 0]
material = "white"
[[lights]]
position = [1, 2, 3]
[[lights]]
position = [-2, 2, 1]
"""
LESSON = """
[[lesson]]
text = "**All rays** at once. Each one asks for a colour."
view = { resolution = 7, pixel = [3, 3], rays = ["all"], tiles = "empty" }
[[lesson]]
text = "The mirror sends the ray on. It brings back what *it* meets."
view = { resolution = 7, pixel = [2, 4], tiles = "filled" }
[[lesson]]
text = "From the side, with a finer grid: now a row of rays."
view = { resolution = 21, pixel = [9, 12], rays = ["pixel", "row"], tiles = "filled", \
observer = { eye = [6, 2, 2], target = [0, 0, 0] } }
[[lesson]]
text = "**Predict.** Is the floor lit here?"
view = { resolution = 7, pixel = [3, 6], tiles = "empty" }
answer = "**Yes.** Both lights reach it."
answer_view = { tiles = "filled" }
"""


@dataclass(frozen=True)
class Made:
    """A scene, and a store of what is made of it."""

    scene: Scene
    store: Store

    def sources(self, aspect: str = "16:9") -> Sources:
        """As `raywalk slides` has them."""
        source = last(traced(self.store, self.scene))
        [plan] = last(plans_of(self.store, STOPS, [source], LAYOUTS[aspect]))
        return sources_of(plan)

    def lesson(self, aspect: str = "16:9") -> Lesson:
        return self.sources(aspect).lesson(LAYOUTS[aspect])

    def deck(self, aspect: str = "16:9") -> Deck:
        return scene_deck(self.sources(aspect), LAYOUTS[aspect])


def last(steps: Generator[str, None, Result]) -> Result:
    """What work that tells how it goes returns at its end."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return cast(Result, end.value)


def make(folder: Path, text: str) -> Made:
    """A scene file's text as a scene; it is traced when it is needed."""
    place = folder / "scenes" / "04-balls"
    place.mkdir(parents=True, exist_ok=True)
    (place / "scene.toml").write_text(text, encoding="utf-8")
    return Made(read_scene(place), Store(folder / "work"))


@pytest.fixture(scope="session")
def balls(tmp_path_factory: pytest.TempPathFactory) -> Made:
    """Two balls on a floor, a lesson of four steps."""
    return make(tmp_path_factory.mktemp("balls"), BALLS + LESSON)


@pytest.fixture(scope="session")
def deck(balls: Made) -> Deck:
    return balls.deck()


@pytest.fixture
def made(tmp_path: Path):
    """A function that traces the two balls with another lesson."""

    def with_lesson(lesson: str, scene: str = BALLS) -> Made:
        return make(tmp_path, scene + lesson)

    return with_lesson
