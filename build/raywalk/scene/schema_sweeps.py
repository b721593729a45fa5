"""[[sweeps]]: a value of the scene that takes several, one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, Self

from pydantic import Field, model_validator

from raywalk.scene.fields import (
    Allowed,
    AxisName,
    Maybe,
    Name,
    Point,
    Text,
    maybe,
    means,
    refusal,
)
from raywalk.scene.table import Table
from raywalk.scene.wording import counted, show

MOST_STOPS = 64  # of a sweep: each is a trace of its own
PICTURE = 385  # pixels across of a stop's picture: a third of 1155, sharp beside the stage
GRIDS = (15, 33)  # whose rays a stop has, where its sweep does not say
CLEAN = 9  # decimals of a stop between `from` and `to`: 0.1 + 0.2 is 0.3 to whoever reads it

# Of numbers as TOML has them: whole ones stay whole.
Figure = Annotated[int, Field(strict=True)] | Annotated[
    float, Field(strict=True, allow_inf_nan=False)
]  # fmt: skip
Value = Annotated[Figure | tuple[Figure, ...], Allowed("a number or a list of numbers")]
Values = Annotated[
    tuple[Value, ...], Field(min_length=2, max_length=MOST_STOPS),
    Allowed(f"a list of 2 to {MOST_STOPS} values, each a number or a list of numbers"),
]  # fmt: skip
Stops = Annotated[
    int, Field(strict=True, ge=2, le=MOST_STOPS), Allowed(f"a whole number from 2 to {MOST_STOPS}")
]
Side = Annotated[int, Field(strict=True, ge=1), Allowed("a whole number of at least 1")]
Grids = Annotated[
    tuple[Annotated[int, Field(strict=True, ge=1)], ...], Field(min_length=1),
    Allowed("a list of at least one whole number"),
]  # fmt: skip


class SteppedTable(Table):
    """A key of the scene's file, and the values that it takes."""

    name: Maybe[Name] = maybe("what a person calls it (default: the sweep's name)")
    varies: Text = means(
        "the key of this file whose value changes; objects, lights and materials by their names, "
        'items of a list by their number from 0: `lights."light 1".position`, '
        "`objects.bunny.transform.0.rotate.degrees`, `lights.lamp.samples`, "
        "`materials.red.shininess`, `camera.fov`, `render.depth`, `background`"
    )
    from_: Maybe[Value] = Field(default=None, alias="from", description="the first stop's value")
    to: Maybe[Value] = maybe("the last stop's value")
    stops: Maybe[Stops] = maybe("how many, in equal steps from `from` to `to`")
    values: Maybe[Values] = maybe("each stop's value, in place of `from`, `to` and `stops`")
    about: Maybe[Point] = maybe(
        "a point: the value, a place, goes round it on a circle, and `from` and `to`, or `values`, "
        "are degrees from where the scene has it, which is 0, counter-clockwise as seen from above"
    )
    axis: Maybe[AxisName] = maybe('the circle\'s axis, through `about` (default "y", upright)')

    @model_validator(mode="after")
    def _round(self) -> Self:
        if self.axis and not self.about:
            raise refusal("only what goes round a point has an axis", at="axis", hint="give about")
        ends = self.values or (self.from_, self.to)
        if self.about and any(_length(value) is not None for value in ends):
            at = "values" if self.values else "from"
            raise refusal(
                "is not in degrees, as what goes round a point is", at=at,
                hint="from = -45, to = 45 go as far to either side",
            )  # fmt: skip
        return self

    @model_validator(mode="after")
    def _whole(self) -> Self:
        given = {"from": self.from_, "to": self.to, "stops": self.stops}
        missing = [key for key, value in given.items() if value is None]
        if self.values is None and missing:
            hint = "give from, to and stops, or a list of values"
            raise refusal("missing", at=missing[0], hint=hint)
        if self.values is not None and len(missing) < len(given):
            extra = next(key for key in given if key not in missing)
            raise refusal("stands beside values, which say it all", at=extra)
        return self

    @model_validator(mode="after")
    def _alike(self) -> Self:
        ends = self.values or (self.from_, self.to)
        for value in ends:
            if _length(value) != _length(ends[0]):
                at = "values" if self.values else "to"
                raise refusal(f"{show(value)} is not like {show(ends[0])}", at=at)
        all_of = self.all_values()
        for k, value in enumerate(all_of):
            if value in all_of[:k]:
                at = "values" if self.values else "to"
                raise refusal(f"{show(value)} is there twice", at=at)
        return self

    def all_values(self) -> list[Any]:
        """One after the other."""
        if self.values is not None:
            return list(self.values)
        assert self.from_ is not None and self.to is not None and self.stops is not None
        return [_between(self.from_, self.to, k, self.stops - 1) for k in range(self.stops)]

    def said(self) -> str:
        """How many values, in words."""
        return counted(len(self.all_values()), "stop")


class AcrossTable(SteppedTable):
    """A second key that a sweep varies: each of its values, which are rows, with each of the
    sweep's own, which are columns."""


class SweepTable(SteppedTable):
    """A slider: something of the scene moves or changes, stop by stop, and each stop is traced.
    The scene's own value is one of the stops. With `across` it is a grid of stops, numbered from 1
    in rows: first those of the first row, one for each of the sweep's own values."""

    name: Name = means("what a person calls it")
    across: Maybe[AcrossTable] = maybe(
        "a second key, each of whose values is crossed with each of the first: "
        f"{{ varies, from, to, stops }} or {{ varies, values }}; at most {MOST_STOPS} stops in all"
    )
    resolutions: Maybe[Grids] = maybe(
        "of the scene's, those whose rays each stop has (default: 15 and 33, those of them that "
        "the scene has)"
    )
    picture: Maybe[Side] = maybe(
        "pixels across of each stop's picture, an odd part of `render.size` "
        f"(default: {PICTURE} or a little less); smaller where a picture would weigh too much"
    )

    @model_validator(mode="after")
    def _few(self) -> Self:
        columns, rows = self.shape()
        if columns * rows > MOST_STOPS:
            raise refusal(
                f"{columns} values with {rows} each are {columns * rows} stops", at="across",
                allowed=f"allowed: {MOST_STOPS} in all",
            )  # fmt: skip
        return self

    def shape(self) -> tuple[int, int]:
        """How many columns and rows of stops."""
        return len(self.all_values()), len(self.across.all_values()) if self.across else 1

    def grids(self, of: Sequence[int]) -> tuple[int, ...]:
        """Those whose rays each stop has, of a scene with these."""
        return tuple(sorted(self.resolutions or {*GRIDS} & {*of}))


def _length(value: Any) -> int | None:
    return len(value) if isinstance(value, Sequence) else None


def _between(first: Any, last: Any, k: int, of: int) -> Any:
    """The value k steps of `of` from the first to the last."""
    if isinstance(first, Sequence):
        return tuple(_between(a, b, k, of) for a, b in zip(first, last, strict=True))
    if isinstance(first, int) and isinstance(last, int) and (last - first) * k % of == 0:
        return first + (last - first) * k // of
    return round(first + (last - first) * k / of, CLEAN)
