"""What a saved scene looks like, before all of it is traced: its grids, exactly; its picture, in
the finest grid's tiles. For pages that `raywalk serve` shows meanwhile; the build that follows has
the grids from the store."""

from __future__ import annotations

from argparse import Namespace
from dataclasses import replace
from pathlib import Path

from raywalk.pipeline.parts import trace_parts
from raywalk.scene.read import read_own_scenes
from raywalk.work.digests import key_of
from raywalk.work.pool import cores
from raywalk.work.store import Store


def first_sight(chosen: Namespace, folder: Path) -> bool:
    """Files of the site below a folder, of the one scene whose trace is not in the store; False if
    there is no such scene, more than one (then an author waits for all), or no page of it yet.

    Raises UserError where the scenes have mistakes.
    """
    store = Store(chosen.work)
    own = read_own_scenes(chosen.scenes)
    parts = {scene.id: (scene, trace_parts(scene)) for scene in own}
    missing = [each for each in parts.values() if not store.has(key_of(each[1]))]
    if len(missing) != 1:
        return False
    [(scene, made_from)] = missing
    if not (chosen.out / "scenes" / scene.id / "index.html").is_file():
        return False
    # Only here: a change of words imports none of it.
    from raywalk.pipeline.figures import filled_here
    from raywalk.pipeline.publishing import publish_scene
    from raywalk.pipeline.trace_task import grids_into
    from raywalk.site.scene_data import write_page_data

    grids = grids_into(store, made_from, scene, cores)
    # Its sweeps come with the build: until then nothing moves.
    shown = replace(filled_here(store, scene, is_quick=True), sweeps=())
    place = folder / "scenes" / scene.id
    publish_scene(place, [grids])
    write_page_data(shown, grids.folder, place)
    return True
