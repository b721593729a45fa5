"""Which slides must be made again, and their making: from traces to decks in the store."""

from __future__ import annotations

import json
import shutil
from collections.abc import Generator, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from raywalk.pipeline.parts import plain, shut_for, silent
from raywalk.pipeline.worked import FILE as WORKED
from raywalk.pipeline.worked import read_worked, worked_chain
from raywalk.scene.credits import named_models
from raywalk.scene.lesson_pictures import pictures_of
from raywalk.scene.model import Scene
from raywalk.site.scene_data import scene_words
from raywalk.slides.formats import ASKED, COURSE, KEPT, LESSON, REMARKS, SIGHTS
from raywalk.slides.layout import WIDE, Layout
from raywalk.stops.process import Stops
from raywalk.words import read_words
from raywalk.words.catalogue import DEFAULT, FOLDER
from raywalk.work.chains import Chain, run_chains
from raywalk.work.digests import digest, key_of
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads, Workers
from raywalk.work.progress import Message, Report
from raywalk.work.snapshot import digest_of
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, Stages, note, undivided

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
    base_data: Entry | None = None  # of a lesson on another scene: that scene's
    sweeps: Mapping[str, Entry] = field(default_factory=dict)  # of each what is published


@dataclass(frozen=True)
class Plan:
    """What one scene's slides in one language are made from, and under which keys they are kept."""

    scene: Scene
    language: str
    traced: Path  # the folder of the scene's trace
    sights: Entry  # the same in every language
    lesson: Entry
    worked: Path | None  # the folder of what the lesson works out; None where it does not
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


@dataclass(frozen=True)
class Asking:
    """Whom slides ask, for which paper, and where the answers are kept."""

    store: Store
    stops: Stops
    layout: Layout
    code: Parts  # what answers


def asking(store: Store, stops: Stops, layout: Layout = PUBLISHED) -> Asking:
    """Reads all that slides are made with, too: processes that start afterwards have it."""
    for maker in (SEE, WRITE, WRITE_COURSE):
        maker.parts()
    return Asking(store, stops, layout, ASK.parts())


def plans_of(
    store: Store, stops: Stops, sources: list[Source], layout: Layout = PUBLISHED
) -> Generator[str | Message, None, list[Plan]]:
    """Of several scenes, whose slides are not drawn yet."""
    scenes: dict[str, list[Source]] = {}
    for each in sources:
        scenes.setdefault(each.scene.id, []).append(each)
    of = asking(store, stops, layout)
    with Workers() as workers:
        chains = [planned(of, scene) for scene in scenes.values()]
        plans = yield from run_chains(chains, workers)
    return [plan for of_scene in plans for plan in of_scene]


def planned(of: Asking, sources: list[Source]) -> Chain[list[Plan]]:
    """Has the viewer's modules tell a scene's lesson in all its languages, and the tracer what they
    ask of it, where that is not in the store. Only what they say is in the slides' keys: other code
    that says the same makes no slide anew."""
    asked = yield from _asked(of, sources[0])
    sights = yield from _seen(of.store, sources[0], asked)
    worked = yield from worked_chain(of.store, sources[0].scene, sources[0].traced)
    own = {"worked": digest(worked.folder / WORKED)} if worked else {}
    plans = []
    for each in sources:
        lesson = yield from _lesson(of, each, asked, sights, worked)
        folder = worked.folder if worked else None
        plans.append(Plan(each.scene, each.language, each.traced.folder, sights, lesson, folder, {
            "what": "slides", "of": _of(each.scene.id, each.language), "layout": of.layout.name,
            "trace": each.traced.folder.name, "sights": sights.folder.name,
            "lesson": digest(lesson.folder / LESSON), "scene": plain(each.scene), **own,
            "pictures": {file.name: digest(file) for file in pictures_of(each.scene)},
            "credits": [model.model_dump() for model in named_models(each.scene)],
            **WRITE.parts(languages={DEFAULT, each.language}),
        }))  # fmt: skip
    return plans


def _asked(of: Asking, source: Source) -> Generator[str, None, Entry]:
    """What the tracer is asked for."""
    parts = {
        "what": "asked", "of": source.scene.id, "layout": of.layout.name,
        **_data_of(source), **of.code,
    }  # fmt: skip
    return (yield from _kept(of, parts, ASKED, {"do": "ask", **_where(source, of.layout)}))


def _seen(store: Store, source: Source, asked: Entry) -> Chain[Entry]:
    """What it answers: the same in every language."""
    scene = source.scene
    parts = {
        "what": "sights", "of": scene.id, "trace": source.traced.folder.name,
        "asked": digest(asked.folder / ASKED), **_swept(scene), **SEE.parts(shut_for(scene)),
    }  # fmt: skip
    yield from reasons(store, parts)
    if not store.find(key_of(parts)):
        note((yield Job(scene.id, partial(_make_sights, store), (scene, asked, parts))))
    return store.get(key_of(parts))


def _swept(scene: Scene) -> Parts:
    """The scene at the stops of sweeps that its lesson shows; nothing where it shows none."""
    views = [view for step in scene.lesson for _, view in step.stops()]
    named = sorted({view["sweep"] for view in views if "sweep" in view})
    return {"stops": {stop: silent(scene.at_stop(stop)) for stop in named}} if named else {}


def _lesson(
    of: Asking, source: Source, asked: Entry, sights: Entry, worked: Entry | None
) -> Generator[str, None, Entry]:
    """The lesson in a language."""
    drawn = {"worked": digest(worked.folder / WORKED)} if worked else {}
    spoken = None if source.language == DEFAULT else scene_words(source.scene)
    parts = {
        "what": "lesson", "of": _of(source.scene.id, source.language), "layout": of.layout.name,
        **_data_of(source), "sights": sights.folder.name, "spoken": spoken,
        **of.code, "read": sentences(source.language), **drawn,
    }  # fmt: skip
    request = {
        "do": "lesson", **_where(source, of.layout), "asked": str(asked.folder / ASKED),
        "sights": str(sights.folder / SIGHTS), "spoken": spoken,
        "words": read_words(source.language).tree,
        **({"worked": str(worked.folder / WORKED)} if worked else {}),
    }  # fmt: skip
    return (yield from _kept(of, parts, LESSON, request))


def _data_of(source: Source) -> Parts:
    """The keys of what the viewer's modules know of a scene."""
    parts = {"page data": source.page_data.folder.name}
    return parts | ({"base": source.base_data.folder.name} if source.base_data else {})


def _where(of: Source, layout: Layout) -> Parts:
    base: Parts = {"base": str(of.base_data.folder / "scene.js")} if of.base_data else {}
    if of.sweeps:
        base["sweeps"] = {id: str(each.folder) for id, each in of.sweeps.items()}
    return base | {
        "scene": str(of.page_data.folder / "scene.js"), "traces": str(of.traced.folder),
        "size": {"width": layout.figure.width, "height": layout.figure.height},
    }  # fmt: skip


def _kept(of: Asking, parts: Parts, name: str, request: Parts) -> Generator[str, None, Entry]:
    """The entry of an answer, asked for if it is not there."""

    def write(folder: Path) -> None:
        (folder / name).write_text(of.stops.ask(request), encoding="utf-8")

    yield from reasons(of.store, parts)
    return made(of.store, parts, write)


def _make_sights(
    store: Store, task: tuple[Scene, Entry, Parts], threads: Threads, report: Report
) -> Spent:
    from raywalk.optics.compiling import seconds_spent

    scene, asked, parts = task
    wanted, stages = _read(asked.folder / ASKED), Stages("compiling kernels", seconds_spent)
    made(store, parts, partial(SEE, scene, wanted, threads=threads))
    return stages.spent("what slides show")


def _read(file: Path) -> Parts:
    answer: Parts = json.loads(file.read_text(encoding="utf-8"))
    return answer


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


def drawn(store: Store, plans: list[Plan]) -> Chain[list[MadeDeck]]:
    """A scene's slides; its languages share its pictures, so one process makes them."""
    for each in plans:
        yield from reasons(store, each.slides)
    if missing := [each for each in plans if not store.find(each.key)]:
        scene = missing[0].scene
        spent = yield Job(scene.id, partial(_make, store), missing)
        note(spent)
        yield f"slides of {scene.id}: {spent.seconds:.1f} s"
    return [MadeDeck(each.scene.id, each.language, store.get(each.key)) for each in plans]


def courses(
    store: Store, plans: list[Plan], workers: Workers
) -> Generator[str | Message, None, list[MadeDeck]]:
    """The course's slides in each language."""
    return (yield from run_chains([_course(store, of) for of in _by_language(plans)], workers))


def _course(store: Store, plans: list[Plan]) -> Chain[MadeDeck]:
    parts, language = course_parts(plans), plans[0].language
    yield from reasons(store, parts)
    if not store.find(key_of(parts)):
        note((yield Job(COURSE, partial(_make_course, store), plans)))
    return MadeDeck(COURSE, language, store.get(key_of(parts)))


def _by_language(plans: list[Plan]) -> list[list[Plan]]:
    languages: dict[str, list[Plan]] = {}
    for each in plans:
        languages.setdefault(each.language, []).append(each)
    return list(languages.values())


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


def _make_course(store: Store, plans: list[Plan], threads: Threads, report: Report) -> Spent:
    stages = undivided()
    kept = [store.get(each.key).folder / KEPT for each in plans]
    sources = [sources_of(each) for each in plans]
    parts, language = course_parts(plans), plans[0].language
    made(store, parts, lambda folder: WRITE_COURSE(sources, kept, PUBLISHED, folder, language))
    return stages.spent("course's slides")


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


def _make(store: Store, plans: list[Plan], threads: Threads, report: Report) -> Spent:
    """One scene's slides in some languages."""
    stages = undivided()
    for each in plans:
        made(
            store, each.slides, partial(WRITE, sources_of(each), PUBLISHED, language=each.language)
        )
    return stages.spent("slides")


def sources_of(of: Plan) -> Sources:
    """Where its slides come from."""
    from raywalk.slides.deck import Sources

    worked = read_worked(of.worked) if of.worked else {}
    return Sources(of.scene, of.traced, of.sights.folder, of.lesson.folder / LESSON, worked)
