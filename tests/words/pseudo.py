"""Languages that nobody speaks, to see what pages do with their words: doubled, 40 % longer, right
to left, hostile. `python tests/words/pseudo.py DIST OUT` makes a site of them in OUT, with the
assets and traces of the built site DIST."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from raywalk.scene.model import Scene
from raywalk.scene.read import read_scenes
from raywalk.site.assets import PART, write_words
from raywalk.site.figures import scene_figures
from raywalk.site.pages import write_pages
from raywalk.site.scene_data import scene_words
from raywalk.trace_file.container import write_script
from raywalk.words.catalogue import read_tree, words_from

HEBREW = "אבגדהוזחטיכלמנסעפצקרשתאבגד"
ATTACK = '<img src=x onerror="hacked=1">"\'{}</script><script>hacked=1</script>{{ 7*7 }}'
# What no translator may change: slots, link targets, code, marks.
FIXED = re.compile(r"(\{\w+\}|\]\(\w+\)|`[^`]*`|\*\*|\[|_)")
FACTS = {"camera": 1, "secondary": 2, "shadow": 12345, "deepest": 3, "dropped": {}, "warnings": []}


def _words(change: Callable[[str], str]) -> Callable[[str], str]:
    def changed(text: str) -> str:
        return re.sub(r"[^\W\d_]{2,}", lambda word: change(word[0]), text)

    return lambda text: "".join(
        part if FIXED.fullmatch(part) else changed(part) for part in FIXED.split(text)
    )


def _hebrew(word: str) -> str:
    return "".join(HEBREW[(ord(letter.lower()) - 97) % 26] for letter in word)


PSEUDO: dict[str, Callable[[str], str]] = {
    "en-x-doubled": lambda text: f"{text} {text}" if len(text) > 1 else text,
    "en-x-long": _words(lambda word: word + "e" * -(-len(word) * 4 // 10)),
    "ar-x-rtl": _words(_hebrew),
    "en-x-hostile": lambda text: f"{text} {ATTACK}",
}


def pseudo_tree(code: str) -> dict[str, Any]:
    """The English catalogue, each sentence changed."""
    change = PSEUDO[code]

    def changed(tree: Any) -> Any:
        if isinstance(tree, dict):
            return {key: changed(value) for key, value in tree.items()}
        return change(tree)

    english = read_tree("en")
    direction = "rtl" if code == "ar-x-rtl" else "ltr"
    about = english["language"] | {"code": code, "name": "Pseudo", "direction": direction}
    return changed(english) | {"language": about}


def pseudo_scene(scene: Scene, code: str) -> Scene:
    """A scene with each of its words changed."""
    change = PSEUDO[code]
    return replace(
        scene,
        title=change(scene.title),
        teaches=change(scene.teaches),
        objects=tuple(replace(each, name=change(each.name)) for each in scene.objects),
        lights=tuple(replace(each, name=change(each.name)) for each in scene.lights),
        materials=tuple(replace(each, name=change(each.name)) for each in scene.materials),
        lesson=tuple(
            replace(step, text=_said(step.text, change), answer=_said(step.answer, change))
            for step in scene.lesson
        ),
    )


#: Formulas and slots: no words of a language.
KEPT = re.compile(r"(\$\$?[^$]+\$\$?|\{[^}]*\})")


def _said(text: str, change: Callable[[str], str]) -> str:
    """A lesson's text with its words changed; a text as a whole where nothing in it is kept."""
    if not KEPT.search(text):
        return text and change(text)
    parts = KEPT.split(text)
    return "".join(
        part if k % 2 or not part.strip() else change(part) for k, part in enumerate(parts)
    )


def write_site(dist: Path, out: Path, scenes_folder: Path) -> None:
    """Pages in all pseudo languages, each below out/<code>/."""
    scenes = [
        scene for scene in read_scenes(scenes_folder) if (dist / "scenes" / scene.id).exists()
    ]
    assets, parts = {}, {}
    (out / "assets").mkdir(parents=True)
    for path in (dist / "assets").iterdir():
        (out / "assets" / path.name).symlink_to(path.resolve())
        stem = path.stem.rpartition("-")[0]
        if stem.startswith(PART):
            parts[stem.removeprefix(PART)] = path.name
        else:
            assets[f"{stem}_{path.suffix[1:]}"] = f"assets/{path.name}"
    assets["parts"] = json.dumps(parts)
    for scene in scenes:
        (out / "scenes" / scene.id).mkdir(parents=True)
        for path in (dist / "scenes" / scene.id).iterdir():
            (out / "scenes" / scene.id / path.name).symlink_to(path.resolve())
    for code in PSEUDO:
        words = words_from(pseudo_tree(code))
        translated = [pseudo_scene(scene, code) for scene in scenes]
        for scene in translated:
            text = json.dumps(scene_words(scene)).encode()
            place = out / "scenes" / scene.id / f"words-{code}.js"
            write_script(place, f"{scene.id}/words-{code}", text)
        figures = {scene.id: scene_figures(scene, FACTS, words) for scene in translated}
        named = assets | write_words(out, words)
        write_pages(out, Path("site_src/templates"), translated, figures, named, words)


if __name__ == "__main__":
    write_site(Path(sys.argv[1]), Path(sys.argv[2]), Path("scenes"))
