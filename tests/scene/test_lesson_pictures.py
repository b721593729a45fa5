"""Pictures in lessons: files beside scene.toml, and no others."""

from __future__ import annotations

from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.lesson_pictures import LARGEST, pictures_in, pictures_of
from raywalk.scene.lesson_text import lesson_html
from raywalk.scene.read import read_scene
from raywalk.slides.lesson_words import plain_text

SCENE = Path("scenes/01-shading/scene.toml").read_text().partition("[[lesson]]")[0]
PNG = b"\x89PNG\r\n\x1a\n" + bytes(100)


def scene_with(folder, text):
    """A scene whose first step says this."""
    lesson = f"[[lesson]]\ntext = '''{text}'''\nview = {{ resolution = 15, pixel = [7, 7] }}\n"
    (folder / "scene.toml").write_text(SCENE + lesson)
    return read_scene(folder)


def test_a_picture_beside_the_scene_is_shown_with_its_words():
    """From any scene's page, in any language: the viewer shows a scene on the page of another."""
    assert lesson_html('![a "sharp" angle](<my sketch.png>)', "01-a") == (
        '<p><img alt="a &quot;sharp&quot; angle" loading="lazy" '
        'src="../01-a/pictures/my%20sketch.png"></p>'
    )


@pytest.mark.parametrize(
    "source",
    [
        "https://a.example/cat.png", "//a.example/cat.png", "../02-shadows/cat.png", "/cat.png",
        "a/cat.png", "..\\cat.png", "cat.html", "cat.png?x", "data:image/png;base64,AA", ".png",
        "javascript:alert(1)//.png", "&#47;&#47;a.example/cat.png", "cat.png#x",
    ],
)  # fmt: skip
def test_a_picture_from_anywhere_else_becomes_its_words(source):
    """Nothing is loaded from another place."""
    html = lesson_html(f"![a cat](<{source}>)", "01-a")
    assert "<img" not in html and "a cat" in html


def test_slides_say_what_a_picture_shows():
    assert plain_text("See ![the angle](sketch.png) here.") == "See the angle here."


@pytest.mark.parametrize("name", ["sketch.png", "Größe (2).png", "a+b.png", "x y.png"])
def test_its_file_is_found(tmp_path, name):
    (tmp_path / name).write_bytes(PNG)
    scene = scene_with(tmp_path, f"Look ![at this](<{name}>) and ![again](<{name}>).")
    assert pictures_of(scene) == [tmp_path / name]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (None, 'is not in the scene\'s folder\n  did you mean "Sketch.PNG"?'),
        (PNG + bytes(LARGEST), "bytes; at most 300,000 come quickly enough"),
        (b"<html><script>", "does not begin as a .png file does"),
        (b"", "does not begin as a .png file does"),
    ],
)
def test_a_picture_that_cannot_be_shown_is_an_error_of_its_step(tmp_path, content, said):
    name = "Sketch.PNG" if content is None else "sketch.png"
    (tmp_path / name).write_bytes(content or (PNG if content is None else b""))
    with pytest.raises(SourceErrors) as caught:
        scene_with(tmp_path, "![a ray](sketch.png)")
    assert "lesson[0].text" in str(caught.value) and said in str(caught.value)


def test_code_and_links_name_no_picture():
    assert pictures_in(["`![a](b.png)`", "[a](b.png)", "![a](c.png)"]) == ["c.png"]
