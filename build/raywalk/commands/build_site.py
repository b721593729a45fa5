"""raywalk site: scene files in, site out. The pipeline's table of contents."""

from __future__ import annotations

import json
import shutil
import time
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.scene import read_scenes
from raywalk.scene.model import Mesh, Scene
from raywalk.site.assets import BundleError, write_assets
from raywalk.site.pages import Figures, write_pages
from raywalk.site.publish import staged
from raywalk.site.scene_data import Display, DisplayMesh, scene_data
from raywalk.trace_file.script import write_script
from raywalk.work.keys import trace_key
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
    entries = {}
    for number, scene in enumerate(scenes, start=1):
        begun = time.monotonic()
        entries[scene.id] = traced(scene, Store(chosen.work))
        how = "unchanged" if entries[scene.id].was_found else f"{time.monotonic() - begun:.1f} s"
        yield f"[{number}/{len(scenes)}] {scene.id}: {how}"
    with staged(chosen.out) as out:
        try:
            assets = write_assets(out, SITE_SOURCE)
        except BundleError as problem:
            raise SourceErrors([SourceError(SITE_SOURCE, "", str(problem))]) from None
        for scene in scenes:
            publish_scene(out / "scenes" / scene.id, scene, entries[scene.id])
        figures = {scene.id: figures_of(scene, entries[scene.id]) for scene in scenes}
        write_pages(out, SITE_SOURCE / "templates", scenes, figures, assets)
    size = sum(path.stat().st_size for path in chosen.out.rglob("*") if path.is_file())
    made = sum(not entry.was_found for entry in entries.values())
    yield (
        f"{len(scenes)} scenes: {made} traced, {len(scenes) - made} unchanged; "
        f"{size / 1e6:.1f} MB in {chosen.out}/, {time.monotonic() - started:.1f} s"
    )


def traced(scene: Scene, store: Store) -> Entry:
    """The scene's trace, found or made."""

    def make(folder: Path) -> None:
        # Only here: a build with nothing to trace never pays for numba, trimesh and Embree.
        from raywalk.products import write_products

        write_products(scene, folder)

    return store.entry(trace_key(scene), make)


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


def figures_of(scene: Scene, entry: Entry) -> Figures:
    """The numbers on a scene's page."""
    facts = json.loads((entry.folder / "facts.json").read_text(encoding="utf-8"))
    size, levels = scene.render.size, sorted(scene.render.resolutions)
    kept = sum(facts[kind] for kind in ("camera", "secondary", "shadow"))
    return [
        ("Picture", f"{size} × {size} pixels, one camera ray each"),
        ("Frustum grids", f"{len(levels)}, from {levels[0]} × {levels[0]} to {levels[-1]} × {levels[-1]}"),
        ("Rays to walk", f"{kept:,}"),
        ("of these shadow rays", f"{facts['shadow']:,}"),
        ("Most bounces on one path", f"{facts['deepest']}"),
        ("Objects and lights", f"{len(scene.objects)} and {len(scene.lights)}"),
    ]
