"""Traces scenes on a Dask distributed cluster, byte for byte as on this machine.

Workers need this package in the same state, and nothing else: scenes and mesh files are sent
to them, and what they make comes back as bytes. Dask hands the work of a lost worker to others.
"""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from raywalk.errors import UserError
from raywalk.pipeline.parts import TRACE
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Mesh
from raywalk.work.maker import Parts
from raywalk.work.making import refuse_edited
from raywalk.work.pool import Finished
from raywalk.work.progress import Progress

PATIENCE = 20.0  # seconds for the scheduler to answer, and for a first worker to come
HOW = (
    "start them with .venv/bin/dask scheduler, and on each machine\n"
    "  .venv/bin/dask worker tcp://HOST:8786 --nthreads 1 --nworkers auto"
)


class ClusterError(UserError):
    """The cluster cannot be used; str() says why and what helps."""


LARGE = 4096  # pixels across: beyond, a picture is traced in strips by all workers
Files = dict[str, bytes]  # name -> content
DEEP = "a/b/c/d"


def run_on_cluster(
    address: str, scenes: Sequence[Scene]
) -> Iterator[Progress | Finished[Scene, tuple[float, Files]]]:
    """Each scene's files and the seconds they took, in the order in which they are finished: a
    scene a worker, then the large ones one after the other, each in strips over all.

    Raises ClusterError, and whatever tracing a scene raises.
    """
    client, distributed = connected(address)
    here = made_by()
    try:
        waiting = {
            client.submit(scene_there, scene, mesh_files(scene), here, pure=False): scene
            for scene in scenes
            if scene.render.size <= LARGE
        }
        for done in distributed.as_completed(waiting, loop=client.loop):
            scene = waiting.pop(done)
            yield Progress(scene.id, "", 1.0)
            yield Finished(scene, task_result(done))
        for scene in scenes:
            if scene.render.size > LARGE:
                yield Finished(scene, _in_strips(client, scene))
    finally:
        client.close()


def _in_strips(client: Any, scene: Scene) -> tuple[float, Files]:
    """Seconds and files of one scene that all workers trace; its pictures and grids are written
    here."""
    # Only here: it needs this module, and what traces.
    from raywalk.pipeline.cluster_strips import Wire, trace_there
    from raywalk.work.pool import cores

    begun = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch:
        TRACE(scene, Path(scratch), cores(), trace=partial(trace_there, client, Wire()))
        files = {path.name: path.read_bytes() for path in sorted(Path(scratch).iterdir())}
    return time.monotonic() - begun, files


def connected(address: str) -> tuple[Any, Any]:
    """A client of a scheduler that has workers, and the package. Raises ClusterError."""
    try:
        import distributed
    except ImportError:
        raise ClusterError(
            "--scheduler: the package `distributed` is not installed\n"
            '  .venv/bin/python -m pip install -e ".[cluster]"'
        ) from None
    try:
        client = distributed.Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as problem:
        raise ClusterError(
            f"--scheduler {address}: cannot be reached ({problem})\n  {HOW}"
        ) from None
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError:
        client.close()
        raise ClusterError(f"--scheduler {address}: has no workers\n  {HOW}") from None
    return client, distributed


def task_result(done: Any) -> Any:
    """What a finished task made; raises what it raised, ClusterError if its workers died."""
    import distributed

    try:
        result = done.result()
    except distributed.KilledWorker as problem:
        raise ClusterError(f"--scheduler: its workers die while tracing ({problem})") from None
    done.release()
    return result


def mesh_files(scene: Scene) -> Files:
    """The content of each mesh file of a scene, of those it needs, and of textures, by its path
    here."""
    paths = {path for obj in scene.objects for path in obj.files}
    return {str(path): path.read_bytes() for path in sorted(paths)}


def made_by() -> Parts:
    """The code and packages that trace, on this machine."""
    return TRACE.parts()


def scene_there(scene: Scene, meshes: Files, expected: Parts) -> tuple[float, Files]:
    """On a worker: seconds, and every file that a trace of the scene makes.

    Raises ClusterError if the worker's code or packages are not those of the builder: its bytes
    could be others.
    """
    refuse_other_makers(expected, made_by())
    begun = time.monotonic()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "made"
        folder.mkdir()
        TRACE(with_meshes(scene, meshes, Path(scratch)), folder, 1)
        refuse_edited({"what": "trace", "of": scene.id, **expected})
        files = {path.name: path.read_bytes() for path in sorted(folder.iterdir())}
    return time.monotonic() - begun, files


def refuse_other_makers(expected: Parts, found: Parts) -> None:
    """Raises ClusterError that names what differs."""
    other = [
        name
        for kind in ("code", "packages")
        for name in sorted({*expected[kind], *found[kind]})
        if expected[kind].get(name) != found[kind].get(name)
    ]
    if other:
        more = f" and {len(other) - 3} more" if len(other) > 3 else ""
        raise ClusterError(
            f"--scheduler: a worker runs other code than we do: {', '.join(other[:3])}{more}"
            "\n  bring its checkout and packages to the same state, and start it again"
        )


def with_meshes(scene: Scene, meshes: Files, folder: Path) -> Scene:
    """The scene with its mesh files and textures in a folder of this machine, under their own
    names, and what meshes need beside them as it was."""
    homes: dict[Path, Path] = {}

    def placed(path: Path, of: Path) -> Path:
        # Deep enough for files that lie some folders above the mesh's own.
        home = homes.setdefault(of.parent, folder / str(len(homes)) / DEEP)
        place = Path(os.path.normpath(home / os.path.relpath(path, of.parent)))
        if place.is_relative_to(folder) and not place.exists():
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(meshes[str(path)])
        return place

    def moved(obj: SceneObject) -> SceneObject:
        shape, base = obj.shape, obj.base
        if isinstance(shape, Mesh):
            beside = tuple(placed(path, shape.path) for path in shape.beside)
            shape = replace(shape, path=placed(shape.path, shape.path), beside=beside)
        if base and base.texture:
            path = base.texture.path
            base = replace(base, texture=replace(base.texture, path=placed(path, path)))
        return replace(obj, shape=shape, base=base)

    return replace(scene, objects=tuple(moved(obj) for obj in scene.objects))
