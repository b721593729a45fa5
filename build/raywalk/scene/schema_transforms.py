"""The TOML of an object's transform, a list of steps."""

from __future__ import annotations

from typing import Annotated, Any, Self

from pydantic import Discriminator, model_validator

from raywalk.scene.fields import Allowed, AxisName, Maybe, Number, Point, maybe, means, refusal
from raywalk.scene.table import LIST, SINGLE, Table, by_form
from raywalk.scene.wording import joined, plain


def _axis_form(value: Any) -> str | None:
    return by_form(value) if isinstance(value, str | list | tuple) else None


def _scale_form(value: Any) -> str | None:
    return None if isinstance(value, dict) else by_form(value)


Axis = Annotated[
    Annotated[AxisName, SINGLE] | Annotated[Point, LIST],
    Discriminator(_axis_form),
    Allowed('"x", "y", "z" or three numbers'),
]
Scale = Annotated[
    Annotated[Number, SINGLE] | Annotated[Point, LIST],
    Discriminator(_scale_form),
    Allowed("a number, or three"),
]


class RotateTable(Table):
    """A right-handed turn about an axis through the origin."""

    axis: Axis = means("the axis, through the origin")
    degrees: Number = means("the angle, in degrees")

    @model_validator(mode="after")
    def _has_direction(self) -> Self:
        if not isinstance(self.axis, str) and not any(self.axis):
            raise refusal(f"{plain(self.axis)} has no direction", at="axis")
        return self


Row = Annotated[tuple[Number, Number, Number, Number], Allowed("a row of four numbers")]
Matrix = Annotated[
    tuple[Row, Row, Row] | tuple[Row, Row, Row, Row], Allowed("three or four rows of four numbers")
]


_AFFINE_ROW = (0.0, 0.0, 0.0, 1.0)


class TransformTable(Table):
    """One step of a transform: exactly one of these keys."""

    translate: Maybe[Point] = maybe("a shift, in world units")
    rotate: Maybe[RotateTable] = maybe("a turn")
    scale: Maybe[Scale] = maybe("a factor about the origin, the same or one per axis")
    matrix: Maybe[Matrix] = maybe("rows of an affine matrix; a fourth row must be [0, 0, 0, 1]")

    @model_validator(mode="after")
    def _one_key(self) -> Self:
        given = [key for key in type(self).model_fields if getattr(self, key) is not None]
        if len(given) != 1:
            found = joined(given) if given else "none"
            raise refusal(
                f"a step has exactly one key, here: {found}",
                allowed="allowed: translate, rotate, scale or matrix",
            )
        if self.matrix is not None and len(self.matrix) == 4 and self.matrix[3] != _AFFINE_ROW:
            raise refusal(
                f"the fourth row {plain(self.matrix[3])} makes it more than affine",
                at="matrix",
                allowed="allowed: [0, 0, 0, 1], or three rows only",
            )
        return self
