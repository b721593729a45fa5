"""What is made of each scene, one thing after the other, all scenes beside one another: its trace;
its pictures and data for pages; of its lesson what the viewer tells and the tracer sees; slides.
"""

from __future__ import annotations

from collections.abc import Generator, Iterable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from raywalk.pipeline.homework import homework_chain
from raywalk.pipeline.parts import (
    PAGE_DATA,
    PAGE_PICTURES,
    page_data_parts,
    page_pictures_parts,
)
from raywalk.pipeline.slides import (
    Asking,
    MadeDeck,
    Plan,
    Source,
    courses,
    drawn,
    last_decks,
    planned,
)
from raywalk.pipeline.sweeps import Tally, sweeps_chain
from raywalk.pipeline.tracing import Tracing, by_cost
from raywalk.pipeline.worked import worked_chain
from raywalk.scene.model import Scene
from raywalk.scene.translation import Spoken
from raywalk.site.shown_picture import shown_picture
from raywalk.words.catalogue import DEFAULT
from raywalk.work.chains import Chain, run_chains
from raywalk.work.digests import key_of
from raywalk.work.maker import Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads, Workers
from raywalk.work.progress import Message, Report
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, note, undivided

# What there is of a scene in one language.
OfOne = TypeVar("OfOne", Source, Plan, MadeDeck)


@dataclass(frozen=True)
class SceneMade:
    """What the store holds of a scene, and what its slides were made from."""

    traced: Entry
    data: Entry
    pictures: Entry | None  # for pages; None where these do not wait for them
    worked: Entry | None  # what its lesson works out; None where it does not
    sweeps: dict[str, Entry]  # what is published of each, by its id
    homework: Entry | None  # its vectors; None where pages do not wait for them
    sources: list[Source]  # by language, as are plans and decks
    plans: list[Plan]
    decks: list[MadeDeck]


@dataclass(frozen=True)
class Making:
    """What the chains of all scenes have in common. asking: None where slides may wait, and with
    them what makes the pages' files smaller and nothing on them other."""

    store: Store
    tracing: Tracing
    asking: Asking | None
    stops: Tally = field(default_factory=Tally)


def make_scenes(
    making: Making, spoken: dict[str, list[Spoken]], workers: Workers
) -> Generator[str | Message, None, tuple[dict[str, SceneMade], list[MadeDeck]]]:
    """By the scenes' ids, and all decks: of the scenes by language, then the courses'."""
    scenes = by_cost([each.scene for each in spoken[DEFAULT]])
    found: dict[str, SceneMade] = {}
    for are_lessons in (False, True):  # lessons on other scenes are made from what these have
        chosen = [scene for scene in scenes if bool(scene.base) is are_lessons]
        chains = [scene_chain(making, each, translated(each, spoken), found) for each in chosen]
        results = yield from run_chains(chains, workers)
        found |= zip([scene.id for scene in chosen], results, strict=True)
    inner = [found[each.scene.id] for each in spoken[DEFAULT]]
    if not making.asking:
        sources = _by_language(spoken, [each.sources for each in inner])
        return found, last_decks(making.store, sources)
    decks = _by_language(spoken, [each.decks for each in inner])
    plans = _by_language(spoken, [each.plans for each in inner])
    return found, [*decks, *(yield from courses(making.store, plans, workers))]


def _by_language(languages: Iterable[str], of_scenes: list[list[OfOne]]) -> list[OfOne]:
    """What each scene has in one language or more: all in the first one, then those in the next."""
    place = {code: k for k, code in enumerate(languages)}
    every = [each for of_scene in of_scenes for each in of_scene]
    return sorted(every, key=lambda each: place[each.language])


def translated(scene: Scene, spoken: dict[str, list[Spoken]]) -> dict[str, Scene]:
    """The scene in each language that its lesson is written in, the default one first."""
    return {
        code: each.scene
        for code, all_scenes in spoken.items()
        for each in all_scenes
        if each.is_translated and each.scene.id == scene.id
    }


def scene_chain(
    making: Making, scene: Scene, spoken: dict[str, Scene], found: dict[str, SceneMade]
) -> Chain[SceneMade]:
    """found: scenes that others' lessons are about."""
    store, base = making.store, found[scene.traces] if scene.base else None
    traced = base.traced if base else (yield from making.tracing.chain(scene))
    folder, name = traced.folder, traced.folder.name
    pictures = None if base else (yield from _page_pictures(making, scene, traced))
    picture = shown_picture(pictures.folder if pictures else folder, "picture")
    worked = yield from worked_chain(store, scene, traced)
    sweeps = base.sweeps if base else (yield from sweeps_chain(store, scene, traced, making.stops))
    made_sweeps = {id: each.folder for id, each in sweeps.items()}
    data = yield from _kept(
        store, page_data_parts(scene, name, picture, worked, sweeps),
        partial(
            PAGE_DATA, scene, folder, picture=picture, worked=worked and worked.folder,
            sweeps=made_sweeps,
        ),
    )  # fmt: skip
    homework = None
    if making.asking and not base:
        homework = yield from homework_chain(store, scene)
    under = base.data if base else None
    sources = [Source(each, code, traced, data, under, sweeps) for code, each in spoken.items()]
    plans, decks = [], []
    if making.asking:
        plans = yield from planned(making.asking, sources)
        decks = yield from drawn(store, plans)
    return SceneMade(traced, data, pictures, worked, sweeps, homework, sources, plans, decks)


def _page_pictures(making: Making, scene: Scene, traced: Entry) -> Chain[Entry | None]:
    """A scene's pictures for pages."""
    store, parts = making.store, page_pictures_parts(scene.id, traced.folder.name)
    if not store.find(key_of(parts)) and making.asking:
        yield from reasons(store, parts)
        note((yield Job(scene.id, partial(_make_page_pictures, store, parts), traced.folder)))
    return store.find(key_of(parts))


def _make_page_pictures(
    store: Store, parts: Parts, traced: Path, threads: Threads, report: Report
) -> Spent:
    stages = undivided()
    made(store, parts, partial(PAGE_PICTURES, traced))
    return stages.spent("pages' pictures")


def _kept(store: Store, made_from: Parts, make: Any) -> Generator[str, None, Entry]:
    """An entry of the store, made if it is not there."""
    yield from reasons(store, made_from)
    return made(store, made_from, make)
