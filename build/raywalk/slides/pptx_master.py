"""The master of a presentation: where title and words stand, in which font, on which ground.

Adapted from python-pptx's default template, of which one layout is kept.
"""

from __future__ import annotations

from typing import Any

from pptx import Presentation
from pptx.opc.constants import RELATIONSHIP_TYPE
from pptx.oxml import parse_xml
from pptx.util import Pt

from raywalk.slides.blocks import BODY_SIZE, TITLE_SIZES
from raywalk.slides.figure import Deck
from raywalk.slides.layout import LAYOUTS, WIDE, Box
from raywalk.slides.palette import Palette
from raywalk.slides.pptx_text import FONT, NAMESPACES, place, solid

WORDS = 1  # of the template's layouts: a title and a body
NAME = "Title, figure and words"


def new_presentation(deck: Deck, palette: Palette) -> tuple[Any, Any]:
    """Without slides, and the layout for all of them."""
    shown = Presentation()
    _forget_thumbnail(shown.part.package)
    shown.slide_width, shown.slide_height = Pt(deck.width), Pt(deck.height)
    layout = shown.slide_layouts[WORDS]
    for other in list(shown.slide_layouts):
        if other is not layout:
            shown.slide_layouts.remove(other)
    frames = next((each for each in LAYOUTS.values() if each.width == deck.width), WIDE)
    layout._element.cSld.set("name", NAME)
    _keep_title_and_body(layout)
    _master(shown.slide_master, frames.title, frames.words, palette)
    return shown, layout


def _forget_thumbnail(package: Any) -> None:
    """The template's shows other slides."""
    for key, relation in list(package._rels.items()):
        if relation.reltype == RELATIONSHIP_TYPE.THUMBNAIL:
            package.drop_rel(key)


def _keep_title_and_body(of: Any) -> None:
    """No dates, footers or numbers: the source line says what a slide is of."""
    for shape in list(of.placeholders):
        mark = shape._element.xpath(".//p:nvPr/p:ph")[0]
        if mark.get("type") in ("dt", "ftr", "sldNum"):
            shape._element.getparent().remove(shape._element)
        elif mark.get("type") is None:
            mark.set("type", "body")


def _master(master: Any, title: Box, words: Box, palette: Palette) -> None:
    _keep_title_and_body(master)
    for shape, box, anchor in zip(master.placeholders, (title, words), ("ctr", "t"), strict=True):
        frame = shape._element.spPr.find(_tag("a", "xfrm"))
        shape._element.spPr.replace(frame, parse_xml(_named(place(box))))
        body = shape._element.txBody.bodyPr
        for side in ("lIns", "tIns", "rIns", "bIns"):
            body.set(side, "0")
        body.set("anchor", anchor)
    ground, styles = palette["ground"][1:], master._element.find(_tag("p", "txStyles"))
    master._element.cSld.replace(master._element.cSld.find(_tag("p", "bg")), parse_xml(
        f"<p:bg {NAMESPACES}><p:bgPr>{solid(ground)}<a:effectLst/></p:bgPr></p:bg>"
    ))  # fmt: skip
    for style, size, bold in (("titleStyle", TITLE_SIZES[0], 1), ("bodyStyle", BODY_SIZE, 0)):
        first = styles.find(f"{_tag('p', style)}/{_tag('a', 'lvl1pPr')}")
        first.getparent().replace(first, parse_xml(_level(size, bold, palette)))
    _set_fonts(master)


def _level(size: float, bold: int, palette: Palette) -> str:
    return (
        f'<a:lvl1pPr {NAMESPACES} algn="l" marL="0" indent="0"><a:spcBef><a:spcPts val="0"/>'
        f'</a:spcBef><a:buNone/><a:defRPr sz="{round(100 * size)}" b="{bold}">'
        f'{solid(palette["ink"][1:])}<a:latin typeface="{FONT}"/><a:cs typeface="{FONT}"/>'
        "</a:defRPr></a:lvl1pPr>"
    )


def _set_fonts(master: Any) -> None:
    """Of the theme: what is added by hand looks like the rest."""
    theme = master.part.part_related_by(RELATIONSHIP_TYPE.THEME)
    theme._blob = theme.blob.replace(b'typeface="Calibri"', f'typeface="{FONT}"'.encode())


def _named(xml: str) -> str:
    return xml.replace("<a:xfrm", f"<a:xfrm {NAMESPACES}", 1)


def _tag(prefix: str, name: str) -> str:
    ends = {"a": "drawingml/2006/main", "p": "presentationml/2006/main"}
    return f"{{http://schemas.openxmlformats.org/{ends[prefix]}}}{name}"
