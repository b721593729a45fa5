"""What word processors, web pages and other countries' keyboards put into a scene typed by hand.

A TOML parser stops at the first of these and tells what it expected there. Here all of them are
found, by the characters outside of texts and comments, and named by their cause.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from raywalk.scene.typed_numbers import ITS_END, NUMBER, PLAIN, Slip, number_slips

#: Texts in any of TOML's quotes, and comments: what is in them is nobody's business.
SPOKEN = re.compile(
    r'"""(?:\\.|[^\\])*?"""|' r"'''.*?'''|" r'"(?:\\.|[^"\\\n])*"|' r"'[^'\n]*'|#[^\n]*", re.DOTALL
)
QUOTES = "„“”‟‚‘’‛«»‹›″′＂＇`´"
MINUS = "−‐‑‒–—－"
INVISIBLE = re.compile(r"[\u00a0\u00ad\u2000-\u200f\u2028-\u202f\u205f\u2060\u3000\ufeff]+")
QUOTED = re.compile(rf"[{QUOTES}]+([^{QUOTES}\n]*)[{QUOTES}]+")
BARE = re.compile(r"^\s*[\w.-]+\s*=\s*(?!true\b|false\b|inf\b|nan\b)([A-Za-z_][\w -]*?)\s*$", re.M)
#: What other notations write: a pattern, what is wrong with its match, and what to type.
FOREIGN = [
    (r";", "; separates nothing", "numbers are separated by commas"),
    (r"//", "// begins no comment", "a comment begins with #"),
    (r"^[ \t]*([\w-]+)[ \t]*:(?=\s)", "a colon stands behind {1}", "write {1} = ..."),
    (r"=[ \t]*(\(([^()\n]*)\))", "{1} stands in round brackets", "write [{2}]"),
    (
        rf"=[ \t]*({NUMBER}(?:[ \t]*,[ \t]*{NUMBER}){{2}})[ \t]*$",
        "{1} stands in no brackets", "write [{1}]",
    ),
    (
        rf"=[ \t]*({NUMBER})[ \t]*(°|[a-df-zµ]+)[ \t]*$",
        "{1} has a unit, {2}", "write {1}: lengths are in world units, angles in degrees",
    ),
    (
        rf"[\[,][ \t]*({NUMBER}[ \t]+{NUMBER}){ITS_END}",
        "{1} has no comma between its numbers", "numbers are separated by commas",
    ),
    (rf"({NUMBER})[ \t]*%", "{0} is no number", "write it as a share of 1, such as 0.5"),
    (
        rf"=[ \t]*((?!\d{{4}}-\d\d-)[-+]?{PLAIN}(?:[ \t]*(?:\*\*|[-+/*^×·])[ \t]*{PLAIN})+)[ \t]*$",
        "{1} is not worked out", "write the result",
    ),
    (r"[，、､]", "{0} is no comma to a program", "type the , of the keyboard"),
]  # fmt: skip


def slips_in(text: str) -> list[Slip]:
    """All slips of a file, in order, one a kind and line."""
    code = SPOKEN.sub(lambda spoken: re.sub(r"[^\n]", " ", spoken[0]), text)
    found = sorted(_all(code), key=lambda slip: slip.place)
    first: dict[tuple[int, str], Slip] = {}
    for slip in found:
        first.setdefault((code.count("\n", 0, slip.place), slip.instead), slip)
    return list(first.values())


def _all(code: str) -> Iterator[Slip]:
    for match in QUOTED.finditer(code):
        sign = match[0][0]
        message = f"{sign} ({_name(sign)}) is no quotation mark to a program"
        yield Slip(match.start(), message, f'write straight quotes: "{match[1]}"')
    for match in re.finditer(rf"([{MINUS}])(?=\s*[\d.])", code):
        message = f"{match[0]} ({_name(match[0])}) looks like a minus sign and is none"
        yield Slip(match.start(), message, "type the - of the keyboard: -1")
    for match in INVISIBLE.finditer(code):
        message = f"holds a character that cannot be seen ({_name(match[0][0])})"
        yield Slip(match.start(), message, "delete it and type a space")
    yield from number_slips(code)
    for match in BARE.finditer(code):
        instead = f'a text stands in quotes: "{match[1]}"'
        if match[1].lower() in ("yes", "no", "true", "false", "on", "off"):
            instead = "yes and no are written true and false"
        yield Slip(match.start(1), f"{match[1]} is no value", instead)
    for pattern, what, instead in FOREIGN:
        for match in re.finditer(pattern, code, re.MULTILINE):
            words = match[0], *match.groups()
            at = match.start(1 if match.re.groups else 0)
            yield Slip(at, what.format(*words), instead.format(*words))


def _name(sign: str) -> str:
    return f"U+{ord(sign):04X}, {unicodedata.name(sign, 'no name').lower()}"
