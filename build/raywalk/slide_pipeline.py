"""Which slides must be made again, and their making: from traces to decks in the store."""

from __future__ import annotations

import shutil
import time
from collections.abc import Generator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.progress import Tell
from raywalk.scene.model import Scene
from raywalk.slides.layout import LAYOUTS, WIDE, Layout
from raywalk.work.digests import digest, key_of
from raywalk.work.keys import Parts, makers, plain
from raywalk.work.pool import Finished, Threads, cores, run_all
from raywalk.work.store import Entry, Store

WORDS = Path(__file__).resolve().parents[2] / "site_src" / "words"
# Where the tracer is asked: a lesson's words are not in it, so a change of words traces nothing.
SIGHT_STAGES = (
    "onlook.py", "sight_products.py", "trace_file",
    *(f"slides/{name}.py" for name in (
        "costs", "frustum", "layout", "lines", "observer", "placing", "sights", "views", "what_if",
    )),
)  # fmt: skip
SIGHT_PACKAGES = ("numpy", "pillow")
STAGES = ("slides", "slide_products.py", "lesson_text.py", "scene", "words", "trace_file")
PACKAGES = ("numpy", "pillow", "markdown", "reportlab", "python-pptx", "python-bidi", "lxml")
PUBLISHED = WIDE
KEPT = "slides.pickle"  # a lesson's slides as plain data, for the course; not published
REMARKS = "remarks.txt"  # what could not be written, and why; not published


@dataclass(frozen=True)
class Plan:
    """What one scene's slides are made from, and under which keys they are kept."""

    scene: Scene
    traced: Path  # the folder of the scene's trace
    sights: Parts
    slides: Parts

    @property
    def key(self) -> str:
        return key_of(self.slides)


def plan(scene: Scene, traced: Path, trace_key: str, layout: Layout = PUBLISHED) -> Plan:
    """trace_key: under which the store has the scene's trace."""
    sights: Parts = {
        "what": "sights", "of": scene.id, "trace": trace_key, "aspect": layout.name,
        "views": [[view for _, view in step.stops()] for step in scene.lesson],
        **makers(SIGHT_STAGES, SIGHT_PACKAGES),
    }  # fmt: skip
    slides: Parts = {
        "what": "slides", "of": scene.id, "sights": key_of(sights), "scene": plain(scene),
        "sentences": sentences(), **makers(STAGES, PACKAGES),
    }  # fmt: skip
    return Plan(scene, traced, sights, slides)


def sentences() -> dict[str, str]:
    """Hashes of the catalogues of sentences."""
    return {path.name: digest(path) for path in sorted(WORDS.glob("*.json"))}


def course_parts(plans: list[Plan]) -> Parts:
    """The course is made from all scenes' slides."""
    return {"what": "slides", "of": "course", "decks": [each.key for each in plans]}


def make_decks(store: Store, plans: list[Plan]) -> Generator[str, None, list[Entry]]:
    """Every scene's slides and the course's, on all cores; tells those that were not there."""
    missing = [each for each in plans if not store.find(each.key)]
    if missing:
        yield f"slides of {len(missing)} of {len(plans)} scenes on {cores()} cores"
    number = 0
    for told in run_all(partial(_make, store), missing, lambda each: each.scene.id):
        if isinstance(told, Finished):
            number += 1
            yield f"[{number}/{len(missing)}] {told.task.scene.id}: {told.result:.1f} s"
    decks = [store.get(each.key) for each in plans]
    if not plans:
        return decks
    parts = course_parts(plans)
    course = store.find(key_of(parts))
    return [*decks, course or _make_course(store, plans, parts)]


def last_decks(store: Store, plans: list[Plan]) -> list[Entry]:
    """The decks as they were last made, for pages that shall not wait for new ones."""
    made = [store.newest("slides", of) for of in [*(each.scene.id for each in plans), "course"]]
    found = [store.find(key_of(made_from)) for made_from in made if made_from]
    return [deck for deck in found if deck]


def _make_course(store: Store, plans: list[Plan], parts: Parts) -> Entry:
    from raywalk.slide_products import write_course_slides

    kept = [store.get(each.key).folder / KEPT for each in plans]
    sources = [_sources(store, each) for each in plans]
    return store.entry(
        key_of(parts), lambda folder: write_course_slides(sources, kept, PUBLISHED, folder), parts
    )


def slide_remarks(decks: list[Entry]) -> list[str]:
    """What could not be written, and why."""
    told = []
    for deck in decks:
        place = deck.folder / REMARKS
        if place.is_file():
            of = next(path.stem for path in deck.files() if path.suffix == ".html")
            lost = place.read_text(encoding="utf-8")
            told.append(f"{of}: no PDF of the slides: their font has no {lost}")
    return told


def publish_slides(folder: Path, decks: list[Entry]) -> dict[str, list[str]]:
    """Copies all decks into the site; the names of a deck's files, by its id."""
    published: dict[str, list[str]] = {}
    folder.mkdir(parents=True)
    for deck in decks:
        files = [path for path in deck.files() if path.name not in (KEPT, REMARKS)]
        for path in files:
            shutil.copyfile(path, folder / path.name)
        of = next(path.stem for path in files if path.suffix == ".html")
        published[of] = [path.name for path in files]
    return published


def make_sights(store: Store, made: Plan) -> Entry:
    """What the tracer tells of a lesson's views."""
    if found := store.find(key_of(made.sights)):
        return found  # a change of words alone never pays for what traces
    from raywalk.sight_products import write_sights

    layout = LAYOUTS[made.sights["aspect"]]
    return store.entry(
        key_of(made.sights),
        lambda folder: write_sights(made.scene, made.traced, layout, folder),
        made.sights,
    )


def _make(store: Store, made: Plan, threads: Threads, tell: Tell) -> float:
    """One scene's slides; returns the seconds it took."""
    # Only here: a build with nothing to make never pays for numba, ReportLab and python-pptx.
    from raywalk.slide_products import write_scene_slides

    begun = time.monotonic()
    make_sights(store, made)
    sources = _sources(store, made)
    store.entry(
        made.key, lambda folder: write_scene_slides(sources, PUBLISHED, folder), made.slides
    )
    return time.monotonic() - begun


def _sources(store: Store, made: Plan) -> Any:
    from raywalk.slides.deck import Sources

    return Sources(made.scene, made.traced, store.get(key_of(made.sights)).folder)
