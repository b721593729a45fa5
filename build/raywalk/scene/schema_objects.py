"""The TOML of objects: materials, shapes, transforms."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Discriminator, Field, Tag

from raywalk.scene.fields import (
    Allowed,
    AtLeastZero,
    Colour,
    Flag,
    Maybe,
    Name,
    Point,
    Positive,
    Share,
    Sizes,
    Text,
    maybe,
    means,
    one_of,
    refusal,
)
from raywalk.scene.schema_transforms import TransformTable
from raywalk.scene.shapes import CREASE, Triple
from raywalk.scene.table import LIST, SINGLE, TABLE, Table, by_form
from raywalk.scene.wording import TAG, closest, did_you_mean, joined, quoted, show

Repeat = Annotated[tuple[Positive, Positive], Allowed("two numbers above 0, [across, upwards]")]


class TextureTable(Table):
    """A picture that gives an object's base colour: ambient and diffuse are multiplied by it, so
    that in `white` it looks as it is. Its colours count as they are, 255 as 1, nothing is decoded
    from sRGB. On a sphere or ellipsoid it goes round once as a map does: its middle faces +z, its
    top edge is the pole at +y, its sides meet at -z. On a plane a picture is as large as a world
    unit, from `point` on; on each face of a box, on a disc (its square) and on caps it is whole,
    upright for who looks at it, and of a floor from +z. On a cylinder or cone it goes round the
    side, from `start` at the bottom to `end`. On a triangle a, b, c are its corners at the lower
    left, lower right and upper left. On a mesh it lies where the file's coordinates (vt, s t, u v,
    TEXCOORD_0) put it. The object's `transform` carries it along."""

    file: Name = means("a .png, .jpg or .webp picture in the scene's folder")
    filter: Annotated[Literal["bilinear", "nearest"], one_of("bilinear", "nearest")] = means(
        "between the centres of four pixels, or the pixel that is hit", "bilinear"
    )
    repeat: Repeat = means("how often it stands side by side, across and upwards", (1.0, 1.0))


class MaterialTable(Table):
    """A Blinn-Phong surface with shares for mirror and glass."""

    like: Maybe[Name] = maybe(
        "a material, built-in or of this scene, that fills in the keys left out"
    )
    ambient: Maybe[Colour] = maybe("light it gives without any lamp")
    diffuse: Maybe[Colour] = maybe("share of light scattered to all sides")
    specular: Maybe[Colour] = maybe("colour of the highlight")
    shininess: Maybe[Positive] = maybe(
        "exponent of the highlight: the higher, the smaller (default 1)"
    )
    reflect: Maybe[Share] = maybe("share of the mirror image (default 0)")
    transmit: Maybe[Share] = maybe(
        "share of light let through; reflect + transmit is at most 1 (default 0)"
    )
    ior: Maybe[Positive] = maybe("index of refraction; required where transmit is above 0")
    fresnel: Maybe[Flag] = maybe("split reflect + transmit by angle, as glass does (default false)")
    texture: Maybe[TextureTable] = maybe("a picture that ambient and diffuse are multiplied by")


TwoColours = Annotated[tuple[Colour, Colour], Allowed("two colours, [[r, g, b], [r, g, b]]")]


class CheckerTable(Table):
    """Squares of two colours on a plane."""

    colours: TwoColours = means("diffuse colours of the even and the odd squares")
    size: Positive = means("side of a square, in world units", 1.0)
    ambient: Maybe[
        Annotated[
            Annotated[AtLeastZero, SINGLE] | Annotated[TwoColours, LIST],
            Discriminator(by_form),
            Allowed("two colours, [[r, g, b], [r, g, b]], or one number, a share of `colours`"),
        ]
    ] = maybe(
        "light that even and odd squares give without any lamp: two colours, or a number that both "
        "of `colours` are multiplied by; default: the material's ambient"
    )

    def ambients(self, usual: Triple) -> tuple[Triple, Triple]:
        """Of the even and the odd squares; usual: the material's."""
        if self.ambient is None:
            return usual, usual
        if isinstance(self.ambient, tuple):
            return self.ambient
        even, odd = (tuple(self.ambient * c for c in colour) for colour in self.colours)
        return even, odd  # type: ignore[return-value]


def _material_form(value: Any) -> str | None:
    return by_form(value) if isinstance(value, str | dict | Table) else None


Dress = Annotated[
    Annotated[Text, SINGLE] | Annotated[MaterialTable, TABLE],
    Discriminator(_material_form),
    Allowed("the name of a material, or a table with a material's keys"),
]


class ObjectTable(Table):
    """What every object has, whatever its shape."""

    name: Maybe[Name] = maybe('what a person calls it; default "sphere 1" and so on')
    material: Dress = means("a material's name, or a table with the keys of one")
    transform: Annotated[
        tuple[TransformTable, ...],
        Allowed("a list of steps", hint="such as [{ translate = [0, 1, 0] }, { scale = 2 }]"),
    ] = means("steps multiplied as written: the leftmost is applied last", ())

    @property
    def kind(self) -> str:
        """The word for its shape: the value of `type`."""
        return next(kind for kind, table in SHAPES.items() if isinstance(self, table))


class SphereTable(ObjectTable):
    type: Literal["sphere"]
    center: Point = means("its centre")
    radius: Positive = means("in world units")


class EllipsoidTable(ObjectTable):
    type: Literal["ellipsoid"]
    center: Point = means("its centre")
    radii: Sizes = means("half axes along x, y and z before the rotation")
    rotation: Point = means("degrees about x, then y, then z, through its centre", (0.0, 0.0, 0.0))


class PlaneTable(ObjectTable):
    """Infinite; its inside is the half-space behind the normal."""

    type: Literal["plane"]
    point: Point = means("any point on it; a checker is measured from here")
    normal: Point = means("the way it faces, of any length")
    checker: Maybe[CheckerTable] = maybe("squares of two colours")


class CylinderTable(ObjectTable):
    type: Literal["cylinder"]
    start: Point = means("centre of one end")
    end: Point = means("centre of the other end")
    radius: Positive = means("in world units")
    capped: Flag = means("closed by a disc at each end", True)


class ConeTable(ObjectTable):
    """A whole one, or one whose tip is cut off; with equal radii a cylinder."""

    type: Literal["cone"]
    start: Point = means("centre of one end")
    end: Point = means("its tip, or centre of the other end")
    radius: Positive = means("at the start, in world units")
    end_radius: AtLeastZero = means("at the end; 0 makes that a tip", 0.0)
    capped: Flag = means("closed by a disc at each end", True)


class BoxTable(ObjectTable):
    type: Literal["box"]
    minimum: Point = means("the corner of smallest x, y and z")
    maximum: Point = means("the corner of largest x, y and z")


class DiscTable(ObjectTable):
    type: Literal["disc"]
    center: Point = means("its centre")
    normal: Point = means("the way it faces, of any length")
    radius: Positive = means("in world units")


class TriangleTable(ObjectTable):
    type: Literal["triangle"]
    a: Point = means("a corner; the front is where a, b, c run anticlockwise")
    b: Point = means("the next corner")
    c: Point = means("the last corner")


Weld = Annotated[
    float, Field(strict=True, ge=0, le=0.1, allow_inf_nan=False), Allowed("a number from 0 to 0.1")
]


Crease = Annotated[
    float,
    Field(strict=True, ge=0, le=180, allow_inf_nan=False),
    Allowed("a number of degrees from 0 to 180"),
]


class MeshTable(ObjectTable):
    """Triangles of a file. `raywalk model FILE` tells what it holds. Without `material` it is shown
    in the file's own materials; each that `materials` names becomes an object of its own."""

    type: Literal["mesh"]
    material: Maybe[Dress] = maybe(  # type: ignore[assignment]
        "a material's name, or a table with the keys of one, for all that `materials` does not "
        "name (default: the file's own)"
    )
    materials: Annotated[
        dict[str, Dress],
        Allowed("a table of materials", hint='such as materials = { red = "glass" }'),
    ] = means("for parts and materials of the file, by their names", {})
    model: Maybe[Name] = maybe("a name in models/models.toml, or give `file`")
    file: Maybe[Name] = maybe(
        "a .obj, .stl, .ply, .off, .gltf, .glb or .3mf file, relative to the scene file"
    )
    smooth: Maybe[Flag] = maybe(
        "normals of the file, by its smoothing groups, or averaged at each vertex, "
        "but not over edges sharper than `crease`; false: one per triangle (default true, but "
        "false of glTF without normals, as it is specified)"
    )
    subdivide: Annotated[
        int, Field(strict=True, ge=0, le=3), Allowed("a whole number from 0 to 3")
    ] = means("rounds of Loop subdivision: each makes four triangles of one", 0)
    crease: Maybe[Crease] = maybe(
        "degrees by which two triangles may turn at an edge that stays smooth, where normals are "
        f"averaged (default {CREASE:g}, or what models.toml says; 180: no edge is sharp)"
    )
    weld: Maybe[Weld] = maybe(
        "corners of open edges nearer than this share of the model's size are one "
        "(default 1e-6; 0: only equal ones)"
    )


SHAPES: dict[str, type[ObjectTable]] = {
    "sphere": SphereTable,
    "ellipsoid": EllipsoidTable,
    "plane": PlaneTable,
    "cylinder": CylinderTable,
    "cone": ConeTable,
    "box": BoxTable,
    "disc": DiscTable,
    "triangle": TriangleTable,
    "mesh": MeshTable,
}


def _with_known_type(value: Any) -> Any:
    """Refuse here what has no known type, so that the rest is read as one shape, not as eight."""
    if not isinstance(value, dict):
        raise refusal(f"{show(value)} is not a table")
    kind = value.get("type")
    if not isinstance(kind, str) or kind not in SHAPES:
        known = f"known: {joined(SHAPES)}"
        if kind is None:
            slip = next((key for key in value if closest(key, ["type"])), "")
            hint = f"{quoted(slip)} stands there" if slip else ""
            raise refusal("missing", at="type", allowed=known, hint=hint)
        message = f"{show(kind)} is not a shape"
        raise refusal(message, at="type", allowed=known, hint=did_you_mean(kind, SHAPES))
    return value


AnyObject = Annotated[
    Annotated[
        Annotated[SphereTable, Tag("as:sphere")]
        | Annotated[EllipsoidTable, Tag("as:ellipsoid")]
        | Annotated[PlaneTable, Tag("as:plane")]
        | Annotated[CylinderTable, Tag("as:cylinder")]
        | Annotated[ConeTable, Tag("as:cone")]
        | Annotated[BoxTable, Tag("as:box")]
        | Annotated[DiscTable, Tag("as:disc")]
        | Annotated[TriangleTable, Tag("as:triangle")]
        | Annotated[MeshTable, Tag("as:mesh")],
        Discriminator(lambda value: TAG + value["type"]),
    ],
    BeforeValidator(_with_known_type),
]
