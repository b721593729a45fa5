"""A question and its choices: what they are together, and what they may name: pixels of its view,
objects of its scene. A step with a fault here is read on: all its faults are told at once."""

from __future__ import annotations

from collections.abc import Sequence

from raywalk.scene.model import Choice
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema import StepTable
from raywalk.scene.schema_choices import FEWEST, MOST, ChoiceTable
from raywalk.scene.wording import counted, did_you_mean, joined, plain, quoted


def check_choices(
    step: StepTable, objects: Sequence[str] | None, at: Location, problems: Problems
) -> None:
    """objects: their names; None if they are not all known."""
    if step.answer_view is not None and step.answer is None:
        problems.add((*at, "answer_view"), "there is no answer to show it with")
    if step.choices:
        _check_together(step.choices, step.answer, (*at, "choices"), problems)
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


def _check_together(
    choices: Sequence[ChoiceTable], answer: str | None, at: Location, problems: Problems
) -> None:
    if answer is None:
        problems.add(at, "there is no answer to reveal", hint="give the step an answer")
    if not FEWEST <= len(choices) <= MOST:
        message = f"a question has more than {counted(len(choices), 'choice')}"
        if len(choices) > MOST:
            message = f"{len(choices)} choices are more than one can weigh"
        problems.add(at, message, allowed=f"allowed: {FEWEST} to {MOST}")
    right = [each.said for each in choices if each.right]
    if len(right) != 1:
        message = f"{' and '.join(right)} are right" if right else "none of them is right"
        problems.add(at, message, allowed="allowed: right = true for exactly one")
    said = [each.said.casefold() for each in choices]
    for k, each in enumerate(choices):
        if said.index(said[k]) < k == said.index(said[k], said.index(said[k]) + 1):  # once for each
            problems.add(at, f"{each.said} is there twice")


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
