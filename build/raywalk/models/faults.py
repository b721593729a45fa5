"""What is wrong with a model file: one sentence with file, place, value, cause and remedy."""

from __future__ import annotations

from pathlib import Path

LONGEST = 40  # characters of a value in a message


class ModelFault(Exception):
    """A file that cannot be read as a model; str() is the sentence."""

    def __init__(self, path: Path, place: str, cause: str, remedy: str):
        super().__init__(path, place, cause, remedy)
        self.path, self.place, self.cause, self.remedy = path, place, cause, remedy

    def __reduce__(self) -> tuple[type[ModelFault], tuple[Path, str, str, str]]:
        return ModelFault, (self.path, self.place, self.cause, self.remedy)

    @property
    def message(self) -> str:
        """The sentence without its remedy."""
        where = ", ".join(part for part in (shown(self.path.name), self.place) if part)
        return f"{where}{' ' if self.cause.startswith('holds') else ': '}{self.cause}"

    def __str__(self) -> str:
        return f"{self.message}; {self.remedy}"


def shown(value: bytes | str) -> str:
    """A piece of a file, safe to print: no control characters, not too long."""
    text = value.decode("utf-8", "replace") if isinstance(value, bytes) else value
    whole = len(text) <= LONGEST
    text = text if whole else text[: LONGEST - 3] + "..."
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def quoted(value: bytes | str) -> str:
    """The same in quotes."""
    return f'"{shown(value)}"'
