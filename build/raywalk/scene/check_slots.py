"""What is wrong with the slots of a lesson's words, as far as the scene's file tells it. What only
rays tell, that there is no refracted one, say, is said where they are filled: pipeline/filling.py.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from raywalk.scene.measures import SlotFault
from raywalk.scene.model import Render
from raywalk.scene.problems import Location, Problems
from raywalk.scene.slots import Operand, Pixel, Slot, own_pixel, slots_in, stop_of
from raywalk.scene.wording import joined


def check_slots(
    text: str, view: Mapping[str, Any], render: Render | None, at: Location, problems: Problems
) -> None:
    """Notes every slot that cannot be read, or names a pixel that there is not.

    view: of the step, which names its own pixel; {} of what belongs to no step.
    """
    for typed, slot in slots_in(text):
        try:
            if isinstance(slot, SlotFault):
                raise slot
            _check_stop(slot, view)
            _check_pixels(slot, view, render)
        except SlotFault as fault:
            shown = " ".join(typed.split())
            message = f"{shown}: {fault.message}"
            problems.add(at, message, allowed=fault.allowed, hint=fault.hint)


def _check_stop(slot: Slot, view: Mapping[str, Any]) -> None:
    """Of a stop there are rays, but no whole picture."""
    for operand in slot.operands:
        if stop_of(operand, view) and operand.quantity and operand.quantity.needs_picture:
            raise SlotFault(
                f"{operand.quantity.name} is counted over the scene's own picture, and the step "
                "shows the scene at a stop of a sweep",
                hint="ask in a step without sweep, or write a plain number: {4.2}",
            )


def _check_pixels(slot: Slot, view: Mapping[str, Any], render: Render | None) -> None:
    for operand in slot.operands:
        if operand.quantity and operand.quantity.of != "scene" and render:
            _check_pixel(operand, view, render)


def _check_pixel(operand: Operand, view: Mapping[str, Any], render: Render) -> None:
    pixel = operand.pixel(own_pixel(view))
    if pixel is None:
        raise SlotFault(
            "of which pixel?" if operand.column is None else "of which grid?",
            hint="give the step's view a resolution and a pixel, or write {t at 4,3 of 15}",
        )
    if not operand.scene:
        check_pixel(operand, pixel, render)


def check_pixel(operand: Operand, pixel: Pixel, render: Render) -> None:
    """That the scene has it. render: of the scene that the operand is of. Raises SlotFault."""
    n, column, row = pixel
    known = f"known: {joined(map(str, render.resolutions))}"
    if n not in render.resolutions:
        raise SlotFault(f"{n} is not one of the scene's resolutions", allowed=known)
    if max(column, row) >= n:
        allowed = f"allowed: columns and rows 0 to {n - 1}"
        raise SlotFault(f"pixel {column},{row} is outside the grid", allowed=allowed)
    for finer, _, _ in operand.inside(pixel)[:1]:
        if finer not in render.resolutions:
            raise SlotFault(f"the scene has no grid of {finer} to take the mean of", allowed=known)
