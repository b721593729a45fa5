"""The stage's approximate look beside the traced picture, from the ray-tracing camera: what a real
browser draws of mirrors and glass, with surroundings and painted without."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

from raywalk.bench.cases import Case
from raywalk.bench.stress_page import run_in_browser


def looks() -> list[dict[str, Any]]:
    """Per scene that has any: mean difference from the picture over the colours of mirrors and
    glass, of 255, and the most that it may be. Of the built site; [] where no browser could run."""
    _, said = run_in_browser("surroundings", {"RAYWALK_PAINTED": "1"})
    return [json.loads(found) for found in re.findall(r"^# look (\{.*\})$", said, re.MULTILINE)]


def as_table(rows: list[dict[str, Any]]) -> Iterator[str]:
    """Now, and before surroundings were traced."""
    for row in rows:
        yield f"  {row['scene']}: {row['shown']:.1f} of 255; painted, {row['painted']:.1f}"
    if not rows:
        yield "  not measured: this needs a built site and a browser"


def look_cases(rows: list[dict[str, Any]], seed: int) -> Iterator[Case]:
    """Each scene keeps what its test allows it."""
    for row in rows:
        metric = "mean difference of mirrors and glass from the picture, of 255"
        yield Case("look", row["scene"], metric, row["most"], row["shown"], 0, seed)
