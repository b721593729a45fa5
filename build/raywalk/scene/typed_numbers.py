"""Numbers as people write them and TOML does not: each found by its form, with what to type."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass


@dataclass(frozen=True)
class Slip:
    """One character or number that cannot be read, and what to type instead."""

    place: int  # in the text
    what: str
    instead: str


PLAIN = r"\d+(?:\.\d+)?"
NUMBER = rf"[-+]?{PLAIN}"
ALONE, ITS_END = r"(?<![\w.,])", r"(?![\w.])"
VALUE, LAST = r"=[ \t]*", r"[ \t]*$"  # round the only value of a line
COMMA = re.compile(rf"{VALUE}([-+]?)(\d*),(\d+)((?:[eE][-+]?\d+)?){LAST}", re.M)
APART = " '\u2019\u00a0\u2009\u202f"
# Thousands set apart: 1.000,5 and 1 000 and 1'000, and 1,000.5; in a list only what cannot be two.
GROUPED = re.compile(
    rf"{VALUE}([-+]?\d{{1,3}}(?:(?:\.\d{{3}})+(?=,)|(?:[{APART}]\d{{3}})+)(?:[.,]\d+)?"
    rf"|[-+]?\d{{1,3}}(?:,\d{{3}})+\.\d+){LAST}"
    rf"|{ALONE}([-+]?\d{{1,3}}(?:\.\d{{3}}){{2,}}){ITS_END}(?![ \t]*=)",
    re.M,
)
POINT_FIRST = re.compile(r"(?<![\w.])([-+]?)\.(\d+)")
POINT_LAST = re.compile(r"(?<![\w.])([-+]?\d+)\.(?![\w.])")
ZERO_FIRST = re.compile(rf"(?<![\w.:-])(?<!\d )([-+]?)0+(\d[\d.]*){ITS_END}(?![:-])(?![ \t]*=)")
SIGN_APART = re.compile(rf"(?<=[=,\[])[ \t]*([-+])[ \t]+({PLAIN})")
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-")
POWER = re.compile(rf"([-+]?)(?:({PLAIN})[ \t]*[·∙×x*][ \t]*)?({PLAIN})([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
OTHER_DIGITS = re.compile(r"[^\x00-\x7f⁰¹²³⁴⁵⁶⁷⁸⁹]+")


def number_slips(code: str) -> Iterator[Slip]:
    """Those of a text without its quoted texts and comments."""
    for match in COMMA.finditer(code):
        sign, whole, part, power = match.groups()
        instead = f"decimals have a point: {sign}{whole or 0}.{part}{power}"
        if len(part) == 3 and 0 < len(whole) <= 3:
            instead += f", or {sign}{whole}{part} if thousands are meant"
        written = f"{sign}{whole},{part}{power}"
        yield Slip(match.start(1), f"{written} has a decimal comma", instead)
    for match in GROUPED.finditer(code):
        written = match[1] or match[2]
        yield Slip(
            match.start(1 if match[1] else 2), f"{written} has its thousands set apart",
            f"decimals have a point, thousands nothing: {_ungrouped(written)}",
        )  # fmt: skip
    for match in POINT_FIRST.finditer(code):
        instead = f"a digit stands before the point: {match[1]}0.{match[2]}"
        yield Slip(match.start(), f"{match[0]} begins with its point", instead)
    for match in POINT_LAST.finditer(code):
        instead = f"a digit stands behind the point: {match[1]}.0"
        yield Slip(match.start(), f"{match[0]} ends with its point", instead)
    for match in ZERO_FIRST.finditer(code):
        yield Slip(match.start(), f"{match[0]} begins with a 0", f"write {match[1]}{match[2]}")
    for match in SIGN_APART.finditer(code):
        instead = f"write {match[1]}{match[2]}"
        yield Slip(match.start(1), f"a space stands behind the {match[1]} of {match[2]}", instead)
    yield from _powers(code)
    yield from _other_digits(code)


def _ungrouped(written: str) -> str:
    """1.000,5 as 1000.5: the last mark is the decimals' if it stands there once and another does
    too, or a comma."""
    marks = re.findall(r"[^-+\d]", written)
    last = marks[-1]
    whole, part = written, ""
    if marks.count(last) == 1 and len(marks) > 1 and last in ".,":
        whole, _, part = written.rpartition(last)
    whole = re.sub(r"[^-+\d]", "", whole)
    return f"{whole}.{part}" if part else whole


def _powers(code: str) -> Iterator[Slip]:
    for match in POWER.finditer(code):
        sign, times, base, raised = match.groups()
        power = int(raised.translate(RAISED)[:6])
        instead = f"{sign}{times or 1}e{power}"
        if float(base) != 10.0:
            instead = "the result, without a power"
            if abs(power) <= 20 and float(base):
                instead = f"{sign}{float(times or 1) * float(base) ** power:.12g}"
        message = f"{match[0]} has its power above the line"
        yield Slip(match.start(), message, f"write {instead}")


def _other_digits(code: str) -> Iterator[Slip]:
    """Fractions of one character, digits of other scripts, and signs for numbers."""
    for run in OTHER_DIGITS.finditer(code):
        for match in re.finditer(r"\d+|.", run[0], re.DOTALL):
            sign, value = match[0], unicodedata.numeric(match[0][0], None)
            if sign in "∞π√±≈":
                instead = "write it in digits, such as 3.1416"
            elif value is None:
                continue
            elif sign.isdecimal():
                instead = f"type the digits of the keyboard: {int(sign)}"
            else:
                instead = f"write {value:.6g}"
            yield Slip(run.start() + match.start(), f"{sign} is no number to a program", instead)
