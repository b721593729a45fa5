"""raywalk slides: one lesson's slides, or the course's, in the form that is asked for."""

from __future__ import annotations

import argparse
import re
from argparse import Namespace
from collections.abc import Generator, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raywalk.commands.check import scene_file
from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.wording import did_you_mean, joined
from raywalk.slides.formats import COURSE, DECK_FORMATS, FORMATS, GROUPS
from raywalk.slides.layout import LAYOUTS, WIDE
from raywalk.slides.palette import PALETTES

if TYPE_CHECKING:
    from raywalk.pipeline.slides import Source
    from raywalk.slides.deck import Sources
    from raywalk.slides.layout import Layout
    from raywalk.work.progress import Message
    from raywalk.work.store import Store


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("slides", help="a lesson as slides, handouts, worksheet")
    parser.add_argument("scene", help='a scene file, folder or id; "course" for all of them')
    parser.add_argument("--steps", type=steps, help="of the lesson, as 1,3-5; all if left out")
    parser.add_argument(
        "--format", type=formats, default=DECK_FORMATS,
        help=f"one or more of {joined(FORMATS)}, with commas between",
    )  # fmt: skip
    parser.add_argument("--aspect", choices=[*LAYOUTS], default=WIDE.name)
    parser.add_argument(
        "--palette", choices=[*PALETTES],
        help="colours for a projector or for paper; left out: pdf for paper, pptx for a projector",
    )  # fmt: skip
    parser.add_argument("--out", type=Path, default=Path("slides"), help="folder for the files")
    parser.add_argument("--work", type=Path, default=Path(".work"), help="where traces are kept")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str | Message]:
    """Names each file that was written. Raises SourceErrors."""
    scenes = _scenes(chosen)
    _refuse_steps(chosen, scenes)
    # Only now: what is wrong is said before anything heavy is imported.
    from raywalk.pipeline.slide_products import missing_letters, write_files
    from raywalk.slides.deck import course_of, lesson_slides, scene_deck
    from raywalk.slides.pdf import MissingGlyphs

    layout, palette = LAYOUTS[chosen.aspect], PALETTES.get(chosen.palette)
    sources = yield from _prepared(chosen, scenes, layout)
    lessons = [each.lesson(layout) for each in sources]
    if chosen.scene == COURSE:
        deck = course_of(sources, [lesson_slides(each) for each in lessons], layout)
        lesson = None
    else:
        deck, lesson = scene_deck(sources[0], layout, chosen.steps, lessons[0]), lessons[0]
    chosen.out.mkdir(parents=True, exist_ok=True)
    before = {path: path.stat().st_mtime_ns for path in chosen.out.iterdir()}
    try:
        write_files(chosen.out, deck, chosen.format, lesson, scenes, palette, strict=True)
    except MissingGlyphs as lost:
        raise SourceErrors([missing_letters(scenes, lost.characters)]) from None
    for path in sorted(chosen.out.iterdir()):
        if before.get(path) != path.stat().st_mtime_ns:
            yield f"{path}: {path.stat().st_size / 1000:.0f} KB"


def steps(text: str) -> frozenset[int]:
    """ "1,3-5" as {0, 2, 3, 4}."""
    chosen: set[int] = set()
    for part in text.split(","):
        match = re.fullmatch(r"\s*(\d{1,4})(?:-(\d{1,4}))?\s*", part, re.ASCII)
        first, last = (int(match[1]), int(match[2] or match[1])) if match else (0, 0)
        if not match or not 1 <= first <= last:
            message = f"{part!r} is no step: write numbers from 1 and ranges, as 1,3-5"
            raise argparse.ArgumentTypeError(message)
        chosen |= set(range(first - 1, last))
    return frozenset(chosen)


def formats(text: str) -> tuple[str, ...]:
    """ "pdf,svg" or "decks,handouts" as a tuple, each once."""
    known = {name: (name,) for name in FORMATS} | GROUPS
    named = [part.strip() for part in text.split(",")]
    for name in named:
        if name not in known:
            hint = did_you_mean(name, list(known))
            raise argparse.ArgumentTypeError(
                f"no format is called {name!r}; known: {joined(list(known))}"
                + (f"; {hint}" if hint else "")
            )
    return tuple(dict.fromkeys(each for name in named for each in known[name]))


def _scenes(chosen: Namespace) -> list[Scene]:
    if chosen.scene == COURSE:
        return read_scenes(chosen.scenes)
    file = scene_file(chosen.scene, chosen.scenes)
    if not file.exists() and file.parent.parent == chosen.scenes and chosen.scenes.is_dir():
        known = sorted(path.parent.name for path in chosen.scenes.glob("*/scene.toml"))
        raise SourceErrors([
            SourceError(
                chosen.scenes, "", f'there is no scene "{chosen.scene}"',
                allowed=f"known: {joined([*known, COURSE])}",
                hint=did_you_mean(chosen.scene, known),
            )
        ])  # fmt: skip
    return [read_scene(file)]


def _refuse_steps(chosen: Namespace, scenes: list[Scene]) -> None:
    """The steps must be there, and a course has none of its own."""
    if chosen.scene == COURSE:
        one_lesson = [name for name in chosen.format if name in ("worksheet", "answers")]
        if chosen.steps is not None or one_lesson:
            what = "--steps" if chosen.steps is not None else f"--format {one_lesson[0]}"
            problem = f"{what} is for the lesson of one scene, not for the course"
            raise SourceErrors([SourceError(chosen.scenes, "", problem)])
        return
    [scene] = scenes
    if not scene.lesson:
        raise SourceErrors([SourceError(scene.path, "lesson", "has no steps to make slides of")])
    missing = sorted(k + 1 for k in chosen.steps or () if k >= len(scene.lesson))
    if missing:
        message = f"has no step {joined(map(str, missing))}"
        allowed = f"allowed: 1 to {len(scene.lesson)}"
        raise SourceErrors([SourceError(scene.path, "lesson", message, allowed=allowed)])


def _prepared(
    chosen: Namespace, scenes: list[Scene], layout: Layout
) -> Generator[str | Message, None, list[Sources]]:
    """What the scenes' slides are made from, by way of the store; tells what has to be traced."""
    from raywalk.pipeline.figures import filled_here
    from raywalk.pipeline.slides import plans_of, sources_of
    from raywalk.stops.process import Stops
    from raywalk.work.store import Store

    store, sources = Store(chosen.work), []
    for scene in (filled_here(store, each) for each in scenes):
        sources.append((yield from traced(store, scene)))
    with Stops() as stops:
        plans = yield from plans_of(store, stops, sources, layout)
    return [sources_of(each) for each in plans]


def traced(store: Store, scene: Scene) -> Generator[str, None, Source]:
    """A scene's trace and page data, made if they are not kept."""
    from raywalk.pipeline.parts import PAGE_DATA, page_data_parts, trace_parts
    from raywalk.pipeline.slides import Source
    from raywalk.pipeline.sweeps import sweeps_here
    from raywalk.pipeline.trace_task import trace_into
    from raywalk.words.catalogue import DEFAULT
    from raywalk.work.digests import key_of
    from raywalk.work.making import made
    from raywalk.work.pool import cores
    from raywalk.work.progress import say_nothing

    if scene.base:
        base = yield from traced(store, scene.base)
        parts = page_data_parts(scene, base.traced.folder.name, sweeps=base.sweeps)
        data = made(store, parts, partial(PAGE_DATA, scene, base.traced.folder))
        return Source(scene, DEFAULT, base.traced, data, base.page_data, base.sweeps)
    parts = trace_parts(scene)
    if not store.find(key_of(parts)):
        yield f"tracing {scene.id}"
    trace_into(store, {scene.id: parts}, scene, cores, say_nothing)
    trace = store.get(key_of(parts))
    sweeps = sweeps_here(store, scene, trace)
    parts = page_data_parts(scene, key_of(parts), sweeps=sweeps)
    folders = {id: each.folder for id, each in sweeps.items()}
    data = made(store, parts, partial(PAGE_DATA, scene, trace.folder, sweeps=folders))
    return Source(scene, DEFAULT, trace, data, sweeps=sweeps)
