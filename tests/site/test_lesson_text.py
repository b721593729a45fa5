"""Lesson text: Markdown formats it, and can do nothing else."""

from html import escape

import pytest

from raywalk.scene.lesson_text import lesson_html


def test_markdown_formats_the_text():
    """Emphasis and lists, as a lecturer writes them."""
    assert lesson_html("a *ray*") == "<p>a <em>ray</em></p>"


@pytest.mark.parametrize(
    "text",
    [
        "<script>alert(1)</script>",
        "<img src=x onerror=alert(1)>",
        "<a href='javascript:alert(1)'>x</a>",
        "a <b onclick='x()'>b</b>",
    ],
)
def test_a_tag_in_the_text_stays_text(text):
    """It is shown as typed, so no attribute or script can act."""
    html = lesson_html(text)
    assert "&lt;" in html
    assert "<script" not in html and "<img" not in html and "<a " not in html and "<b " not in html


UNSAFE = [
    "javascript:alert(1)", "data:text/html,x", "http://a.example", "//a.example", "/\\a.example",
    "\\\\a.example", "\\/a.example", "///a.example", "/&#47;a.example", "&#x2f;/a.example",
    "/&#92;a.example", "javascript&#58;alert(1)", "java&Tab;script:alert(1)", "/&#9;/a.example",
    "HTTP://a.example", "https:a.example", "https:/a.example", "https:///a.example", "ftp://a.example",
    "file:///etc/passwd", "mailto:a@a.example", "#&#10;x",
]  # fmt: skip


@pytest.mark.parametrize("target", UNSAFE)
def test_a_link_that_could_run_or_leave_unsafely_becomes_plain_words(target):
    """Its words stay."""
    assert lesson_html(f"[words]({target})") == "<p><span>words</span></p>"


@pytest.mark.parametrize(
    "target",
    [
        "https://a.example/b?c=d&e#f",
        "#p=1,2",
        "./x",
        "../y.html",
        "/z",
        "model/",
        "page.html#there",
    ],
)
def test_a_link_to_a_secure_address_or_within_the_course_stays(target):
    """As it was written."""
    assert f'<a href="{escape(target)}">words</a>' in lesson_html(f"[words]({target})")


def test_a_link_within_the_course_works():
    """Relative links and places on the page."""
    assert '<a href="../02-shadows/index.html">next</a>' in lesson_html(
        "[next](../02-shadows/index.html)"
    )


def test_a_picture_becomes_its_words():
    """No request leaves the page."""
    assert lesson_html("![a cat](https://a.example/cat.png)") == "<p><span>a cat</span></p>"
