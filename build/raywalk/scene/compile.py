"""From the tables of a scene file to the scene: names resolved, numbers in their place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace

import numpy as np

from raywalk.scene.address import address_of
from raywalk.scene.check_choices import check_choices, choice_of
from raywalk.scene.check_slots import check_slots
from raywalk.scene.check_view import Named, Stops, Sweeps, check_view
from raywalk.scene.checks import (
    check_camera,
    check_closed,
    check_eye_outside,
    check_light,
    check_names,
)
from raywalk.scene.draft import Draft
from raywalk.scene.lesson_pictures import check_pictures
from raywalk.scene.lights import point_lights
from raywalk.scene.materials import Dressed, Materials
from raywalk.scene.mesh_parts import dressed_parts, mesh_of
from raywalk.scene.model import (
    Base,
    Camera,
    Checker,
    LessonStep,
    Light,
    Material,
    Render,
    Scene,
    SceneObject,
)
from raywalk.scene.models import Models, mesh_file
from raywalk.scene.names import untaken, with_defaults
from raywalk.scene.problems import Location, Problems
from raywalk.scene.resolutions import resolutions_of
from raywalk.scene.schema import LessonFile, SceneFile, StepTable, ViewTable
from raywalk.scene.schema_objects import MaterialTable, MeshTable, ObjectTable, PlaneTable
from raywalk.scene.schema_sweeps import SweepTable
from raywalk.scene.shapes import SHAPES, Mesh, Shape
from raywalk.scene.transforms import is_singular, product


def compile_scene(
    whole: SceneFile | None, draft: Draft, models: Models, problems: Problems
) -> Scene | None:
    """The scene, or None with all problems noted. The file's folder gives the id."""
    camera = _camera(draft, problems)
    render = _render(draft, problems)
    parts = _Parts(draft, models, problems)
    parts.add_objects()
    if camera is not None:
        parts.check_eye(camera)
    lights = _lights(draft, problems)
    # With a light or an object left out for its errors, its name would seem to be wrong.
    objects = parts.known()
    sweeps = {each.name: _stops(each, render) for each in draft.sweeps.values()}
    named = None
    if whole is not None:
        named = Named(list(light_names(draft).values()), objects, sweeps)
    names = None if objects is None else [obj.name for obj in objects]
    lesson = _lesson(draft.lesson, render, named, names, problems)
    goals = _goals(whole, render, problems)
    if problems.errors or whole is None or camera is None or render is None:
        return None
    return Scene(
        id=address_of(problems.file.absolute().parent.name),
        path=problems.file,
        key=whole.key or "",
        chapter=whole.chapter or "",
        before=whole.before or "",
        mistakes=whole.mistakes,
        title=whole.title,
        teaches=whole.teaches,
        camera=camera,
        render=render,
        background=whole.background,
        materials=tuple(parts.materials),
        objects=tuple(parts.objects),
        lights=tuple(lights),
        lesson=tuple(lesson),
        goals=goals,
    )


def compile_lesson(
    whole: LessonFile | None, steps: dict[int, StepTable], base: Scene | None,
    lights: list[str] | None, problems: Problems,
) -> Scene | None:  # fmt: skip
    """A lesson on a scene that is there, or None with all problems noted. base: that scene, None if
    it has problems of its own; lights: the names of its lights, as its file gives them."""
    swept = base.sweeps if base else ()
    sweeps = {each.name: Stops(*each.shape, each.resolutions) for each in swept}
    named = Named(lights, base.objects, sweeps) if base and lights is not None else None
    names = [obj.name for obj in base.objects] if base else None
    lesson = _lesson(steps, base.render if base else None, named, names, problems)
    goals = _goals(whole, base.render if base else None, problems)
    if problems.errors or whole is None or base is None:
        return None
    return replace(
        base,
        id=address_of(problems.file.absolute().parent.name),
        path=problems.file,
        key="",
        chapter=whole.chapter or "",
        before=whole.before or "",
        title=whole.title,
        teaches=whole.teaches,
        lesson=tuple(lesson),
        goals=goals,
        base=base,
    )


def _goals(
    whole: SceneFile | LessonFile | None, render: Render | None, problems: Problems
) -> tuple[str, ...]:
    goals = () if whole is None else tuple(goal.strip() for goal in whole.goals or ())
    for i, goal in enumerate(goals):
        check_slots(goal, {}, render, ("goals", i), problems)
    return goals


def _camera(draft: Draft, problems: Problems) -> Camera | None:
    if draft.camera is None:
        return None
    check_camera(draft.camera, problems)
    return Camera(**draft.camera.model_dump())


def _render(draft: Draft, problems: Problems) -> Render | None:
    table = draft.render
    if table is None:
        return None
    resolutions = resolutions_of(table, problems)
    return Render(table.shadows, table.depth, table.size, resolutions, table.glass_shadows)


def _lights(draft: Draft, problems: Problems) -> list[Light]:
    tables = draft.lights
    for i, table in tables.items():
        check_light(table, ("lights", i), problems)
    names = light_names(draft)
    check_names(names.items(), "lights", problems)
    return [light for i, table in tables.items() for light in point_lights(table, names[i])]


def light_names(draft: Draft) -> dict[int, str]:
    """As views name them, by place: an area light is one."""
    return with_defaults((i, table.name, "light") for i, table in draft.lights.items())


def object_names(draft: Draft) -> dict[int, str]:
    """By place; parts of a mesh file are one."""
    return with_defaults((i, table.name, table.kind) for i, table in draft.objects.items())


def _lesson(
    steps: dict[int, StepTable], render: Render | None, named: Named | None,
    objects: list[str] | None, problems: Problems,
) -> list[LessonStep]:  # fmt: skip
    """objects: their names; None where some are not known for their errors."""
    for i, step in steps.items():
        for key, view in (("view", step.view), ("answer_view", step.answer_view)):
            if render is not None and view is not None:
                check_view(view, render, named, ("lesson", i, key), problems)
        check_choices(step, objects, ("lesson", i), problems)
    sweeps = named.sweeps if named else {}
    lesson = {i: _step(step, objects or [], sweeps) for i, step in steps.items()}
    for i, each in lesson.items():
        for place, (text, shown) in each.said().items():
            check_pictures(text, ("lesson", i, *place), problems)
            check_slots(text, shown, render, ("lesson", i, *place), problems)
    return list(lesson.values())


def _stops(table: SweepTable, render: Render | None) -> Stops:
    return Stops(*table.shape(), table.grids(render.resolutions if render else ()))


def _step(step: StepTable, objects: list[str], sweeps: Sweeps) -> LessonStep:
    revealed = _plain(step.answer_view, sweeps) if step.answer_view else {}
    words = (each.strip() if each else "" for each in (step.text, step.answer, step.headline))
    text, answer, headline = words
    choices = tuple(choice_of(each, objects) for each in step.choices)
    return LessonStep(text, _plain(step.view, sweeps), answer, revealed, headline, choices)


def _plain(view: ViewTable, sweeps: Sweeps) -> dict[str, object]:
    """The view's given keys, as JSON has them; a sweep's stop as addresses name it."""
    given = view.model_dump(mode="json", exclude_none=True)
    if view.sweep:
        [(name, stop)] = view.sweep.items()
        number = sweeps[name].number(stop) if name in sweeps else 1
        given["sweep"] = f"{address_of(name)}:{number}"
    return given


@dataclass
class _Parts:
    """Objects and the materials they use, numbered in the order of first use."""

    draft: Draft
    models: Models
    problems: Problems
    materials: list[Material] = field(default_factory=list)
    objects: list[SceneObject] = field(default_factory=list)
    number: dict[Material, int] = field(default_factory=dict)  # of each in `materials`
    taken: set[str] = field(default_factory=set)  # names of objects

    def add_objects(self) -> None:
        known = Materials(self.draft.materials, self.problems)
        tables = self.draft.objects
        names = object_names(self.draft)
        check_names(names.items(), "objects", self.problems)
        self.taken = set(names.values())
        for i, table in tables.items():
            self._add_object(i, table, names[i], known)

    def known(self) -> list[SceneObject] | None:
        """All of them; None if some were left out for their errors."""
        errors = self.problems.errors
        return None if any(error.key.startswith("objects") for error in errors) else self.objects

    def check_eye(self, camera: Camera) -> None:
        for obj in self.objects:
            check_eye_outside(camera, obj, self.materials[obj.material], self.problems)

    def _add_object(self, i: int, table: ObjectTable, name: str, known: Materials) -> None:
        at = ("objects", i)
        shape = self._shape_of(table, at)
        transform = product(table.transform)
        if is_singular(transform):
            self.problems.add((*at, "transform"), "flattens the object: it has no inverse")
            return
        if isinstance(table, MeshTable) and (table.materials or table.material is None):
            self._add_parts(table, shape, name, known, at, transform)
            return
        dressed = self._dressed(table.material, name, known, (*at, "material"))
        if shape is None or dressed is None:
            return
        check_closed(shape, dressed.material, at, self.problems)
        even, checker = self._checkered(table, name, dressed.material)
        base = Base(texture=dressed.texture) if dressed.texture else None
        self.objects.append(SceneObject(name, shape, even, transform, checker, base))

    def _shape_of(self, table: ObjectTable, at: Location) -> Shape | None:
        """None, with the problem noted, if it has no extent or no file."""
        if isinstance(table, MeshTable):
            found = mesh_file(table, self.models, at, self.problems)
            return mesh_of(table, *found, self.models.crease(table.model)) if found else None
        kind = SHAPES[table.kind]
        shape: Shape = kind(**{each.name: getattr(table, each.name) for each in fields(kind)})
        flaws = list(shape.flaws())
        for key, message, hint in flaws:
            self.problems.add((*at, key) if key else at, message, hint=hint)
        return None if flaws else shape

    def _add_parts(
        self, table: MeshTable, shape: Shape | None, name: str, known: Materials, at: Location,
        transform: np.ndarray,
    ) -> None:  # fmt: skip
        """A mesh as objects: one for each material that it is shown in."""
        given = {
            part: self._dressed(dress, f"{name}, {part}", known, (*at, "materials", part))
            for part, dress in table.materials.items()
        }
        rest = None
        if table.material is not None:
            rest = self._dressed(table.material, name, known, (*at, "material"))
        if not isinstance(shape, Mesh):
            return
        for part in dressed_parts(table, shape, name, given, rest, at, self.problems):
            index = self._index(part.material)
            called = name if part.name == name else untaken(part.name, self.taken)
            self.objects.append(SceneObject(called, part.mesh, index, transform, base=part.base))

    def _dressed(
        self, dress: str | MaterialTable, name: str, known: Materials, at: Sequence[str | int]
    ) -> Dressed | None:
        if isinstance(dress, str):
            return known.find(dress, at)
        return known.inline(dress, name, at)

    def _checkered(
        self, table: ObjectTable, name: str, material: Material
    ) -> tuple[int, Checker | None]:
        """Index of the object's material, and its checker if it has one."""
        if not isinstance(table, PlaneTable) or table.checker is None:
            return self._index(material), None
        even, odd = (
            self._index(
                replace(material, name=f"{name}, {which} squares", diffuse=colour, ambient=ambient)
            )
            for which, colour, ambient in zip(
                ("even", "odd"), table.checker.colours, table.checker.ambients(material.ambient),
                strict=True,
            )
        )  # fmt: skip
        return even, Checker(table.checker.size, odd)

    def _index(self, material: Material) -> int:
        if material not in self.number:
            self.number[material] = len(self.materials)
            self.materials.append(material)
        return self.number[material]
