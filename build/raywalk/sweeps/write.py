"""What is published of a sweep: stops.js with what moves, <n>.js with all stops' rays, and each
stop's picture."""

from __future__ import annotations

import gzip
import json
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from raywalk.scene.model import Scene, Sweep
from raywalk.site.scene_data import read_display
from raywalk.site.stop_data import stop_data
from raywalk.sweeps.differences import as_differences
from raywalk.trace_file.container import pack, pack_texts, write_packed

STOPS = "stops"  # stops.js


def write_sweep(
    scene: Scene, sweep: Sweep, traced: Path, stops: Sequence[Path], folder: Path
) -> None:
    """traced: the folder of the scene's trace; stops: those of its stops, in order."""
    display = read_display(scene, traced / "display.npz")
    moved = []
    for k, (stop, made) in enumerate(zip(sweep.stops, stops, strict=True), start=1):
        [picture] = made.glob("picture.*")
        name = f"{k}{picture.suffix}"
        shutil.copyfile(picture, folder / name)
        moved.append(stop_data(stop, scene, display, f"../{name}"))
    _write(folder, scene, sweep, STOPS, moved)
    for n in sweep.resolutions:
        files = [gzip.decompress((made / f"{n}.json.gz").read_bytes()) for made in stops]
        _write(folder, scene, sweep, str(n), as_differences([json.loads(each) for each in files]))


def _write(folder: Path, scene: Scene, sweep: Sweep, name: str, stops: Sequence[Any]) -> None:
    """The smaller of both ways to pack: of many stops' texts most are alike."""
    text = json.dumps(
        {"format": 1, "scene": scene.id, "sweep": sweep.id, "stops": stops},
        separators=(",", ":"), allow_nan=False, default=vars,
    ).encode()  # fmt: skip
    packed = min(pack(text), pack_texts(text), key=len)
    write_packed(folder / f"{name}.js", f"{scene.id}/{sweep.id}/{name}", packed)
