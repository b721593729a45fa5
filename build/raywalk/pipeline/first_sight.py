"""What a saved scene looks like, before all of it is traced: its grids, exactly; its picture, in
the finest grid's tiles. For pages that `raywalk serve` shows meanwhile; nothing of it is kept."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path

from raywalk.pipeline.parts import trace_parts
from raywalk.scene.read import read_scenes
from raywalk.work.digests import key_of
from raywalk.work.pool import cores
from raywalk.work.store import Store


def first_sight(chosen: Namespace, folder: Path) -> bool:
    """Files of the site below a folder, of the one scene whose trace is not in the store; False if
    there is no such scene, more than one (then an author waits for all), or no page of it yet.

    Raises UserError where the scenes have mistakes.
    """
    store = Store(chosen.work)
    missing = [
        scene for scene in read_scenes(chosen.scenes) if not store.find(key_of(trace_parts(scene)))
    ]
    if len(missing) != 1 or not (chosen.out / "scenes" / missing[0].id / "index.html").is_file():
        return False
    # Only here: a change of words imports no engine.
    from raywalk.pipeline.trace_products import write_products
    from raywalk.site.scene_data import write_page_data
    from raywalk.trace.wavefront import trace_grids

    place = folder / "scenes" / missing[0].id
    place.mkdir(parents=True)
    write_products(missing[0], place, cores(), trace=trace_grids)
    write_page_data(missing[0], place, place)
    return True
