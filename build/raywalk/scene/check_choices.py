"""What a question's choices may name: pixels of its view, objects of its scene."""

from __future__ import annotations

from collections.abc import Sequence

from raywalk.scene.model import Choice
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema import StepTable
from raywalk.scene.schema_choices import ChoiceTable
from raywalk.scene.wording import did_you_mean, joined, plain, quoted


def check_choices(
    step: StepTable, objects: Sequence[str] | None, at: Location, problems: Problems
) -> None:
    """objects: their names; None if they are not all known."""
    for k, choice in enumerate(step.choices):
        here = (*at, "choices", k)
        if choice.pixel is not None:
            _check_pixel(choice.pixel, step.view.resolution, (*here, "pixel"), problems)
        if choice.object is not None and objects is not None and choice.object not in objects:
            problems.add(
                (*here, "object"), f"no object is named {quoted(choice.object)}",
                allowed=f"known: {joined(map(quoted, objects))}" if objects else "",
                hint=did_you_mean(choice.object, objects),
            )  # fmt: skip


def _check_pixel(pixel: tuple[int, int], n: int | None, at: Location, problems: Problems) -> None:
    if n is None:
        message = f"{plain(pixel)} needs a resolution to be counted in"
        problems.add(at, message, hint="give the step's view one")
    elif max(pixel) >= n:
        allowed = f"allowed: columns and rows 0 to {n - 1}"
        problems.add(at, f"{plain(pixel)} is outside the frustum", allowed=allowed)


def choice_of(table: ChoiceTable, objects: Sequence[str]) -> Choice:
    """The checked table with its object as a number."""
    is_object = table.object in objects
    return Choice(
        because=table.because.strip(),
        right=table.right,
        text=(table.text or "").strip(),
        pixel=table.pixel,
        object=objects.index(table.object) if table.object and is_object else None,
        colour=table.colour,
    )
