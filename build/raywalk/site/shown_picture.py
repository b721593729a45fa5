"""Which file of a picture pages show: its WebP where that is smaller; people save the PNG."""

from __future__ import annotations

from pathlib import Path


def shown_picture(folder: Path, name: str) -> str:
    """NAME.webp, or NAME.png where there is no other."""
    return f"{name}.webp" if (folder / f"{name}.webp").is_file() else f"{name}.png"
