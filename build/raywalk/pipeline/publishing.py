"""What was made, written into the site's folder: all of it, or none."""

from __future__ import annotations

import json
import shutil
from argparse import Namespace
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from raywalk.pipeline.checking import Checks, publish_check
from raywalk.pipeline.homework import publish_homework
from raywalk.pipeline.mistakes import Mistakes, publish_mistakes, told_in
from raywalk.pipeline.slides import MadeDeck, publish_slides
from raywalk.pipeline.sweeps import publish_sweeps
from raywalk.scene.lesson_pictures import pictures_of
from raywalk.scene.lesson_text import PICTURES
from raywalk.scene.model import Scene
from raywalk.scene.translation import Spoken
from raywalk.site import sizes
from raywalk.site.assets import write_assets, write_check_words, write_words
from raywalk.site.check_page import write_check_page
from raywalk.site.figures import scene_figures
from raywalk.site.licences import write_licences
from raywalk.site.mistake_words import read_said
from raywalk.site.mistakes import write_mistake_pages
from raywalk.site.offline import write_icons, write_manifest, write_worker
from raywalk.site.pages import face_of, home_of, write_pages, write_sizes
from raywalk.site.reports import publish_reports
from raywalk.site.savings import savings_lines
from raywalk.site.scene_data import scene_words
from raywalk.site.sitemap import write_sitemap
from raywalk.terms.glossary import read_glossary
from raywalk.trace_file.container import write_script
from raywalk.words import read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.work.publish import staged
from raywalk.work.store import Entry

# Of an entry, what stays behind: the pages are made from these.
NOT_PUBLISHED = ("facts.json", "display.npz")


@dataclass(frozen=True)
class Made:
    """Scenes by language, and the entries of the store that the site is put together from."""

    spoken: dict[str, list[Spoken]]
    facts: dict[str, Any]  # by scene, as are the next ones
    viewer: Entry
    traces: dict[str, Entry]
    data: dict[str, Entry]
    pictures: dict[str, Entry]  # of some: pages do without
    worked: dict[str, Entry]  # of scenes whose lessons work something out
    sweeps: dict[str, dict[str, Entry]]  # by scene and by the sweep's id
    homework: dict[str, Entry]  # vectors for graders; pages do without
    check: dict[str, Checks]  # what students' pictures are held against; there is no page without
    mistakes: Mistakes | None  # pages of their own; None where pages do not wait for them
    decks: list[MadeDeck]

    @property
    def scenes(self) -> list[Scene]:
        """In the default language."""
        return [each.scene for each in self.spoken[DEFAULT]]

    def of_scene(self, id: str) -> Iterator[Entry]:
        """What is published of a scene; of a lesson on another one, what that has not."""
        is_lesson = any(each.id == id and each.base for each in self.scenes)
        own = (self.data, self.worked)
        for kind in own if is_lesson else (self.traces, self.pictures, *own):
            if id in kind:
                yield kind[id]

    def entries(self) -> Iterator[Entry]:
        """All that are used."""
        yield self.viewer
        for id in self.traces:
            yield from self.of_scene(id)
            yield from self.sweeps[id].values()
        yield from self.homework.values()
        yield from (entry for checks in self.check.values() for entry in checks)
        if self.mistakes:
            yield from self.mistakes.entries()
        yield from (deck.entry for deck in self.decks)


def publish(made: Made, chosen: Namespace, site_source: Path, base: str) -> list[str]:
    """Writes the site, unless something in it outgrew its budget; returns what scenes weigh more
    than ours do, a sentence each. Raises UserError."""
    budgets = sizes.read_budgets(chosen.budgets)
    templates, scenes = site_source / "templates", made.scenes
    with staged(chosen.out) as out:
        assets = write_assets(out, site_source, made.viewer.folder)
        for scene in scenes:
            publish_scene(out / "scenes" / scene.id, list(made.of_scene(scene.id)))
            if not scene.base:
                publish_sweeps(out / "scenes" / scene.id, made.sweeps[scene.id])
        if scenes:
            assets |= write_icons(out, out / "scenes" / face_of(scenes).id / "picture.png")
        published = publish_slides(out, made.decks)
        publish_homework(out, site_source, made.homework.values())
        publish_check(out, made.check)
        if made.mistakes:
            publish_mistakes(out, site_source, made.mistakes)
        publish_reports(out, templates, assets, scenes, chosen.work)
        for code, translated in made.spoken.items():
            said = [each.scene for each in translated]
            downloads = published.get(DEFAULT, {}) | published.get(code, {})
            words = read_words(code)
            own = assets | write_words(out, words) | write_check_words(out, words)
            with_mistakes = made.mistakes is not None
            write_edition(
                out, site_source, said, made.facts, own, downloads, code, base, with_mistakes
            )
            write_check_page(
                out, templates, said, read_said(site_source, code), own, words, base, with_mistakes
            )
            if made.mistakes:
                told = told_in(made.mistakes, code)
                write_mistake_pages(out, site_source, said, told, own, words, base)
        weights = sizes.measured(out, scenes, made.facts)
        heavy = sizes.check(chosen.out, weights, budgets)
        sizes.keep(out, weights)
        write_sizes(out, templates, weights, budgets, assets)
        write_licences(out, scenes, made.viewer.folder, bool(made.decks))
        write_sitemap(out, base)
        write_worker(out, site_source)
    return heavy


def write_edition(
    out: Path, site_source: Path, scenes: list[Scene], facts: dict[str, Any],
    assets: dict[str, str], downloads: dict[str, dict[str, int]], code: str, base: str,
    with_mistakes: bool = False,
) -> None:  # fmt: skip
    """The site in one language: its sentences, the scenes' words, its pages."""
    words = read_words(code)
    for scene in scenes if code != DEFAULT else []:
        path = out / "scenes" / scene.id / f"words-{code}.js"
        told = scene_words(scene, read_glossary(code))
        text = json.dumps(told, ensure_ascii=False, separators=(",", ":"))
        write_script(path, f"{scene.id}/words-{code}", text.encode())
    for scene in scenes:
        publish_pictures(scene, out / home_of(code) / "scenes" / scene.id / PICTURES)
    figures = {scene.id: scene_figures(scene, facts[scene.id], words) for scene in scenes}
    savings = {scene.id: savings_lines(facts[scene.id], words) for scene in scenes}
    templates = site_source / "templates"
    write_pages(
        out, templates, scenes, figures, assets, words, savings, downloads, base, with_mistakes
    )
    write_manifest(out, words, assets)


def publish_pictures(scene: Scene, folder: Path) -> None:
    """Copies what a lesson shows beside its pages, in each language: so addresses are the same."""
    for path in pictures_of(scene):
        folder.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, folder / path.name)


def publish_scene(folder: Path, made: list[Entry]) -> None:
    """Copies a scene's files into the site."""
    folder.mkdir(parents=True)
    for path in [path for entry in made for path in entry.files()]:
        if path.name not in NOT_PUBLISHED:
            shutil.copyfile(path, folder / path.name)
