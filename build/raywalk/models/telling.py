"""The same in sentences: one home for what the command, `check` and a build say of a model."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import Any

from raywalk.models.faults import shown

MOST = 12  # names or places in a row
CENTIMETRE = {"millimetre": 0.1, "metre": 100.0, "inch": 2.54, "centimetre": 1.0, "foot": 30.48,
              "micron": 1e-4}  # fmt: skip


def in_short(facts: dict[str, Any]) -> str:
    """A line: "two.obj, OBJ: 24 triangles, 16 corners, 2 parts, closed; 4 triangles turned"."""
    holds = [_count(facts["triangles"], "triangle"), _count(facts["vertices"], "corner")]
    for key in ("part", "material"):
        if len(facts[f"{key}s"]) > 1:
            holds.append(_count(len(facts[f"{key}s"]), key))
    edges = facts["open_edges"]["count"]
    holds.append("closed" if facts["closed"] else f"open at {_count(edges, 'edge')}")
    done = list(_done(facts))
    return f"{shown(facts['file'])}, {facts['format']}: {', '.join(holds)}" + (
        f"; {', '.join(done)}" if done else ""
    )


def _done(facts: dict[str, Any]) -> Iterator[str]:
    if facts["joined"]:
        yield f"{_count(facts['joined'], 'corner')} joined with near ones"
    if facts["turned"]:
        yield f"{_count(facts['turned'], 'triangle')} turned to face outwards"
    if facts["dropped"]:
        yield f"left out: triangles {dropped_in_words(facts['dropped'])}"


def dropped_in_words(dropped: dict[str, int]) -> str:
    """ "2 without area, 1 not finite" """
    return ", ".join(f"{count} {reason}" for reason, count in dropped.items())


def listed(names: Iterable[str]) -> str:
    """ "red, green and 3 more" """
    every = list(names)
    if len(every) > MOST:
        return f"{', '.join(every[:MOST])} and {len(every) - MOST} more"
    return " and ".join(part for part in (", ".join(every[:-1]), *every[-1:]) if part)


def warnings(facts: dict[str, Any]) -> list[str]:
    """What a person should know who put the model into a scene."""
    shells = facts["shells"]
    found = list(facts["ignored"])
    if shells["overlapping"]:
        found.append(
            f"{_count(shells['overlapping'], 'pair')} of its shells overlap, and count as one body"
        )
    if shells["too_many_to_tell"]:
        found.append(
            f"it has {shells['count']} shells, too many to tell which lie in which: each faces "
            "outwards"
        )
    return found


def in_full(facts: dict[str, Any]) -> Iterator[str]:
    """Line by line, all that `raywalk model` prints."""
    yield f"{shown(facts['file'])}: {facts['format']}"
    yield f"  triangles: {facts['triangles']:,}, on {_count(facts['vertices'], 'corner')}"
    yield f"  box: {_point(facts['box'][0])} to {_point(facts['box'][1])}"
    yield f"  size: {_sized(facts)}"
    yield from _named(facts)
    yield f"  normals: {_normals(facts)}"
    if facts["colours"]:
        yield f"  colours: of its {facts['colours']}"
    yield f"  surface: {_surface(facts)}"
    for place in facts["open_edges"]["places"][:MOST]:
        yield f"    open at {_point(place)}"
    more = facts["open_edges"]["count"] - MOST
    if more > 0:
        yield f"    and at {more} more places; --picture FILE.png draws them all"
    yield f"  cleaned: {', '.join(_done(facts)) or 'nothing was to be done'}"
    yield from (f"  note: {line}" for line in warnings(facts))
    yield from for_a_scene(facts)


def _sized(facts: dict[str, Any]) -> str:
    across = " x ".join(f"{side:.6g}" for side in facts["size"])
    unit = facts["likely_unit"]
    if not unit:
        return f"{across} of its units (the file does not say which)"
    unit = unit.replace("meter", "metre")  # as it is spelt on all pages; 3MF has the other way
    how = "as the file says" if facts["unit"] else "as such files mostly are"
    if unit not in CENTIMETRE:
        return f"{across} {unit} ({how})"
    largest = max(facts["size"]) * CENTIMETRE[unit]
    return f"{across} {unit} ({how}), {largest:.4g} cm at its longest"


def _named(facts: dict[str, Any]) -> Iterator[str]:
    for key in ("part", "material"):
        found = [each for each in facts[f"{key}s"] if each["name"]]
        if found:
            yield f"  {key}s: {len(found)}"
        for each in found[:MOST]:
            count = _count(each["triangles"], "triangle")
            yield f"    {shown(each['name'])}: {count}{_looks(each)}"
        if len(found) > MOST:
            yield f"    and {len(found) - MOST} more"


def _looks(each: dict[str, Any]) -> str:
    looks = ""
    if each.get("colour"):
        looks += f", colour {_point(each['colour'])}"
    if each.get("texture"):
        looks += f", texture {shown(each['texture'])}"
        looks += " (not there)" if each.get("texture_missing") else ""
    if each.get("opacity", 1.0) < 1.0:
        looks += f", opacity {each['opacity']:.4g}"
    return looks


def _normals(facts: dict[str, Any]) -> str:
    return {
        "own": "its own are used (smooth = false: flat faces)",
        "smoothing groups": "by its smoothing groups (smooth = false: flat faces)",
        "flat": "it has none: flat faces, as glTF has it (smooth = true: averaged, but at edges "
        "sharper than `crease`)",
        "": "it has none: averaged, but at edges sharper than `crease` (40 degrees)",
    }[facts["normals"]]


def _surface(facts: dict[str, Any]) -> str:
    shells, edges = facts["shells"], facts["open_edges"]["count"]
    said = ["closed: it may be of glass"] if facts["closed"] else [
        f"open at {_count(edges, 'edge')}: it cannot be of glass" if edges
        else "its triangles do not agree on which side is outside: it cannot be of glass"
    ]  # fmt: skip
    if shells["count"] > 1:
        said.append(f"{shells['count']} shells")
    if shells["hollows"]:
        said.append(f"{shells['hollows']} of them around hollows")
    if within := shells["within_another"]:
        lie = "lies within another, and is" if within == 1 else "lie within others, and are"
        said.append(f"{within} {lie} no border in glass")
    return ", ".join(said)


def for_a_scene(facts: dict[str, Any]) -> Iterator[str]:
    """What to write."""
    yield "  in a scene:"
    yield "    [[objects]]"
    yield '    type = "mesh"'
    yield f"    file = {_text(facts['file'])}"
    names = [each["name"] for each in (*facts["materials"], *facts["parts"]) if each["name"]]
    if facts["materials"]:
        yield "    # without `material` it is shown in the file's own materials, or dress some:"
    elif facts["colours"]:
        yield f"    # without `material` it is shown in the colours of its {facts['colours']}"
    else:
        yield '    material = "white"' + (
            '   # or "glass", as it is closed' if facts["closed"] else ""
        )
    if names:
        yield f'    # materials = {{ {_key(names[0])} = "mirror" }}'
    yield from _placed(facts)


# A scene is some 5 units wide; a model that is not of such a size and place is not seen in it.
FITTING, WANTED = (0.3, 8.0), 2.0


def _placed(facts: dict[str, Any]) -> Iterator[str]:
    """A transform for a model that would hardly be seen: of a usual size, on the ground at the
    origin."""
    if (fitted := _fitted(facts)) is None:
        return
    scale, moved = fitted
    foot = ", ".join(f"{each:.4g}" for each in moved)
    moves = f"[{{ scale = {scale!r} }}, {{ translate = [{foot}] }}]"
    yield f"    transform = {moves}   # {WANTED:g} in size, on the ground in the middle"


def _fitted(facts: dict[str, Any]) -> tuple[float, list[float]] | None:
    """How such a model is scaled, and then moved; None for one that is seen as it is."""
    (low, high), longest = facts["box"], max(facts["size"])
    centre = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    if FITTING[0] <= longest <= FITTING[1] and max(map(abs, centre)) <= longest:
        return None
    scale = float(f"{WANTED / longest:.2g}")
    return scale, [0.0 - each for each in (centre[0], low[1], centre[2])]


def box_in_scene(facts: dict[str, Any]) -> list[list[float]]:
    """The model's box after that transform: its lowest and its highest corner."""
    scale, moved = _fitted(facts) or (1.0, [0.0, 0.0, 0.0])
    return [
        [scale * (at + by) for at, by in zip(corner, moved, strict=True)] for corner in facts["box"]
    ]


def _key(name: str) -> str:
    bare = name.isascii() and name.replace("-", "").replace("_", "").isalnum()
    return name if bare else _text(name)


def _text(value: str) -> str:
    """As TOML writes it: JSON's rules are a part of its own."""
    return json.dumps(value, ensure_ascii=not value.isprintable())


def _count(number: int, word: str) -> str:
    return f"{number:,} {word}" + ("" if number == 1 else "s")


def _point(numbers: list[float]) -> str:
    return "[" + ", ".join(f"{value:.6g}" for value in numbers) + "]"
