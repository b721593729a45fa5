"""A lesson's stops as the viewer's modules have them (Lesson in viewer/stops/lesson.ts), read
from JSON. World units where it says so; else points from the figure's top left, y down."""

from __future__ import annotations

import base64
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator, ConfigDict, TypeAdapter
from pydantic.alias_generators import to_camel

from raywalk.scene.model import Scene


class FromNode:
    """TypeScript's names are Python's but for their capitals; every one must be known."""

    __pydantic_config__ = ConfigDict(
        alias_generator=to_camel, extra="forbid", arbitrary_types_allowed=True
    )


def _ends(four: Any) -> Any:
    return (four[:2], four[2:]) if isinstance(four, list) else four


def _bytes(text: Any) -> Any:
    return np.frombuffer(base64.b64decode(text), np.uint8) if isinstance(text, str) else text


Point = tuple[float, float]
Vector = tuple[float, float, float]  # world units, or a linear colour
Ends = Annotated[tuple[Point, Point], BeforeValidator(_ends)]
Bytes = Annotated[np.ndarray, BeforeValidator(_bytes)]
Colours = Annotated[np.ndarray, BeforeValidator(lambda text: _bytes(text).reshape(-1, 3))]
Matrix = Annotated[np.ndarray, BeforeValidator(np.array)]


@dataclass(frozen=True)
class Piece(FromNode):
    """A stretch of a line before the observer, as far as it is all seen or all hidden."""

    ends: Ends
    hidden: bool
    arrives: bool  # at the line's end


@dataclass(frozen=True)
class ThinLine(FromNode):
    """A ray or shadow ray of a pixel that is not the selected one."""

    kind: str
    pieces: tuple[Piece, ...]


@dataclass(frozen=True)
class ChosenLine(ThinLine):
    """A ray, or a shadow ray, of the selected pixel."""

    ray: int  # its number; of a shadow ray: that of the ray whose hit it leaves
    light: int  # of a shadow ray, else -1
    leaves: bool  # it leaves the scene and ends nowhere
    to: Vector  # world units
    whole: Ends | None  # None behind the observer, as with all points
    end: Point | None
    tip: Point | None  # of the surface's normal there


@dataclass(frozen=True)
class Lamp(FromNode):
    name: str
    at: Point | None
    off: bool


@dataclass(frozen=True)
class Ring(FromNode):
    """Round what the stop points at: a closed line, not cut at the frame."""

    name: str
    is_lamp: bool
    outline: tuple[Point, ...]


@dataclass(frozen=True)
class BoxLine(FromNode):
    """An edge of one of a mesh's boxes."""

    what: str  # level, entered, missed, cutOff
    ends: Ends


@dataclass(frozen=True, eq=False)
class Figure(FromNode):
    """The picture plane, the ray-tracing camera and the lights from where the observer stands."""

    grid: Matrix  # (3, 3): (column, row, 1) -> (x w, y w, w), w the depth
    near: float  # nearer than this nothing is drawn; world units
    eye: Point | None
    edges: tuple[Ends | None, ...]  # from the eye to the picture plane's corners
    lamps: tuple[Lamp, ...]
    rings: tuple[Ring, ...]
    boxes: tuple[BoxLine, ...]

    def on_plane(self, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """(..., 3) x, y and depth of the grid's corners."""
        at = np.stack([columns, rows, np.ones_like(columns)], axis=-1) @ self.grid.T
        with np.errstate(divide="ignore", invalid="ignore"):
            at[..., :2] /= at[..., 2:]
        return at


@dataclass(frozen=True)
class Row(FromNode):
    """One of the selected pixel's rays, as the card has it."""

    number: int
    kind: str
    object: str  # "" if it leaves the scene
    point: Vector
    t: float | None  # None if it leaves the scene
    share: float  # in the pixel's colour
    keeps: float  # share of the surface's own colour in the ray's
    colour: Vector  # what it brings back
    own: Vector  # what it adds by itself, before its share
    gives: Vector  # what it adds to the pixel
    shows: str  # its colour, #rrggbb
    shows_given: str


@dataclass(frozen=True)
class Event(FromNode):
    """One thing that happens to a ray, in words and numbers."""

    what: str
    ray: int
    light: int  # of a shadow ray's event, else -1
    says: str
    phrases: tuple[tuple[str, str | None], ...]  # None: plain, "": bold, else a kind of ray
    numbers: str

    @property
    def in_words(self) -> str:
        return " ".join(part for part in (self.says, self.numbers) if part)


@dataclass(frozen=True)
class Switches(FromNode):
    """What is not as traced."""

    bounces: int | None
    lamps: tuple[tuple[str, float], ...]  # factor of each dimmed light
    shadows: bool
    without: tuple[str, ...]


@dataclass(frozen=True)
class Picture(FromNode):
    """A grid's tiles, (3 n n,) 8-bit."""

    n: int
    tiles: Bytes


@dataclass(frozen=True)
class StripPicture(Picture):
    """The finest grid at another stop of the sweep."""

    value: str  # what is moved, in few words
    is_here: bool  # the one at which the step is


@dataclass(frozen=True)
class Strip(FromNode):
    """Three to five stops of a sweep; two where it has no more."""

    name: str
    pictures: tuple[StripPicture, ...]


@dataclass(frozen=True, eq=False)
class Stop(FromNode):
    """A step of the lesson, or the answer to its question: what a slide of it shows."""

    step: int  # of the lesson, from 0
    kind: str  # step, question, answer
    viewpoint: int  # which shaded view lies behind it
    n: int  # tiles across and down
    pixel: tuple[int, int]  # column, row from the top left
    filled: bool  # whether the tiles show their colours
    observer: dict[str, Any]  # eye, target, up (world units), fov (degrees)
    is_camera: bool  # the observer looks through the ray-tracing camera
    is_elsewhere: bool  # it is rasterised on the page, with what paper cannot show
    colours: str  # what filled tiles show: the picture, or what it cost
    switches: Switches
    is_switched: bool
    one_in: int  # of how many pixels the thin lines show one
    figure: Figure
    chosen: tuple[ChosenLine, ...]
    thin: tuple[ThinLine, ...]
    tiles: Colours | None  # (n * n, 3) 8-bit; None where they are empty
    hidden_tiles: frozenset[int]
    picture: Picture | None  # the finest grid with the switches set
    bytes: tuple[int, int, int]  # the selected tile's colour
    rows: tuple[Row, ...]  # of the selected pixel's rays; none where they are not walked
    events: tuple[Event, ...]
    strip: Strip | None = None  # of that sweep; None where a question is asked
    moved: str = ""  # at which stop of a sweep the scene is shown, in words

    @property
    def walk(self) -> tuple[int, tuple[int, int], Switches, str]:
        """Whose rays its rows are: of each stop at this pixel that is switched and moved alike."""
        return self.n, self.pixel, self.switches, self.moved

    def text(self, scene: Scene) -> str:
        """Its words in the lesson, Markdown."""
        step = scene.lesson[self.step]
        return step.answer if self.kind == "answer" else step.text


@dataclass(frozen=True, eq=False)
class Lesson(FromNode):
    """As there."""

    stops: tuple[Stop, ...]


LESSON = TypeAdapter(Lesson)


def read_stops(file: Path) -> list[Stop]:
    """The lesson's stops."""
    return list(LESSON.validate_json(file.read_bytes()).stops)
