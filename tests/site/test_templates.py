"""A mistake in a template is said with its file and line, like one in a scene."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.site.pages import page_environment, rendered

TEMPLATES = Path("site_src/templates")


def render(tmp_path, change):
    templates = tmp_path / "templates"
    shutil.copytree(TEMPLATES, templates)
    place = templates / "sizes.html"
    place.write_text(change(place.read_text()))
    values = {
        "root": "../",
        "tables": [],
        "style_css": "style.css",
        "page_js": "page.js",
        "home": "",
    }
    rendered(page_environment(templates), "sizes.html", values)


@pytest.mark.parametrize(
    ("mistake", "said"),
    [
        ("{% if %}", "Expected an expression"),
        ("{{ nothing_of_that_name }}", "'nothing_of_that_name' is undefined"),
        ("{{ {}[root] }}", "has no attribute '../'"),
        ("{{ 1 / 0 }}", "division by zero"),
        ("{% include 'gone.html' %}", "gone.html"),
        ("{% for each in %}", "Expected an expression"),
        ("{{ say('pages.no.such.words') }}", "pages.no.such.words"),
    ],
)
def test_any_mistake_names_file_and_line(tmp_path, mistake, said):
    """What jinja2 says of it behind; nothing of ours, and no traceback."""
    with pytest.raises(SourceErrors) as caught:
        render(tmp_path, lambda text: text.replace("</main>", f"{mistake}\n</main>"))
    line = (TEMPLATES / "sizes.html").read_text().partition("</main>")[0].count("\n") + 1
    [error] = caught.value.errors
    assert error.file.name == "sizes.html" and error.key == f"line {line}"
    assert said in error.message
