"""Figures of lessons: what slots ask for, traced where it is not kept.

A scene's figures have a key of their own: other words trace nothing, other pixels a moment's worth.
"""

from __future__ import annotations

import json
from collections.abc import Generator, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.pipeline.filling import Figures, Lessons, filled
from raywalk.pipeline.parts import models_of, shut_for, silent
from raywalk.pipeline.tracing import by_cost
from raywalk.scene.measures import Facts
from raywalk.scene.model import Scene
from raywalk.scene.read import SCENE_FILE, read_scene
from raywalk.scene.slots import Operand, Pixel, Slot, own_pixel, slots_in, stop_of
from raywalk.scene.translation import Spoken
from raywalk.words.catalogue import DEFAULT
from raywalk.work.chains import Chain, run_chains
from raywalk.work.digests import key_of
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads, Workers
from raywalk.work.progress import Message, Report
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, Stages, note

FIGURES = Maker("raywalk.trace.lesson_figures", "write_figures")
BOUNCES = Maker("raywalk.trace.lesson_figures", "write_bounces")
FILE = "figures.json"
Known = Mapping[str, Scene]  # by id


def filled_lessons(
    store: Store, spoken: Lessons, workers: Workers
) -> Generator[str | Message, None, Lessons]:
    """The scenes with the figures in their words, by language. Raises SourceErrors with all slots
    that ask for what there is not."""
    known = {each.scene.id: each.scene for each in spoken[DEFAULT]}
    place = {id: k for k, id in enumerate(known)}
    # In the order in which they are traced: the first processes then want the kernels of other
    # surfaces, and where none is compiled yet no core waits for another's.
    order = [place[scene.id] for scene in by_cost([*known.values()])]
    chains = [_figures_chain(store, in_languages(spoken, k), known) for k in order]
    found = dict(zip(order, (yield from run_chains(chains, workers)), strict=True))
    return filled(spoken, [found[k] for k in range(len(order))])


def in_languages(spoken: Lessons, k: int) -> list[Scene]:
    """One scene in each language."""
    return [all_scenes[k].scene for all_scenes in spoken.values()]


def wanted_pixels(scenes: Iterable[Scene]) -> tuple[list[Pixel], bool] | None:
    """What the slots of a scene's languages need to be traced: pixels, those of all steps, so that
    a slot more in a text needs none; and whether the whole picture. None where there is no slot."""
    scenes = list(scenes)
    found = list(_asked(scenes))
    if not found:
        return None
    own = [(operand, pixel) for stop, operand, pixel in found if not (operand.scene or stop)]
    pixels = {pixel for _, pixel in own if pixel}
    pixels |= {
        pixel
        for scene in scenes
        for step in scene.lesson
        for _, view in step.stops()
        if (pixel := own_pixel(view))
    }
    return sorted(pixels), any(of.quantity and of.quantity.needs_picture for of, _ in own)


def wanted_elsewhere(scenes: Iterable[Scene], known: Known) -> dict[str, list[Pixel]]:
    """By the id of another scene, the pixels of it that the slots of a scene's languages ask for;
    without those that it has not, which are named where slots are filled."""
    found: dict[str, set[Pixel]] = {}
    for _, operand, pixel in _asked(scenes):
        if operand.scene in known:
            of = found.setdefault(operand.scene, set())
            if pixel and _has(known[operand.scene], operand, pixel):
                of.add(pixel)
    return {id: sorted(pixels) for id, pixels in sorted(found.items())}


def wanted_at_stops(scenes: Iterable[Scene]) -> dict[str, list[Pixel]]:
    """By stop of a sweep, as views name it, the pixels that the slots of steps there ask for."""
    found: dict[str, set[Pixel]] = {}
    for stop, _, pixel in _asked(scenes):
        if stop:
            found.setdefault(stop, set()).update([pixel] if pixel else [])
    return {stop: sorted(pixels) for stop, pixels in sorted(found.items())}


def asked_elsewhere(scenes: Sequence[Scene], known: Known) -> dict[str, tuple[Scene, list[Pixel]]]:
    """What the slots of a scene's languages ask of other scenes, by their ids, and of it at stops
    of its sweeps, by their names: these have a colon, and no scene that a slot can name."""
    beside, stops = wanted_elsewhere(scenes, known), wanted_at_stops(scenes)
    of_others = {id: (known[id], pixels) for id, pixels in beside.items()}
    return of_others | {at: (scenes[0].at_stop(at), pixels) for at, pixels in stops.items()}


def with_others(figures: Figures, found: Mapping[str, tuple[Scene, Figures]]) -> Figures:
    """A scene's figures with what asked_elsewhere has asked for."""
    stops = {name: each for name, each in found.items() if ":" in name}
    others = {name: each for name, each in found.items() if name not in stops}
    return replace(figures, others=others, stops=stops)


def _has(scene: Scene, operand: Operand, pixel: Pixel) -> bool:
    n, column, row = pixel
    return n in scene.render.resolutions and max(column, row) < n


def _asked(scenes: Iterable[Scene]) -> Iterator[tuple[str, Operand, Pixel | None]]:
    """Each quantity in a slot with its pixels, and the stop at which it is asked."""
    for scene in scenes:
        told = [said for step in scene.lesson for said in step.said().values()]
        for text, view in [*told, *((goal, {}) for goal in scene.goals)]:
            for _, slot in slots_in(text):
                for operand in slot.operands if isinstance(slot, Slot) else []:
                    if operand.quantity:
                        stop, own = stop_of(operand, view), own_pixel(view)
                        for pixel in [operand.pixel(own), *operand.inside(own)]:
                            yield stop, operand, pixel


def figures_parts(scene: Scene, pixels: list[Pixel]) -> Parts:
    """What a scene's figures are made from: all of it that is traced, and which pixels."""
    return {
        "what": "figures", "of": scene.id, "scene": silent(scene), "models": models_of(scene),
        "pixels": [list(pixel) for pixel in pixels], **FIGURES.parts(shut_for(scene)),
    }  # fmt: skip


def bounces_parts(scene: Scene) -> Parts:
    """Likewise of what is counted over the whole picture."""
    return {
        "what": "bounces", "of": scene.id, "scene": silent(scene), "models": models_of(scene),
        **BOUNCES.parts(shut_for(scene)),
    }  # fmt: skip


def _figures_chain(store: Store, scenes: list[Scene], known: Known) -> Chain[Figures]:
    """A scene's figures, made where they are not there; scenes: it in all languages."""
    wanted, scene = wanted_pixels(scenes), scenes[0]
    if wanted is None:
        return Figures({}, Facts({}, None))
    pixels, is_whole = wanted
    works = [_work(scene, pixels)]
    works += [(bounces_parts(scene), partial(BOUNCES, scene))] if is_whole else []
    elsewhere, own = asked_elsewhere(scenes, known), len(works)
    works += [_work(there, pixels) for there, pixels in elsewhere.values()]
    for parts, _ in works:
        yield from reasons(store, parts)
    missing = [work for work in works if not store.find(key_of(work[0]))]
    if missing:
        note((yield Job(scene.id, partial(_make, store), missing)))
    entries = [store.get(key_of(parts)) for parts, _ in works]
    found = {
        name: (there, read_figures(entry))
        for (name, (there, _)), entry in zip(elsewhere.items(), entries[own:], strict=True)
    }
    return with_others(read_figures(*entries[:own]), found)


def _work(scene: Scene, pixels: list[Pixel]) -> tuple[Parts, Any]:
    return figures_parts(scene, pixels), partial(FIGURES, scene, pixels)


def filled_here(store: Store, scene: Scene, is_quick: bool = False) -> Scene:
    """One scene in its own language with the figures in its words, made in this process.

    is_quick: what needs the whole picture is written only if it is known already. Raises
    SourceErrors.
    """
    wanted = wanted_pixels([scene])
    if wanted is None:
        return scene
    pixels, is_whole = wanted
    entry = made(store, *_work(scene, pixels))
    whole = store.find(key_of(bounces_parts(scene))) if is_whole else None
    if is_whole and not is_quick:
        whole = made(store, bounces_parts(scene), partial(BOUNCES, scene))
    found = {
        name: (there, read_figures(made(store, *_work(there, each))))
        for name, (there, each) in asked_elsewhere([scene], scenes_beside([scene])).items()
    }
    figures = with_others(read_figures(entry, whole), found)
    spoken = filled({DEFAULT: [Spoken(scene, True)]}, [figures])
    return spoken[DEFAULT][0].scene


def scenes_beside(scenes: Iterable[Scene]) -> Known:
    """Those in the folders beside a scene's own that its slots name. Raises SourceErrors.

    scenes: it in its languages.
    """
    scenes = list(scenes)
    named = sorted({operand.scene for _, operand, _ in _asked(scenes) if operand.scene})
    files = {id: scenes[0].path.parent.parent / id / SCENE_FILE for id in named}
    return {id: read_scene(file) for id, file in files.items() if file.is_file()}


def _make(
    store: Store, missing: list[tuple[Parts, Any]], threads: Threads, report: Report
) -> Spent:
    # Only where something is traced: a change of words imports no compiler.
    from raywalk.optics.compiling import seconds_spent

    stages = Stages("compiling kernels", seconds_spent)
    for parts, make in missing:
        made(store, parts, make)
    return stages.spent("lessons' figures")


def read_figures(entry: Entry, whole: Entry | None = None) -> Figures:
    """As they are kept."""
    found = _read(entry.folder)
    trees = {(n, column, row): ray for (n, column, row), ray in found["pixels"]}
    return Figures(trees, Facts(found["meshes"], _read(whole.folder) if whole else None))


def _read(folder: Path) -> Any:
    return json.loads((folder / FILE).read_text(encoding="utf-8"))
