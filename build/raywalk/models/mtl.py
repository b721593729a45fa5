"""MTL files: the materials of an OBJ file. What we have no use for is passed over."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from raywalk.models.model import Colour, FileMaterial
from raywalk.models.text import lines, name_of, one_encoding

# Options of a texture, with how many words follow each.
OPTIONS = {
    b"-blendu": 1, b"-blendv": 1, b"-boost": 1, b"-cc": 1, b"-clamp": 1, b"-texres": 1,
    b"-bm": 1, b"-imfchan": 1, b"-type": 1, b"-mm": 2, b"-o": 3, b"-s": 3, b"-t": 3,
}  # fmt: skip


def read_mtl(path: Path, folder: Path) -> dict[str, FileMaterial]:
    """Materials by name. A line that cannot be read says nothing: colours are no reason to
    refuse a model."""
    found: dict[str, FileMaterial] = {}
    try:
        data = path.read_bytes()
    except OSError:
        return found
    name = ""
    for _, line in lines(one_encoding(data)):
        words = line.split()
        if not words:
            continue
        if words[0] == b"newmtl":
            name = name_of(b" ".join(words[1:]))
            found[name] = FileMaterial(name)
        elif name in found:
            found[name] = _with_line(found[name], words, line, folder)
    return found


def _with_line(
    material: FileMaterial, words: list[bytes], line: bytes, folder: Path
) -> FileMaterial:
    match words[0]:
        case b"Kd" if colour := _colour(words[1:]):
            return replace(material, diffuse=colour)
        case b"Ks" if colour := _colour(words[1:]):
            return replace(material, specular=colour)
        case b"Ns" if (value := _share(words[-1], 1e6)) is not None:
            return replace(material, shininess=value)
        case b"d" if (value := _share(words[-1], 1.0)) is not None:
            return replace(material, opacity=value)
        case b"Tr" if (value := _share(words[-1], 1.0)) is not None:
            return replace(material, opacity=1.0 - value)
        case b"map_Kd" if len(words) > 1:
            return replace(material, texture=_picture(line, folder))
    return material


def _colour(words: list[bytes]) -> Colour | None:
    """One number is a grey."""
    values = [_share(word, 1.0) for word in words[:3]]
    if not values or any(value is None for value in values) or len(values) == 2:
        return None
    r, g, b = (value or 0.0 for value in (values * 3)[:3])
    return (r, g, b)


def _share(word: bytes, most: float) -> float | None:
    try:
        value = float(word)
    except ValueError:
        return None
    return min(max(value, 0.0), most) if value == value else None


def _picture(line: bytes, folder: Path) -> Path:
    """The file's name, which may have spaces, behind options."""
    rest = line.strip()[len(b"map_Kd") :].strip()
    while rest.startswith(b"-"):
        option, *words = rest.split()
        for _ in range(min(1 + OPTIONS.get(option, 1), len(words) + 1)):
            parts = rest.split(None, 1)
            rest = parts[1] if len(parts) > 1 else b""
            if OPTIONS.get(option) == 3 and not _is_number(rest.split(None, 1)[:1]):
                break
    return folder / name_of(rest).replace("\\", "/")


def _is_number(words: list[bytes]) -> bool:
    return bool(words) and _share(words[0], 1e30) is not None
