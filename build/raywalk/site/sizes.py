"""What the site's files weigh, against budgets that a build must keep (budgets.toml)."""

from __future__ import annotations

import gzip
import json
import lzma
import tomllib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from raywalk.errors import UserError, shown_path
from raywalk.scene.model import Scene
from raywalk.site.assets import CHECK, PART
from raywalk.site.scene_data import start_of
from raywalk.site.shown_picture import shown_picture
from raywalk.trace_file.container import pack, script, unpack
from raywalk.words.catalogue import DEFAULT
from raywalk.work.snapshot import text_of

BUDGETS = Path(__file__).with_name("budgets.toml")
REPORT = "sizes.json"
LEVEL = 9
# Smaller files are mostly header: they count as if they held this many.
FEW_RAYS, FEW_TRIANGLES = 5000, 2000


@dataclass(frozen=True)
class Budget:
    """A limit, in `unit`, for every file ("each") or for all together ("all"), and why."""

    key: str
    what: str
    limit: float
    unit: str
    counted: str
    reason: str
    # Set by our own course, for what scenes weigh: somebody's larger model is told of, and built.
    of_scenes: bool = False


@dataclass(frozen=True)
class Size:
    """What one file weighs: bytes as sent, and by how many things they are divided."""

    key: str  # of its budget
    file: str  # below the site
    size: int
    over: int = 1  # rays, triangles

    @property
    def value(self) -> float:
        """In the budget's unit."""
        return self.size / self.over


class OverBudget(UserError):
    """A file outgrew its budget; str() names file, size, budget and why it is there."""


def read_budgets(path: Path = BUDGETS) -> list[Budget]:
    """The budgets of a file in the manner of budgets.toml."""
    read = tomllib.loads(text_of(path))
    parts = read.get("parts", {"limits": {}})
    return [Budget(**each) for each in read["budgets"]] + [
        Budget(_part(name), f"the part {name}", limit, "bytes", "each", parts["reason"])
        for name, limit in parts["limits"].items()
    ]


def _part(name: str) -> str:
    """The key of a part of the viewer that comes when asked for."""
    return f"part {name}"


def measured(out: Path, scenes: Sequence[Scene], facts: dict[str, dict[str, Any]]) -> list[Size]:
    """The sizes of a site that is in `out`. facts: what the trace stage counted, by scene."""
    assets = sorted((out / "assets").iterdir())
    scripts = {path.name: sent(path) for path in assets if _is_loaded(path.name)}
    styles = sum(sent(path) for path in assets if path.suffix == ".css")
    code = {name: size for name, size in scripts.items() if not name.startswith("words-")}
    sizes = [Size("viewer", f"assets/{name}", size) for name, size in code.items()]
    for path in assets:
        if path.name.startswith(PART):
            name = path.stem.removeprefix(PART).rpartition("-")[0]
            sizes.append(Size(_part(name), f"assets/{path.name}", sent(path)))
    sizes += of_mistakes(out)
    sizes += [size for scene in scenes if not scene.base for size in of_sweeps(out, scene)]
    fixed = styles + sum(scripts.values())
    for scene in scenes:
        folder, name = out / "scenes" / scene.id, f"scenes/{scene.id}"
        if scene.base:
            sizes.append(Size("first", name, _first_of_lesson(out, scene) + fixed))
            continue
        finest = facts[scene.id]["finest"]
        trace = folder / f"{finest['n']}.json.gz"
        # What textures and colours of files add is noise to every encoder.
        kind = "textured " if any(obj.base for obj in scene.objects) else ""
        triangles = facts[scene.id]["drawn" if kind else "triangles"]
        data = sent(folder / "scene.js")
        first = sent(folder / "index.html") + _without_meshes(folder / "scene.js")
        first += sent(folder / f"{start_of(scene)['resolution']}.json.gz")
        rays, picture = max(finest["rays"], FEW_RAYS), shown_picture(folder, "picture")
        sizes += [
            Size(kind + "trace", f"{name}/{trace.name}", sent(trace), rays),
            Size(kind + "picture", f"{name}/{picture}", sent(folder / picture)),
            Size("first", name, first + fixed),
        ]
        if (around := folder / "surroundings.js").is_file():
            objects = max(1, len(json.loads(unpack(around.read_bytes()))["objects"]))
            sizes.append(Size("surroundings", f"{name}/{around.name}", sent(around), objects))
        if triangles:
            over = max(triangles, FEW_TRIANGLES)
            sizes.append(Size(kind + "mesh", f"{name}/scene.js", data, over))
    return sizes


def of_sweeps(out: Path, scene: Scene) -> Iterator[Size]:
    """What each sweep's rays weigh, a stop at a time, and each of its pictures."""
    kind = "glass " if scene.has_glass else ""
    for sweep in scene.sweeps:
        name = f"scenes/{scene.id}/{sweep.id}"
        for n in sweep.resolutions:
            file, stops = f"{name}/{n}.js", len(sweep.stops)
            yield Size(f"{kind}sweep {n}", file, sent(out / file), stops)
        for path in sorted((out / name).iterdir()):
            if path.suffix != ".js":
                yield Size(f"{kind}sweep picture", f"{name}/{path.name}", sent(path))


def of_mistakes(out: Path) -> list[Size]:
    """What each page of mistakes loads besides what all pages share; of all, by itself; of that
    which asks, without pictures, which come as one scrolls."""
    folder = out / "mistakes"
    if not folder.is_dir():
        return []
    once = max(map(sent, folder.glob("*.webp")), default=0) + sent(folder / "mistakes.css")
    pages = sorted(path for path in folder.iterdir() if path.is_dir())
    small = sum(sent(path) for path in folder.glob("*/small.webp"))
    whole = Size("mistakes", "mistakes/index.html", sent(folder / "index.html") + small)
    return [
        whole,
        *(Size("mistake", f"mistakes/{page.name}", once + sum(map(sent, page.iterdir())))
          for page in pages),
    ]  # fmt: skip


def _first_of_lesson(out: Path, scene: Scene) -> int:
    """Of a lesson on another scene: its page and data, with that scene's."""
    own, base = out / "scenes" / scene.id, out / "scenes" / scene.traces
    grid = base / f"{start_of(scene)['resolution']}.json.gz"
    data = sent(own / "scene.js") + _without_meshes(base / "scene.js")
    return sent(own / "index.html") + data + sent(grid)


def _is_loaded(name: str) -> bool:
    """A first view loads the words of one language; that of the default one stands for all. A
    kiosk's script comes in a kiosk only, that of checks on their page, and parts when asked for."""
    if name.startswith(("kiosk-", f"{CHECK}-", PART)):
        return False
    other = name.startswith("words-") and not name.startswith(f"words-{DEFAULT}-")
    return name.endswith(".js") and not other


def _without_meshes(path: Path) -> int:
    """What a scene's data would weigh without its meshes, which are counted by themselves."""
    scene = json.loads(unpack(path.read_bytes())) | {"meshes": {}}
    text = json.dumps(scene, separators=(",", ":")).encode()
    return len(gzip.compress(script(f"{path.parent.name}/scene", pack(text)), LEVEL, mtime=0))


def sent(path: Path) -> int:
    """Bytes as a host sends them: text gzipped, what is compressed already as it is."""
    content = path.read_bytes()
    if path.suffix in (".gz", ".png", ".webp"):
        return len(content)
    return len(gzip.compress(content, LEVEL, mtime=0))


def check(out: Path, sizes: Sequence[Size], budgets: Iterable[Budget]) -> list[str]:
    """A sentence for each budget of scenes that is passed. Raises OverBudget with every other one,
    and every part that has none."""
    budgets = list(budgets)
    known = {budget.key for budget in budgets}
    problems = [
        f"{shown_path(out / size.file)}: no budget for {size.key}\n  budgets stand in "
        f"{shown_path(BUDGETS)}"
        for size in sizes
        if size.key.startswith("part ") and size.key not in known
    ]
    told = []
    for budget in budgets:
        for name, value in weighed(sizes, budget):
            if value <= budget.limit:
                continue
            weight, limit = shown(value, budget), shown(budget.limit, budget)
            if budget.of_scenes:
                told.append(f"{name}: {weight} of {budget.what}; the course keeps to {limit}")
                continue
            problems.append(
                f"{shown_path(out / name)}: {weight} of {budget.what}; the budget is {limit}\n"
                f"  why: {budget.reason}\n  budgets stand in {shown_path(BUDGETS)}"
            )
    if problems:
        raise OverBudget("\n".join([*problems, "the site was not changed"]))
    return told


def weighed(sizes: Sequence[Size], budget: Budget) -> Iterator[tuple[str, float]]:
    """(file, value) of all that a budget counts; together, the largest file stands for all."""
    own = [size for size in sizes if size.key == budget.key]
    if budget.counted == "each":
        yield from ((size.file, size.value) for size in own)
    elif own:
        over = sum(size.over for size in own) if any(size.over > 1 for size in own) else 1
        yield max(own, key=lambda size: size.size).file, sum(size.size for size in own) / over


def shown(value: float, budget: Budget) -> str:
    """With its unit."""
    return f"{value:,.2f} {budget.unit}" if value < 1000 else f"{value:,.0f} {budget.unit}"


def keep(out: Path, sizes: Iterable[Size]) -> None:
    """Writes sizes.json into the site."""
    text = json.dumps([asdict(size) for size in sizes], indent=1)
    (out / REPORT).write_text(text + "\n", encoding="utf-8")


def kept(out: Path) -> list[Size]:
    """What keep wrote."""
    return [Size(**each) for each in json.loads((out / REPORT).read_text(encoding="utf-8"))]


def table(out: Path, sizes: Sequence[Size], budgets: Iterable[Budget]) -> Iterator[str]:
    """Lines: each budget, its files against it and against a floor."""
    for budget in budgets:
        own = [size for size in sizes if size.key == budget.key]
        if not own:
            continue
        together = [value for _, value in weighed(own, budget)] if budget.counted == "all" else []
        said = f", together {shown(together[0], budget)}" if together else ""
        yield f"{budget.what}: at most {shown(budget.limit, budget)}{said} ({budget.reason})"
        for size in sorted(own, key=lambda size: -size.value):
            floor, way = floor_of(out / size.file)
            beside = f", {size.size / floor:.2f} of {way}" if floor else ""
            value = f", {shown(size.value, budget)}" if size.over > 1 else ""
            yield f"  {size.file}: {size.size:,} bytes{value}{beside}"


def floor_of(path: Path) -> tuple[int, str]:
    """What the best encoder at hand makes of the same content, for comparison; 0 if none."""
    if path.suffix == ".webp":
        png = path.with_suffix(".png")
        return (png.stat().st_size, "its PNG") if png.is_file() else (0, "")
    if path.suffix == ".png":
        import numpy as np
        from PIL import Image

        from raywalk.trace_file.webp import webp

        return len(webp(np.asarray(Image.open(path).convert("RGB")))), "lossless WebP"
    if not path.is_file():
        return 0, ""
    content = gzip.decompress(path.read_bytes()) if path.suffix == ".gz" else path.read_bytes()
    return len(lzma.compress(content, preset=9 | lzma.PRESET_EXTREME)), "xz -9e"
