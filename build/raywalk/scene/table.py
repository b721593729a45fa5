"""A TOML table that refuses unknown keys and explains itself in our words."""

from __future__ import annotations

from typing import Any, Self

from pydantic import (
    BaseModel,
    ConfigDict,
    ModelWrapValidatorHandler,
    Tag,
    ValidationError,
    model_validator,
)
from pydantic_core import InitErrorDetails, PydanticCustomError

from raywalk.scene.fields import REFUSED, refusal
from raywalk.scene.wording import TAG, closest, did_you_mean, joined, show


class Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)

    @model_validator(mode="wrap")
    @classmethod
    def _explain(cls, value: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        try:
            return handler(value)
        except ValidationError as error:
            lines = [_line(cls, value, line) for line in error.errors(include_url=False)]
            kept = [line for line in lines if line is not None]
            raise ValidationError.from_exception_data(cls.__name__, kept) from None


def _line(table: type[Table], value: Any, line: Any) -> InitErrorDetails | None:
    """One error in our words, or None where another error says the same."""
    words = _words(table, value, line)
    if words is None:
        return None
    return InitErrorDetails(type=words, loc=line["loc"], input=line["input"])


def _words(table: type[Table], value: Any, line: Any) -> PydanticCustomError | None:
    keys = _keys(table)
    match line["type"]:
        case "refused":
            return PydanticCustomError(REFUSED, "{message}", line["ctx"])
        case "extra_forbidden":
            unknown = line["loc"][-1]
            return refusal(
                "unknown key",
                allowed=f"allowed: {joined(keys)}",
                hint=did_you_mean(unknown, keys),
            )
        case "missing":
            missing = line["loc"][-1]
            if any(closest(key, keys) == missing for key in value if key not in keys):
                return None  # misspelt: the unknown key is reported with this very hint
            return refusal("missing", hint=_purpose(table, missing))
        case _:
            return refusal(f"{show(line['input'])} is not a table", allowed=f"keys: {joined(keys)}")


def _keys(table: type[Table]) -> list[str]:
    """The keys allowed, the table's own before those that all its kind share."""
    fields = table.model_fields
    own = [key for key in fields if key in table.__annotations__]
    return [fields[key].alias or key for key in own + [key for key in fields if key not in own]]


def _purpose(table: type[Table], key: str) -> str:
    """key: as a file has it, where Python keeps the word for itself."""
    found = (of for name, of in table.model_fields.items() if key in (name, of.alias))
    description = next(found).description
    return f"{key}: {description}" if description else ""


def by_form(value: Any) -> str:
    """Which member of a union is meant: by whether a table, list or single value is given."""
    if isinstance(value, dict | Table):
        return TAG + "table"
    return TAG + ("list" if isinstance(value, list | tuple) else "single")


SINGLE, LIST, TABLE = Tag(TAG + "single"), Tag(TAG + "list"), Tag(TAG + "table")
