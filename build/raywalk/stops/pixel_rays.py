"""One pixel's ray tree out of a trace file, for people and for programs."""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.stops.decoded import DecodedTrace
from raywalk.trace.tree import LIT, Kind, Visibility

PLAIN = ("kind", "depth", "t", "weight", "localWeight", "tests", "point", "normal", "colour")


def as_json(trace: DecodedTrace, pixel: tuple[int, int]) -> dict[str, Any]:
    """Every column of every ray of one pixel (column, row from the top left), nested by parent.

    Numbers as they are stored; names stand beside indices. A ray that leaves has t null. Raises
    ValueError for a pixel outside.
    """
    column, row = pixel
    n, header = trace.n, trace.header
    if not (0 <= column < n and 0 <= row < n):
        raise ValueError(f"pixel {column},{row} is outside of 0..{n - 1}")
    camera = row * n + column
    rows = np.flatnonzero(trace.pixel == camera).tolist()
    nodes = {k: _ray(trace, k) for k in rows}
    for k in rows[1:]:
        nodes[int(trace.parent[k])]["children"].append(nodes[k])
    hits = slice(int(trace.hitsStart[camera]), int(trace.hitsStart[camera + 1]))
    met = zip(trace.hitsObject[hits].tolist(), trace.hitsT[hits].tolist(), strict=True)
    return {
        "scene": header["scene"], "n": n, "pixel": [column, row], "errors": header["errors"],
        "tile": trace.tiles[3 * camera : 3 * camera + 3].tolist(),
        "hits": [
            {"object": int(thing), "name": header["objects"][thing], "t": t} for thing, t in met
        ],
        "tree": nodes[camera],
    }  # fmt: skip


def _ray(trace: DecodedTrace, k: int) -> dict[str, Any]:
    header = trace.header
    thing, material = int(trace.object[k]), int(trace.material[k])
    ray: dict[str, Any] = {"row": k, "parent": int(trace.parent[k])}
    ray |= {name: getattr(trace, name)[k].tolist() for name in PLAIN}
    ray["kind"] = Kind(ray["kind"]).name.lower()
    ray["t"] = ray["t"] if thing >= 0 else None
    ray["object"], ray["objectName"] = thing, header["objects"][thing] if thing >= 0 else None
    ray["material"] = material
    ray["materialName"] = header["materials"][material]["name"] if material >= 0 else None
    ray["inside"] = bool(trace.inside[k])
    based = {patch["object"] for patch in header["patches"] if "base" in patch}
    ray["baseColour"] = trace.base[k].tolist() if thing in based else None
    ray["lights"] = [_light(trace, k, l) for l in range(len(header["lights"]))]
    ray["children"] = []
    return ray


def _light(trace: DecodedTrace, k: int, l: int) -> dict[str, Any]:
    blocker = int(trace.blocker[k, l])
    return {
        "name": trace.header["lights"][l]["name"],
        "visibility": Visibility(int(trace.visibility[k, l])).name.lower(),
        "facesAway": _faces_away(trace, k, l),
        "blocker": blocker,
        "blockerName": trace.header["objects"][blocker] if blocker >= 0 else None,
        "blockedAt": float(trace.blockedAt[k, l]),
        "diffuse": float(trace.diffuse[k, l]),
        "specular": float(trace.specular[k, l]),
    }


def _faces_away(trace: DecodedTrace, k: int, l: int) -> bool:
    """Where no shadows are asked for, the stored factors tell: a surface that faces a light gets
    some of it."""
    seen, factors = int(trace.visibility[k, l]), (trace.diffuse[k, l], trace.specular[k, l])
    return seen == Visibility.BEHIND or (seen == Visibility.UNTESTED and not any(factors))


def describe(trace: DecodedTrace, pixel: tuple[int, int]) -> str:
    """The same as indented text, three decimals as on the ray card."""
    found = as_json(trace, pixel)
    lines = [
        f"{found['scene']} at {found['n']} x {found['n']}, pixel {pixel[0]},{pixel[1]}: "
        f"tile colour {' '.join(map(str, found['tile']))} of 255"
    ]
    lines += _hit_lines(found["hits"])
    pending = [(found["tree"], 0)]
    while pending:
        ray, depth = pending.pop()
        lines += ["  " * depth + line for line in _ray_lines(ray, trace.header)]
        pending += [(child, depth + 1) for child in reversed(ray["children"])]
    return "\n".join(lines)


def _hit_lines(hits: list[dict[str, Any]]) -> list[str]:
    if not hits:
        return ["hits along the camera ray: none"]
    marks = ["  <- nearest", *[""] * (len(hits) - 1)]
    listed = [
        f"  t {hit['t']:.3f}  {hit['name']}{mark}" for hit, mark in zip(hits, marks, strict=True)
    ]
    return ["hits along the camera ray:", *listed]


def _ray_lines(ray: dict[str, Any], header: dict[str, Any]) -> list[str]:
    share = f", weight {ray['weight']:.3f}" if ray["parent"] >= 0 else ""
    if ray["object"] < 0:
        return [f"{ray['kind']} ray leaves the scene{share}, colour {_three(ray['colour'])}"]
    side = " from inside" if ray["inside"] else ""
    lines = [
        f"{ray['kind']} ray meets {ray['objectName']} ({ray['materialName']}){side}{share}",
        f"  t {ray['t']:.3f}  point {_three(ray['point'])}  normal {_three(ray['normal'])}"
        f"  tests {ray['tests']}",
    ]
    if ray["baseColour"]:
        lines.append(f"  base colour {_three(ray['baseColour'])}")
    if ray["localWeight"] > 0:
        lines += [_light_line(light) for light in ray["lights"]]
    return [*lines, _sum_line(ray, header)]


def _light_line(light: dict[str, Any]) -> str:
    state = {
        "blocked": f"blocked by {light['blockerName']} at {light['blockedAt']:.3f} of the way",
        "reached": "visible",
        "behind": "behind the surface",
        "untested": "lit without a shadow ray",
    }["behind" if light["facesAway"] else light["visibility"]]
    return (
        f"  {light['name']}: {state}, "
        f"diffuse {light['diffuse']:.3f}, specular {light['specular']:.3f}"
    )


def _sum_line(ray: dict[str, Any], header: dict[str, Any]) -> str:
    """colour = local weight x local + each child's weight x colour."""
    parts = []
    if ray["localWeight"] > 0:
        parts.append(f"{ray['localWeight']:.3f} x local {_three(_local(ray, header))}")
    parts += [f"{c['weight']:.3f} x {c['kind']} {_three(c['colour'])}" for c in ray["children"]]
    return f"  colour {_three(ray['colour'])} = {' + '.join(parts) or 'nothing sent on'}"


def _local(ray: dict[str, Any], header: dict[str, Any]) -> list[float]:
    material, base = header["materials"][ray["material"]], ray["baseColour"] or [1.0] * 3
    local = [ambient * base[c] for c, ambient in enumerate(material["ambient"])]
    for light, table in zip(ray["lights"], header["lights"], strict=True):
        if Visibility[light["visibility"].upper()] in LIT:
            for c in range(3):
                term = light["diffuse"] * (material["diffuse"][c] * base[c])
                term += light["specular"] * material["specular"][c]
                local[c] += term * table["colour"][c]
    return local


def _three(values: list[float]) -> str:
    return "(" + ", ".join(f"{value + 0.0:.3f}" for value in values) + ")"
