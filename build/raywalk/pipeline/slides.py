"""Which slides must be made again, and their making: from traces to decks in the store."""

from __future__ import annotations

import json
import shutil
import time
from collections.abc import Generator, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from raywalk.pipeline.parts import plain, shut_for
from raywalk.scene.credits import named_models
from raywalk.scene.lesson_pictures import pictures_of
from raywalk.scene.model import Scene
from raywalk.site.scene_data import scene_words
from raywalk.slides.formats import ASKED, COURSE, KEPT, LESSON, REMARKS, SIGHTS
from raywalk.slides.layout import WIDE, Layout
from raywalk.stops.process import Stops
from raywalk.words import read_words
from raywalk.words.catalogue import DEFAULT, FOLDER
from raywalk.work.digests import digest, key_of
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Finished, Threads, cores, run_all
from raywalk.work.progress import Report
from raywalk.work.snapshot import digest_of
from raywalk.work.store import Entry, Store
from raywalk.work.times import phase

if TYPE_CHECKING:
    from raywalk.slides.deck import Sources

# Asks the viewer's modules; its own code is little, the scripts that it runs are much.
ASK = Maker("raywalk.stops.process", "Stops")
# Where the tracer is asked: a lesson's words are not in it, so a change of words traces nothing.
SEE = Maker("raywalk.pipeline.sight_products", "write_sights")
WRITE = Maker("raywalk.pipeline.slide_products", "write_scene_slides")
WRITE_COURSE = Maker("raywalk.pipeline.slide_products", "write_course_slides")
PUBLISHED = WIDE


@dataclass(frozen=True)
class Source:
    """One scene in one language, and the entries that its slides are made from."""

    scene: Scene  # in that language
    language: str
    traced: Entry
    page_data: Entry  # scene.js, in the default language


@dataclass(frozen=True)
class Plan:
    """What one scene's slides in one language are made from, and under which keys they are kept."""

    scene: Scene
    language: str
    traced: Path  # the folder of the scene's trace
    sights: Entry  # the same in every language
    lesson: Entry
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


def plans_of(
    store: Store, stops: Stops, sources: list[Source], layout: Layout = PUBLISHED
) -> Generator[str, None, list[Plan]]:
    """Has the viewer's modules tell every lesson, and the tracer what they ask of it, where that is
    not in the store. Only what they say is in the slides' keys: other code that says the same makes
    no slide anew."""
    code = ASK.parts()
    asked: dict[str, Entry] = {}
    with phase("ask the viewer what slides show"):
        for each in sources:
            asked[each.scene.id] = yield from _asked(store, stops, each, layout, code)
    with phase("trace what slides show"):
        sights = yield from _sights(store, sources, asked)
    plans = []
    for each in sources:
        of = sights[each.scene.id]
        lesson = yield from _lesson(store, stops, each, layout, asked[each.scene.id], of, code)
        plans.append(Plan(each.scene, each.language, each.traced.folder, of, lesson, {
            "what": "slides", "of": _of(each.scene.id, each.language), "layout": layout.name,
            "trace": each.traced.folder.name, "sights": of.folder.name,
            "lesson": digest(lesson.folder / LESSON), "scene": plain(each.scene),
            "pictures": {file.name: digest(file) for file in pictures_of(each.scene)},
            "credits": [model.model_dump() for model in named_models(each.scene)],
            **WRITE.parts(languages={DEFAULT, each.language}),
        }))  # fmt: skip
    return plans


def _asked(
    store: Store, stops: Stops, of: Source, layout: Layout, code: Parts
) -> Generator[str, None, Entry]:
    """What the tracer is asked for."""
    parts = {
        "what": "asked", "of": of.scene.id, "layout": layout.name,
        "page data": of.page_data.folder.name, **code,
    }  # fmt: skip
    return (yield from _kept(store, stops, parts, ASKED, {"do": "ask", **_where(of, layout)}))


def _sights(
    store: Store, sources: list[Source], asked: dict[str, Entry]
) -> Generator[str, None, dict[str, Entry]]:
    """What it answers, by scene."""
    tasks = {}
    for each in sources:
        tasks[each.scene.id] = (each.scene, asked[each.scene.id], {
            "what": "sights", "of": each.scene.id, "trace": each.traced.folder.name,
            "asked": digest(asked[each.scene.id].folder / ASKED),
            **SEE.parts(shut_for(each.scene)),
        })  # fmt: skip
    missing = [task for task in tasks.values() if not store.find(key_of(task[2]))]
    size = {each.scene.id: _traces_size(each.traced.folder) for each in sources}
    missing.sort(key=lambda task: -size[task[0].id])  # as for slides
    for _, _, parts in missing:
        yield from reasons(store, parts)
    if missing:
        yield f"what is seen in the slides of {len(missing)} of {len(tasks)} scenes"
    for _ in run_all(partial(_make_sights, store), missing, lambda task: task[0].id):
        pass
    return {id: store.get(key_of(parts)) for id, (_, _, parts) in tasks.items()}


def _lesson(
    store: Store, stops: Stops, of: Source, layout: Layout, asked: Entry, sights: Entry, code: Parts
) -> Generator[str, None, Entry]:
    """The lesson in a language."""
    spoken = None if of.language == DEFAULT else scene_words(of.scene)
    parts = {
        "what": "lesson", "of": _of(of.scene.id, of.language), "layout": layout.name,
        "page data": of.page_data.folder.name, "sights": sights.folder.name, "spoken": spoken,
        **code, "read": sentences(of.language),
    }  # fmt: skip
    request = {
        "do": "lesson", **_where(of, layout), "asked": str(asked.folder / ASKED),
        "sights": str(sights.folder / SIGHTS), "spoken": spoken,
        "words": read_words(of.language).tree,
    }  # fmt: skip
    return (yield from _kept(store, stops, parts, LESSON, request))


def _where(of: Source, layout: Layout) -> Parts:
    return {
        "scene": str(of.page_data.folder / "scene.js"), "traces": str(of.traced.folder),
        "size": {"width": layout.figure.width, "height": layout.figure.height},
    }  # fmt: skip


def _kept(
    store: Store, stops: Stops, parts: Parts, name: str, request: Parts
) -> Generator[str, None, Entry]:
    """The entry of an answer, asked for if it is not there."""

    def write(folder: Path) -> None:
        (folder / name).write_text(stops.ask(request), encoding="utf-8")

    yield from reasons(store, parts)
    return made(store, parts, write)


def _make_sights(
    store: Store, task: tuple[Scene, Entry, Parts], threads: Threads, report: Report
) -> None:
    scene, asked, parts = task
    wanted = json.loads((asked.folder / ASKED).read_text(encoding="utf-8"))
    made(store, parts, partial(SEE, scene, wanted))


def _of(id: str, language: str) -> str:
    """What slides are of, by the site's address scheme."""
    return id if language == DEFAULT else f"{language}/{id}"


def sentences(language: str) -> dict[str, str]:
    """Hashes of the catalogues of sentences that are spoken: what one lacks is the default's."""
    files = [FOLDER / f"{code}.json" for code in sorted({DEFAULT, language})]
    return {file.name: digest_of(file) for file in files}


def course_parts(plans: list[Plan]) -> Parts:
    """The course is made from all scenes' slides in its language."""
    language = plans[0].language
    return {
        "what": "slides", "of": _of(COURSE, language), "decks": [each.key for each in plans],
        **WRITE_COURSE.parts(languages={DEFAULT, language}),
    }  # fmt: skip


def make_decks(store: Store, sources: list[Source]) -> Generator[str, None, list[MadeDeck]]:
    """Every scene's slides and the course's in each language, on all cores; tells those that were
    not there. Raises SourceErrors where node is missing."""
    with phase("tell lessons for slides"), Stops() as stops:
        plans = yield from plans_of(store, stops, sources)
    for each in plans:
        yield from reasons(store, each.slides)
    missing = _by_scene(each for each in plans if not store.find(each.key))
    if missing:
        scenes = len({each.scene.id for each in plans})
        yield f"slides of {len(missing)} of {scenes} scenes on {cores()} cores"
    with phase("draw slides"):
        yield from _drawn(store, missing)
    courses = _by_language(plans)
    lost = [of for of in courses if not store.find(key_of(course_parts(of)))]
    for of in lost:
        yield from reasons(store, course_parts(of))
    with phase("draw the course's slides"):
        for _ in run_all(partial(_make_course, store), lost, lambda of: of[0].language):
            pass
    return [
        *(MadeDeck(each.scene.id, each.language, store.get(each.key)) for each in plans),
        *(
            MadeDeck(COURSE, of[0].language, store.get(key_of(course_parts(of))))
            for of in courses
        ),
    ]  # fmt: skip


def _drawn(store: Store, missing: list[tuple[Plan, ...]]) -> Iterator[str]:
    """Makes the scenes' slides, on all cores."""
    number = 0
    for message in run_all(partial(_make, store), missing, lambda each: each[0].scene.id):
        if isinstance(message, Finished):
            number += 1
            yield f"[{number}/{len(missing)}] {message.task[0].scene.id}: {message.result:.1f} s"


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


def last_decks(store: Store, sources: list[Source]) -> list[MadeDeck]:
    """The decks as they were last made, for pages that shall not wait for new ones."""
    wanted = [(each.scene.id, each.language) for each in sources]
    wanted += [(COURSE, code) for code in dict.fromkeys(each.language for each in sources)]
    found, newest = [], store.newest_of("slides")
    for id, language in wanted:
        made_from = newest.get(_of(id, language))
        entry = store.find(key_of(made_from)) if made_from else None
        found += [MadeDeck(id, language, entry)] if entry else []
    return found


def _make_course(store: Store, plans: list[Plan], threads: Threads, report: Report) -> None:
    kept = [store.get(each.key).folder / KEPT for each in plans]
    sources = [sources_of(each) for each in plans]
    parts, language = course_parts(plans), plans[0].language
    made(store, parts, lambda folder: WRITE_COURSE(sources, kept, PUBLISHED, folder, language))


def slide_remarks(decks: list[MadeDeck]) -> list[str]:
    """What could not be written, and why."""
    remarks = []
    for deck in decks:
        place = deck.entry.folder / REMARKS
        if place.is_file():
            lost = place.read_text(encoding="utf-8")
            remarks.append(f"{_of(deck.id, deck.language)}: not all PDFs were made: {lost}")
    return remarks


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


def _make(store: Store, task: tuple[Plan, ...], threads: Threads, report: Report) -> float:
    """One scene's slides in some languages; returns the seconds it took."""
    begun = time.monotonic()
    for each in task:
        made(
            store, each.slides, partial(WRITE, sources_of(each), PUBLISHED, language=each.language)
        )
    return time.monotonic() - begun


def sources_of(of: Plan) -> Sources:
    """Where its slides come from."""
    from raywalk.slides.deck import Sources

    return Sources(of.scene, of.traced, of.sights.folder, of.lesson.folder / LESSON)
