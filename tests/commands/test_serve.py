"""`raywalk serve` between saves: pages at once, slides when their author pauses, nothing waits for
them."""

from __future__ import annotations

import re
import time
from argparse import Namespace
from pathlib import Path

import pytest

from raywalk.commands import build_site, serve
from raywalk.commands.slides_beside import Ended, SlidesBeside
from raywalk.errors import SourceError, SourceErrors
from raywalk.site.live import Live

PATIENCE = 600.0  # seconds: the machine may be busy, and kernels may have to be compiled
SCENE = """
version = 1
key = "1"
title = "Ball"
teaches = "A ball."
camera = { eye = [0, 0, 5], target = [0, 0, 0] }
render = { size = 21, resolutions = [7], depth = 1 }
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 0.9
material = "coloured"
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "Words."
view = { resolution = 7, pixel = [3, 3] }
"""


class Stop(Exception):
    """The story is at its end."""


class Told:
    """In place of watching files, of builds and of slides beside: what happens, and its story."""

    def __init__(self, monkeypatch, saves, meanwhile=(), trouble=None, ended=()):
        """saves: at each glance; meanwhile: the builds (by number) in which something is saved."""
        self.story, self.saves, self.meanwhile = [], list(saves), set(meanwhile)
        self.builds, self.trouble, self.ended, self.are_there = 0, trouble, list(ended), False
        monkeypatch.setattr(serve, "Saves", lambda folders: self)
        monkeypatch.setattr(serve, "SlidesBeside", lambda: self)
        monkeypatch.setattr(serve, "PAUSE", -1.0)
        monkeypatch.setattr(serve.Sights, "show", lambda *_: self.story.append("grids"))
        monkeypatch.setattr(build_site, "run", self.run)

    def wait(self, seconds):
        if not self.saves:
            raise Stop
        self.are_there = False
        return self.saves.pop(0)

    def run(self, chosen):
        assert chosen.slides_later
        self.builds += 1
        number = self.builds
        self.story.append(f"build {number}")
        if self.trouble:
            raise SourceErrors([SourceError(Path("scene.toml"), "", self.trouble)])
        try:
            self.are_there = number in self.meanwhile
            yield "tracing"
            yield "written"
        except GeneratorExit:
            self.story.append(f"given up {number}")
            raise

    def start(self, chosen):
        assert not chosen.slides_later
        self.story.append("slides")

    def tell_to_stop(self):
        self.story.append("end")

    def stop(self):
        self.story.append("stop")

    def messages(self):
        return iter([self.ended.pop(0)] if self.ended else [])


def followed(tmp_path) -> Live:
    """The whole story."""
    chosen, live = Namespace(scenes=tmp_path, slides_later=False), Live()
    with pytest.raises(Stop):
        list(serve._follow(chosen, live, tmp_path))
    return live


def test_a_save_stops_slides_before_anything_else(monkeypatch, tmp_path):
    """They are begun anew in the next pause, and once a pause."""
    told = Told(monkeypatch, [[], [], ["scene.toml"], [], []])
    followed(tmp_path)
    pages = ["build 1", "slides", "end", "grids", "stop", "build 2", "slides"]
    assert told.story == [*pages, "stop"]


def test_a_build_of_pages_is_given_up_when_something_is_saved_meanwhile(monkeypatch, tmp_path):
    """The next one has it; slides wait until all is shown."""
    told = Told(monkeypatch, [["a"], ["b"], []], meanwhile=[2])
    live = followed(tmp_path)
    anew = ["end", "grids", "stop"]
    shown = ["build 1", *anew, "build 2", "given up 2", *anew, "build 3"]
    assert told.story == [*shown, "slides", "stop"]
    assert live.news.version == 2  # of three builds one showed nothing


def test_there_are_no_slides_of_a_mistake(monkeypatch, tmp_path):
    """Pages say what is wrong."""
    told = Told(monkeypatch, [[], []], trouble="no such thing")
    live = followed(tmp_path)
    assert told.story == ["build 1", "stop"]
    assert "no such thing" in live.news.trouble


@pytest.mark.parametrize("trouble", ["", "too heavy"])
def test_pages_hear_what_came_of_slides(trouble, monkeypatch, tmp_path):
    """They are not loaded anew for them."""
    Told(monkeypatch, [[], []], ended=[Ended(trouble)])
    live = followed(tmp_path)
    assert (live.news.version, live.news.busy, live.news.trouble) == (1, False, trouble)


def chosen_in(folder: Path) -> Namespace:
    """As `raywalk serve` has it, for a folder with one scene."""
    place = folder / "scenes" / "01-ball" / "scene.toml"
    place.parent.mkdir(parents=True)
    place.write_text(SCENE, encoding="utf-8")
    return Namespace(
        scenes=folder / "scenes", out=folder / "dist", work=folder / "work", sizes=False,
        budgets=build_site.BUDGETS, explain=False, scheduler=None, times=None, stats=False, url="",
        slides_later=False, without=frozenset(build_site.PARTS),
    )  # fmt: skip


def first_of(slides: SlidesBeside, wanted: type) -> object:
    """The first message of a kind."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        for message in slides.messages():
            if isinstance(message, wanted):
                return message
        time.sleep(0.02)
    raise AssertionError("never said anything")


def test_slides_are_made_beside_and_a_build_that_is_stopped_can_be_begun_anew(
    tmp_path, with_viewer
):
    """Stopped in the middle of it, nothing of it goes on; the next one makes all."""
    slides, chosen = SlidesBeside(), chosen_in(tmp_path)
    with_viewer(chosen.work)
    slides.start(chosen)
    first_of(slides, object)
    process = slides._process
    slides.stop()
    assert process.poll() is not None
    assert not list(slides.messages())
    slides.start(chosen)
    assert first_of(slides, Ended) == Ended()
    assert (tmp_path / "dist" / "slides" / "01-ball.pptx").is_file()
    assert not list(tmp_path.glob("*.partial"))


def test_a_mistake_is_heard_of_too(tmp_path):
    """As a build says it."""
    slides, chosen = SlidesBeside(), chosen_in(tmp_path)
    file = chosen.scenes / "01-ball" / "scene.toml"
    file.write_text(SCENE.replace('"coloured"', '"colored"'), encoding="utf-8")
    slides.start(chosen)
    assert 'no material is named "colored"' in first_of(slides, Ended).trouble


def test_pages_that_wait_for_nothing_show_the_png_until_its_smaller_copy_is_there(
    tmp_path, with_viewer
):
    """Which takes a fifth of a second a picture, and changes nothing on the page."""
    chosen = chosen_in(tmp_path)
    with_viewer(chosen.work)
    file, shown = chosen.scenes / "01-ball" / "scene.toml", []
    for later in (True, False, True):
        words = SCENE.replace("size = 21", "size = 63").replace("Words", f"Words {len(shown)}")
        file.write_text(words, encoding="utf-8")
        list(build_site.run(Namespace(**vars(chosen) | {"slides_later": later})))
        page = (chosen.out / "scenes" / "01-ball" / "index.html").read_text(encoding="utf-8")
        shown += [max(re.findall(r"01-ball/(picture\.\w+)", page))]  # the PNG to save is there, too
    assert shown == ["picture.png", "picture.webp", "picture.webp"]
