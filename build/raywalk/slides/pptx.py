"""Slides as PPTX: native shapes that can be edited, grouped, named, with alternative texts.

python-pptx keeps the package in order; pptx_shapes.py writes the shapes.
"""

from __future__ import annotations

import io
import zipfile
from collections import Counter
from datetime import datetime
from typing import Any

from pptx.opc.packuri import PackURI
from pptx.oxml import parse_xml

from raywalk.slides.figure import Deck, Slide
from raywalk.slides.palette import Palette
from raywalk.slides.pptx_body import body_of
from raywalk.slides.pptx_master import new_presentation
from raywalk.slides.pptx_shapes import Pictures, ShapeWriter

LONG_AGO = datetime(2020, 1, 1)  # every file's date: the same slides are the same bytes


def deck_pptx(deck: Deck, palette: Palette) -> bytes:
    """A presentation whose notes hold what is said."""
    shown, layout = new_presentation(deck, palette)
    package: Any = shown.part.package
    package.next_partname, pictures = Names(package).next, Pictures(package)
    for slide in deck.slides:
        _add(shown, layout, slide, palette, deck.language, pictures)
    about = shown.core_properties
    about.title, about.author, about.language = deck.title, "Raywalk", deck.language
    about.last_modified_by, about.created, about.modified = "Raywalk", LONG_AGO, LONG_AGO
    out = io.BytesIO()
    shown.save(out)
    return steady_zip(out.getvalue())


class Names:
    """The next free name of a kind. python-pptx would look through the whole package for each."""

    def __init__(self, package: Any):
        self._taken = {part.partname for part in package.iter_parts()}
        self._last: Counter[str] = Counter()

    def next(self, template: str) -> PackURI:
        """The template with a number; names of the empty presentation are taken."""
        self._last[template] += 1
        name = template % self._last[template]
        return self.next(template) if name in self._taken else PackURI(name)


def steady_zip(data: bytes) -> bytes:
    """The same files with one date each, in one order."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(out, "w") as new:
        for name in sorted(old.namelist(), key=lambda each: (each != "[Content_Types].xml", each)):
            info = zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0))
            info.external_attr, info.create_system = 0o600 << 16, 3
            packed = name.endswith((".png", ".jpg", ".jpeg"))
            info.compress_type = zipfile.ZIP_STORED if packed else zipfile.ZIP_DEFLATED
            new.writestr(info, old.read(name), compresslevel=9)
    return out.getvalue()


def _add(
    shown: Any, layout: Any, slide: Slide, palette: Palette, language: str, pictures: Pictures
) -> None:
    made = shown.slides.add_slide(layout)
    tree = made.shapes._spTree
    for empty in list(made.placeholders):  # those that are needed come with their words
        tree.remove(empty._element)
    writer, body = ShapeWriter(made, palette, language, pictures), body_of(slide.items)
    for item in slide.items:
        if body and item is body.paragraphs[0].text:
            tree.append(parse_xml(writer.body(body)))
        elif not body or not any(item is each for each in body.items):
            for xml in writer.shapes(item):
                tree.append(parse_xml(xml))
    if slide.notes:
        made.notes_slide.notes_text_frame.text = "\n".join(slide.notes)
