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
    for place in abandoned(folder, prefix):
        shutil.rmtree(place, ignore_errors=True)


def abandoned(folder: Path, prefix: str = "") -> list[Path]:
    """Half-made folders whose makers are gone. What is not named as ours is somebody else's."""
    named = re.compile(re.escape(prefix) + r"(?:[^/]*\.)?(\d+)-[^.]*" + re.escape(PARTIAL))
    found = [(path, named.fullmatch(path.name)) for path in sorted(folder.glob(f"*{PARTIAL}"))]
    return [
        path for path, match in found if match and path.is_dir() and _has_ended(int(match[1]), path)
    ]


def _has_ended(owner: int, place: Path) -> bool:
    """Whether the process that made a half-made folder has ended."""
    if os.name == "posix":
        try:
            os.kill(owner, 0)
        except ProcessLookupError:
            return True
        except OSError:
            return False  # somebody else's, alive
        return False
    try:
        return time.time() - place.stat().st_mtime > ABANDONED
    except OSError:
        return False
