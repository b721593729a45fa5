"""How often the mistakes in students' pictures are named: site_src/check/ asked through node.

Of the atlas as the site has it (check/atlas.py). Students' pictures are made with other habits, at
other sizes.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.check.atlas import CHANGED, GRID, USUAL, atlas_of, changed
from raywalk.check.write import about_of, packed_strips
from raywalk.home import HOME
from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.table import BY_NAME, FAMILIES
from raywalk.mistakes.tracer import picture
from raywalk.scene.model import Scene
from raywalk.stops.process import Stops

SCRIPT = HOME / "site_src" / "check.mjs"
# What tells nothing: each of them is a right program.
HABITS = (
    EXACT,
    USUAL,
    Habits(precision=np.float32, offset=1e-3, truncates=True, last_wins=True),
    Habits(offset=1e-4, truncates=True),
    Habits(precision=np.float32, offset=3e-3),
)
SIZES = (105, 231, 512)
FINE = 1155  # pixels across: one picture takes the numpy tracer up to half a minute
SAMPLE = 3  # every so-maniest mistake, unless all are asked
PAIRS = 200
SCENES = ("01", "02", "03", "04", "05", "08", "10")  # those without meshes and textures
#: Sizes that no scene has a right picture of, and scenes with edges, glass and mirrors.
OTHER_SIZES, FINE_SCENES = (64, 300, 480), ("02", "08", "10")
BOUNDS = {"first": 5.0, "among three": 1.0, "pairs": 20.0, "alarms": 0.0}  # percent that are not

Student = tuple[Scene, int, frozenset[str], Habits]


@dataclass
class Tally:
    """What became of the pictures of one kind."""

    asked: int = 0
    first: int = 0
    among: int = 0
    missed: list[str] = field(default_factory=list)
    alike: list[int] = field(default_factory=list)  # names in the first answer
    by: dict[str, list[int]] = field(default_factory=dict)  # size or family: asked, first, among

    def missing(self, named: int) -> float:
        """Percent; NaN of none, which breaks every bound."""
        return 100 * (1 - named / self.asked) if self.asked else float("nan")

    def count(self, parts: Iterable[str], is_first: bool, is_among: bool) -> None:
        """One picture, for all and for each part that it belongs to."""
        self.asked += 1
        self.first += is_first
        self.among += is_among
        for part in parts:
            own = self.by.setdefault(part, [0, 0, 0])
            self.by[part] = [n + m for n, m in zip(own, (1, is_first, is_among), strict=True)]


class Asked:
    """A scene's atlas in a folder, as the site has it, and check.mjs asked about pictures."""

    def __init__(self, scene: Scene, folder: Path):
        self.scene, self.folder = scene, folder
        folder.mkdir(parents=True, exist_ok=True)
        atlas = atlas_of(scene)
        self.names = [each.mistake.name for each in atlas.wrong]
        (folder / "atlas.gz").write_bytes(packed_strips(atlas))
        (folder / "about.json").write_text(json.dumps(about_of(scene, atlas)), encoding="utf-8")

    def written(self, name: str, values: np.ndarray) -> str:
        """(n, n, 3) uint8 as P6; the file's name."""
        (self.folder / name).write_bytes(ppm(values))
        return name

    def ask(self, node: Stops, student: np.ndarray, right: np.ndarray) -> dict[str, Any]:
        """What is recognised in a picture."""
        files = {"picture": student, "right": right}
        named = {
            key: str(self.folder / self.written(f"asked-{key}", values))
            for key, values in files.items()
        }
        return self.asked(node, named)

    def asked(self, node: Stops, named: dict[str, str]) -> dict[str, Any]:
        """The same of two files, "picture" and "right"."""
        request = {"do": "recognise", "atlas": str(self.folder), **named}
        found: dict[str, Any] = json.loads(node.ask(request))
        return found


def shown_in(scenes: list[Scene], named: tuple[str, ...] = SCENES) -> list[Scene]:
    """Those that the evaluation asks of."""
    return [scene for scene in scenes if scene.id.split("-")[0] in named]


def recognised(
    scenes: list[Scene], sizes: tuple[int, ...] = SIZES, pairs: int = PAIRS, seed: int = 0,
    every: int = 1,
) -> dict[str, Tally]:  # fmt: skip
    """Tallies of single mistakes (every so-maniest), pairs and right pictures."""
    tallies = {"single": Tally(), "pairs": Tally(), "right": Tally()}
    rng = np.random.default_rng(seed)
    with tempfile.TemporaryDirectory() as folder, Stops(SCRIPT) as node:
        for place, scene in enumerate(scenes):
            atlas = Asked(scene, Path(folder) / scene.id)
            share = pairs // len(scenes) + (place < pairs % len(scenes))
            for n in sizes:
                right = picture(scene, n).bytes
                tally_right(tallies["right"], node, atlas, right)
                for name in atlas.names[int(rng.integers(every)) :: every]:
                    habits = HABITS[rng.integers(len(HABITS))]
                    tally(tallies["single"], node, atlas, right, {name}, habits)
            tally_pairs(tallies["pairs"], node, atlas, share, rng)
    return tallies


def at_other_sizes(scenes: list[Scene], site: Path, sizes: tuple[int, ...] = OTHER_SIZES) -> Tally:
    """Right pictures, made as most programs do, held against those of other sizes that the built
    site has: first counts those that look right. None are asked where nothing is built."""
    found = Tally()
    with tempfile.TemporaryDirectory() as folder, Stops(SCRIPT) as node:
        file = Path(folder) / "asked.ppm"
        request = {
            "do": "check",
            "picture": str(file),
            "names": {
                "scene": "",
                "objects": [],
                "mistakes": {name: {"title": name, "right": "", "wrong": ""} for name in BY_NAME},
            },
        }
        for scene in scenes:
            data = site / "check" / scene.id
            for n in sizes if data.exists() else ():
                values = picture(scene, n, frozenset(), USUAL).bytes
                file.write_bytes(ppm(values))
                is_right = json.loads(node.ask(request | {"data": str(data)}))["isRight"]
                found.asked += 1
                found.first += is_right
                found.missed += [] if is_right else [f"{scene.id} at {n}"]
    return found


def ppm(values: np.ndarray) -> bytes:
    """(h, w, 3) uint8 as P6."""
    height, width = values.shape[:2]
    return b"P6 %d %d 255\n" % (width, height) + values.tobytes()


def tally_right(found: Tally, node: Stops, atlas: Asked, right: np.ndarray) -> None:
    """Right pictures of all habits: first counts those that are called right."""
    for habits in HABITS:
        own = picture(atlas.scene, len(right), frozenset(), habits).bytes
        is_right = atlas.ask(node, own, right)["isRight"]
        found.count([], is_right, is_right)
        if not is_right:
            found.missed.append(f"{atlas.scene.id} at {len(right)}, {habits}")


def tally(
    found: Tally, node: Stops, atlas: Asked, right: np.ndarray, names: set[str], habits: Habits
) -> None:
    """One wrong picture, if it is one; all its mistakes must be among the answers."""
    student = picture(atlas.scene, len(right), frozenset(names), habits).bytes
    if not changed(student, right) > CHANGED:
        return
    answers = [set(answer["names"]) for answer in atlas.ask(node, student, right)["answers"]]
    is_first, is_among = bool(answers and names & answers[0]), names <= set().union(*answers)
    families = [BY_NAME[name].family for name in sorted(names)] if len(names) == 1 else []
    found.count([f"at {len(right)}", *families], is_first, is_among)
    found.alike += [len(answers[0])] if answers else []
    if not is_among or not is_first:
        told = "; ".join(", ".join(sorted(answer)) for answer in answers) or "nothing"
        found.missed.append(
            f"{atlas.scene.id} at {len(right)}: {' + '.join(sorted(names))}: {told}"
        )


def tally_pairs(
    found: Tally, node: Stops, atlas: Asked, count: int, rng: np.random.Generator
) -> None:
    """Random pairs of different families that each change something the other leaves."""
    right = picture(atlas.scene, GRID).bytes
    among = [
        set(pair)
        for pair in combinations(atlas.names, 2)
        if BY_NAME[pair[0]].family != BY_NAME[pair[1]].family
    ]
    rng.shuffle(among)
    goal = found.asked + count
    for pair in among:
        if found.asked == goal:
            break
        habits = HABITS[rng.integers(len(HABITS))]
        both = picture(atlas.scene, GRID, frozenset(pair), habits).bytes
        alone = [picture(atlas.scene, GRID, frozenset([name]), habits).bytes for name in pair]
        # Where one hides the other wholly nobody could name both.
        if all(changed(both, each) > CHANGED for each in alone):
            tally(found, node, atlas, right, pair, habits)


def cases(tallies: dict[str, Tally], seed: int) -> Iterator[Case]:
    """The shares that are not named, in percent, with their bounds."""
    single, pairs, right, other = (
        tallies[key] for key in ("single", "pairs", "right", "other sizes")
    )
    for subject, metric, key, missing, asked in (
        ("one mistake", "not first", "first", single.missing(single.first), single.asked),
        ("one mistake", "not in three", "among three", single.missing(single.among), single.asked),
        ("two mistakes", "not both in three", "pairs", pairs.missing(pairs.among), pairs.asked),
        ("right pictures", "called wrong", "alarms", right.missing(right.first), right.asked),
        (
            "right pictures at sizes that there is none of", "called wrong", "alarms",
            other.missing(other.first), other.asked,
        ),
    ):  # fmt: skip
        yield Case("recognition", subject, f"{metric}, %", BOUNDS[key], missing, asked, seed)


def lines(tallies: dict[str, Tally]) -> Iterator[str]:
    """How many were asked, and each that was not named."""
    for kind, found in tallies.items():
        alike = f", {np.mean(found.alike):.2f} names in the first answer" if found.alike else ""
        yield f"  {kind}: {found.asked} pictures{alike}"
        yield from (f"    not named: {each}" for each in found.missed)


def as_table(tallies: dict[str, Tally]) -> dict[str, Any]:
    """For the page: how many were asked, and how many of a hundred were named."""
    single = tallies["single"]
    sizes = [part for part in single.by if part.startswith("at ")]
    families = [family for family in FAMILIES if family in single.by]
    rows = [_row("one mistake", single.asked, single.first, single.among)]
    rows += [_row(f"... {part}", *single.by[part]) for part in [*sizes, *families]]
    pairs, right, other = (tallies[key] for key in ("pairs", "right", "other sizes"))
    rows += [
        _row(
            "two mistakes of different families: one, both", pairs.asked, pairs.first, pairs.among
        ),
        [*_row("right pictures: called right", right.asked, right.first, right.first)[:3], ""],
        [*_row("... of sizes that there is none of", other.asked, other.first, 0)[:3], ""],
    ]
    return {"head": ["pictures", "asked", "first answer, %", "among three, %"], "rows": rows}


def _row(what: str, asked: int, first: int, among: int) -> list[str]:
    shares = (f"{100 * named / asked:.1f}" if asked else "" for named in (first, among))
    return [what, str(asked), *shares]
