"""The pages of mistakes: one a mistake, and one of all by family. They read without a script."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import partial
from itertools import pairwise, zip_longest
from pathlib import Path
from typing import Any

from raywalk.mistake_pages.best import Shown
from raywalk.mistake_pages.rounds import Question, Round
from raywalk.mistakes.table import FAMILIES, TABLE
from raywalk.scene.model import Scene
from raywalk.site.mistake_words import ALL, of_terms, read_said
from raywalk.site.pages import Assets, has_check, home_of, page_environment, rendered
from raywalk.terms.glossary import read_glossary
from raywalk.words import Words

RIGHT = "right"
WHICH = "which"  # the page that asks; no mistake has this name
LETTERS = "ABCD"
DIGITS = 6  # of numbers to test against


@dataclass(frozen=True)
class Told:
    """What pages show besides words, in one language."""

    shown: dict[str, Shown]  # by mistake
    left_out: Sequence[str]  # ids of scenes
    drawn: dict[str, dict[str, Any]]  # by scene: what mistakes.json says
    events: dict[str, dict[str, Any]]  # by scene, mistake and side
    rounds: Sequence[Round]  # of questions; none where too few mistakes show


def of_page(name: str, which: str) -> str:
    """Where a mistake's picture is, below the folder of all."""
    return f"{name}/{which}.webp"


def write_mistake_pages(
    out: Path, site_source: Path, scenes: Sequence[Scene], told: Told, assets: Assets,
    words: Words, base: str,
) -> None:  # fmt: skip
    """mistakes/index.html, mistakes/NAME/index.html and, where there are rounds of questions,
    mistakes/which/index.html, of one language. scenes: in that language, with lessons on others'
    rays."""
    said, home = read_said(site_source, words.code), home_of(words.code)
    environment = page_environment(site_source / "templates", words)
    own = {scene.id: scene for scene in scenes if not scene.base}
    shared = {
        "home": home, "base": base, "preview": "", "scenes": [{"id": id} for id in own], **assets,
        "said": said, "shown": told.shown, "titles": {id: each.title for id, each in own.items()},
        "checked": _checked(own, out),
    }  # fmt: skip

    def write(here: str, template: str, **context: Any) -> None:
        page = out / f"{home}{here}"
        page.parent.mkdir(parents=True, exist_ok=True)
        values = shared | {"root": "../" * (home + here).count("/"), "here": here} | context
        page.write_text(rendered(environment, template, values), encoding="utf-8")

    families = [(f, [m.name for m in TABLE if m.family == f]) for f in FAMILIES]
    write(
        f"{ALL}/index.html",
        "mistakes.html",
        families=families,
        left_out=told.left_out,
        rounds=told.rounds,
    )
    if told.rounds:
        rounds = [
            {
                "family": each.family,
                "questions": [asked(q, told, own, words) for q in each.questions],
            }
            for each in told.rounds
        ]
        write(f"{ALL}/{WHICH}/index.html", "which.html", rounds=rounds, letters=LETTERS)
    named = {name: id for id, names in of_terms(site_source).items() for name in names}
    terms = {term.id: term for term in read_glossary(words.code).terms}
    names = [mistake.name for mistake in TABLE]
    beside = {b: (a, c) for (a, b), (_, c) in pairwise(pairwise([None, *names, None]))}
    for mistake in TABLE:
        before, after = beside[mistake.name]
        page = page_of(mistake.name, told, own, words) if mistake.name in told.shown else None
        write(
            f"{ALL}/{mistake.name}/index.html", "mistake.html", name=mistake.name,
            family=mistake.family, page=page, before=before, after=after,
            term=terms.get(named.get(mistake.name, "")),
        )  # fmt: skip


def _checked(scenes: dict[str, Scene], out: Path) -> str:
    """Titles, by id, of the scenes that pictures are checked of, as JSON."""
    titles = {id: each.title for id, each in scenes.items() if has_check(each, out)}
    return json.dumps(titles, ensure_ascii=False)


def page_of(name: str, told: Told, scenes: dict[str, Scene], words: Words) -> dict[str, Any]:
    """What a mistake's page shows of the scene that shows it best."""
    shown = told.shown[name]
    scene, of = scenes[shown.best], told.drawn[shown.best][name]
    events, n, (column, row) = told.events[shown.best][name], of["n"], of["pixel"]
    return {
        "scene": scene.id, "others": shown.all, "n": n, "x": column, "y": row,
        "walk": f"scenes/{scene.id}/index.html#n={n}&p={column},{row}",
        "drawing": of["drawing"], "events": beside(events["right"], events["wrong"]),
        "ray": ray_of(of["numbers"]["ray"], words),
        "rows": [row_of(row, scene, words) for row in of["numbers"]["rows"]],
    }  # fmt: skip


def asked(question: Question, told: Told, scenes: dict[str, Scene], words: Words) -> dict[str, Any]:
    """A question, and the number that gives its mistake away: of the first ray that differs."""
    of = told.drawn[question.scene][question.name]
    return {
        **question._asdict(), "n": of["n"], "x": of["pixel"][0], "y": of["pixel"][1],
        "row": row_of(of["numbers"]["rows"][0], scenes[question.scene], words),
    }  # fmt: skip


def beside(right: list[dict[str, Any]], wrong: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows of two columns: what both programs tell stands once; `first` where they part."""
    mine, theirs = ([(each["says"], each["numbers"]) for each in side] for side in (right, wrong))
    rows: list[dict[str, Any]] = []
    for what, a, b, c, d in SequenceMatcher(None, mine, theirs, autojunk=False).get_opcodes():
        if what == "equal":
            rows += [{"both": each} for each in right[a:b]]
            continue
        rows += [{"right": r, "wrong": w} for r, w in zip_longest(right[a:b], wrong[c:d])]
    for row in rows:
        if "both" not in row:
            return [each | {"first": each is row} for each in rows]
    return [each | {"first": False} for each in rows]


def ray_of(ray: dict[str, Any] | None, words: Words) -> dict[str, Any] | None:
    """The first ray that differs, in words."""
    if ray is None:
        return None
    tell = partial(vector, words=words)
    return ray | {"start": tell(ray["start"]), "way": tell(ray["way"])}


def row_of(row: dict[str, Any], scene: Scene, words: Words) -> dict[str, str]:
    """A quantity with both its values, written."""
    light = None if row["light"] is None else scene.lights[row["light"]].name
    key = row["what"]
    what = words.say(f"pages.mistakes.what.{key}")
    right, wrong = (written(key, row[side], scene, words) for side in ("right", "wrong"))
    return {"what": f"{light}: {what}" if light else what, "right": right, "wrong": wrong}


def written(what: str, value: Any, scene: Scene, words: Words) -> str:
    """One value in a language."""
    if what == "object":
        return scene.objects[value].name if value >= 0 else words.say("pages.mistakes.nothing")
    if what == "seen":
        return words.say(f"pages.mistakes.sight.{value}")
    if what == "bytes":
        return ", ".join(map(str, value))
    if isinstance(value, list):
        return vector(value, words)
    return words.numbers.fixed(value, DIGITS)


def vector(values: Iterable[float], words: Words) -> str:
    """Three numbers with all the digits that a test asks for."""
    numbers = words.numbers
    return f"({numbers.listed(numbers.fixed(value, DIGITS) for value in values)})"
