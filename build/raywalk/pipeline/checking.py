"""What the page check/ holds pictures of a scene against, kept under what it is made from."""

from __future__ import annotations

import shutil
from collections.abc import Generator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import NamedTuple

from raywalk.check.all_scenes import write_scenes
from raywalk.pipeline.parts import models_of, shut_for, silent
from raywalk.pipeline.scenes import Making, SceneMade
from raywalk.pipeline.tracing import by_cost
from raywalk.scene.model import Scene
from raywalk.work.chains import Chain, run_chains
from raywalk.work.digests import key_of
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads, Workers
from raywalk.work.progress import Message, Report
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, Stages, note

CHECK = Maker("raywalk.check.write", "write_check")
IN_LITTLE = Maker("raywalk.check.in_little", "write_in_little")
FOLDER = "check"  # of the site


def check_parts(scene: Scene, traced: Entry) -> Parts:
    """The scene without its words, its trace, and what makes right and wrong pictures of it."""
    return {
        "what": "check", "of": scene.id, "scene": silent(scene), "models": models_of(scene),
        "trace": traced.folder.name, **CHECK.parts(shut_for(scene)),
    }  # fmt: skip


class Checks(NamedTuple):
    """What there is of a scene."""

    whole: Entry
    little: Entry


def make_checks(
    making: Making, scenes: Sequence[Scene], found: Mapping[str, SceneMade], workers: Workers
) -> Generator[str | Message, None, dict[str, Checks]]:
    """The entries of scenes, by id, in the course's order; where pages shall not wait, of those
    that have one. After all else: lessons on other scenes would wait for the longest of these."""
    store = making.store
    if not making.asking:
        parts = {scene.id: check_parts(scene, found[scene.id].traced) for scene in scenes}
        kept = {id: store.find(key_of(each)) for id, each in parts.items()}
        return _with_little(store, {id: entry for id, entry in kept.items() if entry})
    ordered = by_cost(scenes)
    chains = [check_chain(store, scene, found[scene.id].traced) for scene in ordered]
    entries = yield from run_chains(chains, workers)
    of = dict(zip([scene.id for scene in ordered], entries, strict=True))
    return _with_little(store, {scene.id: of[scene.id] for scene in scenes})


def _with_little(store: Store, whole: Mapping[str, Entry]) -> dict[str, Checks]:
    return {id: Checks(entry, in_little(store, id, entry)) for id, entry in whole.items()}


def check_chain(store: Store, scene: Scene, traced: Entry) -> Chain[Entry]:
    """The entry of a scene's right and wrong pictures."""
    parts = check_parts(scene, traced)
    yield from reasons(store, parts)
    if not store.find(key_of(parts)):
        note((yield Job(scene.id, partial(_make, store, parts, traced.folder), scene)))
    return store.get(key_of(parts))


def _make(
    store: Store, parts: Parts, traced: Path, scene: Scene, threads: Threads, report: Report
) -> Spent:
    # Only where something is traced: a change of words imports no compiler.
    from raywalk.optics.compiling import seconds_spent

    stages = Stages("compiling kernels", seconds_spent)
    made(store, parts, partial(CHECK, scene, traced, threads))
    return stages.spent("pictures to check against")


def in_little(store: Store, id: str, check: Entry) -> Entry:
    """The same pictures in little, made at once: it takes a moment."""
    parts = {"what": "check in little", "of": id, "check": check.folder.name, **IN_LITTLE.parts()}
    found = store.find(key_of(parts))
    return found or made(store, parts, partial(IN_LITTLE, check.folder))


def publish_check(out: Path, made: Mapping[str, Checks]) -> None:
    """A folder for each scene beside the page, and what all look like, of their small pictures
    in the site."""
    if not made:
        return
    for id, checks in made.items():
        (out / FOLDER / id).mkdir(parents=True)
        for path in (path for entry in checks for path in entry.files() if path.suffix == ".js"):
            shutil.copyfile(path, out / FOLDER / id / path.name)
    small = (
        (id, out / "scenes" / id / "thumb.png", checks.little.folder) for id, checks in made.items()
    )
    write_scenes(out / FOLDER, small)
