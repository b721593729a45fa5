"""Rounded figures that stand together must agree when a reader computes one from the others."""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import cos, prod, radians, sin

from raywalk.pipeline.filling import Figures, form_of, value_of, written
from raywalk.scene.model import Scene
from raywalk.scene.slots import SLOT, Operand, Pixel, Slot, filled_in, read_slot
from raywalk.words.numbers import MINUS, Numbers

ABOUT = re.compile(
    r"(\b(about|roughly|around|nearly|almost|over|etwa|ungefähr|rund|fast|knapp|circa|über)|≈)"
    r"[\s*_]*$",
    re.IGNORECASE,
)
# Of what is printed of quantities: figures, and their decimals; a computed one may have any.
Shown = dict[Operand, tuple[float, int]]
EXACT = 12
NUMBER = r"([-\u2212]?\d[\d.,\u2009\u202f\u00a0]*\d|\d)(\s?%)?"
SIGNS = {
    "*": ("×", "·", "*", "times", "mal"), "/": ("/", "÷", "over", "durch"), "+": ("+", "plus"),
    "-": ("-", MINUS, "minus"),
}  # fmt: skip
SIGN_OF = {word: sign for sign, words in SIGNS.items() for word in words}
EQUALS = ("=", "is", "are", "makes", "gives", "ist", "sind", "ergibt", "macht")
SUM = re.compile(
    rf"{NUMBER}\s+({'|'.join(map(re.escape, SIGN_OF))})\s+{NUMBER}"
    rf"\s+(?:{'|'.join(EQUALS)})\s+[*_]*{NUMBER}"
)


def disagreements(
    text: str, scene: Scene, figures: Figures, own: Pixel | None, numbers: Numbers
) -> list[str]:
    """A sentence for each figure that does not follow from others that the text prints."""
    found = list(_of_slots(text, scene, figures, own, numbers))
    filled = filled_in(text, lambda slot: written(slot, scene, figures, own, numbers))
    return found + [said for said in _of_sums(filled, numbers) if said not in found]


def _of_slots(
    text: str, scene: Scene, figures: Figures, own: Pixel | None, numbers: Numbers
) -> Iterator[str]:
    shown: Shown = {}  # what is printed of each quantity that stands alone
    results: list[tuple[Slot, float, int, bool]] = []
    for match in SLOT.finditer(text):
        if match["slot"] is None:
            continue
        slot = read_slot(match["slot"])
        digits, is_percent = form_of(slot)
        digits += 2 if is_percent else 0
        printed = round(value_of(slot, scene, figures, own), digits)
        if not slot.others:
            shown.setdefault(slot.first, (printed, digits))
        is_about = ABOUT.search(text[: match.start()]) is not None
        results.append((slot, printed, digits, is_about))
    for slot, printed, digits, is_about in results:
        again, known = _recomputed(slot, shown)
        digits = min(digits, known)
        if not is_about and again is not None and round(again, digits) != round(printed, digits):
            shown_so = written(slot, scene, figures, own, numbers)
            yield (
                f"{{{slot.typed}}} is {shown_so}, but from the rounded figures beside it it is "
                f"{numbers.fixed(again, digits)}: give them more decimals, or say about"
            )


def _recomputed(slot: Slot, shown: Shown) -> tuple[float | None, int]:
    """A slot's figure from what is printed beside it, None where that is not enough; and to how
    many decimals that tells it."""
    if not slot.others:
        return _follows(slot.first, shown)
    value: float | None = None
    for sign, operand in (("*", slot.first), *slot.others):
        part = operand.number if operand.quantity is None else shown.get(operand, (None, 0))[0]
        part = _follows(operand, shown)[0] if part is None else part
        if part is None:
            return None, EXACT
        value = part if value is None else value * part if sign == "*" else value / part
    return value, EXACT


def _follows(of: Operand, shown: Shown) -> tuple[float | None, int]:
    """What a quantity is by another's printed figure: n.l of its angle, a share of its weights."""
    if of.quantity is None:
        return None, EXACT
    angle, _ = _shown(of, "angle", shown)
    match of.quantity.name:
        case "sine" if angle is not None:
            return sin(radians(angle)), EXACT
        case "n.l" if angle is not None and of.of:
            return cos(radians(angle)), EXACT
        case "share":
            ways = [of.kinds[: k + 1] for k in range(len(of.kinds))]
            parts = [_shown(of, "weight", shown, way)[0] for way in ways]
            known = [part for part in parts if part is not None]
            return (prod(known) if len(known) == len(parts) > 1 else None), EXACT
        case "weight" if of.kinds and of.kinds[-1] in ("reflected", "refracted"):
            other = "refracted" if of.kinds[-1] == "reflected" else "reflected"
            rest, digits = _shown(of, "weight", shown, (*of.kinds[:-1], other))
            return (None if rest is None else 1 - rest), digits
    return None, EXACT


def _shown(
    of: Operand, name: str, shown: Shown, kinds: tuple[str, ...] | None = None
) -> tuple[float | None, int]:
    """What is printed of another quantity of the same ray, or of another ray of the pixel."""
    place = of.column, of.row, of.n, of.scene
    wanted = (name, of.kinds if kinds is None else kinds, of.of, *place)
    for each, printed in shown.items():
        if each.quantity is None:
            continue
        there = each.column, each.row, each.n, each.scene
        if wanted == (each.quantity.name, each.kinds, each.of, *there):
            return printed
    return None, EXACT


def _of_sums(text: str, numbers: Numbers) -> Iterator[str]:
    """Of sums that the text writes out: 0.9406 times 0.9406 is 0.885."""
    for match in SUM.finditer(text):
        a, a_percent, sign, b, b_percent, c, c_percent = match.groups()
        (one, _), (other, _), (result, digits) = (
            _read(figure, percent, numbers)
            for figure, percent in ((a, a_percent), (b, b_percent), (c, c_percent))
        )
        if SIGN_OF[sign] == "/" and other == 0:
            continue
        again = {
            "*": one * other, "/": one / other if other else 0.0, "+": one + other,
            "-": one - other,
        }[SIGN_OF[sign]]  # fmt: skip
        if round(again, digits) != round(result, digits):
            said = " ".join(match[0].split())
            yield f'"{said}": computed, it is {numbers.fixed(again, digits)}'


def _read(figure: str, percent: str | None, numbers: Numbers) -> tuple[float, int]:
    """A printed number, and its decimals; of a percentage as a share."""
    plain = re.sub("[\u2009\u202f\u00a0]", "", figure).replace(MINUS, "-")
    plain = plain.replace("," if numbers.decimal == "." else ".", "")
    plain = plain.replace(numbers.decimal, ".")
    digits = len(plain.partition(".")[2])
    return (float(plain) / 100, digits + 2) if percent else (float(plain), digits)
