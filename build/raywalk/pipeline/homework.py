"""A scene's vectors for homework, kept under what they are made from."""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from functools import partial
from pathlib import Path

from raywalk.pipeline.parts import models_of, shut_for, silent
from raywalk.scene.model import Scene
from raywalk.work.chains import Chain
from raywalk.work.digests import key_of
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads
from raywalk.work.progress import Report
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, Stages, note

HOMEWORK = Maker("raywalk.homework.write", "write_vectors")
FOLDER = "homework"  # of the site, and of what is said about the files
SCHEMA = Path(__file__).parents[1] / FOLDER / "vectors.schema.json"


def homework_chain(store: Store, scene: Scene) -> Chain[Entry | None]:
    """The entry of a scene's vectors. None of a scene with meshes: nobody types them in."""
    if scene.has_mesh:
        return None
    parts = {
        "what": "homework", "of": scene.id, "scene": silent(scene) | {"title": scene.title},
        "models": models_of(scene), **HOMEWORK.parts(shut_for(scene)),
    }  # fmt: skip
    yield from reasons(store, parts)
    if not store.find(key_of(parts)):
        note((yield Job(scene.id, partial(_make, store, parts), scene)))
    return store.get(key_of(parts))


def _make(store: Store, parts: Parts, scene: Scene, threads: Threads, report: Report) -> Spent:
    # Only where something is traced: a change of words imports no compiler.
    from raywalk.optics.compiling import seconds_spent

    stages = Stages("compiling kernels", seconds_spent)
    made(store, parts, partial(HOMEWORK, scene))
    return stages.spent("homework")


def publish_homework(out: Path, site_source: Path, made: Iterable[Entry]) -> None:
    """The files of all scenes, their schema, and what is said about them."""
    files = [path for entry in made for path in entry.files()]
    if not files:
        return
    said = sorted((site_source / FOLDER).glob("*.txt"))
    (out / FOLDER).mkdir()
    for path in [*files, SCHEMA, *said]:
        shutil.copyfile(path, out / FOLDER / path.name)
