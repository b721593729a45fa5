"""Named materials: the built-in ones, and a scene's own with what they inherit."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from raywalk.scene.model import Material, Texture
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema_objects import MaterialTable
from raywalk.scene.textures import check_texture, texture_of
from raywalk.scene.wording import did_you_mean, joined, plain, quoted

# All glassy ones split by Fresnel and scatter nothing: what is not mirrored goes through.
_CLEAR: dict[str, Any] = {"transmit": 1.0, "fresnel": True}

BUILT_IN: dict[str, MaterialTable] = {
    # The course's plastic: diffuse is to be given, everything else is the same for all colours.
    "coloured": MaterialTable(
        ambient=(0.1, 0.1, 0.1), diffuse=(1, 1, 1), specular=(1, 1, 0.5), shininess=100
    ),
    # The course's chalk: no highlight.
    "white": MaterialTable(ambient=(0.1, 0.1, 0.1), diffuse=(1, 1, 1), specular=(0, 0, 0)),
    # An ideal mirror has no colour of its own.
    "mirror": MaterialTable(reflect=1.0),
    # Schott N-BK7 crown glass, n_d = 1.5168 at 587.6 nm (Schott data sheet).
    "glass": MaterialTable(ior=1.5168, **_CLEAR),
    # Water at 20 C, n_D = 1.333 at 589 nm (IAPWS R9-97).
    "water": MaterialTable(ior=1.333, **_CLEAR),
    # Diamond, n_D = 2.417 at 589 nm (CRC Handbook of Chemistry and Physics).
    "diamond": MaterialTable(ior=2.417, **_CLEAR),
}


# Likenesses are sought for so many unknown names: each is compared with all that are known.
MOST_HINTS = 10
CIRCLE = 12  # names that are listed of a circle


class Dressed(NamedTuple):
    """What an object is dressed in."""

    material: Material
    texture: Texture | None = None


class Materials:
    """Looks up materials by name and notes once what is wrong with each.

    A scene's own material hides a built-in one of the same name.

    own: a scene's [materials.*]; None for a table that was refused already.
    """

    def __init__(self, own: Mapping[str, MaterialTable | None], problems: Problems):
        self._own = own
        self._problems = problems
        self._finished: dict[str, Dressed | None] = {}
        self._inherited: dict[str, dict[str, Any]] = {}  # all keys of own materials, once followed
        self._endless: set[str] = set()  # those that inherit from a circle that was told
        self._unknown = 0
        for name in own:
            self._finished[name] = self._read_own(name)

    def find(self, name: str, at: Location) -> Dressed | None:
        """The material of that name; None, with the problem noted, if there is none."""
        if name in self._finished:
            return self._finished[name]
        if name in BUILT_IN:
            return _finish(name, _given(BUILT_IN[name]), self._problems.file.parent)
        self._note_unknown(name, at)
        return None

    def inline(self, table: MaterialTable, name: str, at: Location) -> Dressed | None:
        """A material given in place, with a name for people to read."""
        keys = self._with_inherited(table, at)
        return None if keys is None else self._checked(name, keys, table, at)

    def _read_own(self, name: str) -> Dressed | None:
        at = ("materials", name)
        table = self._own[name]
        keys = None if table is None else self._with_inherited(table, at, name)
        return None if keys is None or table is None else self._checked(name, keys, table, at)

    def _with_inherited(
        self, table: MaterialTable, at: Location, own_name: str = ""
    ) -> dict[str, Any] | None:
        """The table's keys over those it inherits; None where the chain is broken."""
        chain, passed, current = [own_name], {own_name: table}, table
        base: dict[str, Any] = {}
        while current.like is not None:
            name = current.like
            if name == chain[-1] and name in BUILT_IN:  # an own "glass" may build on the built-in
                base = _given(BUILT_IN[name])
                break
            if name in self._endless:
                return None
            if name in passed:
                self._note_circle(chain[chain.index(name) :])
                self._endless.update(chain)
                return None
            if name in self._inherited:  # followed before, to its end
                base = self._inherited[name]
                break
            parent = self._own.get(name, BUILT_IN.get(name))
            if parent is None:
                if current is table and name not in self._own:
                    self._note_unknown(name, (*at, "like"))
                return None
            chain.append(name)
            passed[name] = current = parent
        for name in reversed(chain):
            base = base | _given(passed[name])
            if self._own.get(name) is passed[name]:
                self._inherited[name] = base
        return base

    def _checked(
        self, name: str, keys: dict[str, Any], table: MaterialTable, at: Location
    ) -> Dressed | None:
        """The material, if light is neither lost nor won there, and its texture is there."""
        # What is wrong with an inherited texture is said where it is given.
        if table.texture and not check_texture(table.texture, (*at, "texture"), self._problems):
            return None
        dressed = _finish(name, keys, self._problems.file.parent)
        problem = _physics_problem(dressed.material, "ior" in keys)
        if problem is None:
            return dressed
        key, message, hint = problem
        self._problems.add((*at, key), message, hint=hint)
        return None

    def _note_circle(self, names: list[str]) -> None:
        """Once, at the first of them: it is one mistake."""
        told = [*names[:CIRCLE], *["..."][: len(names) > CIRCLE], names[0]]
        self._problems.add(
            ("materials", names[0], "like"), f"inherits from itself: {' -> '.join(told)}"
        )

    def _note_unknown(self, name: str, at: Location) -> None:
        known = f"known: {joined(BUILT_IN)}"
        if self._own:
            known += f", and this scene's {joined(self._own)}"
        self._problems.add(
            at,
            f"no material is named {quoted(name)}",
            allowed=known,
            hint=did_you_mean(name, [*BUILT_IN, *self._own]) if self._unknown < MOST_HINTS else "",
        )
        self._unknown += 1


def _physics_problem(material: Material, has_ior: bool) -> tuple[str, str, str] | None:
    """Key, message and hint of what cannot be, if anything."""
    total = material.reflect + material.transmit
    if total > 1:
        shares = f"reflect {plain(material.reflect)} + transmit {plain(material.transmit)}"
        return (
            "reflect",
            f"{shares} = {total:.6g} is more than 1",
            "light would be made from nothing",
        )
    if material.transmit > 0 and not has_ior:
        message = f"missing: a material with transmit = {plain(material.transmit)} bends light"
        return "ior", message, 'window glass has 1.5; or write like = "glass"'
    if material.fresnel and material.transmit == 0:
        message = "needs transmit above 0: it moves light between reflect and transmit"
        return "fresnel", message, ""
    return None


def _given(table: MaterialTable) -> dict[str, Any]:
    """The keys the table gives, without `like`."""
    return table.model_dump(exclude_none=True, exclude={"like"})


def _finish(name: str, keys: dict[str, Any], folder: Path) -> Dressed:
    texture = keys.get("texture")
    rest = {key: value for key, value in keys.items() if key != "texture"}
    return Dressed(Material(name, **rest), texture and texture_of(texture, folder))
