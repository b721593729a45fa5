"""Damaged model files, seeded: each must be read or refused in a sentence, soon, and in little
memory. Run as a process of its own, so that its memory is its own.

    python -m raywalk.bench.model_fuzz COUNT SEED
"""

from __future__ import annotations

import json
import resource
import signal
import sys
import tempfile
import traceback
import warnings
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np

from raywalk.bench.model_files import good_files, packed, resized, unpacked
from raywalk.errors import SourceErrors
from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.mesh_file import load_triangles
from raywalk.models.faults import ModelFault
from raywalk.models.kept import read_cleaned
from raywalk.models.report import report
from raywalk.models.telling import in_full
from raywalk.scene.model import Camera, Material, Render, Scene, SceneObject
from raywalk.scene.shapes import Mesh

PATIENCE = 5  # seconds for one file
TRACED = 10  # every how manieth is made ready for rays too
WORDS = [
    b"nan", b"inf", b"-1", b"0", b"1e999", b"1e300", b"-1e-320", b"4294967295", b"0,5", b"99999",
    b"2147483648", b"9223372036854775808", b"\xff\xfe", b"", b" ", b"\n", b"\0", b"\t", b"\\\n",
    b"null", b"[]", b"{}", b'"', b"/", b"//", b"1e", b"--1", b"\xe2\x88\x921", b"0x10", b"1_0",
]  # fmt: skip


class TooLong(Exception):
    """A file that was read for more than PATIENCE."""


@dataclass
class Found:
    """What damaged files led to."""

    files: int = 0
    read: int = 0
    refused: int = 0
    tracebacks: list[str] = field(default_factory=list)
    hangs: list[str] = field(default_factory=list)
    unclear: list[str] = field(default_factory=list)  # sentences that are none
    kinds: Counter[str] = field(default_factory=Counter)


def damaged(content: bytes, rng: np.random.Generator) -> bytes:
    """One to four wounds: cut, bytes exchanged, pieces repeated, moved, dropped, words put in."""
    data = bytearray(content)
    for _ in range(int(rng.choice([1, 1, 1, 2, 3, 4]))):
        if not data:
            break
        at = int(rng.integers(len(data)))
        end = min(len(data), at + int(rng.geometric(0.05)))
        match int(rng.integers(8)):
            case 0:
                del data[at:]
            case 1:
                data[at] = int(rng.integers(256))
            case 2:
                data[at] ^= 1 << int(rng.integers(8))
            case 3:
                del data[at:end]
            case 4:
                data[at:at] = data[at:end] * int(rng.integers(1, 4))
            case 5:
                data[at:end] = WORDS[int(rng.integers(len(WORDS)))]
            case 6:
                _exchange_number(data, at, WORDS[int(rng.integers(len(WORDS)))])
            case 7:
                size = min(4, len(data) - at)
                data[at : at + size] = int(rng.integers(2**32)).to_bytes(4, "little")[:size]
    return bytes(data)


def damaged_within(name: str, content: bytes, rng: np.random.Generator) -> bytes:
    """The same; half of the packages are whole, and damaged within."""
    if name.endswith(".3mf") and rng.random() < 0.5:
        return packed(damaged(unpacked(content), rng))
    if name.endswith(".glb") and rng.random() < 0.5:
        return resized(damaged(content, rng))
    return damaged(content, rng)


def _exchange_number(data: bytearray, at: int, word: bytes) -> None:
    """The number that follows a place becomes another word."""
    digits = b"0123456789.-"
    while at < len(data) and data[at] not in digits:
        at += 1
    end = at
    while end < len(data) and data[end] in digits:
        end += 1
    data[at:end] = word


def fuzz(count: int, seed: int, folder: Path, compile_every: int = TRACED) -> Found:
    """Damages good files of all kinds in turn, and reads them as a build does."""
    warnings.simplefilter("error")  # what numpy warns of is as little meant as a traceback
    rng, found, good = np.random.default_rng(seed), Found(), good_files()
    (folder / "cube.mtl").write_bytes(b"newmtl red\nKd 1 0 0\n")
    before = signal.signal(signal.SIGALRM, _too_long)
    try:
        for k in range(count):
            name, content = list(good.items())[k % len(good)]
            path = folder / name
            path.write_bytes(damaged_within(name, content, rng))
            signal.setitimer(signal.ITIMER_REAL, PATIENCE)
            _try(path, found, f"{name}, file {k} of seed {seed}", k % compile_every == 0)
            signal.setitimer(signal.ITIMER_REAL, 0)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    return found


def _too_long(number: int, frame: FrameType | None) -> None:
    raise TooLong


def _try(path: Path, found: Found, named: str, is_traced: bool) -> None:
    found.files += 1
    try:
        facts = report(read_cleaned(path))
        json.dumps(facts, allow_nan=False)
        list(in_full(facts))
        scene = _scene(path)
        load_triangles(scene, scene.objects[0])
        if is_traced:
            CompiledScene(scene)
        found.read += 1
    except (ModelFault, SourceErrors) as fault:
        found.refused += 1
        if not str(fault).startswith((path.name, str(path), "scene.toml", "/")) or "\n\n" in str(
            fault
        ):
            found.unclear.append(f"{named}: {fault}")
    except TooLong:
        found.hangs.append(named)
    except Exception:
        found.tracebacks.append(f"{named}\n{traceback.format_exc(limit=-3)}")


def _scene(path: Path) -> Scene:
    """The model alone."""
    camera = Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0))
    chalk = Material("chalk", diffuse=(1.0, 1.0, 1.0))
    return Scene(
        "fuzz", Path("scene.toml"), "", "", "", camera, Render(), (0.0, 0.0, 0.0), (chalk,),
        (SceneObject("model", Mesh(path.name, path), 0),), (), (),
    )  # fmt: skip


def peak_megabytes() -> float:
    """Of this process so far."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main(count: int, seed: int) -> dict[str, Any]:
    """All figures; the memory is what damaged files needed beyond good ones."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / "cube.mtl").write_bytes(b"newmtl red\nKd 1 0 0\n")
        for name, content in good_files().items():  # kernels compiled, packages imported
            (folder / name).write_bytes(content)
            CompiledScene(_scene(folder / name))
        before = peak_megabytes()
        found = fuzz(count, seed, folder)
    return {
        "files": found.files, "read": found.read, "refused": found.refused,
        "tracebacks": found.tracebacks, "hangs": found.hangs, "unclear": found.unclear,
        "megabytes": round(peak_megabytes() - before, 1),
    }  # fmt: skip


if __name__ == "__main__":
    print(json.dumps(main(int(sys.argv[1]), int(sys.argv[2]))))
