"""Gathers what is wrong with one file, while reading goes on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from pydantic import ValidationError

from raywalk.errors import SourceError
from raywalk.scene.wording import key_path

Location = Sequence[str | int]


@dataclass
class Problems:
    file: Path
    errors: list[SourceError] = field(default_factory=list)

    def add(self, at: Location, message: str, *, allowed: str = "", hint: str = "") -> None:
        """Note one problem at a location such as ("objects", 2, "material")."""
        self.errors.append(SourceError(self.file, key_path(at), message, allowed, hint))

    def add_refusals(self, error: ValidationError) -> None:
        """Note every refusal of a table (fields.refusal); its words are ours already."""
        for line in error.errors(include_url=False):
            words = line["ctx"]
            at = (*line["loc"], words["at"]) if words["at"] else line["loc"]
            self.add(at, words["message"], allowed=words["allowed"], hint=words["hint"])
