"""One scene's trace as files: pictures, trace files, facts for its page."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from PIL import Image

from raywalk.scene.model import Scene
from raywalk.scene.shapes import Mesh, Plane
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.scene_warnings import scene_warnings
from raywalk.trace.sections import sections_of
from raywalk.trace.surroundings import surroundings_of
from raywalk.trace.tally import OF_KEPT
from raywalk.trace.tree import SHOT, RayTree
from raywalk.trace.wavefront import (
    Threads,
    Traced,
    Tracer,
    in_order,
    trace_colours,
    trace_picture,
)
from raywalk.trace_file.container import write_script
from raywalk.trace_file.encode import write_level
from raywalk.trace_file.level import level_of
from raywalk.trace_file.png import write_png
from raywalk.work.progress import Report, say_nothing

if TYPE_CHECKING:
    from raywalk.geometry.base_colour import BaseColours
    from raywalk.geometry.mesh_file import Triangles

FACTS = "facts.json"
TRACING = 0.7  # of a scene's time; the rest is encoding. Only the progress bar knows this.
THUMB = 385  # pixels: a third of 1155, sharp on a card of 180 points at any density


def write_products(
    scene: Scene, folder: Path, threads: Threads, report: Report = say_nothing,
    trace: Callable[..., Traced] | None = None, ready: Sequence[Path] = (),
) -> None:  # fmt: skip
    """Traces a scene and writes picture.png, thumb.png, <n>.js, <n>.json.gz, sections.js, boxes.js
    where there is a mesh, surroundings.js where there are mirrors or glass, facts.json, display.npz
    into a folder.

    report: called with the stage and the share that is done. trace: trace_grids, or by default
    trace_picture. ready: the files that trace_grids gave, of which only the pictures are made anew.
    """
    report("reading", 0.0)
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    report("reading", 0.0)  # it is done, as said of every other stage
    if ready:
        _complete(tracer, folder, threads, report, ready)
        return
    traced = (trace or trace_picture)(
        tracer, threads, lambda share: report("tracing", TRACING * share)
    )
    # The longest first, or a thread waits at the end.
    grids = sorted(scene.render.resolutions, reverse=True)
    stages = ["picture", "sections", "surroundings", *(f"grid {n}" for n in grids)]
    works: list[Callable[[], int | None]] = [
        partial(_write_pictures, folder, traced.picture),
        partial(_write_cuts, folder, tracer),
        partial(_write_surroundings, folder, tracer),
        *(partial(_write_grid, folder, scene, traced, n) for n in grids),
    ]
    made: list[int | None] = []
    for place, rays in enumerate(in_order(lambda k: works[k](), len(works), threads)):
        made.append(rays)
        report(stages[place], TRACING + (1 - TRACING) * (place + 1) / len(works))
    drawn = write_display(folder / "display.npz", scene, tracer)
    _write_facts(folder, counts(traced.tree) | {
        "tally": traced.tally.as_dict(),
        "not_run": tracer.plan.stages_not_run,
        "finest": {"n": grids[0], "rays": made[stages.index(f"grid {grids[0]}")]},
        "triangles": sum(len(mesh.triangles.faces) for mesh in tracer.compiled.meshes),
        "drawn": drawn,
        "dropped": dropped_triangles(tracer),
        "warnings": scene_warnings(tracer),
    })  # fmt: skip


def _complete(
    tracer: Tracer, folder: Path, threads: Threads, report: Report, ready: Sequence[Path]
) -> None:
    """The picture besides grids that are ready, and what was counted over all of it."""
    picture, tally = trace_colours(
        tracer, threads, lambda share: report("tracing", TRACING * share)
    )
    _write_pictures(folder, picture)
    report("picture", 1.0)
    for path in ready:
        if not (folder / path.name).exists():
            shutil.copyfile(path, folder / path.name)
    facts = json.loads((folder / FACTS).read_text(encoding="utf-8"))
    of_kept = {name: facts["tally"][name] for name in OF_KEPT}
    _write_facts(folder, facts | {"tally": tally.as_dict() | of_kept})


def _write_facts(folder: Path, facts: dict[str, Any]) -> None:
    (folder / FACTS).write_text(json.dumps(facts, sort_keys=True), encoding="utf-8")


def _write_pictures(folder: Path, picture: np.ndarray) -> None:
    write_png(folder / "picture.png", picture)
    write_png(folder / "thumb.png", thumbnail(picture))


def _write_grid(folder: Path, scene: Scene, traced: Traced, n: int) -> int:
    """Returns how many rays it has."""
    level = level_of(traced.tree, n)
    write_level(folder, level, n, scene, traced.picture)
    return rays_of(level)


def _write_cuts(folder: Path, tracer: Tracer) -> None:
    """What the viewer draws of the geometry itself: outlines in planes, a mesh's boxes."""
    drawn = {"sections": sections_of(tracer)}
    if tracer.compiled.meshes:
        from raywalk.trace.mesh_boxes import boxes_of  # a scene without a mesh runs none of it

        drawn["boxes"] = boxes_of(tracer)
    for name, data in drawn.items():
        _write_json(folder, tracer.scene, name, data)


def _write_surroundings(folder: Path, tracer: Tracer) -> None:
    if (data := surroundings_of(tracer)) is not None:
        _write_json(folder, tracer.scene, "surroundings", data)


def _write_json(folder: Path, scene: Scene, name: str, data: dict[str, Any]) -> None:
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
    write_script(folder / f"{name}.js", f"{scene.id}/{name}", text.encode())


def thumbnail(picture: np.ndarray) -> np.ndarray:
    """The picture at most THUMB wide, each pixel the mean of those it covers."""
    side = min(THUMB, picture.shape[0])
    return np.asarray(Image.fromarray(picture).resize((side, side), Image.Resampling.BOX))


def counts(tree: RayTree) -> dict[str, Any]:
    """What was kept: pixels, rays by kind, shadow rays, tests."""
    return {
        "camera": tree.cameras,
        "secondary": len(tree.kind) - tree.cameras,
        "shadow": shadow_rays(tree),
        "deepest": int(tree.depth.max(initial=0)),
        "tests": int(tree.tests.sum()),
    }


def shadow_rays(tree: RayTree) -> int:
    """Shadow rays that were shot."""
    return int(np.isin(tree.visibility, SHOT).sum())


def rays_of(tree: RayTree) -> int:
    """Camera, reflected, refracted and total rays, and shadow rays shot."""
    return len(tree.kind) + shadow_rays(tree)


def dropped_triangles(tracer: Tracer) -> dict[str, dict[str, int]]:
    """Unusable triangles by object and reason."""
    objects = tracer.scene.objects
    return {
        objects[mesh.index].name: mesh.triangles.dropped
        for mesh in tracer.compiled.meshes
        if mesh.triangles.dropped
    }


def write_display(path: Path, scene: Scene, tracer: Tracer) -> int:
    """What the page needs of geometry: the sphere round the scene, meshes to rasterise, and objects
    with a base colour as meshes that have it. Returns how many triangles these are."""
    centre, radius = tracer.scene_sphere
    arrays: dict[str, np.ndarray] = {"centre": centre, "radius": np.array(radius)}
    for k, obj in enumerate(scene.objects):
        if obj.base and tracer.compiled.base:
            arrays |= _based_arrays(k, scene, tracer.compiled.base)
        elif isinstance(obj.shape, Mesh):
            # Only here: a scene without a mesh imports nothing that reads one.
            from raywalk.geometry.mesh_display import display_triangles

            arrays |= _mesh_arrays(k, display_triangles(scene, obj))
    np.savez(path, **arrays)  # type: ignore[arg-type]
    return sum(len(faces) for name, faces in arrays.items() if name.endswith(".faces"))


def _based_arrays(k: int, scene: Scene, base: BaseColours) -> dict[str, np.ndarray]:
    """Of an object with a base colour; `base` is its mean."""
    from raywalk.geometry.base_display import painted_mesh, painted_shape, plane_tile

    obj, arrays = scene.objects[k], {f"{k}.centre": np.zeros(3)}
    if isinstance(obj.shape, Plane):
        tile, axes = plane_tile(obj, base)
        mean = tile.reshape(-1, 3).mean(axis=0)
        return {f"{k}.tile": tile, f"{k}.tile_axes": axes, f"{k}.base": mean / 255.0}
    if isinstance(obj.shape, Mesh):
        from raywalk.geometry.mesh_display import display_triangles

        triangles = display_triangles(scene, obj)
        painted = painted_mesh(obj, base, triangles)
        arrays[f"{k}.centre"] = triangles.centre
    else:
        painted = painted_shape(obj, base)
    for name, column in painted._asdict().items():
        if column is not None:
            arrays[f"{k}.{name}"] = column
    return arrays | {f"{k}.base": painted.colours.mean(axis=0) / 255.0}


def _mesh_arrays(k: int, triangles: Triangles) -> dict[str, np.ndarray]:
    from raywalk.geometry.mesh_display import one_normal_each

    vertices, faces, normals = one_normal_each(triangles)
    arrays = {f"{k}.centre": triangles.centre, f"{k}.vertices": vertices, f"{k}.faces": faces}
    return arrays if normals is None else arrays | {f"{k}.normals": normals}
