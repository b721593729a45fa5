"""A scene's words in another language: lesson.<language>.toml beside its scene.toml."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from pydantic import Field, ValidationError

from raywalk.errors import SourceErrors
from raywalk.scene.check_slots import check_slots
from raywalk.scene.fields import Headline, LessonText, Maybe, Name, Text, maybe, means
from raywalk.scene.lesson_pictures import check_pictures
from raywalk.scene.model import Choice, LessonStep, Scene, Sweep
from raywalk.scene.problems import Problems
from raywalk.scene.schema import Goals
from raywalk.scene.schema_choices import TranslatedChoice, TranslatedChoices
from raywalk.scene.table import Table
from raywalk.scene.toml import read_toml
from raywalk.scene.wording import counted, did_you_mean, joined, quoted

MOST_NAMED = 8  # scenes without a translation; how many more there are is told


class TranslatedStep(Table):
    """What a step of the lesson says; what it shows stands in scene.toml."""

    text: LessonText = means(
        "what is said or asked, in Markdown, with $formulas$ and ![words](a picture.png)"
    )
    headline: Maybe[Headline] = maybe("a slide's title, if the step has one there")
    answer: Maybe[LessonText] = maybe("of a question, in Markdown")
    choices: TranslatedChoices = means("of a question that has some, in their order", ())


class TranslationFile(Table):
    """All words of a scene, in the order of its scene.toml."""

    title: Text = means("a few words")
    teaches: Text = means("one sentence: what a student takes home")
    goals: Maybe[Goals] = maybe("of the lesson, as many as there")
    names: dict[str, Name] = Field(
        default_factory=dict,
        description="of each object, light, material, sweep, by its name there",
    )
    lesson: tuple[TranslatedStep, ...] = means("step by step", ())


@dataclass(frozen=True)
class Spoken:
    """A scene in one language."""

    scene: Scene  # its words are that language's if it is translated
    is_translated: bool


def read_spoken(scenes: Iterable[Scene], language: str) -> list[Spoken]:
    """Scenes in a language other than their own; those without a translation as they are.

    Raises SourceErrors with everything that is wrong in any translation.
    """
    spoken, errors = [], []
    for scene in scenes:
        file = translation_file(scene, language)
        if not file.exists():
            spoken.append(Spoken(scene, False))
            continue
        problems = Problems(file)
        table = _read(file, problems)
        if table is not None:
            _check(table, scene, problems)
            table = _with_base_names(table, scene, language)
        errors += problems.errors
        if table is not None and not problems.errors:
            spoken.append(Spoken(in_words_of(table, scene), True))
    if errors:
        raise SourceErrors(errors)
    return spoken


def _with_base_names(table: TranslationFile, scene: Scene, language: str) -> TranslationFile:
    """A lesson on another scene has its names from there; where they have mistakes, those are told
    of that scene."""
    file = translation_file(scene.base, language) if scene.base else None
    of_base = _read(file, Problems(file)) if file and file.exists() else None
    return table.model_copy(update={"names": of_base.names}) if of_base else table


def translation_file(scene: Scene, language: str) -> Path:
    """Where a scene's words in a language stand."""
    return scene.path.with_name(f"lesson.{language}.toml")


def missing_translations(spoken: Iterable[Spoken], language: str) -> list[str]:
    """One sentence that names the scenes which have none; no sentence where all have."""
    of = list(spoken)
    untold = [each for each in of if not each.is_translated]
    if not untold:
        return []
    named = [each.scene.id for each in untold[:MOST_NAMED]]
    more = f" and {len(untold) - MOST_NAMED} more" if len(untold) > MOST_NAMED else ""
    file, all_of = translation_file(untold[0].scene, language).name, counted(len(of), "scene")
    return [
        f"{language}: {len(untold)} of {all_of} not translated ({file} is missing), so "
        f"the words stay as in scene.toml: {joined(named)}{more}"
    ]


def in_words_of(table: TranslationFile, scene: Scene) -> Scene:
    """The scene with another language's words; geometry, light and views as they are."""

    def named(name: str) -> str:
        return table.names.get(name, name)

    lesson = zip(scene.lesson, table.lesson, strict=True)
    return replace(
        scene,
        title=table.title,
        teaches=table.teaches,
        goals=tuple(goal.strip() for goal in table.goals or ()),
        materials=tuple(replace(each, name=named(each.name)) for each in scene.materials),
        objects=tuple(replace(each, name=named(each.name)) for each in scene.objects),
        lights=tuple(replace(each, name=named(each.name)) for each in scene.lights),
        sweeps=tuple(_in_sweep(each, named) for each in scene.sweeps),
        lesson=tuple(
            replace(
                step,
                text=said.text.strip(),
                answer=(said.answer or "").strip(),
                headline=(said.headline or "").strip(),
                view=_in_view(step.view, named),
                answer_view=_in_view(step.answer_view, named),
                choices=tuple(map(_in_choice, step.choices, said.choices)),
            )
            for step, said in lesson
        ),
    )


def _in_sweep(sweep: Sweep, named: Callable[[str], str]) -> Sweep:
    across = sweep.across and replace(sweep.across, name=named(sweep.across.name))
    return replace(sweep, name=named(sweep.name), across=across)


def _in_choice(choice: Choice, said: TranslatedChoice) -> Choice:
    return replace(choice, text=(said.text or "").strip(), because=said.because.strip())


def _in_view(view: dict[str, Any], named: Callable[[str], str]) -> dict[str, Any]:
    """The view with lights and objects by their new names."""

    def by_name(of: dict[str, Any]) -> dict[str, Any]:
        return {named(name): each for name, each in of.items()}

    translated: dict[str, Any] = {}
    if lights := (view.get("switches") or {}).get("lights"):
        translated["switches"] = view["switches"] | {"lights": by_name(lights)}
    if "highlight" in view:
        translated["highlight"] = [named(name) for name in view["highlight"]]
    if "labels" in view:
        translated["labels"] = by_name(view["labels"])
    return view | translated


def _read(file: Path, problems: Problems) -> TranslationFile | None:
    raw = read_toml(file, problems)
    if raw is None:
        return None
    try:
        return TranslationFile.model_validate(raw)
    except ValidationError as error:
        problems.add_refusals(error)
        return None


def _check(table: TranslationFile, scene: Scene, problems: Problems) -> None:
    _check_names(table, scene, problems)
    steps, said = len(scene.lesson), len(table.lesson)
    for i in range(said, steps):
        problems.add(("lesson", i), f"missing: {scene.path.name} has {steps} steps, this {said}")
    for i in range(steps, said):
        problems.add(("lesson", i), f"too many: {scene.path.name} has {steps} steps, this {said}")
    _check_goals(table, scene, problems)
    for i, (step, each) in enumerate(zip(scene.lesson, table.lesson, strict=False)):
        _check_answer(i, step, each, problems)
        _check_choices(i, step, each, problems)
        for key, text in _said(each):
            check_pictures(text, ("lesson", i, *key), problems)
            view = step.said().get(key, ("", step.view))[1]
            check_slots(text, view, scene.render, ("lesson", i, *key), problems)


def _said(step: TranslatedStep) -> Iterator[tuple[tuple[str | int, ...], str]]:
    """Its words by their places."""
    for key in ("headline", "text", "answer"):
        yield (key,), getattr(step, key) or ""
    for k, choice in enumerate(step.choices):
        yield ("choices", k, "text"), choice.text or ""
        yield ("choices", k, "because"), choice.because


def _check_goals(table: TranslationFile, scene: Scene, problems: Problems) -> None:
    goals = table.goals or ()
    for i, goal in enumerate(goals):
        check_slots(goal, {}, scene.render, ("goals", i), problems)
    if len(goals) != len(scene.goals):
        there = f"{scene.path.name} has {len(scene.goals)}, this {len(goals)}"
        problems.add(("goals",), f"{'missing' if not goals else 'not as many'}: {there}")


def _check_answer(i: int, step: LessonStep, said: TranslatedStep, problems: Problems) -> None:
    if bool(step.headline) != bool(said.headline):
        message = f"missing: {quoted(step.headline)}" if step.headline else "this step has none"
        problems.add(("lesson", i, "headline"), message)
    if step.answer and not said.answer:
        problems.add(("lesson", i, "answer"), "missing: this step is a question")
    if said.answer and not step.answer:
        message = "this step is no question, so it has no answer"
        problems.add(("lesson", i, "answer"), message, hint="is a step missing or in the way?")


def _check_choices(i: int, step: LessonStep, said: TranslatedStep, problems: Problems) -> None:
    there, here = len(step.choices), len(said.choices)
    if there != here:
        problems.add(("lesson", i, "choices"), f"there are {here}, in scene.toml {there}")
    texts = [each.text for each in said.choices if each.text]
    for text in {text for text in texts if texts.count(text) > 1}:
        problems.add(("lesson", i, "choices"), f"{quoted(text)} is there twice")
    for k, (choice, each) in enumerate(zip(step.choices, said.choices, strict=False)):
        at = ("lesson", i, "choices", k, "text")
        if choice.text and each.text is None:
            problems.add(at, f"missing: there it is {quoted(choice.text)}")
        if each.text is not None and not choice.text:
            problems.add(at, "this choice is a pixel or an object, which has no text")


def _check_names(table: TranslationFile, scene: Scene, problems: Problems) -> None:
    parts: Sequence[Sequence[object]] = (
        scene.objects, scene.lights, scene.materials, scene.sweeps,
        [each.across for each in scene.sweeps if each.across and each.across.name],
    )  # fmt: skip
    known = list(dict.fromkeys(str(getattr(each, "name", "")) for of in parts for each in of))
    if scene.base:
        if table.names:
            hint = f"they stand in {scene.base.path.parent.name}, for both"
            problems.add(("names",), "a lesson on another scene has its names there", hint=hint)
        return
    for name in table.names:
        if name not in known:
            problems.add(
                ("names", name),
                f"{quoted(name)} is no object, light, material or sweep of {scene.path.name}",
                allowed=f"known: {joined(known)}",
                hint=did_you_mean(name, known),
            )
    if untold := [name for name in known if name not in table.names]:
        problems.add(("names",), f"missing: {joined(untold)}")
