"""From [[sweeps]] to stops: for each value the scene that has it, read as if its file said so."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from copy import deepcopy
from dataclasses import dataclass, replace
from math import isclose
from typing import Any

from raywalk.scene.address import address_of
from raywalk.scene.checks import check_names
from raywalk.scene.compile import compile_scene, light_names, object_names
from raywalk.scene.draft import Draft, read_tables
from raywalk.scene.lesson_text import PICTURES
from raywalk.scene.model import Scene, Sweep
from raywalk.scene.models import Models
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema_sweeps import CLEAN, SweepTable
from raywalk.scene.shapes import Plane
from raywalk.scene.wording import did_you_mean, joined, quoted, show

VARIED = ("camera", "lights", "materials", "objects", "render")
WORDS = ("lesson", "goals", "sweeps")  # of the file: no stop has any
GRIDS = (15, 33)  # whose rays a stop has, where its sweep does not say
NEAR = 10.0**-CLEAN  # a stop so close to the scene's own value is that

Path = list[str | int]


@dataclass(frozen=True)
class _Plan:
    """A sweep whose value was found in the file."""

    place: int  # among the sweeps
    table: SweepTable
    path: Path
    values: list[Any]
    own: int


def read_sweeps(
    scene: Scene | None, raw: dict[str, Any], draft: Draft, models: Models, problems: Problems
) -> tuple[Sweep, ...]:
    """A scene's sweeps; their problems are noted, those of their stops if the scene is sound."""
    check_names(((i, each.name) for i, each in draft.sweeps.items()), "sweeps", problems)
    _check_addresses(draft, problems)
    plans = [_plan(i, table, raw, draft, problems) for i, table in draft.sweeps.items()]
    if scene is None:
        return ()
    found = [_swept(each, scene, raw, models, problems) for each in plans if each]
    return tuple(each for each in found if each)


def _check_addresses(draft: Draft, problems: Problems) -> None:
    """Names that differ in spaces only are one in a page's address, those that differ in capitals
    one folder on some disks; beside it stands that of a lesson's pictures."""
    first: dict[str, str] = {PICTURES: "the folder of a lesson's pictures"}
    for i, table in draft.sweeps.items():
        other = first.setdefault(address_of(table.name).lower(), table.name)
        if other != table.name:
            message = f"has the address {quoted(address_of(table.name))} that {quoted(other)} has"
            problems.add(("sweeps", i, "name"), message)


def _plan(
    i: int, table: SweepTable, raw: dict[str, Any], draft: Draft, problems: Problems
) -> _Plan | None:
    at = ("sweeps", i, "varies")
    path = _path(table.varies, raw, draft, at, problems)
    if path is None:
        return None
    own, values = _at(raw, path), table.all_values()
    near = next((k for k, value in enumerate(values) if _is_same(value, own)), None)
    if near is None:
        problems.add(
            ("sweeps", i), f"the scene's own value, {show(own)}, is none of its {table.said()}",
            allowed=f"its stops: {joined(map(show, map(_listed, values)))}",
            hint="choose them so that one is the scene as it is",
        )  # fmt: skip
        return None
    return _Plan(i, table, path, [*values[:near], own, *values[near + 1 :]], near)


def _is_same(value: Any, own: Any) -> bool:
    if isinstance(value, Sequence) or isinstance(own, Sequence):
        both = isinstance(value, Sequence) and isinstance(own, Sequence)
        return both and len(value) == len(own) and all(map(_is_same, value, own))
    return isclose(value, own, rel_tol=NEAR, abs_tol=NEAR)


def _listed(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _path(
    varies: str, raw: dict[str, Any], draft: Draft, at: Location, problems: Problems
) -> Path | None:
    """Where in the file the value stands; None, with the problem noted, if it is not there."""
    keys = _keys(varies)
    if keys is None or len(keys) < 2 or keys[0] not in VARIED:
        problems.add(
            at, f"{quoted(varies)} is no key whose value may change",
            allowed=f"allowed: one below {joined(VARIED)}",
            hint='write it as lights."light 1".position, or camera.fov',
        )  # fmt: skip
        return None
    path: Path = [keys[0]]
    known = {"lights": light_names(draft), "objects": object_names(draft)}.get(keys[0])
    if known is not None and keys[1] not in known.values():
        if not known or any(e.key.startswith(keys[0]) for e in problems.errors):
            return None  # its table may be one of those that could not be read
        problems.add(
            at, f"there is no {quoted(keys[1])} in {keys[0]}",
            allowed=f"known: {joined(map(quoted, known.values()))}",
            hint=did_you_mean(keys[1], known.values()),
        )  # fmt: skip
        return None
    if known is not None:
        path.append(next(place for place, name in known.items() if name == keys[1]))
    return _walk(varies, raw, path, keys[len(path) :], at, problems)


def _keys(varies: str) -> list[str] | None:
    """A dotted key as TOML reads it."""
    try:
        table: Any = tomllib.loads(f"{varies} = 0")
    except tomllib.TOMLDecodeError:
        return None
    keys = []
    while isinstance(table, dict):
        if len(table) != 1:
            return None
        [(key, table)] = table.items()
        keys.append(key)
    return keys if table == 0 else None


def _walk(
    varies: str, raw: dict[str, Any], path: Path, rest: list[str], at: Location, problems: Problems
) -> Path | None:  # fmt: skip
    """The whole path, through tables and lists, to a number or a list of numbers."""
    here: Any = _at(raw, path)
    for key in rest:
        if isinstance(here, dict) and key in here:
            step: str | int = key
        elif isinstance(here, list) and key.isdecimal() and int(key) < len(here):
            step = int(key)
        else:
            known = list(here) if isinstance(here, dict) else []
            problems.add(
                at, f"{quoted(varies)}: the file gives no {quoted(key)} there",
                allowed=f"there: {joined(known)}" if known else "",
                hint=did_you_mean(key, known)
                or "write the scene's own value there: it is one of the stops",
            )  # fmt: skip
            return None
        path, here = [*path, step], here[step]
    if not _is_number(here) and not (
        isinstance(here, list) and here and all(map(_is_number, here))
    ):
        problems.add(at, f"{quoted(varies)} is {show(here)}: neither a number nor a list of them")
        return None
    return path


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _at(raw: Any, path: Path) -> Any:
    for key in path:
        raw = raw[key]
    return raw


def _swept(
    plan: _Plan, scene: Scene, raw: dict[str, Any], models: Models, problems: Problems
) -> Sweep | None:
    """The sweep with all its stops; None, with the first stop's problems noted that has some."""
    table, at = plan.table, ("sweeps", plan.place)
    grids = tuple(sorted(table.resolutions or {*GRIDS} & {*scene.render.resolutions}))
    if not grids or not {*grids} <= {*scene.render.resolutions}:
        problems.add(
            (*at, "resolutions"),
            "none of 15 and 33 is" if not grids else f"{show(list(grids))} are not all",
            allowed=f"one of the scene's: {joined(map(str, scene.render.resolutions))}",
        )  # fmt: skip
        return None
    stops: list[Scene] = []
    for k, value in enumerate(plan.values):
        own = Problems(problems.file)
        stop = _stop(raw, plan.path, value, models, own)
        for error in own.errors:
            said = f"at stop {k + 1}, {show(_listed(value))}: {error.key}: {error.message}"
            problems.add(at, said, allowed=error.allowed, hint=error.hint)
        if stop is None or own.errors or not _is_like(stop, scene, k, at, problems):
            return None
        stops.append(stop)
    values = tuple(tuple(each) if isinstance(each, list) else each for each in plan.values)
    return Sweep(
        address_of(table.name), table.name, table.varies, values, plan.own, grids, tuple(stops)
    )


def _is_like(stop: Scene, scene: Scene, k: int, at: Location, problems: Problems) -> bool:
    """Whether it has as much of everything as the scene: what is there moves, nothing comes."""
    for what in ("objects", "lights", "materials"):
        there, here = len(getattr(stop, what)), len(getattr(scene, what))
        if there != here:
            message = f"at stop {k + 1} the scene has {there} {what}, not {here}"
            problems.add(at, message, hint="a slider moves and changes what is there")
            return False
    own = _drawn_once(scene)
    for what, there in _drawn_once(stop).items():
        if there != own[what]:
            problems.add(
                (*at, "varies"), f"at stop {k + 1} {what} is other, which the page draws once",
                allowed="what moves: the camera, lamps' positions and intensities, all objects "
                "but planes; and a material's ior, render.depth",
            )  # fmt: skip
            return False
    return True


def _drawn_once(scene: Scene) -> dict[str, Any]:
    """By its name, what the page's stage draws the same at every stop."""
    drawn: dict[str, Any] = {"the background": scene.background}
    for material in scene.materials:
        drawn[f"the material {quoted(material.name)}"] = replace(material, ior=1.0)
    for light in scene.lights:
        drawn[f"the colour of {quoted(light.name)}"] = light.colour, light.attenuation
    for obj in scene.objects:
        fixed = obj.shape.drawn(), obj.material, obj.checker, obj.base
        is_plane = isinstance(obj.shape, Plane)
        drawn[quoted(obj.name)] = (*fixed, obj.shape, obj.transform.tolist()) if is_plane else fixed
    return drawn


def _stop(
    raw: dict[str, Any], path: Path, value: Any, models: Models, problems: Problems
) -> Scene | None:
    """The scene with this value, as if its file had it."""
    changed = deepcopy({key: part for key, part in raw.items() if key not in WORDS})
    table = _at(changed, path[:-1])
    table[path[-1]] = _listed(value)
    whole, draft = read_tables(changed, problems)
    return compile_scene(whole, draft, models, problems)
