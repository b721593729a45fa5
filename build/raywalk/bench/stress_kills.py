"""A build killed at any instant: what stands afterwards is a whole site, the old or the new."""

from __future__ import annotations

import random
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from itertools import count as numbers
from pathlib import Path

from raywalk.bench.cases import Case
from raywalk.work import publish

# Of the rays that a case asks for: with a million, 500 kills of each kind.
RAYS_A_KILL = 2000
LEAST = 20
PAGES = 60  # of a site that is put in another's place as fast as can be
LONGEST = 0.03  # seconds of swapping before the kill: some ten sites


def cases(count: int, seed: int) -> Iterator[Case]:
    """Both ways to put a site in place: in one step, and in two renames where there is no such
    step; then the next build puts back what stood between them."""
    kills = max(LEAST, count // RAYS_A_KILL)
    for way, restores in ("exchange", False), ("renames", True):
        broken = sum(killed(way, restores, random.Random(f"{seed} {k}")) for k in range(kills))
        yield Case(
            f"builds killed, site put in place by {way}", f"kill -9 x {kills:,}",
            "sites that are not whole", 0.0, broken, kills, seed,
        )  # fmt: skip


def killed(way: str, restores: bool, chance: random.Random) -> bool:
    """Whether a site is broken after its builder was killed."""
    with tempfile.TemporaryDirectory() as place:
        out = Path(place) / "dist"
        write_sites(out, 1)
        command = [sys.executable, "-m", __name__, str(out), way]
        with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
            assert process.stdout
            process.stdout.readline()  # it has begun
            time.sleep(chance.uniform(0.0, LONGEST))
            process.send_signal(signal.SIGKILL)
        if restores:
            publish.restore(out)
        return not is_whole(out)


def write_sites(out: Path, most: int | None = None) -> None:
    """Site after site, each of pages that all say its number."""
    for number in numbers() if most is None else range(most):
        with publish.staged(out) as fresh:
            for page in range(PAGES):
                (fresh / f"{page}.html").write_text(f"site {number}", encoding="utf-8")


def is_whole(out: Path) -> bool:
    """All pages are there, of one site."""
    said = [path.read_text(encoding="utf-8") for path in out.glob("*.html")]
    return len(said) == PAGES and len(set(said)) == 1


if __name__ == "__main__":
    print("begins", flush=True)
    if sys.argv[2] == "renames":
        vars(publish)["exchange"] = lambda one, other: False
    write_sites(Path(sys.argv[1]))
