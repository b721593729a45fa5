"""Which slides must be made again, and their making: from traces to decks in the store."""

from __future__ import annotations

import shutil
import time
from collections.abc import Generator, Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.scene.model import Scene
from raywalk.slides.layout import LAYOUTS, WIDE, Layout
from raywalk.words.catalogue import DEFAULT
from raywalk.work.digests import digest, key_of
from raywalk.work.keys import Parts, makers, plain
from raywalk.work.pool import Finished, Threads, cores, run_all
from raywalk.work.progress import Report
from raywalk.work.store import Entry, Store

WORDS = Path(__file__).resolve().parents[2] / "site_src" / "words"
# Where the tracer is asked: a lesson's words are not in it, so a change of words traces nothing.
SIGHT_STAGES = (
    "trace/observer_view.py", "sight_products.py", "trace_file",
    *(f"slides/{name}.py" for name in (
        "costs", "frustum", "layout", "lines", "observer", "placing", "sights", "views", "what_if",
    )),
)  # fmt: skip
SIGHT_PACKAGES = ("numpy", "pillow")
STAGES = (
    "slides",
    "slide_products.py",
    "lesson_text.py",
    "scene",
    "words",
    "telling",
    "trace_file",
)
PACKAGES = ("numpy", "pillow", "markdown", "reportlab", "python-pptx", "python-bidi", "lxml")
PUBLISHED = WIDE
COURSE = "course"  # the id of the deck of all scenes
KEPT = "slides.pickle"  # a lesson's slides as plain data, for the course; not published
REMARKS = "remarks.txt"  # what could not be written, and why; not published


@dataclass(frozen=True)
class Plan:
    """What one scene's slides in one language are made from, and under which keys they are kept."""

    scene: Scene  # in that language
    language: str
    traced: Path  # the folder of the scene's trace
    sights: Parts  # the same in every language
    slides: Parts

    @property
    def key(self) -> str:
        return key_of(self.slides)


@dataclass(frozen=True)
class MadeDeck:
    """A deck's files in the store."""

    id: str  # the scene's, or the course's
    language: str
    entry: Entry


def plan(
    scene: Scene, traced: Path, trace_key: str, layout: Layout = PUBLISHED,
    spoken: Scene | None = None, language: str = DEFAULT,
) -> Plan:  # fmt: skip
    """trace_key: under which the store has the scene's trace; spoken: the scene in the language."""
    sights: Parts = {
        "what": "sights", "of": scene.id, "trace": trace_key, "aspect": layout.name,
        "views": [[view for _, view in step.stops()] for step in scene.lesson],
        **makers(SIGHT_STAGES, SIGHT_PACKAGES),
    }  # fmt: skip
    told = spoken or scene
    slides: Parts = {
        "what": "slides", "of": _of(scene.id, language), "sights": key_of(sights),
        "scene": plain(told), "sentences": sentences(language), **makers(STAGES, PACKAGES),
    }  # fmt: skip
    return Plan(told, language, traced, sights, slides)


def _of(id: str, language: str) -> str:
    """What slides are of, by the site's address scheme."""
    return id if language == DEFAULT else f"{language}/{id}"


def sentences(language: str) -> dict[str, str]:
    """Hashes of the catalogues of sentences that are spoken: what one lacks is the default's."""
    return {code: digest(WORDS / f"{code}.json") for code in sorted({DEFAULT, language})}


def course_parts(plans: list[Plan]) -> Parts:
    """The course is made from all scenes' slides in its language."""
    of = _of(COURSE, plans[0].language)
    return {"what": "slides", "of": of, "decks": [each.key for each in plans]}


def make_decks(store: Store, plans: list[Plan]) -> Generator[str, None, list[MadeDeck]]:
    """Every scene's slides and the course's in each language, on all cores; tells those that were
    not there."""
    missing = _by_scene(each for each in plans if not store.find(each.key))
    if missing:
        scenes = len({each.scene.id for each in plans})
        yield f"slides of {len(missing)} of {scenes} scenes on {cores()} cores"
    number = 0
    for told in run_all(partial(_make, store), missing, lambda each: each[0].scene.id):
        if isinstance(told, Finished):
            number += 1
            yield f"[{number}/{len(missing)}] {told.task[0].scene.id}: {told.result:.1f} s"
    courses = _by_language(plans)
    lost = [of for of in courses if not store.find(key_of(course_parts(of)))]
    for _ in run_all(partial(_make_course, store), lost, lambda of: of[0].language):
        pass
    return [
        *(MadeDeck(each.scene.id, each.language, store.get(each.key)) for each in plans),
        *(
            MadeDeck(COURSE, of[0].language, store.get(key_of(course_parts(of))))
            for of in courses
        ),
    ]  # fmt: skip


def _by_scene(plans: Iterable[Plan]) -> list[tuple[Plan, ...]]:
    """A scene's languages share its pictures, so one process makes them. Long work comes first,
    or a core waits at the end: a scene's traces tell how much there is to draw and to trace."""
    tasks: dict[str, list[Plan]] = {}
    for each in plans:
        tasks.setdefault(each.scene.id, []).append(each)
    return sorted(map(tuple, tasks.values()), key=lambda task: -_traces_size(task[0].traced))


def _traces_size(traced: Path) -> int:
    return sum(path.stat().st_size for path in traced.glob("*.json.gz"))


def _by_language(plans: list[Plan]) -> list[list[Plan]]:
    courses: dict[str, list[Plan]] = {}
    for each in plans:
        courses.setdefault(each.language, []).append(each)
    return list(courses.values())


def last_decks(store: Store, plans: list[Plan]) -> list[MadeDeck]:
    """The decks as they were last made, for pages that shall not wait for new ones."""
    wanted = [(each.scene.id, each.language) for each in plans]
    wanted += [(COURSE, of[0].language) for of in _by_language(plans)]
    found = []
    for id, language in wanted:
        made_from = store.newest("slides", _of(id, language))
        entry = store.find(key_of(made_from)) if made_from else None
        found += [MadeDeck(id, language, entry)] if entry else []
    return found


def _make_course(store: Store, plans: list[Plan], threads: Threads, report: Report) -> None:
    from raywalk.slide_products import write_course_slides

    kept = [store.get(each.key).folder / KEPT for each in plans]
    sources = [_sources(store, each) for each in plans]
    parts, language = course_parts(plans), plans[0].language
    store.entry(
        key_of(parts),
        lambda folder: write_course_slides(sources, kept, PUBLISHED, folder, language),
        parts,
    )


def slide_remarks(decks: list[MadeDeck]) -> list[str]:
    """What could not be written, and why."""
    told = []
    for deck in decks:
        place = deck.entry.folder / REMARKS
        if place.is_file():
            lost = place.read_text(encoding="utf-8")
            told.append(f"{_of(deck.id, deck.language)}: not all PDFs were made: {lost}")
    return told


def publish_slides(out: Path, decks: list[MadeDeck]) -> dict[str, dict[str, dict[str, int]]]:
    """Copies all decks into the site, below slides/ or <language>/slides/; by language and id the
    paths from the site's root and the sizes (bytes) of a deck's files."""
    published: dict[str, dict[str, dict[str, int]]] = {}
    for deck in decks:
        folder = out / _of("slides", deck.language)
        folder.mkdir(parents=True, exist_ok=True)
        files = [path for path in deck.entry.files() if path.name not in (KEPT, REMARKS)]
        for path in files:
            shutil.copyfile(path, folder / path.name)
        where = folder.relative_to(out).as_posix()
        sizes = {f"{where}/{path.name}": path.stat().st_size for path in files}
        published.setdefault(deck.language, {})[deck.id] = sizes
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


def _make(store: Store, task: tuple[Plan, ...], threads: Threads, report: Report) -> float:
    """One scene's slides in some languages; returns the seconds it took."""
    # Only here: a build with nothing to make never pays for numba, ReportLab and python-pptx.
    from raywalk.slide_products import write_scene_slides

    begun = time.monotonic()
    for made in task:
        make_sights(store, made)
        sources = _sources(store, made)
        language = made.language
        store.entry(
            made.key,
            partial(write_scene_slides, sources, PUBLISHED, language=language),
            made.slides,
        )
    return time.monotonic() - begun


def _sources(store: Store, made: Plan) -> Any:
    from raywalk.slides.deck import Sources

    return Sources(made.scene, made.traced, store.get(key_of(made.sights)).folder)
