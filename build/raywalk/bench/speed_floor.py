"""A scene's making over its floor: meeting its own rays with surfaces and shading the hits by the
same kernels, once, and deflating the same bytes. Processor time of one thread, so that other
programs count little."""

from __future__ import annotations

import gzip
import tempfile
import time
import zlib
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.geometry.compiled import CompiledScene
from raywalk.pipeline.trace_products import write_products
from raywalk.scene.model import Scene
from raywalk.trace import lighting
from raywalk.trace_file.png import LEVEL

GOAL = 2.5  # of all scenes together
GZIP = 31  # window bits of a gzip frame
# What meets rays and shades hits, each part in no other.
FLOOR: dict[str, list[tuple[Any, str]]] = {
    "meet": [(CompiledScene, "_unrefined")],
    "shade": [
        (CompiledScene, "surface"), (lighting, "towards_lights"), (lighting, "light_factors"),
        (lighting, "local_colours"),
    ],
}  # fmt: skip


def floors(scenes: Sequence[Scene], rounds: int) -> Iterator[dict[str, Any]]:
    """Per scene, medians: how often its floor its making takes, and the floor's parts."""
    for scene in scenes:
        _once(scene)  # compiles what this scene needs
        runs = [_once(scene) for _ in range(rounds)]
        seconds = {key: median(run[key] for run in runs) for key in runs[0]}
        floor = seconds["meet"] + seconds["shade"] + seconds["deflate"]
        yield {"scene": scene.id, "ratio": seconds["all"] / floor, "floor": floor, **seconds}


def _once(scene: Scene) -> dict[str, float]:
    """Processor seconds of the whole; of meeting rays, of shading hits, of bare deflating."""
    spent = dict.fromkeys(FLOOR, 0.0)
    own = [(key, place, name, getattr(place, name)) for key, parts in FLOOR.items()
           for place, name in parts]  # fmt: skip

    def timed(key: str, work: Callable[..., Any]) -> Callable[..., Any]:
        def run(*given: Any, **named: Any) -> Any:
            start = time.thread_time()
            try:
                return work(*given, **named)
            finally:
                spent[key] += time.thread_time() - start

        return run

    with tempfile.TemporaryDirectory() as folder:
        for key, place, name, work in own:
            setattr(place, name, timed(key, work))
        start = time.process_time()
        try:
            write_products(scene, Path(folder), threads=1)
        finally:
            for _, place, name, work in own:
                setattr(place, name, work)
        whole = time.process_time() - start
        return {"all": whole, **spent, "deflate": _deflating(Path(folder))}


def _deflating(folder: Path) -> float:
    """Seconds for the same bytes once: trace files at zlib 9, the picture's rows as they are."""
    from PIL import Image

    texts = [(gzip.decompress(path.read_bytes()), 9) for path in folder.glob("*.json.gz")]
    rows = np.asarray(Image.open(folder / "picture.png").convert("RGB"))
    texts.append((np.diff(rows, axis=0, prepend=rows[:1]).tobytes(), LEVEL))
    start = time.process_time()
    for text, level in texts:
        deflate = zlib.compressobj(level, zlib.DEFLATED, GZIP)
        deflate.compress(text)
        deflate.flush()
    return time.process_time() - start


def as_table(rows: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Ratios and shares only: seconds are of one machine."""
    for row in rows:
        meet = row["meet"] / row["floor"]
        yield f"  {row['scene']}: {row['ratio']:.2f} times its floor, {meet:.0%} of that to meet"


def floor_cases(rows: Sequence[dict[str, Any]], seed: int) -> Iterator[Case]:
    """All scenes together keep the goal."""
    together = sum(row["all"] for row in rows) / sum(row["floor"] for row in rows)
    yield Case("speed", f"{len(rows)} scenes", "times the floor", GOAL, together, 0, seed)
