"""The pages: a gallery, one page a scene that tells its story without JavaScript, and the
page on the model behind the pictures."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape

from raywalk.scene.model import Scene
from raywalk.site.figures import Figures, has_glass
from raywalk.site.lesson_text import lesson_html
from raywalk.site.saying import sayings
from raywalk.words import Words, read_words

Assets = dict[str, str]  # viewer_js, words_js and style_css, relative to the site's root


def write_pages(
    out: Path, templates: Path, scenes: list[Scene], figures: dict[str, Figures], assets: Assets
) -> None:
    """index.html, model/index.html and scenes/<id>/index.html under `out`.

    Links are relative, so that the site works under any sub-path and from a disk.
    """
    environment = page_environment(templates)
    shared = {"scenes": [_card(scene) for scene in scenes], **assets}
    _write(out / "index.html", environment, "gallery.html", root="", **shared)
    _write(
        out / "model" / "index.html", environment, "model.html", root="../", **shared,
        glass_scenes=[_glass(scene) for scene in scenes if has_glass(scene)],
        has_benchmarks=(out / "benchmarks" / "index.html").exists(),
    )  # fmt: skip
    for scene in scenes:
        page = out / "scenes" / scene.id / "index.html"
        told = _scene(scene, figures[scene.id])
        _write(page, environment, "scene.html", root="../../", scene=told, **shared)


def page_environment(templates: Path, words: Words | None = None) -> Environment:
    """Jinja2 as every page uses it: all values are escaped, `say` and `tell` know the sentences
    of a language, of the default one if none is given."""
    environment = Environment(
        loader=FileSystemLoader(templates),
        autoescape=select_autoescape(default=True, default_for_string=True),
        undefined=StrictUndefined,  # a misspelt name fails the build, not the page
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.globals.update(sayings(words or read_words()))
    return environment


def _write(page: Path, environment: Environment, template: str, **context: Any) -> None:
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(environment.get_template(template).render(context), encoding="utf-8")


def _card(scene: Scene) -> dict[str, str]:
    return {
        "id": scene.id,
        "key": scene.key,
        "title": scene.title,
        "teaches": scene.teaches,
        "url": f"scenes/{scene.id}/index.html",
        "thumb": f"scenes/{scene.id}/thumb.png",
    }


def _glass(scene: Scene) -> dict[str, str]:
    return _card(scene) | {"glass_shadows": scene.render.glass_shadows}


def _scene(scene: Scene, figures: Figures) -> dict[str, Any]:
    return {
        "id": scene.id,
        "key": scene.key,
        "title": scene.title,
        "teaches": scene.teaches,
        "picture": "picture.png",
        "size": scene.render.size,
        "levels": sorted(scene.render.resolutions),
        "depth": scene.render.depth,
        "shadows": scene.render.shadows,
        "figures": figures,
        "lesson": [
            {"html": lesson_html(step.text), "answer": lesson_html(step.answer)}
            for step in scene.lesson
        ],
    }
