"""Formulas in lesson text: LaTeX between dollar signs, as MathML on pages, as a line on slides."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.formula import KEPT, PARTS, NoFormula, line, mathml
from raywalk.scene.lesson_text import lesson_html
from raywalk.scene.read import read_scene
from raywalk.slides.lesson_words import plain_text


@pytest.mark.parametrize(
    ("latex", "said"),
    [
        (r"p = o + t\,d", "p = o + t d"),
        (r"n_1 \sin\theta_1 = n_2\sin\theta_2", "n₁ sin θ₁ = n₂ sin θ₂"),
        (r"\frac{a+b}{2}", "(a + b)/2"),
        (r"\frac{\sqrt{x^2+1}}{n}", "(√(x² + 1))/n"),
        (r"r^2-|o|^2 \ge 0", "r² − |o|² ≥ 0"),
        ("10^{-3}", "10⁻³"),
        ("-x + 1", "−x + 1"),
        ("a_{max}^2", "a_max²"),
        ("x^{a+b}", "x^(a+b)"),
        (r"\vec{d}\cdot\hat{n}", "d·n"),
        (r"\begin{pmatrix}1&2\\3&4\end{pmatrix}", "(1, 2; 3, 4)"),
        (r"\text{if } x < 0", "if x < 0"),
        (r"\sqrt[3]{x}", "³√x"),
        (r"k \, I \max(0, n \cdot h)^s", "k I max(0, n·h)ˢ"),
        (r"0 < t < \text{far away}", "0 < t < far away"),
    ],
)
def test_a_formula_is_said_in_one_line(latex, said):
    assert line(mathml(latex)) == mathml(latex).get("alttext") == said


@pytest.mark.parametrize(
    ("latex", "problem"),
    [
        (r"\foo", r"\foo is not known"),
        ("x_", "missing super script or subscript"),
        (r"\frac{1", "braces"),
        (r"\left(x", "right"),
        (r"\text{<script>}", "markup"),
        (r"\text{</mtext><a href='x'>y</a><mtext>}", "markup"),
        ("&", "markup"),
        ("a^b^c", "double superscripts"),
    ],
)
def test_what_is_no_formula_is_told_in_words(latex, problem):
    with pytest.raises(NoFormula, match=problem.replace("\\", r"\\")):
        mathml(latex)


@pytest.mark.parametrize(
    "latex",
    [r"\href{javascript:alert(1)}{x}", r"\style{color:red}{x}", r"\class{a}{x}", r"\color{red}{x}"],
)
def test_addresses_styles_and_classes_do_not_get_through(latex):
    """MathML has links and styles as HTML has; the policy of the page is not the only guard."""
    seen = [(element.tag, set(element.attrib)) for element in mathml(latex).iter()]
    assert all(tag in PARTS and names <= KEPT | {"alttext"} for tag, names in seen)


class _Balanced(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.seen = [], []

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        self.seen.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def test_a_formula_stands_in_its_sentence_and_markdown_leaves_it_alone():
    html = lesson_html(r"A *ray* is $p = o + t * d * 1_a$, so *there*.")
    parser = _Balanced()
    parser.feed(html)
    assert not parser.open and parser.seen.count("em") == 2 and parser.seen.count("math") == 1
    assert "\n" not in html and "<mo>*</mo>" in html


@pytest.mark.parametrize(
    ("text", "html"),
    [
        ("costs $5 and $6", "<p>costs $5 and $6</p>"),
        (r"\$x\$", "<p>$x$</p>"),
        ("`$x$`", "<p><code>$x$</code></p>"),
        ("a $ b $ c", "<p>a $ b $ c</p>"),
    ],
)
def test_a_dollar_sign_that_is_no_formulas_stays_one(text, html):
    assert lesson_html(text) == html


def test_a_formula_of_its_own_line_is_set_apart():
    assert 'display="block"' in lesson_html("Then\n\n$$x = 1$$")
    assert 'display="inline"' in lesson_html("Then $x = 1$")


def test_slides_say_a_formula_in_a_line():
    assert plain_text(r"So $n_1 < \frac{a}{2}$ *here*.") == "So n₁ < a/2 here."


def scene_with(folder, text):
    scene = Path("scenes/01-shading/scene.toml").read_text().partition("[[lesson]]")[0]
    lesson = f"[[lesson]]\ntext = '''{text}'''\nview = {{ resolution = 15, pixel = [7, 7] }}\n"
    (folder / "scene.toml").write_text(scene + lesson)
    return read_scene(folder)


@pytest.mark.parametrize("text", ["Code:\n\n    $\\foo$\n", "`$\\foo$`", "``a ` $\\foo$``"])
def test_what_markdown_takes_for_code_is_no_formula(tmp_path, text):
    assert "<math" not in lesson_html(scene_with(tmp_path, text).lesson[0].text)


def test_backticks_of_two_paragraphs_hide_no_formula(tmp_path):
    """A check with rules of its own would let it pass, and the build would end in a traceback."""
    with pytest.raises(SourceErrors, match=r"lesson\[0\].text: the formula"):
        scene_with(tmp_path, "don`t\n\n$\\foo$\n\nisn`t")


def test_a_formula_that_cannot_be_read_is_an_error_of_its_step(tmp_path):
    """With the file and the key, like any other."""
    text = Path("scenes/01-shading/scene.toml").read_text()
    first = text.index("[[lesson]]")
    bad = text[:first] + text[first:].replace('text = """', 'text = """$\\\\foo$ ', 1)
    assert bad != text
    (tmp_path / "scene.toml").write_text(bad)
    with pytest.raises(SourceErrors) as caught:
        read_scene(tmp_path)
    said = str(caught.value)
    assert r"lesson[0].text: the formula $\foo$ cannot be read: \foo is not known" in said
    assert r"a dollar sign without a formula: \$" in said
