"""Scene files that a person, an editor or a disk has spoilt: refused in words, at once."""

from __future__ import annotations

import random
import shutil
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from raywalk.bench.cases import Case
from raywalk.errors import SourceErrors
from raywalk.scene.read import read_scene

MUTANTS = 100_000
SLOW = 5.0  # seconds of processor time, in which a mutant must be refused or read
SIGNS = "\u201e\u2212\u00a0\ufeff\x00\x1b\u202e\"'[]{}=,.#\\\n\t-+_e09\U0001f600\u00e4"
NUMBERS = (
    "0",
    "-1",
    "1e300",
    "-1e-320",
    "nan",
    "inf",
    "1" * 400,
    "40,5",
    ".5",
    "true",
    '"x"',
    "[]",
)


def cases(count: int, seed: int, scenes: Path = Path("scenes")) -> Iterator[Case]:
    """A tenth of the rays' number of mutants."""
    mutants = max(1, count * MUTANTS // 1_000_000)
    wrong, slow = spoilt(mutants, seed, scenes)
    name = "mutants of the ten scenes"
    yield Case("scene files", name, "tracebacks", 0.0, float(wrong), mutants, seed)
    yield Case("scene files", name, f"over {SLOW:g} s", 0.0, float(slow), mutants, seed)


def spoilt(count: int, seed: int, scenes: Path = Path("scenes")) -> tuple[int, int]:
    """How many mutants end otherwise than as a scene or SourceErrors, and how many take long."""
    rng = random.Random(seed)
    sources = [path.read_text(encoding="utf-8") for path in sorted(scenes.glob("*/scene.toml"))]
    wrong = slow = 0
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(scenes.absolute().parent / "models", Path(folder) / "models")
        path = Path(folder) / "scenes" / "mutant" / "scene.toml"
        path.parent.mkdir(parents=True)
        for _ in range(count):
            path.write_bytes(mutant(rng, sources))
            start = time.process_time()
            try:
                read_scene(path)
            except SourceErrors as problems:
                str(problems)
            except Exception:
                wrong += 1
            slow += time.process_time() - start > SLOW
    return wrong, slow


def mutant(rng: random.Random, sources: list[str]) -> bytes:
    """One of the texts, spoilt in one to five places."""
    lines = rng.choice(sources).splitlines(keepends=True)
    for _ in range(rng.randint(1, 5)):
        at = rng.randrange(len(lines))
        match rng.randrange(7):
            case 0:
                del lines[at]
            case 1:
                lines.insert(at, lines[rng.randrange(len(lines))])
            case 2:
                other = rng.choice(sources).splitlines(keepends=True)
                lines[at] = rng.choice(other)
            case 3:
                place = rng.randrange(len(lines[at]) + 1)
                lines[at] = lines[at][:place] + rng.choice(SIGNS) + lines[at][place:]
            case 4:
                place = rng.randrange(len(lines[at]) + 1)
                lines[at] = lines[at][:place] + lines[at][place + 1 :]
            case 5:
                words = lines[at].split(" ")
                words[rng.randrange(len(words))] = rng.choice(NUMBERS)
                lines[at] = " ".join(words)
            case 6:
                lines = lines[: at + 1]
        lines = lines or ["\n"]
    text = "".join(lines).encode("utf-8", "surrogatepass")
    if rng.random() < 0.05 and text:
        place = rng.randrange(len(text))
        text = text[:place] + bytes([rng.randrange(256)]) + text[place + 1 :]
    return text
