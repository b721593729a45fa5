"""Scene files in, site out. The pipeline's table of contents."""

from __future__ import annotations

import json
import shutil
from argparse import Namespace
from collections.abc import Generator, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scenes
from raywalk.scene.shapes import Mesh
from raywalk.scene.translation import Spoken, missing_translations, read_spoken
from raywalk.site import sizes
from raywalk.site.assets import BundleError, bundle_viewer, write_assets, write_words
from raywalk.site.figures import has_glass, left_out, scene_figures
from raywalk.site.licences import write_licences
from raywalk.site.offline import write_icons, write_manifest, write_worker
from raywalk.site.pages import face_of, write_pages, write_sizes
from raywalk.site.reports import publish_reports
from raywalk.site.savings import as_table, savings_lines
from raywalk.site.scene_data import scene_words
from raywalk.site.sitemap import base_of, write_sitemap
from raywalk.slide_pipeline import Source, last_decks, make_decks, publish_slides, slide_remarks
from raywalk.trace_file.script import write_script
from raywalk.words import languages, read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.work.cluster import run_on_cluster
from raywalk.work.digests import key_of
from raywalk.work.explain import why
from raywalk.work.keys import (
    PAGE_DATA,
    PREVIEW,
    Parts,
    page_data_parts,
    preview_parts,
    trace_parts,
    viewer_parts,
)
from raywalk.work.making import made
from raywalk.work.pool import Finished, cores, run_all
from raywalk.work.progress import Begin, End, Message, Progress
from raywalk.work.publish import staged
from raywalk.work.store import Entry, Store, damage_of
from raywalk.work.tracing import trace_into

# Of an entry, what stays behind: the pages are made from these.
NOT_PUBLISHED = ("facts.json", "display.npz")


@dataclass(frozen=True)
class Built:
    """What the command line and the record of this build need to know."""

    traced: str  # how many scenes were traced, in words
    also_read: list[Path]  # files outside of the usual places: meshes
    said: dict[str, Any]  # what the next build tells again if nothing changed


def build(chosen: Namespace, site_source: Path) -> Generator[str | Message, None, Built]:
    """Builds the site, telling what was traced, kept and written."""
    base = base_of(chosen.url)
    scenes = read_scenes(chosen.scenes)
    spoken = in_all_languages(scenes)
    store = Store(chosen.work)
    parts = {scene.id: trace_parts(scene) for scene in scenes}
    keys = {id: key_of(made_from) for id, made_from in parts.items()}
    missing = [scene for scene in scenes if not store.find(keys[scene.id])]
    if chosen.explain:
        for scene in missing:
            yield f"{scene.id} is traced: {reason(store, parts[scene.id])}"
    if missing:
        where = f"the cluster {chosen.scheduler}" if chosen.scheduler else f"{cores()} cores"
        yield f"tracing {len(missing)} of {len(scenes)} scenes on {where}"
        yield from trace_all(missing, store, parts, chosen.scheduler)
    entries = {scene.id: store.get(keys[scene.id]) for scene in scenes}
    facts = {scene.id: facts_of(entries[scene.id]) for scene in scenes}
    words = read_words()
    if chosen.stats:
        yield from (as_table(id, counted, words) for id, counted in facts.items())
        yield words.say("savings.note")
    notes = [line for scene in scenes for line in remarks(scene, facts[scene.id])]
    for code, told in spoken.items():
        notes += missing_translations(told, code)
    yield from notes
    viewer = yield from kept(store, viewer_parts(site_source), partial(bundle, site_source), chosen)
    data, previews = {}, {}
    for scene in scenes:
        picture = entries[scene.id].folder / "picture.png"
        previews[scene.id] = yield from kept(
            store, preview_parts(scene.id, keys[scene.id]), partial(PREVIEW, picture), chosen
        )
        data[scene.id] = yield from kept(
            store, page_data_parts(scene, keys[scene.id]),
            partial(PAGE_DATA, scene, entries[scene.id].folder), chosen,
        )  # fmt: skip
    sources = [
        Source(each.scene, code, entries[each.scene.id], data[each.scene.id])
        for code, told in spoken.items()
        for each in told
        if each.is_translated
    ]
    in_a_hurry = chosen.slides_later
    decks = last_decks(store, sources) if in_a_hurry else (yield from make_decks(store, sources))
    notes += slide_remarks(decks)
    yield from slide_remarks(decks)
    budgets = sizes.read_budgets(chosen.budgets)
    with staged(chosen.out) as out:
        assets = write_assets(out, site_source, viewer.folder)
        for scene in scenes:
            made = [entries[scene.id], data[scene.id], previews[scene.id]]
            publish_scene(out / "scenes" / scene.id, made)
        if scenes:
            assets |= write_icons(out, out / "scenes" / face_of(scenes).id / "picture.png")
        published = publish_slides(out, decks)
        publish_reports(out, site_source / "templates", assets, scenes, chosen.work)
        for code, told in spoken.items():
            said = [each.scene for each in told]
            downloads = published.get(DEFAULT, {}) | published.get(code, {})
            write_edition(out, site_source, said, facts, assets, downloads, code, base)
        weights = sizes.measured(out, scenes, facts)
        sizes.check(chosen.out, weights, budgets)
        sizes.keep(out, weights)
        write_sizes(out, site_source / "templates", weights, budgets, assets)
        write_licences(out, scenes, viewer.folder, bool(decks))
        write_sitemap(out, base)
        write_worker(out, site_source)
    slides = [deck.entry for deck in decks]
    used = [*entries.values(), *data.values(), *previews.values(), *slides, viewer]
    store.prune(keep={entry.folder.name for entry in used})
    size = sum(path.stat().st_size for path in chosen.out.rglob("*") if path.is_file())
    return Built(
        f"{len(scenes)} scenes: {len(missing)} traced, {len(scenes) - len(missing)} unchanged",
        [
            obj.shape.path
            for scene in scenes
            for obj in scene.objects
            if isinstance(obj.shape, Mesh)
        ],
        {"scenes": len(scenes), "size": size, "remarks": notes},
    )


def in_all_languages(scenes: list[Scene]) -> dict[str, list[Spoken]]:
    """The scenes by language, the default one first. Raises SourceErrors."""
    own = {DEFAULT: [Spoken(scene, True) for scene in scenes]}
    return own | {code: read_spoken(scenes, code) for code in languages() if code != DEFAULT}


def kept(
    store: Store, made_from: Parts, make: Any, chosen: Namespace
) -> Generator[str, None, Entry]:
    """An entry of the store, made if it is not there; tells why, if that is asked."""
    if found := store.find(key_of(made_from)):
        return found
    if chosen.explain:
        yield f"{made_from['of']}: {made_from['what']} is made: {reason(store, made_from)}"
    return made(store, made_from, make)


def reason(store: Store, made_from: Parts) -> str:
    """Why a piece of work that is not in the store has to be made."""
    before = store.newest(made_from["what"], made_from["of"])
    return why(before, made_from, damage_of(store.folder / key_of(made_from)) or "")


def guessed_cost(scene: Scene) -> float:
    """For the order and the progress bar only, in no unit."""
    is_mesh = any(isinstance(obj.shape, Mesh) for obj in scene.objects)
    bounces = scene.render.depth + 1
    return len(scene.objects) * bounces * (4 if has_glass(scene) else 1) * (3 if is_mesh else 1)


def trace_all(
    missing: list[Scene], store: Store, parts: dict[str, Parts], scheduler: str | None
) -> Iterator[str | Message]:
    """Traces scenes into the store, here or on a cluster; tells how far it is."""
    # Long work is started first, or a core waits at the end.
    scenes = sorted(missing, key=guessed_cost, reverse=True)
    yield Begin({scene.id: guessed_cost(scene) for scene in scenes})
    number = 0
    for told in _traced(scenes, store, parts, scheduler):
        if isinstance(told, Progress):
            yield told
            continue
        number += 1
        yield Progress(told.task.id, "", 1.0)
        yield f"[{number}/{len(scenes)}] {told.task.id}: {told.result:.1f} s"
    yield End()


def _traced(
    scenes: list[Scene], store: Store, parts: dict[str, Parts], scheduler: str | None
) -> Iterator[Progress | Finished[Scene, float]]:
    if not scheduler:
        yield from run_all(partial(trace_into, store, parts), scenes, lambda scene: scene.id)
        return
    for told in run_on_cluster(scheduler, scenes):
        if isinstance(told, Progress):
            yield told
            continue
        seconds, files = told.result
        made_from = parts[told.task.id]
        store.entry(key_of(made_from), partial(write_files, files), made_from)
        yield Finished(told.task, seconds)


def write_files(files: dict[str, bytes], folder: Path) -> None:
    """What a worker sent, into a folder."""
    for name, content in files.items():
        (folder / name).write_bytes(content)


def write_edition(
    out: Path, site_source: Path, scenes: list[Scene], facts: dict[str, Any],
    assets: dict[str, str], downloads: dict[str, dict[str, int]], code: str, base: str,
) -> None:  # fmt: skip
    """The site in one language: its sentences, the scenes' words, its pages."""
    words = read_words(code)
    for scene in scenes if code != DEFAULT else []:
        path = out / "scenes" / scene.id / f"words-{code}.js"
        text = json.dumps(scene_words(scene), ensure_ascii=False, separators=(",", ":"))
        write_script(path, f"{scene.id}/words-{code}", text.encode())
    figures = {scene.id: scene_figures(scene, facts[scene.id], words) for scene in scenes}
    savings = {scene.id: savings_lines(facts[scene.id], words) for scene in scenes}
    told_by = assets | write_words(out, words)
    templates = site_source / "templates"
    write_pages(out, templates, scenes, figures, told_by, words, savings, downloads, base)
    write_manifest(out, words, assets)


def bundle(site_source: Path, folder: Path) -> None:
    """The viewer's script, into a folder. Raises SourceErrors."""
    try:
        bundle_viewer(site_source, folder)
    except BundleError as problem:
        raise SourceErrors([SourceError(site_source, "", str(problem))]) from None


def publish_scene(folder: Path, made: list[Entry]) -> None:
    """Copies a scene's files into the site."""
    folder.mkdir(parents=True)
    for path in [path for entry in made for path in entry.files()]:
        if path.name not in NOT_PUBLISHED:
            shutil.copyfile(path, folder / path.name)


def remarks(scene: Scene, facts: dict[str, Any]) -> Iterator[str]:
    """What an author should know though nothing is wrong."""
    for name, reasons in left_out(facts["dropped"]):
        yield f'{scene.id}: left out of "{name}": triangles {reasons}'
    for warning in facts["warnings"]:
        yield f"{scene.id}: warning: {warning}"


def facts_of(entry: Entry) -> dict[str, Any]:
    """What the trace stage counted."""
    facts: dict[str, Any] = json.loads((entry.folder / "facts.json").read_text(encoding="utf-8"))
    return facts
