"""The kinds of value a scene file may hold, each with the words for what is allowed.

A kind carries its own words (`Allowed`), so that an error, the JSON Schema and
the README all say the same, and none of them speaks in a library's terms.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from math import inf, isfinite
from typing import Annotated, Any, Literal, TypeVar, get_args

from pydantic import AfterValidator, Field, GetCoreSchemaHandler, ValidationError
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from raywalk.scene.formula import NoFormula
from raywalk.scene.lesson_text import lesson_html
from raywalk.scene.wording import did_you_mean, quoted, show

HEX = re.compile(r"#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})")
REFUSED = "refused"  # the type of every error that is already in our words


class _WithoutNull:
    """Reads and documents T | None as T: TOML has no null, only keys that are left out."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return handler.generate_schema(get_args(source)[0])


T = TypeVar("T")
# A key that may be left out, and is None then.
Maybe = Annotated[T | None, _WithoutNull()]


def means(text: str, default: Any = ...) -> Any:
    """A table's key, with what it means to authors; required if it has no default."""
    return Field(default, description=text)


def maybe(text: str) -> Any:
    """Of a key that may be left out."""
    return means(text, None)


def refusal(
    message: str, *, at: str = "", allowed: str = "", hint: str = ""
) -> PydanticCustomError:
    """An error in our words; `at` is the key below the checked table, if one is to blame."""
    words = {"message": message, "at": at, "allowed": allowed, "hint": hint}
    return PydanticCustomError(REFUSED, "{message}", words)


# Squares of larger numbers, and products of three, would leave float64's range.
LARGEST = 1e100


@dataclass(frozen=True)
class Allowed:
    """Says what is allowed: "-1 is not {words}"."""

    words: str
    choices: tuple[str, ...] = ()
    hint: str = ""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_wrap_validator_function(self._check, handler(source))

    def _check(self, value: Any, handler: Callable[[Any], Any]) -> Any:
        if isinstance(value, float) and isfinite(value) and abs(value) > LARGEST:
            said = f"{show(value)} is too large: its square is no number, so no direction is left"
            raise refusal(said, allowed=f"allowed: at most {LARGEST:g} in size")
        try:
            return handler(value)
        except ValidationError as error:
            if all(line["type"] == REFUSED for line in error.errors(include_url=False)):
                raise  # a part of the value has been refused, and says so better
            if isinstance(value, float) and not isfinite(value):
                infinite = f"{show(value)} is not a finite number"
                raise refusal(infinite, allowed=f"allowed: {self.words}") from None
            raise refusal(f"{show(value)} is not {self.words}", hint=self._hint(value)) from None

    def _hint(self, value: Any) -> str:
        if _has_too_many_numbers(value):
            return "decimals have a point: 0.8, for 0,8 is two numbers"
        if self.choices and isinstance(value, int) and str(value) in self.choices:
            return f"write it in quotes: {quoted(str(value))}"
        if self.words.startswith("a number") and _reads_as_number(value):
            return f"write it without quotes: {value}"
        return did_you_mean(value, self.choices) or self.hint


@dataclass(frozen=True)
class AllowedColour(Allowed):
    """Also says how a colour of a picture program or a web page is written here. bound: 1 where
    no part may be above it."""

    bound: float = inf

    def _check(self, value: Any, handler: Callable[[Any], Any]) -> Any:
        try:
            return super()._check(value, handler)
        except (ValidationError, PydanticCustomError):
            if shares := _shares_of(value, self.bound):
                message = f"{show(value)} is not {self.words}"
                raise refusal(message, hint=f"divided by 255 it is {show(shares)}") from None
            raise


def _shares_of(value: Any, bound: float) -> list[float] | None:
    """#rgb, #rrggbb or three numbers up to 255 as shares of 1; None for what is none of these."""
    if isinstance(value, str) and (digits := HEX.fullmatch(value.strip())):
        code = digits[1] if len(digits[1]) == 6 else "".join(2 * each for each in digits[1])
        parts: list[float] = list(bytes.fromhex(code))
    elif bound == 1 and _are_numbers(value) and len(value) == 3 and _are_bytes(value):
        parts = value
    else:
        return None
    return [round(part / 255, 3) for part in parts]


def _are_bytes(parts: list[float]) -> bool:
    """Whole numbers up to 255, and not all of them so small that they may be slips of shares."""
    return all(part == int(part) and 0 <= part <= 255 for part in parts) and max(parts) > 10


def _are_numbers(value: Any) -> bool:
    return isinstance(value, list | tuple) and all(
        isinstance(each, int | float) and not isinstance(each, bool) for each in value
    )


def _has_too_many_numbers(value: Any) -> bool:
    return _are_numbers(value) and 3 < len(value) <= 6


def _reads_as_number(value: Any) -> bool:
    if not isinstance(value, str):
        return False
    try:
        float(value)
    except ValueError:
        return False
    return True


def one_of(*choices: str) -> Allowed:
    return Allowed("one of " + ", ".join(map(quoted, choices)), choices)


_FINITE = Field(strict=True, allow_inf_nan=False)

Number = Annotated[float, _FINITE, Allowed("a number")]
Positive = Annotated[float, _FINITE, Field(gt=0), Allowed("a number above 0")]
AtLeastZero = Annotated[float, _FINITE, Field(ge=0), Allowed("a number of at least 0")]
Share = Annotated[float, _FINITE, Field(ge=0, le=1), Allowed("a number from 0 to 1")]
FieldOfView = Annotated[
    float, _FINITE, Field(gt=0, lt=180), Allowed("a number above 0 and below 180")
]

Flag = Annotated[bool, Field(strict=True), Allowed("true or false")]
Text = Annotated[str, Field(strict=True, pattern=r"\S"), Allowed("a text that says something")]
Name = Annotated[
    str, Field(strict=True, pattern=r"^\S(.*\S)?$"), Allowed("a name (a text of one line)")
]


def _check_formulas(text: str) -> str:
    try:
        if "$" in text:  # what has no formula has none that is wrong
            lesson_html(text)
    except NoFormula as problem:
        hint = "a dollar sign without a formula: \\$"
        raise refusal(f"the formula {problem}", hint=hint) from None
    return text


LessonText = Annotated[Text, AfterValidator(_check_formulas)]
MOST_WORDS = 8  # of a slide's title: more are not read at a glance


def _check_length(text: str) -> str:
    # A slot becomes one figure, however much is typed for it.
    count = len(re.sub(r"\{[^{}]*\}", "0", text).split())
    if "\n" in text.strip():
        raise refusal(f"{show(text)} has several lines", allowed="allowed: one")
    if count > MOST_WORDS:
        allowed = f"allowed: at most {MOST_WORDS}, which are read at a glance"
        raise refusal(f"{show(text)} has {count} words", allowed=allowed)
    return text


Headline = Annotated[LessonText, AfterValidator(_check_length)]

# Lists arrive from TOML; tuples leave, because a scene does not change.
Point = Annotated[tuple[Number, Number, Number], Allowed("three numbers, [x, y, z]")]
Sizes = Annotated[tuple[Positive, Positive, Positive], Allowed("three numbers above 0")]
Colour = Annotated[
    tuple[Share, Share, Share],
    AllowedColour("a colour, [red, green, blue], each from 0 to 1", bound=1),
]
Brightness = Annotated[
    tuple[AtLeastZero, AtLeastZero, AtLeastZero],
    AllowedColour("a colour, [red, green, blue], each at least 0"),
]
Falloff = Annotated[
    tuple[AtLeastZero, AtLeastZero, AtLeastZero],
    Allowed("three numbers of at least 0, [a0, a1, a2]"),
]
AxisName = Annotated[Literal["x", "y", "z"], one_of("x", "y", "z")]
