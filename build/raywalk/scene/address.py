"""A scene's id: its folder's name as it can stand in every address, file name and link.

Encoded once, here: everything behind the reader uses the id as it is. An address is read by
servers, browsers, zip programs and three systems' file names, which agree on few characters.
"""

from __future__ import annotations

import hashlib
import os
import re
import unicodedata

#: Letters of European languages that are not a letter with a mark.
SPELT = {
    "ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss", "æ": "ae", "ø": "oe", "å": "aa", "œ": "oe",
    "ł": "l", "đ": "d", "ð": "d", "þ": "th",
}  # fmt: skip
SPELT |= {one.upper(): other.capitalize() for one, other in SPELT.items() if one != "ß"}
SAFE = re.compile(r"[A-Za-z0-9_][A-Za-z0-9._-]*(?<![.])")
#: What a page of the site is called already; what Windows takes for a device.
TAKEN = re.compile(r"(index|course|con|prn|aux|nul|(com|lpt)\d)(\..*)?", re.IGNORECASE)
#: Characters: with what a sheet's name adds, and a language's folder, far below any system's limit.
LONGEST = 80


def address_of(folder: str) -> str:
    """The id of the scene in a folder of this name: the name itself where it is safe, else a
    likeness of it, with some digits of the name's hash where that says less than the name did.

    >>> address_of("01-shading"), address_of("Größe und Maß"), address_of("C#, 50 %")
    ('01-shading', 'Groesse-und-Mass', 'C-50-313c65')
    """
    likeness = "".join(_spelt(character) for character in _as_typed(folder).replace(" ", "-"))
    plain = re.sub(r"-{2,}", "-", re.sub(r"[^A-Za-z0-9._-]+", "-", likeness)).strip("-.")
    is_plain = plain == likeness and SAFE.fullmatch(plain) and not TAKEN.fullmatch(plain)
    if is_plain and len(plain) <= LONGEST:
        return plain
    hash = hashlib.sha256(os.fsencode(folder)).hexdigest()[:6]
    return f"{plain[:LONGEST].strip('-.') or 'scene'}-{hash}"


def _as_typed(name: str) -> str:
    """macOS takes letters and their marks apart."""
    return unicodedata.normalize("NFC", name)


def _spelt(character: str) -> str:
    """A letter without its marks."""
    if character in SPELT:
        return SPELT[character]
    letters = unicodedata.normalize("NFKD", character)
    return "".join(letter for letter in letters if not unicodedata.combining(letter))
