"""The page and its plots come from kept figures alone."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from raywalk.bench.bench import beats, says
from raywalk.bench.cases import Case
from raywalk.bench.recognition import Tally, as_table, cases, lines
from raywalk.bench.report import keep_bench, keep_mistakes, keep_stress, publish_page
from raywalk.site.plots import front_of
from raywalk.site.reports import publish_reports
from raywalk.work.publish import staged

TEMPLATES = Path("site_src/templates")
ASSETS = {"style_css": "assets/style-0.css"}


def method(name: str, nanoseconds: float, largest: float, ours: bool = False) -> dict:
    """A row as `bench` measures it."""
    return {
        "name": name, "ours": ours, "nanoseconds": nanoseconds, "rate": 1e3 / nanoseconds,
        "ratio": 1.0, "median": largest / 10, "largest": largest, "point": 1e-16,
        "normal": 0.0, "wrong": 0.0,
    }  # fmt: skip


def report() -> dict:
    """One task of three methods, a picture, a resolution."""
    methods = [
        method("ours", 100.0, 1e-15, ours=True),
        method("fast <&>", 50.0, 1e-3),
        method("slow", 200.0, 1e-7),
    ]
    task = {"key": "t", "title": "Task", "about": "About.", "floor": "slow", "methods": methods}
    picture = {"about": "Pictures.", "methods": [
        {"name": "ours", "ours": True, "seconds": 1.0, "ratio": 1.0, "wrong": 0.0, "mean": 0.0,
         "largest": 0.0}]}  # fmt: skip
    rows = [{"size": 5, "error": 6.0, "off": 0.5}, {"size": 15, "error": 2.0, "off": 0.2}]
    case = Case("subject", "case", "metric", 1.0, 0.5, 10, 7, 3.0, "Embree").as_dict()
    return {
        "seed": 7, "says": list(says([task])), "tasks": [task], "picture": picture,
        "resolution": {"about": "Grids.", "rows": rows}, "cases": [case],
        "builds": [{"key": "many", "title": "Many scenes", "lines": ["a < b"], "cases": [case]}],
    }  # fmt: skip


def test_nothing_kept_means_no_page(tmp_path: Path) -> None:
    """A site is built without figures too."""
    assert not publish_reports(tmp_path / "dist", TEMPLATES, ASSETS, (), tmp_path / "work")
    assert not (tmp_path / "dist").exists()


def test_kept_figures_become_page_plots_and_json(tmp_path: Path) -> None:
    """Without measuring again; plots are XML, no script or style stands inline."""
    work, out = tmp_path / "work", tmp_path / "dist"
    keep_bench(work, report())
    keep_stress(work, [Case("s", "c", "m", 0.0, float("inf"), 5, 9)], 5, 9)
    assert publish_reports(out, TEMPLATES, ASSETS, (), work)
    page = (out / "benchmarks/index.html").read_text(encoding="utf-8")
    assert "<script" not in page
    assert "raywalk bench --only many" in page
    assert "a &lt; b" in page
    assert "style=" not in page
    assert "<style" not in page
    assert "make bench" in page
    assert "fast &lt;&amp;&gt;" in page
    assert "broken" in page  # the case that is infinite
    for plot in ("t-median", "t-largest", "resolution"):
        assert f'src="{plot}.svg"' in page
        ElementTree.parse(out / f"benchmarks/{plot}.svg")
    kept = json.loads((out / "benchmarks/benchmarks.json").read_text(encoding="utf-8"))
    assert kept["bench"]["tasks"][0]["methods"][0]["name"] == "ours"


def test_a_build_after_a_bench_replaces_the_page_that_the_bench_put_into_the_site(
    tmp_path: Path,
) -> None:
    """It refused it as a file of somebody else's."""
    work, out = tmp_path / "work", tmp_path / "dist"
    with staged(out) as fresh:
        (fresh / "assets").mkdir()
        (fresh / "assets" / "style-0.css").write_text("")
    keep_bench(work, report())
    assert list(publish_page(work, out))
    with staged(out) as fresh:
        (fresh / "benchmarks").mkdir()
        (fresh / "benchmarks" / "index.html").write_text("another")
    assert [path.name for path in (out / "benchmarks").iterdir()] == ["index.html"]
    assert not (out / "assets").exists()


def named(work: Path) -> None:
    """Keeps tallies of four pictures with one mistake and one with two."""
    tallies = {
        "single": Tally(),
        "pairs": Tally(missed=["a + b: a"]),
        "right": Tally(),
        "other sizes": Tally(),
    }
    for size, family, is_first in (("at 105", "light", True), ("at 231", "camera", False)) * 2:
        tallies["single"].count([size, family], is_first, True)
    tallies["pairs"].count([], True, False)
    told = {"lines": list(lines(tallies)), "table": as_table(tallies)}
    keep_mistakes(work, told, cases(tallies, 7), "raywalk bench --only mistakes --seed 7")


def test_how_often_mistakes_are_named_stands_on_the_page_by_itself(tmp_path: Path) -> None:
    """Measured without the rest: by size and family, with the command, its bounds, and what was
    missed; what was not asked has no share and breaks its bound."""
    named(tmp_path / "work")
    assert publish_reports(tmp_path, TEMPLATES, ASSETS, (), tmp_path / "work")
    page = (tmp_path / "benchmarks/index.html").read_text(encoding="utf-8")
    cells = [re.findall(r"<td[^>]*>(.*?)</td>", row) for row in page.split("<tr>")]
    assert ["one mistake", "4", "50.0", "100.0"] in cells
    assert ["... at 105", "2", "100.0", "100.0"] in cells
    assert ["... camera", "2", "0.0", "100.0"] in cells
    assert ["right pictures: called right", "0", "", ""] in cells
    assert "raywalk bench --only mistakes --seed 7" in page and "<li>a + b: a</li>" in page
    assert page.count("holds") == 1 and page.count('class="broken"') == 4
    assert "Time against error" not in page


def test_the_front_holds_what_nothing_beats() -> None:
    """(1, 3), (2, 2), (3, 1) are on it; (3, 3) is beaten by all of them."""
    assert front_of([1, 2, 3, 3], [3, 2, 1, 3]) == [True, True, True, False]


def test_being_beaten_is_said() -> None:
    """Faster and as exact beats our path; faster and wrong does not."""
    ours = method("ours", 100.0, 1e-15, ours=True)
    better = method("better", 90.0, 1e-15)
    assert beats(better, ours)
    assert not beats(better | {"wrong": 1.0}, ours)
    assert not beats(method("inexact", 50.0, 1e-7), ours)
    holes = {"title": "H", "methods": [ours, better | {"wrong": 7.0}]}
    sentences = " ".join(says([{"title": "T", "methods": [ours, better]}, holes]))
    assert "better is faster than our path" in sentences
    assert "7 ppm on h" in sentences
