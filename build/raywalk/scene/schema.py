"""The TOML of a scene file. What it means, geometrically, is checked elsewhere (checks.py)."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self, get_args

from pydantic import Discriminator, Field, model_validator

from raywalk.scene.fields import (
    Allowed,
    AtLeastZero,
    Brightness,
    Falloff,
    FieldOfView,
    Flag,
    LessonText,
    Maybe,
    Name,
    Point,
    Text,
    one_of,
    refusal,
)
from raywalk.scene.schema_objects import AnyObject, MaterialTable
from raywalk.scene.table import SINGLE, TABLE, Table, by_form
from raywalk.scene.wording import plain

VERSION = 1
DEFAULT_RESOLUTIONS = (5, 7, 11, 15, 21, 33, 55, 77, 105)
MOST_SAMPLES = 64  # lights an area light may become: every hit asks for each of them

Size = Annotated[int, Field(strict=True, ge=1, le=8192), Allowed("a whole number from 1 to 8192")]
Count = Annotated[int, Field(strict=True, ge=1), Allowed("a whole number of at least 1")]
Index = Annotated[int, Field(strict=True, ge=0), Allowed("a whole number of at least 0")]


Depth = Annotated[int, Field(strict=True, ge=0, le=1000), Allowed("a whole number from 0 to 1000")]
Resolutions = Annotated[
    tuple[Count, ...], Field(min_length=1), Allowed("a list of at least one whole number")
]
GlassShadows = Annotated[Literal["opaque", "pass"], one_of("opaque", "pass")]
Edges = Annotated[tuple[Point, Point], Allowed("two edges, [[x, y, z], [x, y, z]]")]
Samples = Annotated[tuple[Count, Count], Allowed("two whole numbers of at least 1")]


class CameraTable(Table):
    """A pinhole camera with a square picture."""

    eye: Point = Field(description="where all camera rays start")
    target: Point = Field(description="a point in the middle of the picture")
    up: Point = Field(
        default=(0.0, 1.0, 0.0), description="the direction that is upright in the picture"
    )
    fov: FieldOfView = Field(default=45.0, description="vertical field of view, in degrees")


class RenderTable(Table):
    """How far the rays are followed, and how many there are."""

    shadows: Flag = Field(default=True, description="whether hits ask if each light is visible")
    depth: Depth = Field(default=8, description="bounces at most, after the camera ray")
    size: Size = Field(default=1155, description="the picture has size x size pixels")
    resolutions: Maybe[Resolutions] = Field(
        default=None,
        description="rays across each frustum; each divides size by an odd number, so that every "
        f"ray is a pixel's (default: those of {list(DEFAULT_RESOLUTIONS)} that do)",
    )
    glass_shadows: GlassShadows = Field(
        default="opaque",
        description="what glass does to light on its way to a hit: stop it, or let `transmit` "
        "of it pass, unbent",
    )


class LightTable(Table):
    """A point light; with `edges` an area light, made of point lights."""

    name: Maybe[Name] = Field(
        default=None, description='what a person calls it; default "light 1" and so on'
    )
    position: Point = Field(description="where it is; of an area light, one corner")
    colour: Brightness = Field(default=(1.0, 1.0, 1.0), description="of its light")
    intensity: AtLeastZero = Field(default=1.0, description="factor of the colour, at distance 0")
    attenuation: Falloff = Field(
        default=(1.0, 0.0, 0.0),
        description="light at distance D is divided by a0 + a1 D + a2 D^2",
    )
    edges: Maybe[Edges] = Field(
        default=None, description="the two sides from the corner, in world units: an area light"
    )
    samples: Maybe[Samples] = Field(
        default=None,
        description="point lights along each edge, in the middle of equal cells "
        f"(default [4, 4], together at most {MOST_SAMPLES})",
    )

    @model_validator(mode="after")
    def _sampled(self) -> Self:
        if self.samples and not self.edges:
            raise refusal("only an area light has samples", at="samples", hint="give it edges")
        if self.samples and self.samples[0] * self.samples[1] > MOST_SAMPLES:
            raise refusal(
                f"{plain(self.samples)} makes {self.samples[0] * self.samples[1]} lights",
                at="samples",
                allowed=f"allowed: at most {MOST_SAMPLES}",
            )
        return self

    @model_validator(mode="after")
    def _fades(self) -> Self:
        if not any(self.attenuation):
            raise refusal(
                f"{plain(self.attenuation)} divides the light by 0",
                at="attenuation",
                allowed="allowed: not all three 0; [1, 0, 0] for light that does not fade",
            )
        return self


class ObserverTable(Table):
    """Where the observer stands in a step of the lesson."""

    eye: Point = Field(description="where the observer is")
    target: Point = Field(description="what the observer looks at")


def _observer_form(value: Any) -> str | None:
    return by_form(value) if isinstance(value, str | dict | Table) else None


Pixel = Annotated[tuple[Index, Index], Allowed("a pixel, [column, row] from the top left")]
RayChoice = Annotated[
    Literal["pixel", "row", "column", "all"], one_of("pixel", "row", "column", "all")
]
Rays = Annotated[tuple[RayChoice, ...], Allowed('a list of "pixel", "row", "column", "all"')]
Tiles = Annotated[Literal["empty", "filled"], one_of("empty", "filled")]
Look = Annotated[
    Literal["plain", "approximate", "traced"], one_of("plain", "approximate", "traced")
]
Slice = Annotated[Literal["none", "row", "column"], one_of("none", "row", "column")]
Place = Annotated[Literal["start", "camera"], one_of("start", "camera")]
Observer = Annotated[
    Annotated[Place, SINGLE] | Annotated[ObserverTable, TABLE],
    Discriminator(_observer_form),
    Allowed('"start", "camera" or a table of eye and target'),
]


Part = Annotated[
    Literal["ambient", "diffuse", "specular", "reflected", "refracted"],
    one_of("ambient", "diffuse", "specular", "reflected", "refracted"),
]
Parts = Annotated[
    tuple[Part, ...],
    Allowed('a list of "ambient", "diffuse", "specular", "reflected", "refracted"'),
]
BRIGHTEST = 2.0  # in viewer/state/switches.ts too
Dimming = Annotated[
    float, Field(strict=True, ge=0, le=BRIGHTEST, allow_inf_nan=False),
    Allowed(f"a number from 0 to {BRIGHTEST:g}"),
]  # fmt: skip
Dimmed = Annotated[
    dict[str, Dimming], Allowed("a table of lights", hint='write lights = { "light 1" = 0 }')
]
# What tiles can show; the viewer's state/costs.ts has a formula for each.
TileColours = Literal["picture", "rays", "depth", "tests", "distance", "shadow", "normal"]
Colours = Annotated[TileColours, one_of(*get_args(TileColours))]


class SwitchesTable(Table):
    """What-if switches: how the tiles and rays would be with other settings."""

    bounces: Maybe[Index] = Field(
        default=None, description="bounces at most; as many as render.depth, or fewer"
    )
    lights: Maybe[Dimmed] = Field(
        default=None, description="factor of each named light's brightness, 0 for off"
    )
    shadows: Maybe[Flag] = Field(default=None, description="false: every light counts as seen")
    without: Maybe[Parts] = Field(default=None, description="parts of a colour to leave out")


class ViewTable(Table):
    """What a step of the lesson shows; what is left out is as at the start."""

    resolution: Maybe[Count] = Field(default=None, description="one of the scene's resolutions")
    pixel: Maybe[Pixel] = Field(
        default=None, description="the selected ray, [column, row] from the top left"
    )
    rays: Maybe[Rays] = Field(default=None, description="which rays are drawn; [] draws none")
    tiles: Maybe[Tiles] = Field(
        default=None, description="whether the frustum's tiles show their colours"
    )
    look: Maybe[Look] = Field(
        default=None, description="how the stage shows the scene; traced needs the camera's view"
    )
    slice: Maybe[Slice] = Field(
        default=None, description="the selected row's or column's plane of rays, drawn flat"
    )
    observer: Maybe[Observer] = Field(default=None, description="where the observer stands")
    switches: Maybe[SwitchesTable] = Field(default=None, description="what-if switches")
    colours: Maybe[Colours] = Field(
        default=None, description="what the tiles show: the picture, or what it cost"
    )


class StepTable(Table):
    """A step of the lesson. With an answer it is a question: predict, then reveal."""

    text: LessonText = Field(description="what is said or asked, in Markdown with $formulas$")
    view: ViewTable = Field(default_factory=ViewTable, description="what is shown")
    answer: Maybe[LessonText] = Field(
        default=None, description="what is said once everyone has predicted, in Markdown"
    )
    answer_view: Maybe[ViewTable] = Field(
        default=None, description="what is shown with the answer; what is left out is as in view"
    )

    @model_validator(mode="after")
    def _answers(self) -> Self:
        if self.answer_view is not None and self.answer is None:
            raise refusal("there is no answer to show it with", at="answer_view")
        return self


def _tables(name: str) -> Allowed:
    return Allowed("a list of tables", hint=f"write [[{name}]], with two brackets, before each")


Key = Annotated[Literal["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"], one_of(*"0123456789")]


class SceneFile(Table):
    """What is there, how it is lit, from where it is seen, and what is said about it."""

    version: Annotated[Literal[1], Allowed("a version this program reads, which is 1")] = Field(
        description="of this format, which is 1"
    )
    key: Maybe[Key] = Field(
        default=None, description="the key that selects the scene in the viewer"
    )
    title: Text = Field(description="a few words")
    teaches: Text = Field(description="one sentence: what a student takes home")
    background: Brightness = Field(
        default=(0.0, 0.0, 0.0), description="what a ray brings back that leaves the scene"
    )
    camera: CameraTable = Field(description="where the picture is taken from")
    render: RenderTable = Field(default_factory=RenderTable, description="how far and how finely")
    materials: Annotated[
        dict[str, MaterialTable],
        Allowed("a table of materials", hint="write [materials.NAME] before each"),
    ] = Field(default={}, description="this scene's own materials, by name")
    objects: Annotated[tuple[AnyObject, ...], _tables("objects")] = Field(
        default=(), description="what the rays may hit"
    )
    lights: Annotated[tuple[LightTable, ...], _tables("lights")] = Field(
        default=(), description="where light comes from"
    )
    lesson: Annotated[tuple[StepTable, ...], _tables("lesson")] = Field(
        default=(), description="the steps, in order: a text and what is shown meanwhile"
    )
