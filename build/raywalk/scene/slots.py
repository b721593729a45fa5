"""Slots: figures in a lesson's words that the trace fills in. docs.py has the grammar for authors.

A quantity is a name, the ray it is of and what else it is of, with full stops between:
{angle.refracted.refracted}, {n.l.reflected.light 2}. Behind it may stand a pixel and another scene:
{lit at 10,11 in 13-soft-shadows-4}. Slots stand outside of formulas and code.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from math import isqrt
from typing import Any

from raywalk.scene.formula import FORMULA
from raywalk.scene.measures import SlotFault
from raywalk.scene.quantities import KINDS, QUANTITIES, Quantity
from raywalk.scene.wording import did_you_mean, joined

CODE = r"(?P<ticks>`+).+?(?P=ticks)"
# A name, or a number that is no list's first: {1, 2} stays as it is.
INNER = r"\s*(?:[A-Za-z]|\d+(?:\.\d+)?\s*(?=[}:]|[*/]\s))[^{}]*"
SLOT = re.compile(rf"(?P<skipped>\\.|{CODE}|{FORMULA.pattern})|\{{(?P<slot>{INNER})\}}", re.DOTALL)
FORMAT = re.compile(r"\s*(?P<digits>\d?)\s*(?P<percent>%?)")
PLACE = re.compile(r"(?P<column>\d+)\s*,\s*(?P<row>\d+)(\s+of\s+(?P<n>\d+))?")
# Folders of scenes have a digit or a hyphen, so that "ball in water" stays a name.
ELSEWHERE = re.compile(r"\s+in\s+(?P<scene>(?=\S*[-\d])[\w-]+)$")
NUMBER = re.compile(r"\d+(\.\d+)?")
OPERATOR = re.compile(r"\s+([*/])\s+")
Pixel = tuple[int, int, int]  # n, column, row


@dataclass(frozen=True)
class Operand:
    """A quantity of a ray, or of the scene; or a plain number."""

    number: float | None = None
    quantity: Quantity | None = None
    kinds: tuple[str, ...] = ()  # of the rays from the camera's on, each sent on by the one before
    of: str = ""  # a light, an object, a material, a component
    column: int | None = None  # of the pixel that it names, if it names one
    row: int = 0
    n: int | None = None
    scene: str = ""  # another one, by its folder

    def pixel(self, own: Pixel | None) -> Pixel | None:
        """The pixel it is of; own: the step's. None where neither tells one."""
        if self.column is None:
            return own
        n = self.n or (own[0] if own else None)
        return None if n is None else (n, self.column, self.row)

    def inside(self, own: Pixel | None) -> list[Pixel]:
        """Of a mean over a tile: the pixels of the finer grid whose rays are in it."""
        if self.quantity is None or not self.quantity.is_mean or not (pixel := self.pixel(own)):
            return []
        across, (n, column, row) = isqrt(int(self.of.rpartition(".")[2])), pixel
        along = range(across)
        return [(n * across, column * across + i, row * across + j) for j in along for i in along]


@dataclass(frozen=True)
class Slot:
    """As it was typed, and read: the first operand, then pairs of "*" or "/" and another one."""

    typed: str
    first: Operand
    others: tuple[tuple[str, Operand], ...]
    digits: int | None
    is_percent: bool

    @property
    def operands(self) -> list[Operand]:
        return [self.first, *(operand for _, operand in self.others)]


def slots_in(text: str) -> Iterator[tuple[str, Slot | SlotFault]]:
    """Each slot as typed, read or with what is wrong with it."""
    for match in SLOT.finditer(text):
        if match["slot"] is not None:
            try:
                yield match[0], read_slot(match["slot"])
            except SlotFault as fault:
                yield match[0], fault


def own_pixel(view: Mapping[str, Any]) -> Pixel | None:
    """The pixel that a step's view names, if it names one."""
    if "resolution" not in view or "pixel" not in view:
        return None
    column, row = view["pixel"]
    return view["resolution"], column, row


def stop_of(operand: Operand, view: Mapping[str, Any]) -> str:
    """At which stop of a sweep it is asked of: as the step shows its scene; "" of one as it is."""
    return "" if operand.scene else str(view.get("sweep", ""))


def filled_in(text: str, write: Callable[[Slot], str]) -> str:
    """The text with each slot written. Raises SlotFault, and what `write` raises."""
    return SLOT.sub(
        lambda match: match[0] if match["slot"] is None else write(read_slot(match["slot"])), text
    )


def read_slot(typed: str) -> Slot:
    """What stands between the braces. Raises SlotFault."""
    words = " ".join(typed.split())
    body, colon, after = words.rpartition(":")
    form = FORMAT.fullmatch(after) if colon else None
    if colon and (form is None or not (form["digits"] or form["percent"])):
        raise SlotFault(
            f"{after.strip() or 'nothing'} after the colon is no way to write a number",
            allowed="allowed: decimals, percent or both, as in {t : 2}, {share : %}, {share : 1%}",
        )
    first, *rest = OPERATOR.split((body if form else words).strip())
    pairs = zip(rest[::2], rest[1::2], strict=True)
    return Slot(
        words, _operand(first), tuple((sign, _operand(other)) for sign, other in pairs),
        int(form["digits"]) if form and form["digits"] else None,
        bool(form and form["percent"]),
    )  # fmt: skip


def _operand(words: str) -> Operand:
    if NUMBER.fullmatch(words):
        return Operand(number=float(words))
    elsewhere = ELSEWHERE.search(words)
    scene = elsewhere["scene"] if elsewhere else ""
    named, at, place = ELSEWHERE.sub("", words).partition(" at ")
    quantity, rest = _quantity(named)
    kinds: list[str] = []
    while quantity.of == "ray" and rest and rest.partition(".")[0] in KINDS:
        kind, _, rest = rest.partition(".")
        kinds.append(kind)
    _check_subject(quantity, rest, named)
    if scene and quantity.needs_picture:
        raise SlotFault(f"{quantity.name} is counted for the lesson's own scene only")
    if not at:
        return Operand(None, quantity, tuple(kinds), rest, scene=scene)
    where = PLACE.fullmatch(place.strip())
    if not where:
        raise SlotFault(f'"{place}" is no pixel', hint="write {t at 4,3} or {t at 4,3 of 15}")
    if quantity.of == "scene":
        raise SlotFault(f"{quantity.name} is of the scene, not of a pixel", hint="leave out the at")
    n = int(where["n"]) if where["n"] else None
    at_pixel = int(where["column"]), int(where["row"])
    return Operand(None, quantity, tuple(kinds), rest, *at_pixel, n, scene)


def _quantity(named: str) -> tuple[Quantity, str]:
    """The quantity that a name begins with, and what follows its full stop."""
    for name in sorted(QUANTITIES, key=len, reverse=True):
        if named == name or named.startswith(f"{name}."):
            return QUANTITIES[name], named[len(name) + 1 :]
    head = named.partition(".")[0]
    raise SlotFault(
        f'there is no quantity "{head}"',
        allowed=f"known: {joined(QUANTITIES)}",
        hint=did_you_mean(head, QUANTITIES) or "a brace that opens no slot: \\{",
    )


def _check_subject(quantity: Quantity, of: str, named: str) -> None:
    """That there is one where one is needed, of the allowed ones where these are few."""
    if not quantity.takes and of:
        kinds = f"; a ray: {joined(KINDS)}" if quantity.of == "ray" else ""
        raise SlotFault(
            f'"{of}" does not belong to {quantity.name}',
            allowed=f"allowed: {{{quantity.name}}} alone{kinds}", hint=did_you_mean(of, KINDS),
        )  # fmt: skip
    if quantity.takes and not of and not quantity.may_be_alone:
        raise SlotFault(
            f"{named} of what?", allowed=f"allowed: {quantity.name}.{quantity.takes.upper()}"
        )
    if of and quantity.choices and of not in quantity.choices:
        known = f"known: {joined(quantity.choices)}"
        raise SlotFault(f'{quantity.name} has no "{of}"', known, did_you_mean(of, quantity.choices))
