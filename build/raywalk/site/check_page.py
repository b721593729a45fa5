"""The page check/, of one language: its scenes, and what its script says of mistakes."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from raywalk.mistakes.table import TABLE
from raywalk.scene.model import Scene
from raywalk.site.mistake_words import ALL, Said, named
from raywalk.site.pages import (
    Assets,
    card_of,
    has_check,
    home_of,
    page_environment,
    rendered,
)
from raywalk.words import Words

HERE = "check/index.html"


def write_check_page(
    out: Path, templates: Path, scenes: Sequence[Scene], said: Said, assets: Assets, words: Words,
    base: str, with_mistakes: bool,
) -> None:  # fmt: skip
    """Writes none where no scene has pictures to check against. scenes: in the language; said: of
    mistakes in it; with_mistakes: whether they have pages to lead to."""
    home = home_of(words.code)
    checks = [_chosen(each, home, out) for each in scenes if has_check(each, out)]
    if not checks:
        return
    values = {
        "home": home, "base": base, "preview": "", "scenes": checks, **assets, "here": HERE,
        "root": "../" * (home + HERE).count("/"), "checks": checks,
        "mistakes": _mistakes(said, home, with_mistakes),
    }  # fmt: skip
    page = out / f"{home}{HERE}"
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(rendered(page_environment(templates, words), "check.html", values), "utf-8")


def _chosen(scene: Scene, home: str, out: Path) -> dict[str, str]:
    """objects: their names in the page's language, as JSON."""
    names = json.dumps([obj.name for obj in scene.objects], ensure_ascii=False)
    return card_of(scene, home, out) | {"objects": names}


def _mistakes(said: Said, home: str, with_mistakes: bool) -> str:
    """By name: what each is called, the line to look for, and its page; as JSON."""
    pages = {each.name: f"{home}{ALL}/{each.name}/index.html" for each in TABLE}
    told = {
        name: named(said[name]) | {"url": page if with_mistakes else ""}
        for name, page in pages.items()
    }
    return json.dumps(told, ensure_ascii=False)
