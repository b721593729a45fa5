"""A validated scene: what every later stage reads.

World frame: right-handed, +y up. Lengths in world units, angles in degrees,
colours linear (r, g, b) with 1 as full. Everything is immutable and complete:
names are resolved, defaults filled in, files found.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.shapes import Mesh, Shape, Triple


@dataclass(frozen=True)
class Material:
    """Blinn-Phong surface with shares for mirror and glass.

    colour = (1 - reflect - transmit) local + reflect * reflected + transmit * refracted
    """

    name: str
    ambient: Triple = (0.0, 0.0, 0.0)
    diffuse: Triple = (0.0, 0.0, 0.0)
    specular: Triple = (0.0, 0.0, 0.0)
    shininess: float = 1.0
    reflect: float = 0.0
    transmit: float = 0.0
    ior: float = 1.0
    fresnel: bool = False


@dataclass(frozen=True)
class Checker:
    """Squares of two diffuse colours on a plane; the even ones keep the object's material.

    A point's cell is floor(u / size) + floor(v / size), measured from the plane's
    `point` along the two world axes left when the normal's largest component is
    dropped (each made perpendicular to the normal): x and z on a floor.
    """

    size: float
    material: int  # index into Scene.materials, of the odd squares


BASE_STEPS = 4080  # from 0 to 1: 16 to each of 8 bits; base colours are rounded so


@dataclass(frozen=True)
class Texture:
    """A picture whose colours an object shows, each where it belongs; it repeats."""

    path: Path
    filter: str = "bilinear"  # between the centres of four pixels; or "nearest"
    repeat: tuple[float, float] = (1.0, 1.0)  # pictures in a unit of u and of v
    inside: int = -1  # a glTF file holds it as its image of that number


@dataclass(frozen=True)
class Base:
    """An object's base colour, which differs from place to place: what its material's ambient and
    diffuse are multiplied by at a hit. Linear, 1 is full, as all colours, in steps of 1/BASE_STEPS:
    so trace files hold it exactly."""

    colours: bool = False  # those that a mesh's file gives its vertices or faces
    texture: Texture | None = None  # where both are given, their product


@dataclass(frozen=True, eq=False)
class SceneObject:
    name: str
    shape: Shape
    material: int  # index into Scene.materials
    transform: np.ndarray = field(default_factory=lambda: np.eye(4))  # (4, 4), after the shape
    checker: Checker | None = None
    base: Base | None = None  # None: the material's colours as they are

    @property
    def files(self) -> tuple[Path, ...]:
        """What its mesh and its texture are read from."""
        mesh = (self.shape.path, *self.shape.beside) if isinstance(self.shape, Mesh) else ()
        return (*mesh, self.base.texture.path) if self.base and self.base.texture else mesh


@dataclass(frozen=True)
class Light:
    """A point light; its strength at distance D is intensity / (a0 + a1 D + a2 D^2)."""

    name: str
    position: Triple
    colour: Triple = (1.0, 1.0, 1.0)
    intensity: float = 1.0
    attenuation: Triple = (1.0, 0.0, 0.0)


@dataclass(frozen=True)
class Camera:
    """A pinhole with a square picture."""

    eye: Triple
    target: Triple
    up: Triple = (0.0, 1.0, 0.0)
    fov: float = 45.0  # vertical, degrees


@dataclass(frozen=True)
class Render:
    shadows: bool = True
    depth: int = 8  # bounces at most: reflected or refracted rays after the camera ray
    size: int = 1155  # the picture is size x size
    resolutions: tuple[int, ...] = (5, 7, 11, 15, 21, 33, 55, 77, 105)
    glass_shadows: str = "opaque"  # "opaque", or "pass": unbent, times transmit per surface


Place = tuple[str | int, ...]  # of a text in its step: ("choices", 0, "because")


@dataclass(frozen=True)
class Choice:
    """Of a question. Exactly one of text, pixel and object says what is chosen."""

    because: str  # Markdown: why it is right or wrong
    right: bool = False
    text: str = ""  # Markdown
    pixel: tuple[int, int] | None = None  # column, row of the step's grid
    object: int | None = None  # index into Scene.objects
    colour: Triple | None = None  # beside the text


@dataclass(frozen=True)
class LessonStep:
    text: str  # Markdown; a question if there is an answer
    view: dict[str, Any]  # see the schema's View; keys that differ from the start view
    answer: str = ""  # Markdown, revealed when asked for
    answer_view: dict[str, Any] = field(default_factory=dict)  # keys that differ from `view`
    headline: str = ""  # Markdown, a few words: a slide's title
    choices: tuple[Choice, ...] = ()  # of a question; exactly one is right

    def stops(self) -> list[tuple[str, dict[str, Any]]]:
        """Text and view, and then those of the answer: as one goes through a lesson."""
        asked = [(self.text, self.view)]
        return [*asked, (self.answer, self.view | self.answer_view)] if self.answer else asked

    def said(self) -> dict[Place, tuple[str, dict[str, Any]]]:
        """All its words by their places in the file, and the view that each is said with."""
        revealed = self.view | self.answer_view
        texts = {"headline": self.view, "text": self.view, "answer": revealed}
        said: dict[Place, tuple[str, dict[str, Any]]] = {}
        for key, view in texts.items():
            said[key,] = (getattr(self, key), view)
        for k, choice in enumerate(self.choices):
            said["choices", k, "text"] = (choice.text, self.view)
            said["choices", k, "because"] = (choice.because, revealed)
        return said

    def saying(self, words: dict[Place, str]) -> LessonStep:
        """The step with other words, by these places."""
        own = {str(key[0]): text for key, text in words.items() if len(key) == 1}
        choices = tuple(
            replace(
                choice,
                text=words["choices", k, "text"],
                because=words["choices", k, "because"],
            )
            for k, choice in enumerate(self.choices)
        )
        return replace(self, **own, choices=choices)  # type: ignore[arg-type]


@dataclass(frozen=True)
class Across:
    """What a sweep is crossed with: each of these values has a row of stops."""

    name: str  # "" if it has none of its own
    varies: str
    values: tuple[Any, ...]
    is_turned: bool = False  # values are degrees


@dataclass(frozen=True, eq=False)
class Sweep:
    """One value of a scene that takes several, stop by stop. Each stop is the scene with that
    value, validated as any scene; without a lesson, which is the scene's. Crossed with a second
    one, the stops are a grid's, row by row."""

    id: str  # its name as it can stand in an address
    name: str
    varies: str  # what, as its file says it: lights."light 1".position
    values: tuple[Any, ...]  # numbers, or lists of them: of a grid's columns
    own: int  # the stop that is the scene itself, of all
    resolutions: tuple[int, ...]  # whose rays are kept at each stop
    picture: int  # pixels across of each stop's
    stops: tuple[Scene, ...]
    across: Across | None = None  # of its rows
    is_turned: bool = False  # values are degrees

    @property
    def shape(self) -> tuple[int, int]:
        """How many columns and rows of stops; one row where it is not crossed."""
        return len(self.values), len(self.across.values) if self.across else 1


@dataclass(frozen=True, eq=False)
class Scene:
    id: str  # the folder's name, e.g. "05-many-bounces"
    path: Path  # of scene.toml
    key: str  # the key that selects it, "1".."9", "0", or ""
    title: str
    teaches: str  # one sentence
    camera: Camera
    render: Render
    background: Triple
    materials: tuple[Material, ...]
    objects: tuple[SceneObject, ...]
    lights: tuple[Light, ...]
    lesson: tuple[LessonStep, ...]
    goals: tuple[str, ...] = ()  # of the lesson: Markdown, a line each
    chapter: str = ""  # of the course, one of the schema's
    before: str = ""  # folder of the scene of its chapter that comes right after it
    mistakes: tuple[str, ...] = ()  # of mistakes.json, that it is good at showing
    sweeps: tuple[Sweep, ...] = ()
    # Of a lesson on another scene: that scene, whose rays, pictures and meshes it shows. All that
    # is here besides id, path, key, chapter, place and words is that scene's.
    base: Scene | None = None

    @property
    def traces(self) -> str:
        """The id of the scene that was traced for this one: as a rule its own."""
        return self.base.id if self.base else self.id

    def at_stop(self, named: str) -> Scene:
        """It at a stop of a sweep, by what views and addresses call that: "lamp-height:7"; itself
        where it is called nothing."""
        id, _, number = named.partition(":")
        found = [each.stops[int(number) - 1] for each in self.sweeps if each.id == id]
        return found[0] if named else self

    @property
    def has_glass(self) -> bool:
        """Whether light goes through any object."""
        return any(self.materials[obj.material].transmit > 0 for obj in self.objects)

    @property
    def has_mesh(self) -> bool:
        return any(isinstance(obj.shape, Mesh) for obj in self.objects)
