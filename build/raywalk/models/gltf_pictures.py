"""Pictures that a glTF or GLB file holds itself."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from raywalk.models.faults import ModelFault
from raywalk.models.gltf_buffers import Buffers, data_of, whole


def picture_bytes(path: Path, index: int) -> bytes:
    """The bytes of image `index`, empty if they are not there. Raises OSError."""
    from raywalk.models.gltf import parts_of

    document, chunk = parts_of(path, path.read_bytes())
    try:
        image: dict[str, Any] = document["images"][index]
        if "bufferView" in image:
            return Buffers(path, document, chunk).view(whole(image["bufferView"]))
        return data_of(str(image.get("uri", ""))) or b""
    except (KeyError, IndexError, TypeError, ValueError, ModelFault):
        return b""
