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
from raywalk.pipeline.parts import (
    PAGE_DATA,
    PREVIEW,
    page_data_parts,
    preview_parts,
    trace_parts,
    viewer_parts,
)
from raywalk.pipeline.publishing import Made, publish
from raywalk.pipeline.slides import MadeDeck, Source, last_decks, make_decks, slide_remarks
from raywalk.pipeline.tracing import trace_all
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scenes
from raywalk.scene.translation import Spoken, missing_translations, read_spoken
from raywalk.site.assets import BundleError, bundle_viewer
from raywalk.site.figures import left_out
from raywalk.site.savings import as_table
from raywalk.site.sitemap import base_of
from raywalk.words import languages, read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.work.digests import key_of
from raywalk.work.maker import Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import cores
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
        spoken = in_all_languages(scenes)
    store = Store(chosen.work, chosen.explain)
    made_from = viewer_parts(site_source)
    yield from reasons(store, made_from)
    with phase("trace"), ThreadPoolExecutor(1) as beside:
        # Esbuild needs one core for a moment, and tracing leaves one towards its end.
        bundled = beside.submit(made, store, made_from, partial(bundle, site_source))
        traces, missing = yield from _traces(store, scenes, chosen)
    facts = {scene.id: facts_of(traces[scene.id]) for scene in scenes}
    if chosen.stats:
        words = read_words()
        yield from (as_table(id, counted, words) for id, counted in facts.items())
        yield words.say("savings.note")
    notes = [line for scene in scenes for line in remarks(scene, facts[scene.id])]
    for code, translated in spoken.items():
        notes += missing_translations(translated, code)
    yield from notes
    viewer = bundled.result()
    with phase("data and previews of pages"):
        previews, data = yield from _pages(store, scenes, traces)
    decks = yield from _decks(store, spoken, traces, data, chosen)
    yield from slide_remarks(decks)
    notes += slide_remarks(decks)
    works = Made(spoken, facts, viewer, traces, data, previews, decks)
    with phase("publish"):
        heavy = publish(works, chosen, site_source, base)
    heavy = [f"warning: {line}" for line in heavy]
    yield from heavy
    notes += heavy
    if not chosen.slides_later:  # nor is tidying up anything that pages should wait for
        with phase("tidy up kept work"):
            store.prune(keep={entry.folder.name for entry in works.entries()})
    size = sum(path.stat().st_size for path in chosen.out.rglob("*") if path.is_file())
    return Built(
        f"{len(scenes)} scenes: {missing} traced, {len(scenes) - missing} unchanged",
        [path for scene in scenes for obj in scene.objects for path in obj.files],
        {"scenes": len(scenes), "size": size, "remarks": notes},
    )


def in_all_languages(scenes: list[Scene]) -> dict[str, list[Spoken]]:
    """The scenes by language, the default one first. Raises SourceErrors."""
    own = {DEFAULT: [Spoken(scene, True) for scene in scenes]}
    return own | {code: read_spoken(scenes, code) for code in languages() if code != DEFAULT}


def _traces(
    store: Store, scenes: list[Scene], chosen: Namespace
) -> Generator[str | Message, None, tuple[dict[str, Entry], int]]:
    """Each scene's trace, and how many were not there."""
    parts = {scene.id: trace_parts(scene) for scene in scenes}
    keys = {id: key_of(made_from) for id, made_from in parts.items()}
    missing = [scene for scene in scenes if not store.find(keys[scene.id])]
    for scene in missing:
        yield from reasons(store, parts[scene.id])
    if missing:
        where = f"the cluster {chosen.scheduler}" if chosen.scheduler else f"{cores()} cores"
        yield f"tracing {len(missing)} of {len(scenes)} scenes on {where}"
        yield from trace_all(missing, store, parts, chosen.scheduler)
    return {id: store.get(key) for id, key in keys.items()}, len(missing)


def _pages(
    store: Store, scenes: list[Scene], traces: dict[str, Entry]
) -> Generator[str, None, tuple[dict[str, Entry], dict[str, Entry]]]:
    """Each scene's preview picture, and its data for the viewer."""
    previews, data = {}, {}
    for scene in scenes:
        traced = traces[scene.id].folder
        parts, make = preview_parts(scene.id, traced.name), partial(PREVIEW, traced / "picture.png")
        previews[scene.id] = yield from kept(store, parts, make)
        parts, make = page_data_parts(scene, traced.name), partial(PAGE_DATA, scene, traced)
        data[scene.id] = yield from kept(store, parts, make)
    return previews, data


def _decks(
    store: Store, spoken: dict[str, list[Spoken]], traces: dict[str, Entry],
    data: dict[str, Entry], chosen: Namespace,
) -> Generator[str, None, list[MadeDeck]]:  # fmt: skip
    """The slides of each lesson in each language that it is written in; in a hurry, those that
    were made last."""
    sources = [
        Source(each.scene, code, traces[each.scene.id], data[each.scene.id])
        for code, translated in spoken.items()
        for each in translated
        if each.is_translated
    ]
    if chosen.slides_later:
        return last_decks(store, sources)
    return (yield from make_decks(store, sources))


def kept(store: Store, made_from: Parts, make: Any) -> Generator[str, None, Entry]:
    """An entry of the store, made if it is not there."""
    yield from reasons(store, made_from)
    return made(store, made_from, make)


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
