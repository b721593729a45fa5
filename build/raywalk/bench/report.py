"""What was measured, kept as JSON for the page that site/reports.py makes of it."""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from raywalk.bench.cases import Case
from raywalk.home import HOME
from raywalk.site.assets import named
from raywalk.site.reports import FORMAT, REPORTS, publish_reports
from raywalk.trace_file.container import write_beside
from raywalk.work.ownership import mark_too

SITE_SOURCE = HOME / "site_src"
PACKAGES = ("numpy", "numba", "embreex", "trimesh", "mpmath", "mitsuba", "open3d")


def keep_stress(work: Path, cases: Iterable[Case], rays: int, seed: int) -> None:
    """Keeps the stress table."""
    listed = [case.as_dict() for case in cases]
    _keep(work, "stress", {"cases": listed, "rays": rays, "seed": seed})


def keep_bench(work: Path, measured: dict[str, Any]) -> None:
    """Keeps what `bench` measured."""
    _keep(work, "bench", measured)


def keep_mistakes(
    work: Path, measurement: dict[str, Any], cases: Iterable[Case], command: str
) -> None:
    """Keeps how often mistakes in students' pictures are named. command: what measures the same."""
    listed = [case.as_dict() for case in cases]
    _keep(work, "mistakes", {**measurement, "cases": listed, "command": command})


def publish_page(work: Path, out: Path) -> Iterator[str]:
    """Renders the kept reports into a site that is there or not; tells where."""
    style = _style_of(out)
    if publish_reports(out, SITE_SOURCE / "templates", {"style_css": style}, (), work):
        mark_too(out, [out / style, *(out / "benchmarks").iterdir()])
        yield f"page: {out.as_posix()}/benchmarks/index.html"


def _keep(work: Path, name: str, measured: dict[str, Any]) -> None:
    (work / REPORTS).mkdir(parents=True, exist_ok=True)
    whole = {"format": FORMAT, "machine": _machine(), **measured}
    text = json.dumps(whole, indent=1, allow_nan=False) + "\n"
    write_beside(work / REPORTS / f"{name}.json", text.encode())


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
    if found := sorted((out / "assets").glob("style-*.css")):
        return f"assets/{found[0].name}"
    sheets = sorted((SITE_SOURCE / "styles").glob("*.css"))
    return named(out, "style", "css", b"\n".join(sheet.read_bytes() for sheet in sheets))
