"""The page of what `raywalk bench` and `raywalk stress` measured: figures, plots, JSON."""

from __future__ import annotations

import json
import math
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from raywalk.site.pages import page_environment, rendered
from raywalk.site.plots import plots_of

REPORTS = "reports"  # below the work folder
FORMAT = 2  # of the reports: those of an older one are not shown
STYLE = Path(__file__).with_name("benchmarks.css")


def publish_reports(
    out: Path, templates: Path, assets: dict[str, str], scenes: Sequence[Any] = (),
    work: Path = Path(".work"),
) -> bool:  # fmt: skip
    """Writes benchmarks/ (page, plots, JSON) below `out` from what was kept; False if nothing."""
    kept = {name: kept_report(work, name) for name in ("bench", "stress", "mistakes")}
    if not any(kept.values()):
        return False
    folder = out / "benchmarks"
    folder.mkdir(parents=True, exist_ok=True)
    plots = plots_of(kept["bench"]) if kept["bench"] else []
    text = json.dumps(kept, indent=1, allow_nan=False)
    (folder / "benchmarks.json").write_text(text + "\n", encoding="utf-8")
    shutil.copyfile(STYLE, folder / "benchmarks.css")
    environment = page_environment(templates)
    for plot in plots:
        (folder / f"{plot.name}.svg").write_text(plot.svg(environment), encoding="utf-8")
    environment.filters["shown"] = lambda value: value if isinstance(value, str) else shown(value)
    values = {"root": "../", "scenes": scenes, "plots": plots, **kept, **assets}
    page = rendered(environment, "benchmarks.html", values)
    (folder / "index.html").write_text(page, encoding="utf-8")
    return True


def kept_report(work: Path, name: str) -> Any:
    """What was kept under this name, None if nothing of this format was."""
    try:
        kept = json.loads((work / REPORTS / f"{name}.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return kept if kept.get("format") == FORMAT else None


def shown(value: float) -> str:
    """Three digits, and none for whole numbers."""
    is_whole = math.isfinite(value) and value == round(value)
    return f"{value:,.0f}" if is_whole and abs(value) < 1e7 else f"{value:.3g}"
