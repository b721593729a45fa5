"""What a scene's page says of its numbers, models and simplifications."""

from __future__ import annotations

from pathlib import Path

import pytest

from raywalk.scene.read import read_scenes
from raywalk.site.figures import scene_figures
from raywalk.site.pages import write_pages
from raywalk.words import read_words

ROOT = Path(__file__).parents[2]
SCENES = {scene.key: scene for scene in read_scenes(ROOT / "scenes") if scene.key}
FACTS = {"camera": 10, "secondary": 5, "shadow": 3, "deepest": 2, "dropped": {}, "warnings": []}


@pytest.mark.parametrize("key", "67")
def test_a_scanned_model_is_credited_on_its_scenes_page(key):
    """With the laboratory's name and the licence."""
    figures = dict(scene_figures(SCENES[key], FACTS, read_words()))
    assert "Stanford Computer Graphics Laboratory" in figures["Model"]
    assert "public domain" in figures["Model"]


@pytest.mark.parametrize("key", SCENES)
def test_every_scene_with_glass_names_its_shadow_model_as_a_simplification(key):
    """And a scene without glass says nothing of it."""
    figures = dict(scene_figures(SCENES[key], FACTS, read_words()))
    assert ("Shadow rays at glass" in figures) == SCENES[key].has_glass
    if SCENES[key].has_glass:
        assert "a simplification" in figures["Shadow rays at glass"]


def test_triangles_that_were_left_out_are_named():
    """By object, reason and count."""
    facts = FACTS | {"dropped": {"bunny": {"without area": 2, "not finite": 1}}}
    figures = dict(scene_figures(SCENES["6"], facts, read_words()))
    assert figures["Triangles left out of bunny"] == "2 without area, 1 not finite"


def test_the_model_page_lists_every_scene_with_glass_and_its_shadow_model(tmp_path):
    """The page for teachers names each simplification where it is used."""
    scenes = list(SCENES.values())
    figures = {scene.id: scene_figures(scene, FACTS, read_words()) for scene in scenes}
    assets = {
        "viewer_js": "assets/v.js",
        "words_js": "assets/w.js",
        "page_js": "assets/p.js",
        "kiosk_js": "assets/k.js",
        "style_css": "assets/s.css",
        "parts": "{}",
    }
    write_pages(tmp_path, ROOT / "site_src" / "templates", scenes, figures, assets)
    page = (tmp_path / "model" / "index.html").read_text(encoding="utf-8")
    for scene in scenes:
        assert (f"scenes/{scene.id}/index.html" in page) == scene.has_glass
