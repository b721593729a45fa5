"""What the pages of mistakes show, kept under what it is made from: how clearly each shows in each
scene, which decides where it is shown; pictures and rays there; and these told in each language.

Pages do not wait for it: they get what is in the store.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Generator, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raywalk.errors import SourceError
from raywalk.mistake_pages.best import Shown, best_scenes
from raywalk.mistake_pages.rounds import Round, rounds_of
from raywalk.mistakes.table import BY_NAME
from raywalk.pipeline.parts import silent
from raywalk.pipeline.slides import ASK, Asking, sentences
from raywalk.pipeline.tracing import by_cost
from raywalk.scene.model import Scene
from raywalk.scene.translation import Spoken
from raywalk.scene.wording import did_you_mean, quoted
from raywalk.site.mistake_words import ALL
from raywalk.site.mistakes import RIGHT, Told, of_page
from raywalk.site.scene_data import scene_words
from raywalk.words import read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.work.chains import Chain, run_chains
from raywalk.work.digests import key_of
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads, Workers
from raywalk.work.progress import Message, Report
from raywalk.work.snapshot import bytes_of
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, note, undivided

if TYPE_CHECKING:
    from raywalk.pipeline.scenes import Making, SceneMade

CLARITY = Maker("raywalk.mistake_pages.clarity", "write_clarity")
WRITE = Maker("raywalk.mistake_pages.write", "write_mistakes")
PICTURES, TOLD = "mistakes.json", "told.json"


@dataclass(frozen=True)
class Mistakes:
    """All that pages are made from."""

    shown: dict[str, Shown]  # by mistake; those that show nowhere are not in it
    left_out: tuple[str, ...]  # ids of scenes that the second tracer does not know all of
    pictures: dict[str, Entry]  # by scene
    told: dict[str, dict[str, Entry]]  # by language and scene
    others: tuple[Entry, ...]  # what decided
    rounds: tuple[Round, ...]  # of questions: which mistake is this?

    def entries(self) -> Iterator[Entry]:
        """All that are used."""
        yield from self.others
        yield from self.pictures.values()
        for of_scene in self.told.values():
            yield from of_scene.values()


def misnamed(scenes: Iterable[Scene]) -> list[SourceError]:
    """What scenes say they are good at showing, and is no mistake that we know."""
    return [
        SourceError(
            scene.path, f"mistakes[{k}]", f"there is no mistake {quoted(name)}",
            hint=did_you_mean(name, BY_NAME),
        )
        for scene in scenes
        for k, name in enumerate(scene.mistakes)
        if name not in BY_NAME
    ]  # fmt: skip


def unseen(scenes: Iterable[Scene], made: Mistakes) -> Iterator[str]:
    """A line for each mistake that a scene names and does not show."""
    for scene in scenes:
        for name in scene.mistakes:
            if name not in made.shown or scene.id not in made.shown[name].all:
                yield f"{scene.id}: warning: mistakes: {quoted(name)} hardly shows in this scene"


class _Missing(Exception):
    """Something is not in the store, and shall not be waited for."""


def make_mistakes(
    making: Making, spoken: dict[str, list[Spoken]], found: dict[str, SceneMade], workers: Workers
) -> Generator[str | Message, None, Mistakes | None]:
    """None where pages shall not wait, unless all is there."""
    scenes = [each.scene for each in spoken[DEFAULT] if not each.scene.base]
    try:
        return (yield from _made(making.store, making.asking, scenes, spoken, found, workers))
    except _Missing:
        return None


def _made(
    store: Store, asking: Asking | None, scenes: list[Scene], spoken: dict[str, list[Spoken]],
    found: dict[str, SceneMade], workers: Workers,
) -> Generator[str | Message, None, Mistakes]:  # fmt: skip
    may_make, ordered = asking is not None, by_cost(scenes)
    chains = [_kept(store, each, CLARITY, {"what": "clarity"}, may_make) for each in ordered]
    clear = dict(
        zip([e.id for e in ordered], (yield from run_chains(chains, workers)), strict=True)
    )
    said = {scene.id: _read(clear[scene.id].folder / "clarity.json") for scene in scenes}
    shown = best_scenes(said, {scene.id: scene.mistakes for scene in scenes})
    own = {s.id: [name for name, each in shown.items() if each.best == s.id] for s in ordered}
    ordered = [scene for scene in ordered if own[scene.id]]
    chains = []
    for each in ordered:
        names = own[each.id]
        what = {"what": "mistakes", "names": names}
        chains.append(_kept(store, each, WRITE, what, may_make, names))
    drawn = yield from run_chains(chains, workers)
    pictures = dict(zip([scene.id for scene in ordered], drawn, strict=True))
    told: dict[str, dict[str, Entry]] = {code: {} for code in spoken}
    for code, all_scenes in spoken.items():
        of = {each.scene.id: each.scene for each in all_scenes}
        for id, drawing in pictures.items():
            told[code][id] = yield from _told(store, asking, of[id], code, found[id].data, drawing)
    without = tuple(id for id, each in said.items() if each["left_out"])
    rounds = rounds_of(shown, said)
    return Mistakes(shown, without, pictures, told, tuple(clear.values()), rounds)


def _kept(
    store: Store, scene: Scene, maker: Maker, own: Parts, may_make: bool, *given: Any
) -> Chain[Entry]:
    """The entry of what a maker makes of a scene. Raises _Missing."""
    parts = {**own, "of": scene.id, "scene": silent(scene), **maker.parts()}
    if not store.find(key_of(parts)):
        if not may_make:
            raise _Missing
        yield from reasons(store, parts)
        note((yield Job(scene.id, partial(_make, store, parts, maker, given), scene)))
    return store.get(key_of(parts))


def _make(
    store: Store, parts: Parts, maker: Maker, given: tuple[Any, ...], scene: Scene,
    threads: Threads, report: Report,
) -> Spent:  # fmt: skip
    stages = undivided()
    made(store, parts, partial(maker, scene, *given))
    return stages.spent("pages of mistakes")


def _told(
    store: Store, asking: Asking | None, scene: Scene, code: str, data: Entry, pictures: Entry
) -> Generator[str, None, Entry]:
    """What the viewer tells of a scene's right and wrong rays in a language. Raises _Missing."""
    spoken = None if code == DEFAULT else scene_words(scene)
    parts = {
        "what": "mistakes told", "of": f"{code}/{scene.id}", "page data": data.folder.name,
        "pictures": pictures.folder.name, "spoken": spoken, "read": sentences(code),
        **ASK.parts(),
    }  # fmt: skip
    if entry := store.find(key_of(parts)):
        return entry
    if not asking:
        raise _Missing
    yield from reasons(store, parts)
    drawn = _read(pictures.folder / PICTURES)
    sides = [(name, side) for name in drawn for side in ("right", "wrong")]
    answer = json.loads(asking.stops.ask({
        "do": "beside", "scene": str(data.folder / "scene.js"), "spoken": spoken,
        "words": read_words(code).tree, "programs": [drawn[name][side] for name, side in sides],
    }))  # fmt: skip
    events: dict[str, dict[str, Any]] = {name: {} for name in drawn}
    for (name, side), told in zip(sides, answer, strict=True):
        events[name][side] = told
    text = json.dumps(events, ensure_ascii=False)
    return made(store, parts, lambda folder: (folder / TOLD).write_text(text, encoding="utf-8"))


def told_in(made: Mistakes, code: str) -> Told:
    """What a language's pages say besides their words."""
    drawn = {id: _read(entry.folder / PICTURES) for id, entry in made.pictures.items()}
    events = {id: _read(entry.folder / TOLD) for id, entry in made.told[code].items()}
    return Told(made.shown, made.left_out, drawn, events, made.rounds)


def publish_mistakes(out: Path, site_source: Path, made: Mistakes) -> None:
    """The pictures of all mistakes, which are the same in every language, their style sheets and
    the script of the page that asks."""
    for id, entry in made.pictures.items():
        for path in entry.files():
            if path.suffix != ".webp":
                continue
            name, _, which = path.stem.partition("--")
            to = out / ALL / (f"{RIGHT}-{id}.webp" if name == RIGHT else of_page(name, which))
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, to)
    files = ["mistakes.css", *(("which.css", "which.js") if made.rounds else ())]
    (out / ALL).mkdir(exist_ok=True)
    for name in files:
        (out / ALL / name).write_bytes(bytes_of(site_source / ALL / name))


def _read(file: Path) -> Any:
    return json.loads(file.read_text(encoding="utf-8"))
