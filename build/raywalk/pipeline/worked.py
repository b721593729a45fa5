"""What a lesson's steps ask to have worked out, kept under what it is made from."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.pipeline.parts import models_of, shut_for, silent
from raywalk.scene.model import Scene
from raywalk.trace_file.container import unpack
from raywalk.work.chains import Chain
from raywalk.work.digests import key_of
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads
from raywalk.work.progress import Report
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, Stages, note

WORKED = Maker("raywalk.pipeline.worked_products", "write_worked")
FILE = "worked.js"


def asked_of(scene: Scene) -> dict[str, Any]:
    """By what a view's `works` says: the pixels of equations as (n, column, row); n of the grid
    whose rays go through the tree; n of that whose tiles are averaged. {} where there is none."""
    asked: dict[str, Any] = {}
    for step in scene.lesson:
        for _, view in step.stops():
            works, n = view.get("works"), view.get("resolution")
            if works == "equation":
                pixels = asked.setdefault(works, [])
                pixels += [each for each in [[n, *view["pixel"]]] if each not in pixels]
            elif works:
                asked[works] = n
    return asked


def worked_chain(store: Store, scene: Scene, traced: Entry) -> Chain[Entry | None]:
    """The entry of worked.js; None where no step asks for any."""
    if not (asked := asked_of(scene)):
        return None
    parts = {
        "what": "worked", "of": scene.id, "scene": silent(scene), "models": models_of(scene),
        "trace": traced.folder.name, "asked": asked, **WORKED.parts(shut_for(scene)),
    }  # fmt: skip
    yield from reasons(store, parts)
    if not store.find(key_of(parts)):
        note((yield Job(scene.id, partial(_make, store, parts, traced.folder, asked), scene)))
    return store.get(key_of(parts))


def _make(
    store: Store, parts: Parts, traced: Path, asked: dict[str, Any], scene: Scene,
    threads: Threads, report: Report,
) -> Spent:  # fmt: skip
    # Only where something is traced: a change of words imports no compiler.
    from raywalk.optics.compiling import seconds_spent

    stages = Stages("compiling kernels", seconds_spent)
    made(store, parts, partial(WORKED, scene, traced, asked))
    return stages.spent("what lessons work out")


def read_worked(folder: Path) -> dict[str, Any]:
    """What worked.js in an entry's folder holds (trace/equations.py, trace/mesh_visits.py,
    trace_file/nested.py)."""
    found: dict[str, Any] = json.loads(unpack((folder / FILE).read_bytes()))
    return found
