"""From [[sweeps]] to stops: for each value the scene that has it, read as if its file said so."""

from __future__ import annotations

from collections.abc import Sequence
from copy import deepcopy
from dataclasses import dataclass
from math import isclose
from typing import Any

import numpy as np

from raywalk.scene.address import address_of
from raywalk.scene.checks import check_names
from raywalk.scene.compile import compile_scene
from raywalk.scene.draft import Draft, read_tables
from raywalk.scene.fields import AxisName
from raywalk.scene.lesson_text import PICTURES
from raywalk.scene.model import Across, Scene, SceneObject, Sweep
from raywalk.scene.models import Models
from raywalk.scene.problems import Location, Problems
from raywalk.scene.resolutions import fits
from raywalk.scene.schema_sweeps import CLEAN, PICTURE, SteppedTable, SweepTable
from raywalk.scene.schema_transforms import RotateTable, TransformTable
from raywalk.scene.shapes import Plane
from raywalk.scene.transforms import step_matrix
from raywalk.scene.varied_keys import Path, path_of, value_at
from raywalk.scene.wording import joined, quoted, show

WORDS = ("lesson", "goals", "sweeps")  # of the file: no stop has any
SPACE = 3  # numbers of a place
DEGREES = ("degrees", "fov")  # keys whose numbers are
NEAR = 10.0**-CLEAN  # a stop so close to the scene's own value is that


@dataclass(frozen=True)
class _Axis:
    """A key that was found in the file, and its values: of a grid's columns, or of its rows."""

    varies: str
    path: Path
    values: list[Any]
    own: int  # which of them is the scene's
    puts: list[Any]  # what the file has at each: the value, or the place that it turns to
    is_turned: bool  # whether its values are degrees


@dataclass(frozen=True)
class _Plan:
    place: int  # among the sweeps
    table: SweepTable
    columns: _Axis
    rows: _Axis | None = None

    @property
    def own(self) -> int:
        """The stop that is the scene itself."""
        row = self.rows.own if self.rows else 0
        return row * len(self.columns.values) + self.columns.own

    def stops(self) -> list[list[tuple[Path, Any]]]:
        """What is put where at each stop, row by row."""
        columns = [[(self.columns.path, each)] for each in self.columns.puts]
        if self.rows is None:
            return columns
        return [[*each, (self.rows.path, row)] for row in self.rows.puts for each in columns]


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
    columns = _axis(table, ("sweeps", i), raw, draft, problems)
    if table.across is None:
        return _Plan(i, table, columns) if columns else None
    at = ("sweeps", i, "across")
    rows = _axis(table.across, at, raw, draft, problems)
    if columns is None or rows is None:
        return None
    if all(one == other for one, other in zip(columns.path, rows.path, strict=False)):
        message = f"{quoted(rows.varies)} changes with {quoted(columns.varies)} already"
        problems.add((*at, "varies"), message, hint="cross it with a key that it leaves as it is")
        return None
    return _Plan(i, table, columns, rows)


def _axis(
    table: SteppedTable, at: Location, raw: dict[str, Any], draft: Draft, problems: Problems
) -> _Axis | None:
    path = path_of(table.varies, raw, draft, (*at, "varies"), problems)
    if path is None:
        return None
    here, values = value_at(raw, path), table.all_values()
    if table.about and not (isinstance(here, list) and len(here) == SPACE):
        problems.add((*at, "about"), f"{quoted(table.varies)} is no place: {show(here)}")
        return None
    if table.about and list(table.about) == here:
        problems.add((*at, "about"), f"{show(here)} is the place itself: it would not move")
        return None
    own = 0 if table.about else here
    near = next((k for k, value in enumerate(values) if _is_same(value, own)), None)
    if near is None:
        problems.add(
            at, f"the scene's own value, {show(own)}, is none of its {table.said()}",
            allowed=f"its stops: {joined(map(show, map(_listed, values)))}",
            hint="choose them so that one is the scene as it is",
        )  # fmt: skip
        return None
    values[near] = own
    puts = [*values]
    if table.about:
        puts = [_turned(here, table.about, table.axis or "y", each) for each in values]
        puts[near] = here
    return _Axis(
        table.varies, path, values, near, puts, bool(table.about) or path[-1] in DEGREES
    )  # fmt: skip


def _turned(
    place: Sequence[float], about: Sequence[float], axis: AxisName, degrees: float
) -> list[float]:
    """A place on its circle round an axis through `about`, right-handed; without a last digit that
    nobody would write."""
    turn = step_matrix(TransformTable(rotate=RotateTable(axis=axis, degrees=degrees)))[:3, :3]
    away = np.subtract(place, about)
    return [round(float(each), CLEAN) for each in np.add(about, turn @ away)]


def _is_same(value: Any, own: Any) -> bool:
    if isinstance(value, Sequence) or isinstance(own, Sequence):
        both = isinstance(value, Sequence) and isinstance(own, Sequence)
        return both and len(value) == len(own) and all(map(_is_same, value, own))
    return isclose(value, own, rel_tol=NEAR, abs_tol=NEAR)


def _listed(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _swept(
    plan: _Plan, scene: Scene, raw: dict[str, Any], models: Models, problems: Problems
) -> Sweep | None:
    """The sweep with all its stops; None, with the first stop's problems noted that has some."""
    table, at = plan.table, ("sweeps", plan.place)
    grids = table.grids(scene.render.resolutions)
    if not grids or not {*grids} <= {*scene.render.resolutions}:
        problems.add(
            (*at, "resolutions"),
            "none of 15 and 33 is" if not grids else f"{show(list(grids))} are not all",
            allowed=f"one of the scene's: {joined(map(str, scene.render.resolutions))}",
        )  # fmt: skip
        return None
    side = _picture_side(table, scene.render.size, at, problems)
    if side is None:
        return None
    stops: list[Scene] = []
    for k, settings in enumerate(plan.stops()):
        own = Problems(problems.file)
        stop = _stop(raw, settings, models, own)
        for error in own.errors:
            values = " and ".join(show(_listed(value)) for _, value in settings)
            said = f"at stop {k + 1}, {values}: {error.key}: {error.message}"
            problems.add(at, said, allowed=error.allowed, hint=error.hint)
        if stop is None or own.errors or not _is_like(stop, scene, k, at, problems):
            return None
        stops.append(stop)
    return Sweep(
        address_of(table.name), table.name, table.varies, _frozen(plan.columns), plan.own, grids,
        side, tuple(stops), _across(plan), plan.columns.is_turned,
    )  # fmt: skip


def _picture_side(table: SweepTable, size: int, at: Location, problems: Problems) -> int | None:
    if table.picture is None:
        return picture_side(size)
    if fits(table.picture, size):
        return table.picture
    problems.add(
        (*at, "picture"), f"{table.picture} x {table.picture} pixels are none of the picture's",
        allowed=f"allowed: {joined(map(str, _sides(size)))}",
    )  # fmt: skip
    return None


def picture_side(size: int) -> int:
    """The most pixels across, up to PICTURE, that are pixels of a picture of this size: all of it
    where there are no such."""
    near = [side for side in _sides(size) if side <= PICTURE <= 3 * side]
    return max(near, default=size)


def _sides(size: int) -> list[int]:
    return [side for side in range(1, size + 1) if fits(side, size)]


def _across(plan: _Plan) -> Across | None:
    if plan.rows is None or plan.table.across is None:
        return None
    name, rows = plan.table.across.name or "", plan.rows
    return Across(name, rows.varies, _frozen(rows), rows.is_turned)


def _frozen(axis: _Axis) -> tuple[Any, ...]:
    return tuple(tuple(each) if isinstance(each, list) else each for each in axis.values)


def _is_like(stop: Scene, scene: Scene, k: int, at: Location, problems: Problems) -> bool:
    """Whether what the page draws from files is the scene's there. As many of everything there are:
    no number that a file gives makes an object, and a lamp's points are one lamp."""
    for obj, own in zip(stop.objects, scene.objects, strict=True):
        if _filed(obj) != _filed(own):
            message = f"changes {quoted(obj.name)}, at stop {k + 1}: its texture is drawn once"
            hint = "move or colour an object without a texture"
            problems.add((*at, "varies"), message, hint=hint)
            return False
    return True


def _filed(obj: SceneObject) -> Any:
    """What the page's stage has of an object's texture: which, and of a plane where it lies."""
    is_laid = obj.base is not None and isinstance(obj.shape, Plane)
    return obj.base, (obj.shape, obj.transform.tolist()) if is_laid else None


def _stop(
    raw: dict[str, Any], settings: list[tuple[Path, Any]], models: Models, problems: Problems
) -> Scene | None:
    """The scene with these values, as if its file had them."""
    changed = deepcopy({key: part for key, part in raw.items() if key not in WORDS})
    for path, value in settings:
        table = value_at(changed, path[:-1])
        table[path[-1]] = _listed(value)
    whole, draft = read_tables(changed, problems)
    return compile_scene(whole, draft, models, problems)
