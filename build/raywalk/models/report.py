"""What a model file holds and what was done to it, as data: for the command, checks and JSON."""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.models.clean import Cleaned
from raywalk.models.model import FileMaterial

PLACES = 20  # of open edges that are reported
# What files of a format mostly are measured in, where they do not say it.
USUAL = {"STL": "millimetre", "3MF": "millimetre"}


def report(cleaned: Cleaned) -> dict[str, Any]:
    """Plain values, which JSON can write. Lengths are in the file's own units."""
    model, shape = cleaned.model, cleaned.shape
    places = _open_places(cleaned)
    corners = cleaned.vertices[_used(cleaned)]
    low, high = corners.min(axis=0), corners.max(axis=0)
    return {
        "file": model.path.name,
        "format": model.format,
        "triangles": len(cleaned.faces),
        "vertices": len(corners),
        "box": [low.tolist(), high.tolist()],
        "size": (high - low).tolist(),
        "unit": model.unit,
        "likely_unit": model.unit or next(
            (unit for name, unit in USUAL.items() if name in model.format), ""
        ),
        "parts": _parts(cleaned),
        "materials": _materials(cleaned),
        "normals": "own" if model.normals else "smoothing groups" if model.smoothing is not None
        else "flat" if model.flat else "",
        "colours": model.colours_of,
        "closed": shape.closed,
        "open_edges": {"count": len(places), "places": places[:PLACES].tolist()},
        "shells": {
            "count": len(shape.shells),
            "hollows": sum(shell.is_hollow for shell in shape.shells),
            "within_another": sum(s.within >= 0 and not s.is_hollow for s in shape.shells),
            "overlapping": len(shape.overlapping),
            "too_many_to_tell": shape.is_unknown,
        },
        "joined": cleaned.joined,
        "turned": int(cleaned.turned.sum()),
        "dropped": cleaned.dropped,
        "ignored": list(model.ignored),
    }  # fmt: skip


def _used(cleaned: Cleaned) -> np.ndarray:
    """(v,) bool: corners of triangles."""
    used = np.zeros(len(cleaned.vertices), bool)
    used[cleaned.faces] = True
    return used


def _open_places(cleaned: Cleaned) -> np.ndarray:
    """(k, 3) middles of open edges, by place."""
    middle = np.round(cleaned.open_edges.mean(axis=1), 9) + 0.0
    return np.asarray(middle[np.lexsort(middle.T)])


def _parts(cleaned: Cleaned) -> list[dict[str, Any]]:
    model = cleaned.model
    if model.part is None:
        return [{"name": model.parts[0], "triangles": len(cleaned.faces)}]
    counts = np.bincount(model.part[cleaned.source], minlength=len(model.parts))
    return [
        {"name": name, "triangles": int(count)}
        for name, count in zip(model.parts, counts.tolist(), strict=True)
        if count
    ]


def _materials(cleaned: Cleaned) -> list[dict[str, Any]]:
    model = cleaned.model
    of = model.material_of()[cleaned.source]
    return [
        {
            "name": each.name,
            "colour": None if each.diffuse is None else list(each.diffuse),
            "opacity": each.opacity,
            "texture": _texture_of(each),
            "texture_missing": _lacks_texture(each),
            "triangles": int((of == k).sum()),
        }
        for k, each in enumerate(model.materials)
    ]


def _lacks_texture(material: FileMaterial) -> bool:
    """Whether it names a picture's file that is not there."""
    file = material.texture if material.texture_inside < 0 else None
    try:
        return file is not None and not file.is_file()
    except (OSError, ValueError):
        return True


def _texture_of(material: FileMaterial) -> str | None:
    if material.texture is None:
        return None
    inside = material.texture_inside
    return material.texture.name if inside < 0 else f"picture {inside} in the file itself"
