"""What was measured, kept as JSON and published as a page with plots."""

from __future__ import annotations

import hashlib
import json
import os
import platform
import shutil
from collections.abc import Iterable, Iterator, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from raywalk.bench.cases import Case, shown
from raywalk.bench.plots import plots_of
from raywalk.site.pages import page_environment

REPORTS = "reports"  # below the work folder
FORMAT = 2  # of the reports: those of an older one are not shown
SITE_SOURCE = Path("site_src")
STYLE = Path(__file__).with_name("page.css")
PACKAGES = ("numpy", "numba", "embreex", "trimesh", "mpmath", "mitsuba", "open3d")


def keep_stress(work: Path, cases: Iterable[Case], rays: int, seed: int) -> None:
    """Keeps the stress table."""
    listed = [case.as_dict() for case in cases]
    _keep(work, "stress", {"cases": listed, "rays": rays, "seed": seed})


def keep_bench(work: Path, measured: dict[str, Any]) -> None:
    """Keeps what `bench` measured."""
    _keep(work, "bench", measured)


def publish_page(work: Path, out: Path) -> Iterator[str]:
    """Renders the kept reports into a site that is there or not; tells where."""
    assets = {"style_css": _style_of(out)}
    if publish_reports(out, SITE_SOURCE / "templates", assets, (), work):
        yield f"page: {out.as_posix()}/benchmarks/index.html"


def publish_reports(
    out: Path, templates: Path, assets: dict[str, str], scenes: Sequence[Any] = (),
    work: Path = Path(".work"),
) -> bool:  # fmt: skip
    """Writes benchmarks/ (page, plots, JSON) below `out` from what was kept; False if nothing."""
    kept = {name: _kept(work, name) for name in ("bench", "stress")}
    if not any(kept.values()):
        return False
    folder = out / "benchmarks"
    folder.mkdir(parents=True, exist_ok=True)
    plots = plots_of(kept["bench"]) if kept["bench"] else []
    for plot in plots:
        (folder / f"{plot.name}.svg").write_text(plot.svg, encoding="utf-8")
    text = json.dumps(kept, indent=1, allow_nan=False)
    (folder / "benchmarks.json").write_text(text + "\n", encoding="utf-8")
    shutil.copyfile(STYLE, folder / "benchmarks.css")
    environment = page_environment(templates)
    environment.filters["shown"] = lambda value: value if isinstance(value, str) else shown(value)
    page = environment.get_template("benchmarks.html").render(
        root="../", scenes=scenes, plots=plots, **kept, **assets
    )
    (folder / "index.html").write_text(page, encoding="utf-8")
    return True


def _keep(work: Path, name: str, measured: dict[str, Any]) -> None:
    folder = work / REPORTS
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(
        {"format": FORMAT, "machine": _machine(), **measured}, indent=1, allow_nan=False
    )
    beside = folder / f"{name}.json.partial"
    beside.write_text(text + "\n", encoding="utf-8")
    beside.replace(folder / f"{name}.json")


def _kept(work: Path, name: str) -> Any:
    try:
        kept = json.loads((work / REPORTS / f"{name}.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return kept if kept.get("format") == FORMAT else None


def _machine() -> dict[str, str]:
    """What the figures depend on, without names or paths."""
    packages = []
    for name in PACKAGES:
        try:
            packages.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            packages.append(f"{name} not installed")
    return {
        "processor": f"{platform.machine()}, {os.cpu_count()} processors, {_model()}",
        "python": f"Python {platform.python_version()}",
        "packages": ", ".join(packages),
        "measured": datetime.now(UTC).strftime("%Y-%m-%d"),
    }


def _model() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.system()
    return next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), "")


def _style_of(out: Path) -> str:
    """The site's style sheet, by its name there; written if the site is not built yet."""
    found = sorted((out / "assets").glob("style-*.css"))
    if found:
        return f"assets/{found[0].name}"
    sheets = sorted((SITE_SOURCE / "styles").glob("*.css"))
    content = b"\n".join(sheet.read_bytes() for sheet in sheets)
    name = f"assets/style-{hashlib.sha256(content).hexdigest()[:10]}.css"
    (out / "assets").mkdir(parents=True, exist_ok=True)
    (out / name).write_bytes(content)
    return name
