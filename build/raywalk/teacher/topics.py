"""What a scene needs to be understood, and to be programmed: told by what is in it, and by what its
lesson works out."""

from __future__ import annotations

from collections.abc import Callable

from raywalk.scene.model import Scene
from raywalk.slides.sheet_facts import lamps
from raywalk.slides.words import say

# Of teacher.topic and teacher.program in the catalogue, in the order in which one learns them.
TOPICS: dict[str, Callable[[Scene], bool]] = {
    "rays": lambda scene: True,
    "shading": lambda scene: bool(scene.lights),
    "shadows": lambda scene: scene.render.shadows and bool(scene.lights),
    "lights": lambda scene: len(lamps(scene)) > 1,
    "areas": lambda scene: any(len(points) > 1 for points in lamps(scene).values()),
    "mirrors": lambda scene: scene.render.depth > 0 and any(m.reflect for m in scene.materials),
    "depth": lambda scene: scene.render.depth > 1 and any(m.reflect for m in scene.materials),
    "meshes": lambda scene: scene.has_mesh,
    "boxes": lambda scene: _works_out(scene, "tree"),
    "means": lambda scene: _works_out(scene, "average"),
    "transforms": lambda scene: any((obj.transform != obj.transform.round()).any()
                                    for obj in scene.objects),
    "glass": lambda scene: scene.has_glass and scene.render.depth > 0,
}  # fmt: skip


def _works_out(scene: Scene, what: str) -> bool:
    return any(view.get("works") == what for step in scene.lesson for _, view in step.stops())


def topics(scene: Scene) -> list[str]:
    return [name for name, is_in in TOPICS.items() if is_in(scene)]


def prerequisites(scene: Scene, course: list[Scene]) -> list[str]:
    """What the scene needs that an earlier lesson brings, with that lesson's title; without one,
    vectors."""
    before = course[: [each.id for each in course].index(scene.id)]
    said = []
    for topic in topics(scene):
        first = next((each for each in before if topic in topics(each)), None)
        if first:
            number = before.index(first) + 1
            word = say(f"teacher.topic.{topic}")
            said.append(say("teacher.fromLesson", topic=word, number=number, title=first.title))
    return [say("teacher.vectors"), *said]
