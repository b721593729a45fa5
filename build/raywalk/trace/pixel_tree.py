"""One pixel's ray tree as nested plain data, traced on the spot."""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Scene
from raywalk.trace.tree import LIT, Kind, Visibility
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import Tracer

NOTHING = 1e-6  # of a light's factor: less is 0 in trace files


def pixel_tree(
    scene: Scene, width: int, height: int, column: int, row: int, depth: int | None = None
) -> dict[str, Any]:
    """{"colour": linear, unclamped, "tree": the camera ray with its children}.

    A node's colour = local_weight * local + sum of weight * colour over its children; weight
    is the share in the parent, 1 for the camera ray. A ray that leaves the scene has null
    for object, t, point and normal, and the background as colour. Points without a colour of
    their own (local_weight 0: mirrors, clear glass) ask no light: their lights are [].
    """
    return tree_at(Tracer(scene, depth), row * width + column, width, height)


def tree_at(tracer: Tracer, pixel: int, width: int, height: int) -> dict[str, Any]:
    """The same of a pixel (row * width + column), by a tracer that is there."""
    [tree] = trees_at(tracer, np.array([pixel]), width, height)
    return {"colour": tree["colour"], "tree": tree}


def trees_at(tracer: Tracer, pixels: np.ndarray, width: int, height: int) -> list[dict[str, Any]]:
    """The trees of pixels (p,), in their order."""
    scene = tracer.scene
    waves = tracer.waves(pixels, width, height)
    nodes = [_nodes(tracer, wave) for wave in waves]
    for before, wave, after in zip(nodes, waves[1:], nodes[1:], strict=False):
        for parent, node in zip(wave.parent, after, strict=True):
            before[parent]["children"].append(node)
    start, t, met = tracer.compiled.crossings(waves[0].rays)
    for root, first, last in zip(nodes[0], start, start[1:], strict=False):
        root["hits"] = [
            {"object": scene.objects[who].name, "t": float(at)}
            for who, at in zip(met[first:last], t[first:last], strict=True)
        ]
    return nodes[0]


def _nodes(tracer: Tracer, wave: Wave) -> list[dict[str, Any]]:
    ends = np.where(wave.hits.object == NOWHERE, np.inf, wave.hits.t)
    tests = tracer.compiled.count_tests(wave.rays, ends).tolist()
    return [_node(tracer.scene, wave, k, tests[k]) for k in range(len(tests))]


def _node(scene: Scene, wave: Wave, k: int, tests: int) -> dict[str, Any]:
    hits, lighting = wave.hits, wave.lighting
    gone = hits.object[k] == NOWHERE
    return {
        "kind": Kind(wave.kind[k]).name.lower(),
        "object": None if gone else scene.objects[hits.object[k]].name,
        "material": None if gone else scene.materials[hits.material[k]].name,
        "origin": wave.rays.origin[k].tolist(),
        "direction": wave.rays.direction[k].tolist(),
        "t": None if gone else float(hits.t[k]),
        "point": None if gone else hits.point[k].tolist(),
        "normal": None if gone else hits.normal[k].tolist(),
        "inside": bool(hits.inside[k]),
        "tests": tests,
        "base_colour": _base(scene, wave, k),
        "weight": float(wave.weight[k]),
        "local_weight": float(lighting.local_weight[k]),
        "local": lighting.local[k].tolist(),
        "lights": [] if lighting.local_weight[k] == 0.0 else _lights(scene, wave, k),
        "colour": wave.colour[k].tolist(),
        "children": [],
    }


def _base(scene: Scene, wave: Wave, k: int) -> list[float] | None:
    """What ambient and diffuse were multiplied by; None on an object without a base colour."""
    thing = int(wave.hits.object[k])
    if wave.lighting.base is None or thing == NOWHERE or not scene.objects[thing].base:
        return None
    found: list[float] = wave.lighting.base[k].tolist()
    return found


def _lights(scene: Scene, wave: Wave, k: int) -> list[dict[str, Any]]:
    lighting, listed = wave.lighting, []
    for column, light in enumerate(scene.lights):
        seen = Visibility(lighting.visibility[k, column])
        # Without shadows nobody asked, and the surface faces away all the same; but a wide
        # highlight may reach beyond n.l = 0, and then the light counts.
        turned = bool((light.position - wave.hits.point[k]) @ wave.hits.normal[k] <= 0.0)
        turned = turned and bool(lighting.specular[k, column] < NOTHING)
        is_away = seen == Visibility.BEHIND or (seen == Visibility.UNTESTED and turned)
        # It stands in its own light.
        blocker = int(wave.hits.object[k] if is_away else lighting.blocker[k, column])
        listed.append({
            "name": light.name,
            "visible": seen in LIT and not is_away,
            "blocker": None if blocker == NOWHERE else scene.objects[blocker].name,
            "faces_away": is_away,
            "diffuse": float(lighting.diffuse[k, column]),
            "specular": float(lighting.specular[k, column]),
        })  # fmt: skip
    return listed


def as_text(answer: dict[str, Any]) -> str:
    """The tree as indented lines, a ray each."""
    lines = ["colour " + _numbers(answer["colour"])]
    pending = [(answer["tree"], 0)]
    while pending:
        node, depth = pending.pop()
        lines += [depth * "  " + line for line in _lines(node)]
        pending += [(child, depth + 1) for child in reversed(node["children"])]
    return "\n".join(lines)


def _lines(node: dict[str, Any]) -> list[str]:
    if node["object"] is None:
        return [f"{node['kind']} ray leaves the scene: colour {_numbers(node['colour'])}"]
    lines = [
        f"{node['kind']} ray hits {node['object']} at t {node['t']:.6g}, "
        f"point {_numbers(node['point'])}, normal {_numbers(node['normal'])}: "
        f"colour {_numbers(node['colour'])}, weight {node['weight']:.6g}"
    ]
    if node["base_colour"]:
        lines[0] += f", base colour {_numbers(node['base_colour'])}"
    for light in node["lights"]:
        state = "lights it" if light["visible"] else f"is blocked by {light['blocker']}"
        lines.append(
            f"  {light['name']} {'is faced away from' if light['faces_away'] else state}: "
            f"diffuse {light['diffuse']:.6g}, specular {light['specular']:.6g}"
        )
    return lines


def _numbers(values: list[float]) -> str:
    return "(" + ", ".join(f"{value:.6g}" for value in values) + ")"
