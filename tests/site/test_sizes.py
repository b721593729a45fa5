"""What files weigh is measured as sent, and a budget that is passed names the file."""

from __future__ import annotations

import gzip
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raywalk.site import sizes
from raywalk.site.sizes import Budget, OverBudget, Size, check, read_budgets, sent, weighed

EACH = Budget("picture", "pictures", 100, "bytes", "each", "a reason")
ALL = Budget("trace", "trees", 2.0, "bytes a ray", "all", "another reason")


def test_every_budget_has_a_limit_above_nothing_and_a_reason() -> None:
    budgets = read_budgets()
    parts = [budget for budget in budgets if budget.key.startswith("part ")]
    assert {budget.key for budget in budgets if budget not in parts} == {
        "trace", "picture", "mesh", "textured trace", "textured picture", "textured mesh",
        "surroundings", "viewer", "first", "mistake", "mistakes",
        "sweep 15", "sweep 33", "sweep picture",
        "glass sweep 15", "glass sweep 33", "glass sweep picture",
    }  # fmt: skip
    assert parts and all(part.limit <= 15_000 for part in parts)
    for budget in budgets:
        assert budget.limit > 0 and len(budget.reason) > 20 and budget.counted in ("each", "all")


def test_text_counts_gzipped_and_packed_files_as_they_are(tmp_path: Path) -> None:
    text = b"ray " * 1000
    (tmp_path / "a.js").write_bytes(text)
    (tmp_path / "a.json.gz").write_bytes(gzip.compress(text))
    (tmp_path / "a.png").write_bytes(text)
    assert sent(tmp_path / "a.js") < 100
    assert sent(tmp_path / "a.json.gz") == (tmp_path / "a.json.gz").stat().st_size
    assert sent(tmp_path / "a.png") == len(text)


def test_files_over_their_budget_are_named_all_at_once_with_size_budget_and_reason() -> None:
    weights = [Size("picture", "a.png", 100), Size("picture", "b.png", 101)]
    weights += [Size("picture", "c.png", 1234)]
    with pytest.raises(OverBudget) as caught:
        check(Path("dist"), weights, [EACH])
    said = str(caught.value)
    assert "dist/b.png: 101.00 bytes of pictures; the budget is 100.00 bytes" in said
    assert "dist/c.png: 1,234 bytes" in said and "a reason" in said
    assert "a.png" not in said and "not changed" in said


def test_a_part_of_the_viewer_without_a_budget_is_named() -> None:
    weights = [Size("part help", "assets/part-help-1.js", 10)]
    with pytest.raises(OverBudget, match=r"part-help-1\.js: no budget for part help"):
        check(Path("dist"), weights, [EACH])


def test_a_budget_for_all_divides_the_sum_so_one_dear_file_among_cheap_ones_passes() -> None:
    weights = [Size("trace", "a", 300, 100), Size("trace", "b", 100, 200)]
    check(Path("dist"), weights, [ALL])
    assert list(weighed(weights, ALL)) == [("a", pytest.approx(4 / 3))]
    with pytest.raises(OverBudget, match=r"c: 2\.50 bytes a ray"):
        check(Path("dist"), [*weights, Size("trace", "c", 600, 100)], [ALL])


def test_what_is_kept_comes_back(tmp_path: Path) -> None:
    weights = [Size("trace", "a", 300, 100), Size("picture", "b", 7)]
    sizes.keep(tmp_path, weights)
    assert sizes.kept(tmp_path) == weights


def test_the_floor_of_a_picture_is_its_lossless_webp(tmp_path: Path) -> None:
    from PIL import Image

    ramp = np.broadcast_to(np.arange(64, dtype=np.uint8)[:, None, None], (64, 64, 3))
    Image.fromarray(np.ascontiguousarray(ramp)).save(tmp_path / "a.png")
    floor, way = sizes.floor_of(tmp_path / "a.png")
    assert 0 < floor < (tmp_path / "a.png").stat().st_size and way == "lossless WebP"


def test_what_a_scene_weighs_over_the_courses_own_is_told_and_built() -> None:
    """Somebody's scan is finer than ours: once it failed the whole build."""
    budget = Budget("mesh", "meshes", 2.5, "bytes a triangle", "all", "ours", of_scenes=True)
    sizes = [Size("mesh", "scenes/01-scan/scene.js", 5_000, 1_000)]
    (said,) = check(Path("dist"), sizes, [budget])
    assert said.startswith("scenes/01-scan/scene.js: 5.00 bytes a triangle of meshes; ")
    assert "2.50 bytes a triangle" in said
    with pytest.raises(OverBudget):
        check(Path("dist"), sizes, [replace(budget, of_scenes=False)])
