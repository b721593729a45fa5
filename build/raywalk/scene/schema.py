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
    Headline,
    LessonText,
    Maybe,
    Name,
    Point,
    Positive,
    Text,
    maybe,
    means,
    one_of,
    refusal,
)
from raywalk.scene.schema_choices import Choices, Index, Pixel
from raywalk.scene.schema_objects import AnyObject, MaterialTable
from raywalk.scene.schema_sweeps import SweepTable
from raywalk.scene.table import SINGLE, TABLE, Table, by_form
from raywalk.scene.wording import plain

VERSION = 1
DEFAULT_RESOLUTIONS = (5, 7, 11, 15, 21, 33, 55, 77, 105)
MOST_SAMPLES = 64  # lights an area light may become: every hit asks for each of them

Size = Annotated[int, Field(strict=True, ge=1, le=8192), Allowed("a whole number from 1 to 8192")]
Count = Annotated[int, Field(strict=True, ge=1), Allowed("a whole number of at least 1")]


Depth = Annotated[int, Field(strict=True, ge=0, le=1000), Allowed("a whole number from 0 to 1000")]
Resolutions = Annotated[
    tuple[Count, ...], Field(min_length=1), Allowed("a list of at least one whole number")
]
GlassShadows = Annotated[Literal["opaque", "pass"], one_of("opaque", "pass")]
Edges = Annotated[tuple[Point, Point], Allowed("two edges, [[x, y, z], [x, y, z]]")]
Samples = Annotated[tuple[Count, Count], Allowed("two whole numbers of at least 1")]


class CameraTable(Table):
    """A pinhole camera with a square picture."""

    eye: Point = means("where all camera rays start")
    target: Point = means("a point in the middle of the picture")
    up: Point = means("the direction that is upright in the picture", (0.0, 1.0, 0.0))
    fov: FieldOfView = means("vertical field of view, in degrees", 45.0)


class RenderTable(Table):
    """How far the rays are followed, and how many there are."""

    shadows: Flag = means("whether hits ask if each light is visible", True)
    depth: Depth = means("bounces at most, after the camera ray", 8)
    size: Size = means("the picture has size x size pixels", 1155)
    resolutions: Maybe[Resolutions] = maybe(
        "rays across each frustum; each divides size by an odd number, so that every "
        f"ray is a pixel's (default: those of {list(DEFAULT_RESOLUTIONS)} that do)"
    )
    glass_shadows: GlassShadows = means(
        "what glass does to light on its way to a hit: stop it, or let `transmit` "
        "of it pass, unbent",
        "opaque",
    )


class LightTable(Table):
    """A point light; with `edges` an area light, made of point lights."""

    name: Maybe[Name] = maybe('what a person calls it; default "light 1" and so on')
    position: Point = means("where it is; of an area light, one corner")
    colour: Brightness = means("of its light", (1.0, 1.0, 1.0))
    intensity: AtLeastZero = means("factor of the colour, at distance 0", 1.0)
    attenuation: Falloff = means(
        "light at distance D is divided by a0 + a1 D + a2 D^2", (1.0, 0.0, 0.0)
    )
    edges: Maybe[Edges] = maybe("the two sides from the corner, in world units: an area light")
    size: Positive = means("factor of both sides about the middle: a larger or smaller lamp", 1.0)
    samples: Maybe[Samples] = maybe(
        "point lights along each edge, in the middle of equal cells "
        f"(default [4, 4], together at most {MOST_SAMPLES})"
    )

    @model_validator(mode="after")
    def _sampled(self) -> Self:
        if self.size != 1 and not self.edges:
            raise refusal("only an area light has a size", at="size", hint="give it edges")
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

    eye: Point = means("where the observer is")
    target: Point = means("what the observer looks at")


def _observer_form(value: Any) -> str | None:
    return by_form(value) if isinstance(value, str | dict | Table) else None


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
BRIGHTEST = 2.0
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


Side = Annotated[
    Literal["left", "right", "above", "below"], one_of("left", "right", "above", "below")
]
Sides = Annotated[
    dict[str, Side],
    Allowed("a table of names on the stage", hint='write labels = { "light 1" = "left" }'),
]
Names = Annotated[tuple[Text, ...], Allowed("a list of names of objects and lights")]


Works = Annotated[Literal["equation", "tree", "average"], one_of("equation", "tree", "average")]
TreeDepth = Annotated[
    Literal["none", "sphere", "1", "2", "4", "8", "all"],
    one_of("none", "sphere", "1", "2", "4", "8", "all"),
]
RaysATile = Annotated[Literal[1, 9, 25, 49], Allowed("1, 9, 25 or 49")]


Ordinal = Annotated[int, Field(strict=True, ge=1)]
# Of a grid's stops its number, or column and row.
StopNumber = Annotated[
    Ordinal | tuple[Ordinal, Ordinal],
    Allowed(
        "a whole number of at least 1, or [column, row] of such",
        hint='write sweep = { "lamp height" = 7 }',
    ),
]  # fmt: skip
Stop = Annotated[
    dict[str, StopNumber], Field(min_length=1, max_length=1),
    Allowed("a table of one sweep", hint='write sweep = { "lamp height" = 7 }'),
]  # fmt: skip


class SwitchesTable(Table):
    """What-if switches: how the tiles and rays would be with other settings."""

    bounces: Maybe[Index] = maybe("bounces at most; as many as render.depth, or fewer")
    lights: Maybe[Dimmed] = maybe("factor of each named light's brightness, 0 for off")
    shadows: Maybe[Flag] = maybe("false: every light counts as seen")
    without: Maybe[Parts] = maybe("parts of a colour to leave out")


class ViewTable(Table):
    """What a step of the lesson shows; what is left out is as at the start."""

    resolution: Maybe[Count] = maybe("one of the scene's resolutions")
    pixel: Maybe[Pixel] = maybe("the selected ray, [column, row] from the top left")
    rays: Maybe[Rays] = maybe("which rays are drawn; [] draws none")
    tiles: Maybe[Tiles] = maybe("whether the frustum's tiles show their colours")
    look: Maybe[Look] = maybe("how the stage shows the scene; traced needs the camera's view")
    slice: Maybe[Slice] = maybe("the selected row's or column's plane of rays, drawn flat")
    observer: Maybe[Observer] = maybe("where the observer stands")
    switches: Maybe[SwitchesTable] = maybe("what-if switches")
    colours: Maybe[Colours] = maybe("what the tiles show: the picture, or what it cost")
    highlight: Maybe[Names] = maybe("objects and lights that are ringed and named on the stage")
    labels: Maybe[Sides] = maybe("on which side of its thing a name on the stage stands")
    boxes: Maybe[Flag] = maybe("whether the boxes that the selected ray tested are drawn")
    works: Maybe[Works] = maybe(
        "what is worked out beside the stage for the selected ray: where it meets each sphere, by "
        "its equation; how it goes through a mesh's tree of boxes; the mean of the finer grids' "
        "rays in its tile"
    )
    tree_depth: Maybe[TreeDepth] = maybe("levels of the tree that the step begins with")
    rays_a_tile: Maybe[RaysATile] = maybe("rays of the mean that the step begins with")
    sweep: Maybe[Stop] = Field(
        default=None, json_schema_extra={"viewer": "string"},
        description="a sweep by its name, and the stop that is shown, counted from 1; of a grid's "
        "stops (`across`) its number, row by row, or `[column, row]`",
    )  # fmt: skip


class StepTable(Table):
    """A step of the lesson. With an answer it is a question: predict, then reveal."""

    text: LessonText = means(
        "what is said or asked, in Markdown, with $formulas$, {slots} for figures and "
        "![words](a picture.png); slides and worksheets have of an .svg its words"
    )
    view: ViewTable = Field(default_factory=ViewTable, description="what is shown")
    headline: Maybe[Headline] = maybe(
        "a slide's title, of at most 8 words (default: the text's first sentence, if it is short)"
    )
    answer: Maybe[LessonText] = maybe("what is said once everyone has predicted, in Markdown")
    answer_view: Maybe[ViewTable] = maybe(
        "what is shown with the answer; what is left out is as in view"
    )
    choices: Choices = means("of a question: what one chooses from before the answer", ())


def _tables(name: str) -> Allowed:
    return Allowed("a list of tables", hint=f"write [[{name}]], with two brackets, before each")


Materials = Annotated[
    dict[str, MaterialTable],
    Allowed("a table of materials", hint="write [materials.NAME] before each"),
]
Objects = Annotated[tuple[AnyObject, ...], _tables("objects")]
Lights = Annotated[tuple[LightTable, ...], _tables("lights")]
Lesson = Annotated[tuple[StepTable, ...], _tables("lesson")]
Sweeps = Annotated[tuple[SweepTable, ...], _tables("sweeps")]
GOALS = (2, 4)  # fewer are no list, more nobody remembers
Goals = Annotated[
    tuple[LessonText, ...], Field(min_length=GOALS[0], max_length=GOALS[1]),
    Allowed("a list of 2 to 4 texts"),
]  # fmt: skip
# In the order in which the course goes through them.
ChapterName = Literal["rays", "light", "mirrors", "triangles", "glass", "sampling", "pictures"]
Chapter = Annotated[ChapterName, one_of(*get_args(ChapterName))]
Key = Annotated[Literal["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"], one_of(*"0123456789")]


class SceneFile(Table):
    """What is there, how it is lit, from where it is seen, and what is said about it."""

    version: Annotated[Literal[1], Allowed("a version this program reads, which is 1")] = means(
        "of this format, which is 1"
    )
    key: Maybe[Key] = maybe("the key that selects the scene in the viewer")
    chapter: Maybe[Chapter] = maybe(
        "of the course: where the scene stands among all; without one, after all that have one"
    )
    before: Maybe[Name] = maybe(
        "the folder of a scene of the same chapter: this one stands right before it; without it, "
        "by its own folder's name"
    )
    title: Text = means("a few words")
    teaches: Text = means("one sentence: what a student takes home")
    goals: Maybe[Goals] = maybe(
        "2 to 4 sentences for the lesson's first slide: what a student can do after it"
    )
    background: Brightness = means("what a ray brings back that leaves the scene", (0.0, 0.0, 0.0))
    mistakes: Annotated[
        tuple[Name, ...],
        Allowed("a list of names, as the pages of mistakes have in their addresses"),
    ] = means(
        "that this scene is good at showing: their pages show them here; without, the site chooses "
        "by how plainly they show",
        (),
    )
    camera: CameraTable = means("where the picture is taken from")
    render: RenderTable = Field(default_factory=RenderTable, description="how far and how finely")
    materials: Materials = means("this scene's own materials, by name", {})
    objects: Objects = means("what the rays may hit", ())
    lights: Lights = means("where light comes from", ())
    sweeps: Sweeps = means("what can be moved or changed by a slider, stop by stop", ())
    lesson: Lesson = means("the steps, in order: a text and what is shown meanwhile", ())


class LessonFile(Table):
    """Another lesson on a scene that is there: it has that scene's objects, light, camera and rays,
    which are not traced again, and a page, slides and sheets of its own."""

    version: Annotated[Literal[1], Allowed("a version this program reads, which is 1")] = means(
        "of this format, which is 1"
    )
    scene: Name = means("the folder of the scene that it is about, beside its own")
    chapter: Maybe[Chapter] = maybe("of the course, as a scene's")
    before: Maybe[Name] = maybe("its place in the chapter, as a scene's")
    title: Text = means("a few words")
    teaches: Text = means("one sentence: what a student takes home")
    goals: Maybe[Goals] = maybe(
        "2 to 4 sentences for the lesson's first slide: what a student can do after it"
    )
    lesson: Annotated[
        Lesson, Field(min_length=1), Allowed("at least one step", hint="write [[lesson]]")
    ] = means("the steps, in order: a text and what is shown meanwhile")
