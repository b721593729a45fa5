"""raywalk site: scene files in, site out. The pipeline's table of contents."""

from __future__ import annotations

import json
import shutil
import time
from argparse import Namespace
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.bench.report import publish_reports
from raywalk.errors import SourceError, SourceErrors
from raywalk.scene import read_scenes
from raywalk.scene.model import Mesh, Scene
from raywalk.site.assets import BundleError, write_assets
from raywalk.site.figures import has_glass, left_out, scene_figures
from raywalk.site.mesh_data import DisplayMesh
from raywalk.site.pages import write_pages
from raywalk.site.publish import staged
from raywalk.site.scene_data import Display, scene_data
from raywalk.trace_file.script import write_script
from raywalk.work.keys import trace_key
from raywalk.work.pool import cores, run_all
from raywalk.work.store import Entry, Store

SITE_SOURCE = Path("site_src")
# Of an entry, what stays behind: the pages are made from these.
NOT_PUBLISHED = ("facts.json", "display.npz")


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("site", help="trace all scenes and build the site")
    parser.add_argument("--out", type=Path, default=Path("dist"), help="where the site goes")
    parser.add_argument("--work", type=Path, default=Path(".work"), help="where traces are kept")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """Builds the site, telling what was traced, kept and written."""
    started = time.monotonic()
    scenes = read_scenes(chosen.scenes)
    # Keys are taken before anything runs: a file edited meanwhile is then traced next time.
    store, keys = Store(chosen.work), {scene.id: trace_key(scene) for scene in scenes}
    missing = [scene for scene in scenes if not store.find(keys[scene.id])]
    if missing:
        yield f"tracing {len(missing)} of {len(scenes)} scenes on {cores()} cores"
    work = partial(trace_into, store, keys)
    for number, (scene, seconds) in enumerate(
        run_all(work, sorted(missing, key=guessed_cost)), start=1
    ):
        yield f"[{number}/{len(missing)}] {scene.id}: {seconds:.1f} s"
    entries = {scene.id: store.get(keys[scene.id]) for scene in scenes}
    for scene in scenes:
        yield from remarks(scene, facts_of(entries[scene.id]))
    with staged(chosen.out) as out:
        try:
            assets = write_assets(out, SITE_SOURCE)
        except BundleError as problem:
            raise SourceErrors([SourceError(SITE_SOURCE, "", str(problem))]) from None
        for scene in scenes:
            publish_scene(out / "scenes" / scene.id, scene, entries[scene.id])
        figures = {scene.id: scene_figures(scene, facts_of(entries[scene.id])) for scene in scenes}
        publish_reports(out, SITE_SOURCE / "templates", assets, scenes, chosen.work)
        write_pages(out, SITE_SOURCE / "templates", scenes, figures, assets)
    size = sum(path.stat().st_size for path in chosen.out.rglob("*") if path.is_file())
    yield (
        f"{len(scenes)} scenes: {len(missing)} traced, {len(scenes) - len(missing)} unchanged; "
        f"{size / 1e6:.1f} MB in {chosen.out}/, {time.monotonic() - started:.1f} s"
    )


def guessed_cost(scene: Scene) -> float:
    """Negative and only for the order: long work is started first, or a core waits at the end."""
    is_mesh = any(isinstance(obj.shape, Mesh) for obj in scene.objects)
    bounces = scene.render.depth + 1
    return -len(scene.objects) * bounces * (4 if has_glass(scene) else 1) * (3 if is_mesh else 1)


def trace_into(store: Store, keys: dict[str, str], scene: Scene, threads: int) -> float:
    """Traces a scene into the store, under its key; returns the seconds it took."""
    # Only here: a build with nothing to trace never pays for numba, trimesh and Embree.
    from raywalk.products import write_products

    begun = time.monotonic()
    store.entry(keys[scene.id], lambda folder: write_products(scene, folder, threads))
    return time.monotonic() - begun


def publish_scene(folder: Path, scene: Scene, entry: Entry) -> None:
    """Copies a scene's files into the site and writes its scene.js."""
    folder.mkdir(parents=True)
    for path in entry.files():
        if path.name not in NOT_PUBLISHED:
            shutil.copyfile(path, folder / path.name)
    data = scene_data(scene, read_display(scene, entry.folder / "display.npz"))
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    write_script(folder / "scene.js", f"{scene.id}/scene", text.encode())


def read_display(scene: Scene, path: Path) -> Display:
    """The drawing data that the trace stage handed on."""
    arrays = np.load(path)
    meshes = {
        obj.name: DisplayMesh(
            centre=arrays[f"{k}.centre"],
            vertices=arrays[f"{k}.vertices"],
            faces=arrays[f"{k}.faces"],
            normals=arrays.get(f"{k}.normals"),
        )
        for k, obj in enumerate(scene.objects)
        if isinstance(obj.shape, Mesh)
    }
    return Display(arrays["centre"], float(arrays["radius"]), meshes)


def remarks(scene: Scene, facts: dict[str, Any]) -> Iterator[str]:
    """What an author should know though nothing is wrong."""
    for name, why in left_out(facts["dropped"]):
        yield f'{scene.id}: left out of "{name}": triangles {why}'
    for warning in facts["warnings"]:
        yield f"{scene.id}: warning: {warning}"


def facts_of(entry: Entry) -> dict[str, Any]:
    """What the trace stage counted."""
    facts: dict[str, Any] = json.loads((entry.folder / "facts.json").read_text(encoding="utf-8"))
    return facts
