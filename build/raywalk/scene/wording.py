"""How values, keys and suggestions read in an error."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Any

LONGEST_VALUE = 60  # characters; beyond it a value hides the message

MOST_WORDS = 60  # that a list in an error names

# In a location, marks which member of a union was tried; no key of a person's file.
TAG = "as:"


def show(value: Any) -> str:
    """The value as it is written in TOML, shortened."""
    text = _toml(value)
    return text if len(text) <= LONGEST_VALUE else text[: LONGEST_VALUE - 3] + "..."


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return quoted(value.replace("\n", " "))
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_toml, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_toml(item)}" for key, item in value.items()) + " }"
    return str(value)


def plain(value: Any) -> str:
    """A checked value, its numbers without the .0 that nobody wrote."""
    if isinstance(value, tuple | list):
        return "[" + ", ".join(map(plain, value)) + "]"
    return f"{value:.12g}" if isinstance(value, float) else show(value)


def quoted(text: str) -> str:
    return f'"{text}"'


def did_you_mean(word: Any, known: Iterable[str]) -> str:
    """A question that offers the nearest known word, or nothing."""
    nearest = closest(word, known)
    return f'did you mean "{nearest}"?' if nearest else ""


def closest(word: Any, known: Iterable[str]) -> str:
    """The known word most like this one, ignoring case; "" if none is like it."""
    # One letter is like any other: "did you mean "2"?" helps nobody.
    by_lower_case = {name.lower(): name for name in known if len(name) > 1}
    matches = get_close_matches(str(word).lower(), by_lower_case, n=1)
    return by_lower_case[matches[0]] if matches else ""


def joined(words: Iterable[str]) -> str:
    """With commas; of very many the first ones and their number."""
    listed = list(words)
    more = len(listed) - MOST_WORDS
    return ", ".join(listed) if more <= 1 else f"{', '.join(listed[:MOST_WORDS])} and {more} more"


def counted(number: int, word: str) -> str:
    """1 light, 2 lights."""
    return f"{number:,} {word}{'' if number == 1 else 's'}"


def key_path(location: Sequence[str | int]) -> str:
    """("objects", 2, "material") as objects[2].material."""
    path = ""
    for part in location:
        if isinstance(part, int):
            path += f"[{part}]"
        elif not part.startswith(TAG):
            path += ("." if path else "") + (part if _is_bare(part) else quoted(part))
    return path


def _is_bare(key: str) -> bool:
    """Whether TOML lets this key stand without quotes."""
    return re.fullmatch(r"[A-Za-z0-9_-]+", key) is not None
