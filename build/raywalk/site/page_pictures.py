"""A scene's pictures as its pages show them: in fewer bytes than the PNGs that the tracer writes,
and the preview of a link. Slides and grids need none of it, so it is made by itself."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from raywalk.site.preview import write_preview
from raywalk.trace_file.webp import write_webp

SHOWN = ("picture", "thumb")


def write_page_pictures(traced: Path, folder: Path) -> None:
    """traced: the folder of the scene's trace, with a PNG of each that is SHOWN. Writes their WebP
    where that is smaller, and preview.jpg."""
    for name in SHOWN:
        png = traced / f"{name}.png"
        rgb8 = np.asarray(Image.open(png).convert("RGB"))
        write_webp(folder / f"{name}.webp", rgb8, unless=png.stat().st_size)
    write_preview(traced / "picture.png", folder)
