"""What checking a student's picture costs in a real browser, over the least that it can."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

from raywalk.bench.cases import Case
from raywalk.bench.stress_page import run_in_browser

# Times reading the picture and going through it once. Alone at most 50, 20, 13 and 5 were measured,
# beside other work, which takes caches from both but more from what is larger, 61, 23, 16 and 6.8;
# of what is left in a page that rests, 36 and 8.1.
MOST = {
    ("atOnce", 512): 70.0, ("first", 512): 50.0, ("again", 512): 28.0,
    ("atOnce", 1155): 18.0, ("first", 1155): 13.0, ("again", 1155): 8.0,
}  # fmt: skip


def checks() -> list[dict[str, Any]]:
    """Per scene and size: processor time of the page in ms, of a check in a page that has just
    opened, with loading and preparing, of the first in one that rests, of another one, and the
    floor. [] where no browser could run."""
    _, said = run_in_browser("check-work", {"RAYWALK_CHECK_WORK": "1"})
    return [json.loads(found) for found in re.findall(r"check (\{.*\})$", said, re.MULTILINE)]


def as_lines(rows: list[dict[str, Any]]) -> Iterator[str]:
    """In seconds, which are those of a page only where nothing else runs."""
    for row in rows:
        yield (
            f"  {row['scene']} at {row['size']}: at once {row['atOnce'] / 1000:.2f} s of work, "
            f"first in a page that rests {row['first'] / 1000:.2f} s, again "
            f"{row['again'] / 1000:.2f} s; reading it and one pass {row['floor'] / 1000:.3f} s"
        )
    if not rows:
        yield "  not measured: this needs a built site and a browser"


def check_cases(rows: list[dict[str, Any]], seed: int) -> Iterator[Case]:
    """Each check stays within its multiple of the floor."""
    for row in rows:
        for which, told in (
            ("atOnce", "a check at once"),
            ("first", "a first check"),
            ("again", "another check"),
        ):
            metric = f"{told} at {row['size']}, over reading the picture and one pass"
            most = MOST[which, row["size"]]
            yield Case("check", row["scene"], metric, most, row[which] / row["floor"], 0, seed)
