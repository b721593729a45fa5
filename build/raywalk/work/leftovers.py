"""Half-made folders carry the number of the process that makes them: what a killed build left
behind is known by it, and cleared away by the next build."""

from __future__ import annotations

import os
import re
import shutil
import time
from pathlib import Path

PARTIAL = ".partial"
ABANDONED = 86_400  # seconds, where processes cannot be asked for


def owned_name(prefix: str) -> dict[str, str]:
    """prefix and suffix for tempfile.mkdtemp: <prefix><process>-<random>.partial"""
    return {"prefix": f"{prefix}{os.getpid()}-", "suffix": PARTIAL}


def remove_leftovers(folder: Path, prefix: str = "") -> None:
    """Removes half-made folders whose makers are gone."""
    for place in folder.glob(f"{prefix}*{PARTIAL}"):
        if place.is_dir() and is_abandoned(place):
            shutil.rmtree(place, ignore_errors=True)


def is_abandoned(place: Path) -> bool:
    """Whether the process that made a half-made folder has ended."""
    owner = re.search(r"\.(\d+)-[^.]*\.partial$", place.name)
    if owner and os.name == "posix":
        try:
            os.kill(int(owner[1]), 0)
        except ProcessLookupError:
            return True
        except OSError:
            return False  # somebody else's, alive
        return False
    try:
        return time.time() - place.stat().st_mtime > ABANDONED
    except OSError:
        return False
