"""Scene files in, site out. The pipeline's table of contents."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Generator, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.errors import SourceError, SourceErrors
from raywalk.pipeline.checking import make_checks
from raywalk.pipeline.figures import filled_lessons
from raywalk.pipeline.mistakes import make_mistakes, misnamed, unseen
from raywalk.pipeline.parts import trace_parts, viewer_parts
from raywalk.pipeline.publishing import Made, publish
from raywalk.pipeline.scenes import Making, make_scenes
from raywalk.pipeline.slides import asking, slide_remarks
from raywalk.pipeline.tracing import Tracing
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scenes
from raywalk.scene.translation import Spoken, missing_translations, read_spoken
from raywalk.scene.wording import counted
from raywalk.site.assets import BundleError, bundle_viewer
from raywalk.site.figures import left_out
from raywalk.site.savings import as_table
from raywalk.site.sitemap import base_of
from raywalk.stops.process import Stops
from raywalk.words import languages, read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.work.making import made, reasons
from raywalk.work.pool import Workers
from raywalk.work.progress import Message
from raywalk.work.store import Entry, Store
from raywalk.work.times import phase


@dataclass(frozen=True)
class Built:
    """What the command line and the record of this build need to know."""

    traced: str  # how many scenes were traced, in words
    also_read: list[Path]  # files outside of the usual places: meshes
    said: dict[str, Any]  # what the next build says again if nothing changed


def build(chosen: Namespace, site_source: Path) -> Generator[str | Message, None, Built]:
    """Builds the site, saying what was traced, kept and written."""
    base = base_of(chosen.url)
    with phase("read scenes"):
        scenes = read_scenes(chosen.scenes)
        if wrong := misnamed(scenes):
            raise SourceErrors(wrong)
        spoken = in_all_languages(scenes)
    store = Store(chosen.work, chosen.explain)
    made_from = viewer_parts(site_source)
    yield from reasons(store, made_from)
    own = [scene for scene in scenes if not scene.base]
    tracing = Tracing(own, store, {scene.id: trace_parts(scene) for scene in own})
    with phase("make what changed"), ThreadPoolExecutor(1) as beside, Stops() as stops:
        # Esbuild needs one core for a moment, and the first traces compile or load kernels.
        bundled = beside.submit(made, store, made_from, partial(bundle, site_source))
        yield from tracing.begin(chosen.scheduler)
        making = Making(store, tracing, None if chosen.slides_later else asking(store, stops))
        with Workers() as workers:
            # First: what is wrong with a slot is said before minutes of tracing.
            spoken = yield from filled_lessons(store, spoken, workers)
            of_scenes, decks = yield from make_scenes(making, spoken, workers)
            mistakes, check = None, {}
            if "mistakes" not in chosen.without:
                mistakes = yield from make_mistakes(making, spoken, of_scenes, workers)
            if "check" not in chosen.without:
                check = yield from make_checks(making, own, of_scenes, workers)
        viewer = bundled.result()
    traces = {scene.id: of_scenes[scene.id].traced for scene in scenes}
    facts = {id: facts_of(traced) for id, traced in traces.items()}
    if chosen.stats:
        words = read_words()
        yield from (as_table(scene.id, facts[scene.id], words) for scene in own)
        yield words.say("savings.note")
    notes = [line for scene in own for line in remarks(scene, facts[scene.id])]
    for code, translated in spoken.items():
        notes += missing_translations(translated, code)
    notes += slide_remarks(decks)
    notes += unseen(own, mistakes) if mistakes else []
    yield from notes
    data = {scene.id: of_scenes[scene.id].data for scene in scenes}
    pictures = {id: each.pictures for id, each in of_scenes.items() if each.pictures}
    worked = {id: each.worked for id, each in of_scenes.items() if each.worked}
    sweeps = {id: each.sweeps for id, each in of_scenes.items()}
    homework = {id: each.homework for id, each in of_scenes.items() if each.homework}
    works = Made(
        spoken, facts, viewer, traces, data, pictures, worked, sweeps, homework, check, mistakes,
        decks,
    )  # fmt: skip
    with phase("publish"):
        heavy = publish(works, chosen, site_source, base)
    heavy = [f"warning: {line}" for line in heavy]
    yield from heavy
    notes += heavy
    if not chosen.slides_later:  # nor is tidying up anything that pages should wait for
        with phase("tidy up kept work"):
            store.prune(keep={entry.folder.name for entry in works.entries()})
    count, missing = len(own), len(tracing.missing)
    scenes_told = f"{counted(count, 'scene')}: {missing} traced, {count - missing} unchanged"
    size = sum(path.stat().st_size for path in chosen.out.rglob("*") if path.is_file())
    return Built(
        "; ".join(filter(None, [scenes_told, making.stops.told()])),
        [path for scene in scenes for obj in scene.objects for path in obj.files],
        {"scenes": count, "size": size, "remarks": notes},
    )


def in_all_languages(scenes: list[Scene]) -> dict[str, list[Spoken]]:
    """The scenes by language, the default one first. Raises SourceErrors."""
    own = {DEFAULT: [Spoken(scene, True) for scene in scenes]}
    return own | {code: read_spoken(scenes, code) for code in languages() if code != DEFAULT}


def bundle(site_source: Path, folder: Path) -> None:
    """The viewer's script, into a folder. Raises SourceErrors."""
    try:
        bundle_viewer(site_source, folder)
    except BundleError as problem:
        raise SourceErrors([SourceError(site_source, "", str(problem))]) from None


def remarks(scene: Scene, facts: dict[str, Any]) -> Iterator[str]:
    """What an author should know though nothing is wrong."""
    for name, because in left_out(facts["dropped"]):
        yield f'{scene.id}: left out of "{name}": triangles {because}'
    for warning in facts["warnings"]:
        yield f"{scene.id}: warning: {warning}"


def facts_of(entry: Entry) -> dict[str, Any]:
    """What the trace stage counted."""
    facts: dict[str, Any] = json.loads((entry.folder / "facts.json").read_text(encoding="utf-8"))
    return facts
