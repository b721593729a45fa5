"""What a scene's scripts hold besides its rays: all that the viewer knows of a scene.

The viewer's own types are made from these (viewer_types.py). World units, right-handed, +y up;
colours linear, 1 is full. NotRequired is left out where it does not apply.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal, NotRequired

from pydantic import Field, WithJsonSchema
from typing_extensions import TypedDict

from raywalk.scene.model import Camera, Material
from raywalk.scene.shapes import DRAWN


def _list_of(*parts: dict[str, str]) -> WithJsonSchema:
    return WithJsonSchema({"type": "array", "prefixItems": list(parts)})


_VECTOR = {"viewer": "Vec3"}
Vec3 = Annotated[list[float], WithJsonSchema(_VECTOR)]
TwoVec3 = Annotated[list[list[float]], _list_of(_VECTOR, _VECTOR)]
ThreeVec3 = Annotated[list[list[float]], _list_of(_VECTOR, _VECTOR, _VECTOR)]
Pixel = Annotated[list[int], _list_of({"type": "integer"}, {"type": "integer"})]
# As the scene's file has it: the schema's ViewTable without what it leaves out.
View = Annotated[dict[str, Any], WithJsonSchema({"viewer": "View"})]
Others = Annotated[dict[str, Any], WithJsonSchema({"viewer": "object"})]
Drawn = Annotated[str, WithJsonSchema({"enum": DRAWN})]
# Keys of words/<language>.json, below "savings".
Stage = Literal["meshes", "shadows", "highlights", "reflection", "refraction"]
Saving = Literal[
    "shadow", "turned", "colourless", "dark", "unshadowed", "faint", "tests", "mesh", "kept"
]


class CheckerData(TypedDict):
    size: float
    material: int  # of the odd squares
    axes: TwoVec3
    origin: Vec3


class TileData(TypedDict):
    """A small picture with which a plane is drawn, again and again: base64 of 8-bit red, green,
    blue, row 0 below. The way from `origin` times an axis is how many of it lie between."""

    width: int
    pixels: str
    axes: TwoVec3
    origin: Vec3


class ObjectData(TypedDict):
    """Canonical shapes, placed by `transform`, 16 numbers, column-major (as three's
    Matrix4.fromArray): sphere of radius 1; plane y = 0 facing +y; cylinder x^2 + y^2 = w^2,
    |z| <= 1 with w rising from `tip` to 1; box |x|,|y|,|z| <= 1; disc z = 0 of radius 1 facing +z;
    triangle (0,0,0) (1,0,0) (0,1,0); a mesh in its own coordinates."""

    name: str
    type: Drawn
    label: str  # the word a person reads: "ellipsoid", "mesh", ...
    material: int  # index into SceneData.materials
    transform: list[float]
    open: NotRequired[bool]  # a cylinder without caps
    tip: NotRequired[float]  # of a cone: a cylinder's radius at z = -1, else 1
    mesh: NotRequired[str]  # key into SceneData.meshes: what it is drawn as
    checker: NotRequired[CheckerData]
    base: NotRequired[Vec3]  # it has a base colour, which differs from place to place: its mean
    tile: NotRequired[TileData]  # of a plane


class MeshData(TypedDict):
    """Base64 of byte planes: all low bytes, then all next ones. Positions: 2 planes of steps of
    65535 over box[0]..box[1], normals (absent when flat): 1 plane, / 127; both axis by axis,
    each the difference to the vertex before, modulo the planes' range. Colours (base colours,
    where there are some) like normals, of 255. Indices: 4 planes, how far behind the next new
    vertex; 0 is that new one."""

    box: TwoVec3
    positions: str
    normals: NotRequired[str]
    colours: NotRequired[str]
    indices: str


class LightData(TypedDict):
    """attenuation: a0, a1, a2 of light that is 1 / (a0 + a1 d + a2 d^2) as strong at distance d."""

    name: str
    position: Vec3
    colour: Vec3
    intensity: float
    attenuation: Vec3


class LessonStop(TypedDict):
    """html: rendered and sanitised."""

    html: str
    view: View


class ChoiceData(TypedDict):
    """Of a question: words, or a pixel or an object, and why it is right or wrong. html and
    because: rendered and sanitised, of a line."""

    html: str  # "" of a pixel or an object
    because: str
    right: NotRequired[bool]  # true, of exactly one
    pixel: NotRequired[Pixel]
    object: NotRequired[int]  # index into SceneData.objects
    colour: NotRequired[Vec3]


class LessonStepData(LessonStop):
    """With an answer, the step is a question."""

    answer: NotRequired[LessonStop]
    choices: NotRequired[list[ChoiceData]]


class StartData(TypedDict):
    resolution: int
    pixel: Pixel


class BoundsData(TypedDict):
    """A sphere round everything finite: objects, lights, eye."""

    center: Vec3
    radius: float


class Savings(TypedDict):
    """What tracing a scene did not have to do. counts: key, how many, of how many; that is 0
    where it is not to be shown."""

    notRun: list[Stage]
    counts: list[tuple[Saving, int, int]]


SweptUnit = Literal["degrees"]  # of numbers that have one


class AcrossData(TypedDict):
    """What a sweep is crossed with: of each value a row of stops."""

    name: NotRequired[str]  # if it has one of its own
    values: list[float | list[float]]
    unit: NotRequired[SweptUnit]


class SweepData(TypedDict):
    """What can be moved: its stops are numbered from 1, as in addresses; of a grid row by row:
    (row - 1) * values.length + column."""

    id: str  # the folder of its files beside scene.js
    name: str
    values: list[float | list[float]]  # of a grid's columns
    unit: NotRequired[SweptUnit]
    across: NotRequired[AcrossData]
    own: int  # the stop that is the scene itself, of all
    anew: NotRequired[
        bool
    ]  # True: the stage draws some stops anew, whose colours or planes are other
    points: NotRequired[list[int]]  # of each lamp at most, where stops differ in them


class SceneData(TypedDict):
    """scenes/<id>/scene.js"""

    format: Literal[1]
    id: str
    of: str  # whose rays, pictures and meshes it shows: its own id, or of a lesson that scene's
    key: str  # "1".."9", "0" or ""
    title: str
    teaches: str
    picture: str  # file name beside scene.js
    size: int  # the picture is size x size
    camera: Camera
    background: Vec3
    shadows: bool
    depth: int
    levels: list[int]  # frustum resolutions, ascending; <n>.js beside scene.js
    start: StartData
    bounds: BoundsData
    materials: list[Material]
    objects: list[ObjectData]
    meshes: dict[str, MeshData]
    lights: list[LightData]
    lesson: list[LessonStepData]
    savings: Savings
    files: dict[str, str]  # the marks of the scripts beside it: of this build, and no other
    sweeps: NotRequired[list[SweepData]]
    deepest: NotRequired[int]  # depth of a stop that goes deeper than the scene and all others
    sweepNames: NotRequired[list[str]]  # in another language, laid over by its words
    acrossNames: NotRequired[list[str]]  # likewise; "" where there is none


class StopData(TypedDict):
    """What of SceneData is other at a stop; of objects, lights and materials what is other of
    each. Lights with names are all of them, in place of the scene's."""

    picture: str
    camera: NotRequired[Camera]
    background: NotRequired[Vec3]
    shadows: NotRequired[bool]
    depth: NotRequired[int]
    objects: NotRequired[list[Others]]
    lights: NotRequired[list[Others]]
    materials: NotRequired[list[Others]]


class StopsData(TypedDict):
    """scenes/<id>/<sweep>/stops.js"""

    format: Literal[1]
    scene: str
    sweep: str
    stops: list[StopData]


class LessonData(TypedDict):
    """scenes/<id>/scene.js of a lesson on another scene: what it has of its own. Laid over that
    scene's it is a SceneData."""

    format: Literal[1]
    id: str
    of: str  # the other scene's id
    key: str
    title: str
    teaches: str
    start: StartData
    lesson: list[LessonStepData]
    files: dict[str, str]  # of scripts beside it, which are not the other scene's


class WorkedSphere(TypedDict):
    """A sphere's equation for a ray, t^2 + 2 b t + c = 0, as trace/equations.py has it."""

    object: int
    centre: Vec3
    radius: float
    b: float
    c: float
    discriminant: float
    t: list[float]  # the two roots, or none


class WorkedRay(TypedDict):
    n: int
    pixel: Annotated[list[int], Field(min_length=2, max_length=2)]
    origin: Vec3
    direction: Vec3
    spheres: list[WorkedSphere]


class WorkedTree(TypedDict):
    """As trace/mesh_visits.py writes it."""

    object: int
    n: int
    triangles: int
    sphere: list[float]
    boxes: list[list[float]]  # low, high, level, triangles in it
    visits: list[list[float]]  # by ray: box, what, t; and so on
    tests: dict[str, list[int]]  # by cut, by ray


class WorkedAverage(TypedDict):
    """As trace_file/nested.py writes it."""

    n: int
    across: list[int]
    samples: list[str]
    means: list[str]


class WorkedData(TypedDict):
    """scenes/<id>/worked.js"""

    format: Literal[1]
    scene: str
    equations: NotRequired[list[WorkedRay]]
    tree: NotRequired[WorkedTree]
    average: NotRequired[WorkedAverage]


class SceneWords(TypedDict):
    """scenes/<id>/words-<language>.js. lesson: with its views, which name lights."""

    title: str
    teaches: str
    objects: list[str]
    lights: list[str]
    materials: list[str]
    lesson: list[LessonStepData]
    sweepNames: NotRequired[list[str]]
    acrossNames: NotRequired[list[str]]


# The slope of a section's plane, and outlines in it: object, kind, whole steps x, y, ...
SectionRecord = tuple[float, list[list[int]]]


class SectionsData(TypedDict):
    """scenes/<id>/sections.js, as trace/sections.py writes it; rows and columns of the picture."""

    format: Literal[1]
    scene: str
    step: float  # world units
    eye: Vec3
    frame: ThreeVec3  # right, up, forward
    rows: dict[str, SectionRecord]
    columns: dict[str, SectionRecord]


class Surroundings(TypedDict):
    """Of one mirror or glass body; see trace/surroundings.py."""

    object: int  # index into SceneData.objects
    centre: Vec3
    radius: float
    picture: str  # a data URI
    turns: list[list[float]]


class FlatMirror(TypedDict):
    """Of a plane, disc or triangle how much it mirrors."""

    object: int  # index into SceneData.objects
    share: float


class SurroundingsData(TypedDict):
    """scenes/<id>/surroundings.js, as trace/surroundings.py writes it."""

    format: Literal[2]
    scene: str
    objects: list[Surroundings]
    flat: list[FlatMirror]
    background: Vec3  # what is seen where there is nothing


class MeshBoxes(TypedDict):
    """A mesh's bounding volumes. parents: -1 for the first box; each stands before its children.
    levels: by n, of the sphere and then of each box, how many camera rays one after the other
    miss it, enter it, miss it ..."""

    object: int  # index into SceneData.objects
    triangles: int
    sphere: tuple[float, float, float, float]  # centre, radius
    boxes: list[list[float]]  # low corner, high corner
    parents: list[int]
    levels: dict[str, list[list[int]]]


class BoxesData(TypedDict):
    """scenes/<id>/boxes.js, as trace/mesh_boxes.py writes it."""

    format: Literal[1]
    scene: str
    primitives: int  # shapes that each ray is tested against besides
    meshes: list[MeshBoxes]
