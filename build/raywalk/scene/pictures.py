"""Pictures that textures look up: read, checked, and kept for a while."""

from __future__ import annotations

from functools import lru_cache
from io import BytesIO
from pathlib import Path
from warnings import catch_warnings

import numpy as np

from raywalk.scene.model import Texture
from raywalk.scene.wording import joined

#: Endings that are read, with Pillow's name for the format.
FORMATS = {".png": "PNG", ".jpg": "JPEG", ".jpeg": "JPEG", ".webp": "WEBP"}
MOST = 4096  # pixels across and down: 50 MB in memory
KEPT = 16
READ = sorted(set(FORMATS.values()))


class PictureFault(ValueError):
    """Why a file is no picture for a texture; and what to do about it."""

    def __init__(self, cause: str, remedy: str):
        super().__init__(cause)
        self.cause, self.remedy = cause, remedy


def read_texture(texture: Texture) -> np.ndarray:
    """(height, width, 3) uint8 red, green, blue, row 0 on top. Raises PictureFault.

    As the file has them: 255 is full light, and nothing is decoded from sRGB. What is transparent
    is as opaque as the rest; greys and palettes become colours; a camera's turn is followed.
    """
    path = texture.path
    if texture.inside < 0 and path.suffix.lower() not in FORMATS:
        raise PictureFault(
            f"ends in {path.suffix or 'nothing'}, and is no picture that is read",
            f"save it as one of {joined(FORMATS)}",
        )
    try:
        state = path.stat()
    except (OSError, ValueError):
        raise PictureFault("is not there", "look at its name and place") from None
    return _kept(path, texture.inside, state.st_mtime_ns, state.st_size)


@lru_cache(KEPT)
def _kept(path: Path, inside: int, changed: int, size: int) -> np.ndarray:
    if inside < 0:
        return decoded(path.read_bytes())
    from raywalk.models.gltf_pictures import picture_bytes  # only where a model holds pictures

    return decoded(picture_bytes(path, inside))


def decoded(data: bytes) -> np.ndarray:
    """The same of a file's bytes. Raises PictureFault."""
    from PIL import (
        Image,
        ImageOps,
        UnidentifiedImageError,
    )  # only here: a scene without a texture needs none of it

    try:
        # Pillow warns of what it passes over in a damaged file; faults are named below.
        with catch_warnings(action="ignore"), Image.open(BytesIO(data), formats=READ) as opened:
            if max(opened.size) > MOST:
                size = f"{opened.width} x {opened.height}"
                raise PictureFault(
                    f"has {size} pixels; at most {MOST} x {MOST} are read", "save it smaller"
                )
            upright = ImageOps.exif_transpose(opened)
            if upright.mode.startswith("I"):  # 16 bits of grey
                grey = np.asarray(upright, float) / 257.0
                return np.repeat(np.rint(grey).astype(np.uint8)[:, :, None], 3, axis=2)
            return np.asarray(upright.convert("RGB"))
    except PictureFault:
        raise
    except Image.DecompressionBombError:
        raise PictureFault(f"has far more than {MOST} x {MOST} pixels", "save it smaller") from None
    except UnidentifiedImageError:
        raise PictureFault(
            "is no picture that is read", f"save it as one of {joined(FORMATS)}"
        ) from None
    except (OSError, ValueError, SyntaxError, MemoryError) as problem:
        raise PictureFault(
            f"is a damaged picture ({str(problem)[:100]})", "save it again"
        ) from None
