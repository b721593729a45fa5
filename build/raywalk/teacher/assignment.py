"""An assignment: what a student programs for a scene, from which numbers, and the pixels to check
the program against."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from raywalk.scene.model import Material, Scene
from raywalk.slides.figure import Cell, Deck, Run, Table
from raywalk.slides.handout import A4
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.sheet_facts import Facts, exact_vector, exactly, given, lamps
from raywalk.slides.sheet_questions import sheet_facts
from raywalk.slides.step_slide import Lesson
from raywalk.slides.table_parts import table_parts
from raywalk.slides.words import numbers, say, words
from raywalk.slides.worksheet import WIDE, Block, flowed, listed, numbered, pages
from raywalk.teacher.topics import topics

ROW, CELLS = 17.0, 10.5  # points: a row of the table, its letters
COLUMNS = (52.0, 138.0, 58.0, 150.0, WIDE - 398.0)


def assignment(lesson: Lesson) -> Deck:
    scene, facts = lesson.scene, sheet_facts(lesson)
    title = say("teacher.assignmentTitle", title=scene.title)
    blocks = [flowed([Paragraph((Run(say("teacher.assignmentSays", title=scene.title)),))])]
    blocks += listed(say("teacher.toProgram"), [say(f"teacher.program.{t}") for t in topics(scene)])
    blocks += listed(say("slides.given"), given(scene, facts))
    blocks += listed(say("teacher.colours"), list(_colours(scene)))
    if facts["checks"]:
        head = say("teacher.checks", n=facts["n"])
        blocks.append(flowed([Paragraph((Run(head),))]))
        blocks.append(_table(scene, facts))
    return Deck(scene.id, title, *A4, tuple(numbered(pages(title, blocks))), words().code)


def _colours(scene: Scene) -> Iterator[str]:
    """Materials by the objects that have them, light, background, how far rays are followed."""
    for k, material in enumerate(scene.materials):
        names = [obj.name for obj in scene.objects if obj.material == k]
        if names:
            yield f"{', '.join(names)}: {_material(material)}"
    for obj in scene.objects:
        if obj.checker:
            odd = scene.materials[obj.checker.material]
            yield say(
                "teacher.checker", name=obj.name, size=exactly(obj.checker.size),
                diffuse=exact_vector(odd.diffuse), ambient=exact_vector(odd.ambient),
            )  # fmt: skip
        if obj.base:
            yield say("teacher.base", name=obj.name)
    for name, (light, *more) in lamps(scene).items():
        yield say(
            "teacher.lights" if more else "teacher.light",
            light=name, colour=exact_vector(light.colour),
            intensity=exactly(light.intensity), falloff=exact_vector(light.attenuation),
        )  # fmt: skip
    yield say("teacher.background", colour=exact_vector(scene.background),
              depth=scene.render.depth)  # fmt: skip


def _material(of: Material) -> str:
    said = say("teacher.material", ambient=exact_vector(of.ambient),
               diffuse=exact_vector(of.diffuse), specular=exact_vector(of.specular),
               shininess=exactly(of.shininess))  # fmt: skip
    if of.fresnel:
        return said + say("teacher.fresnel", both=exactly(of.reflect + of.transmit),
                          ior=exactly(of.ior))  # fmt: skip
    if of.reflect:
        said += say("teacher.reflects", share=exactly(of.reflect))
    if of.transmit:
        said += say("teacher.transmits", share=exactly(of.transmit), ior=exactly(of.ior))
    return said


def _table(scene: Scene, facts: Facts) -> Block:
    heads = ("columnPixel", "columnObject", "columnT", "columnColour", "columnBytes")
    rows = [tuple(Cell(say(f"teacher.{head}"), bold=True) for head in heads)]
    rows += [_row(scene, check) for check in facts["checks"]]
    high = ROW * len(rows)
    name = say("teacher.checksTable")
    align = ("left", "left", "right", "right", "right")
    table = Table(Box(0, 0, WIDE, high), COLUMNS, align, tuple(rows), ROW, CELLS, name, name)
    return table_parts(table), high


def _row(scene: Scene, check: dict[str, Any]) -> tuple[Cell, ...]:
    write, thing = numbers(), check["object"]
    return (
        Cell(f"({', '.join(map(str, check['pixel']))})"),
        Cell(say("slides.nothing") if thing is None else scene.objects[thing].name),
        Cell("" if thing is None else write.number(check["t"])),
        Cell(write.vector(check["colour"])),
        Cell(", ".join(map(str, check["bytes"]))),
    )
