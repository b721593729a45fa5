"""Meshes that were made ready for ray queries, kept for scenes that have them again: where an
author changes a colour, or slides show what was just traced, reading them is most of the wait."""

from __future__ import annotations

from collections import OrderedDict
from threading import Lock

from raywalk.geometry.mesh_file import load_triangles
from raywalk.geometry.mesh_target import MeshTarget
from raywalk.scene.model import Scene, SceneObject

MOST = 100_000  # triangles, about 100 MB: ours fit, and nobody's large scan stays in memory

_kept: OrderedDict[str, MeshTarget] = OrderedDict()
_lock = Lock()


def mesh_target(scene: Scene, index: int, glass: bool) -> MeshTarget:
    """That of scene.objects[index], which nothing of the scene but the object decides. Raises
    SourceErrors if its file is unusable."""
    obj = scene.objects[index]
    key = _made_from(obj, index, glass)
    with _lock:
        if key and key in _kept:
            _kept.move_to_end(key)
            return _kept[key]
    target = MeshTarget(index, load_triangles(scene, obj), glass)
    if key:
        _keep(key, target)
    return target


def _made_from(obj: SceneObject, index: int, glass: bool) -> str | None:
    """All that decides on a target; None where a file's state cannot be told."""
    try:
        states = [path.stat() for path in obj.files]
    except (OSError, ValueError):
        return None
    files = [(state.st_mtime_ns, state.st_size) for state in states]
    return repr((index, glass, obj.shape, obj.transform.tolist(), obj.base, files))


def _keep(key: str, target: MeshTarget) -> None:
    """What was used longest ago makes room."""
    with _lock:
        _kept[key] = target
        while sum(len(each.triangles.faces) for each in _kept.values()) > MOST:
            _kept.popitem(last=False)
