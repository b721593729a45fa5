"""Writes figures into the words of lessons, each in the language of its text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import isnan, nan
from typing import Any

from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.check_slots import check_pixel
from raywalk.scene.measures import Asked, Facts, Ray, SlotFault
from raywalk.scene.model import Scene
from raywalk.scene.slots import Operand, Pixel, Slot, filled_in, own_pixel
from raywalk.scene.translation import Spoken, translation_file
from raywalk.scene.wording import joined, key_path, quoted
from raywalk.words import read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.words.numbers import MINUS, Numbers

UNKNOWN = "…"  # a figure of the whole picture, while only its grids are traced
Lessons = dict[str, list[Spoken]]  # by language


@dataclass(frozen=True)
class Figures:
    """What a scene's slots are filled from."""

    trees: dict[Pixel, Ray]
    facts: Facts
    others: Mapping[str, tuple[Scene, Figures]] = field(default_factory=dict)  # by the scene's id
    stops: Mapping[str, tuple[Scene, Figures]] = field(default_factory=dict)  # as views name them

    def at(self, view: Mapping[str, Any], scene: Scene) -> tuple[Scene, Figures]:
        """The scene as a step shows it, and the figures of that: at its stop, if it names one."""
        there, figures = self.stops.get(view.get("sweep", ""), (scene, self))
        return there, replace(figures, others=self.others)


def filled(spoken: Lessons, figures: list[Figures]) -> Lessons:
    """By language, the figures of each scene in its words. Raises SourceErrors."""
    problems: list[SourceError] = []
    told = {
        code: [
            replace(each, scene=_filled(each, of, spoken[DEFAULT][k].scene, code, problems))
            for k, (each, of) in enumerate(zip(all_scenes, figures, strict=True))
        ]
        for code, all_scenes in spoken.items()
    }
    if problems:
        raise SourceErrors(problems)
    return told


def _filled(
    spoken: Spoken, figures: Figures, own: Scene, code: str, problems: list[SourceError]
) -> Scene:
    """own: the scene with the names that slots use."""
    scene = spoken.scene
    language = code if spoken.is_translated else DEFAULT
    file = translation_file(own, code) if language != DEFAULT else own.path
    numbers = read_words(language).numbers

    def fill(key: str, text: str, view: Mapping[str, Any]) -> str:
        here, known = figures.at(view, own)

        def write(slot: Slot) -> str:
            try:
                return written(slot, here, known, own_pixel(view), numbers)
            except SlotFault as fault:
                message = f"{{{slot.typed}}}: {fault.message}"
                problems.append(SourceError(file, key, message, fault.allowed, fault.hint))
                return UNKNOWN

        return filled_in(text, write)

    lesson = tuple(
        step.saying({
            key: fill(key_path(("lesson", i, *key)), text, view)
            for key, (text, view) in step.said().items()
        })
        for i, step in enumerate(scene.lesson)
    )  # fmt: skip
    goals = tuple(fill(f"goals[{i}]", goal, {}) for i, goal in enumerate(scene.goals))
    return replace(scene, lesson=lesson, goals=goals)


def written(slot: Slot, scene: Scene, figures: Figures, own: Pixel | None, numbers: Numbers) -> str:
    """A slot's figure as the language writes it. Raises SlotFault."""
    value = value_of(slot, scene, figures, own)
    if isnan(value):
        return UNKNOWN
    digits, is_percent = form_of(slot)
    if is_percent and slot.digits is None:
        return numbers.percent(value)
    if is_percent:
        return numbers.fixed(100 * value, digits) + "\u202f%"
    if digits:
        return numbers.fixed(value, digits)
    whole = int(abs(value) + 0.5)
    return (MINUS if value < 0 < whole else "") + numbers.grouped(whole)


def form_of(slot: Slot) -> tuple[int, bool]:
    """Decimals, and whether it is written in percent: as it says, else as its first quantity is;
    plain numbers as they were typed."""
    quantity = next((operand.quantity for operand in slot.operands if operand.quantity), None)
    if quantity is None:
        typed = [f"{operand.number:g}".partition(".")[2] for operand in slot.operands]
        digits, is_percent = max(map(len, typed)), False
    else:
        digits, is_percent = quantity.digits, quantity.is_percent
    if slot.digits is None and not slot.is_percent:
        return digits, is_percent
    return digits if slot.digits is None else slot.digits, slot.is_percent


def value_of(slot: Slot, scene: Scene, figures: Figures, own: Pixel | None) -> float:
    """From full float64. Raises SlotFault."""
    value = _operand(slot.first, scene, figures, own)
    for sign, operand in slot.others:
        other = _operand(operand, scene, figures, own)
        if sign == "/" and other == 0:
            raise SlotFault("it divides by 0")
        value = value * other if sign == "*" else value / other
    return value


def _operand(operand: Operand, scene: Scene, figures: Figures, own: Pixel | None) -> float:
    if operand.quantity is None:
        return operand.number if operand.number is not None else nan
    if operand.scene:
        if operand.scene not in figures.others:
            raise SlotFault(f"there is no scene {quoted(operand.scene)} beside this one")
        scene, figures = figures.others[operand.scene]
    pixel = operand.pixel(own) if operand.quantity.of != "scene" else None
    if pixel:
        check_pixel(operand, pixel, scene.render)
    path = _path(figures.trees[pixel], operand.kinds, pixel) if pixel else ()
    inside = tuple(figures.trees[each] for each in operand.inside(own))
    return operand.quantity.value(Asked(scene, figures.facts, path, operand.of, inside))


def _path(camera: Ray, kinds: tuple[str, ...], pixel: Pixel) -> tuple[Ray, ...]:
    """The camera ray and those that it leads to, kind by kind."""
    path = [camera]
    for kind in kinds:
        sent = {child["kind"]: child for child in path[-1]["children"]}
        if kind not in sent:
            n, column, row = pixel
            last = path[-1]["kind"]
            raise SlotFault(
                f"the {last} ray of pixel {column},{row} of {n} sends no {kind} ray on",
                allowed=f"it sends on: {joined(sent) or 'none'}",
            )
        path.append(sent[kind])
    return tuple(path)
