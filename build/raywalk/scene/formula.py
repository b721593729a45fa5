"""Formulas in lesson text: $...$ in LaTeX's notation, as MathML, which browsers set themselves.

A library reads the notation; what it writes is looked through here, since it lets an author name
styles and addresses, and takes commands that it does not know for letters.
"""

from __future__ import annotations

import re
from functools import lru_cache
from xml.etree.ElementTree import Element, ParseError, fromstring

#: Between dollar signs as in Pandoc: $5 and $6 are prices, \$ is a dollar sign.
INLINE = r"(?<![\\$])\$(?P<one>[^\s$](?:[^$\n]*?[^\s\\$])?)\$(?![\d$])"
DISPLAY = r"(?<!\\)\$\$(?P<whole>[^$]+?)\$\$"
FORMULA = re.compile(f"{DISPLAY}|{INLINE}")

#: MathML Core's elements that a formula may use -> how many parts each must have, 0 for any.
PARTS = {
    "math": 0, "mrow": 0, "mi": 0, "mn": 0, "mo": 0, "mtext": 0, "mspace": 0, "mstyle": 0,
    "mpadded": 0, "mphantom": 0, "msqrt": 0, "mtable": 0, "mtr": 0, "mtd": 0,
    "mfrac": 2, "mroot": 2, "msub": 2, "msup": 2, "msubsup": 3, "munder": 2, "mover": 2,
    "munderover": 3,
}  # fmt: skip
KEPT = {"display", "stretchy", "accent", "width", "mathvariant", "linethickness", "fence"}
SPACED = "=<>≤≥≠≈+−±∈→⇒"
SUPERSCRIPTS = str.maketrans("0123456789+−-=()ns", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻⁼⁽⁾ⁿˢ")
SUBSCRIPTS = str.maketrans("0123456789+−-=()", "₀₁₂₃₄₅₆₇₈₉₊₋₋₌₍₎")


class NoFormula(ValueError):
    """What is wrong with a formula, in words."""


@lru_cache(maxsize=1024)  # a text is checked once and shown on pages and slides
def mathml(latex: str, is_display: bool = False) -> Element:
    """The formula as MathML, with its words in one line as `alttext`. Raises NoFormula."""
    # Only here: its table of symbols takes longer to read than most scenes.
    from latex2mathml.converter import convert

    try:
        root = fromstring(convert(latex, display="block" if is_display else "inline"))
    except ParseError:
        raise NoFormula("it holds markup") from None
    except StopIteration:
        raise NoFormula("a bracket or \\right is missing") from None
    except Exception as problem:  # of many kinds; their names are their words
        words = re.sub(r"(?<!^)(?=[A-Z])", " ", type(problem).__name__.removesuffix("Error"))
        raise NoFormula(words.lower()) from None
    for element in root.iter():
        _look_through(element)
    root.set("alttext", line(root))
    return root


def _look_through(element: Element) -> None:
    """Leaves nothing but formula. Raises NoFormula."""
    element.tag = element.tag.rpartition("}")[2]
    if element.tag not in PARTS:
        raise NoFormula(f"a part of it ({element.tag}) is none that pages show")
    if "\\" in (text := element.text or ""):
        raise NoFormula(f"{text} is not known")
    if (count := PARTS[element.tag]) and len(element) != count:
        raise NoFormula("a part in {braces} is missing")
    for name in set(element.keys()) - KEPT:
        del element.attrib[name]


def line(element: Element) -> str:
    """A formula in one line, for slides and for who is read to: (a + b)/2, x², n₁, √(x)."""
    parts = [line(part) for part in element]
    match element.tag:
        case "mfrac":
            return f"{_grouped(parts[0])}/{_grouped(parts[1])}"
        case "msqrt":
            return f"√{_grouped(_in_a_row(element, parts))}"
        case "mroot":
            return f"{_raised(parts[1])}√{_grouped(parts[0])}"
        case "msup":
            return parts[0] + _raised(parts[1])
        case "msub":
            return parts[0] + _lowered(parts[1])
        case "msubsup" | "munderover":
            return parts[0] + _lowered(parts[1]) + _raised(parts[2])
        case "mover" | "munder":
            return parts[0]  # without its arrow or hat: a slide's typeface has none to combine
        case "mtable":
            return "; ".join(parts)
        case "mtr":
            return ", ".join(parts)
        case "mspace":
            return " "
        case "mi" | "mn" | "mo" | "mtext":
            return (element.text or "").replace("\N{NO-BREAK SPACE}", " ")
    return _in_a_row(element, parts)


def _in_a_row(element: Element, parts: list[str]) -> str:
    """Room round signs between two values, round words, after commas: a − b, but −a; max(0, x)."""
    said, after_word = "", False
    for part, words in zip(element, parts, strict=True):
        is_sign = part.tag == "mo" and words.strip() in SPACED and words.strip() != ""
        is_word = part.tag in ("mi", "mo") and len(words) > 1 and words.isalpha()
        if (is_sign and said) or (is_word and said[-1:].isalnum()):
            said += " "
        if after_word and words == "(":
            said = said.rstrip()
        has_room = (is_sign and said) or is_word or words == ","
        said, after_word = said + words + (" " if has_room else ""), is_word
    return re.sub(" {2,}", " ", said).strip()


def _grouped(text: str) -> str:
    """In brackets, unless it is one value."""
    text = text.strip()
    return text if re.fullmatch(r"[\w.₀-₉⁰-⁹²³¹]+|\([^()]*\)", text) else f"({text})"


def _raised(text: str) -> str:
    text = text.replace(" ", "")
    raised = text.translate(SUPERSCRIPTS)
    return f"^{_grouped(text)}" if any(sign in text for sign in raised) else raised


def _lowered(text: str) -> str:
    text = text.replace(" ", "")
    lowered = text.translate(SUBSCRIPTS)
    return f"_{_grouped(text)}" if any(sign in text for sign in lowered) else lowered
