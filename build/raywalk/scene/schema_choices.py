"""The choices of a lesson's question, in a scene's file and in its translations."""

from __future__ import annotations

from typing import Annotated, Self

from pydantic import Field, model_validator

from raywalk.scene.fields import (
    Allowed,
    Colour,
    Flag,
    LessonText,
    Maybe,
    Name,
    maybe,
    means,
    refusal,
)
from raywalk.scene.table import Table
from raywalk.scene.wording import quoted

FEWEST, MOST = 2, 5
LONGEST = 90  # letters of a choice: more are not read from the back row

Index = Annotated[int, Field(strict=True, ge=0), Allowed("a whole number of at least 0")]
Pixel = Annotated[tuple[Index, Index], Allowed("a pixel, [column, row] from the top left")]


class ChoiceTable(Table):
    """One of a question's choices. It is said by its text, or is a pixel or an object, which can
    be clicked as well. Of a question two to five are given, exactly one of them right."""

    text: Maybe[LessonText] = maybe("what is chosen, in a few words of Markdown")
    pixel: Maybe[Pixel] = maybe("instead of a text: a pixel of the view, [column, row]")
    object: Maybe[Name] = maybe("instead of a text: an object of the scene, by its name")
    colour: Maybe[Colour] = maybe("beside a text: shown as a swatch")
    right: Flag = means("whether it is the right one", False)
    because: LessonText = means("one sentence: why it is right or wrong, in Markdown")

    @model_validator(mode="after")
    def _one_thing(self) -> Self:
        given = [key for key in ("text", "pixel", "object") if getattr(self, key) is not None]
        if len(given) != 1:
            message = f"has {' and '.join(given)}" if given else "says nothing that can be chosen"
            raise refusal(message, allowed="allowed: one of text, pixel, object")
        if self.colour is not None and self.text is None:
            hint = "not everybody tells colours apart, so a swatch has a text"
            raise refusal("there is no text beside it", at="colour", hint=hint)
        if self.text is not None and len(self.text.strip()) > LONGEST:
            message = f"has {len(self.text.strip())} letters"
            raise refusal(message, at="text", allowed=f"allowed: at most {LONGEST}")
        return self

    @property
    def said(self) -> str:
        """What tells it from the others."""
        if self.pixel is not None:
            return f"pixel {list(self.pixel)}"
        return quoted((self.text or self.object or "").strip())


class TranslatedChoice(Table):
    """A choice's words, in the order of scene.toml."""

    text: Maybe[LessonText] = maybe("of a choice that has one")
    because: LessonText = means("one sentence: why it is right or wrong")


Choices = Annotated[
    tuple[ChoiceTable, ...],
    Allowed("a list of tables", hint="write [[lesson.choices]], with two brackets, before each"),
]
TranslatedChoices = Annotated[
    tuple[TranslatedChoice, ...],
    Allowed("a list of tables", hint="write [[lesson.choices]], with two brackets, before each"),
]
