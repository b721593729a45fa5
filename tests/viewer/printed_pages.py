"""python tests/viewer/printed_pages.py FILE.pdf: what stands on each page, as JSON.

A page: {"text": all of it, "last": what stands lowest, "pictures": how many are drawn on it}.
"""

from __future__ import annotations

import json
import sys
from collections import defaultdict
from typing import Any

from pypdf import PageObject, PdfReader
from pypdf.generic import ContentStream, DictionaryObject


def page_of(page: PageObject) -> dict[str, Any]:
    """pypdf hands on each run of letters with where it stands, y up from the page's foot."""
    lines: dict[int, str] = defaultdict(str)

    def seen(text: str, current: list[float], at: list[float], *_font: object) -> None:
        if text.strip():
            y = at[4] * current[1] + at[5] * current[3] + current[5]
            lines[round(y)] += text.strip()

    text = page.extract_text(visitor_text=seen)
    return {"text": text, "last": lines[min(lines)], "pictures": drawn_on(page, page)}


def drawn_on(page: PageObject, part: DictionaryObject) -> int:
    """Pictures drawn on the page or a part of it; what is drawn twice counts twice."""
    stream = page.get_contents() if part is page else ContentStream(part, page.pdf)
    things = part.get("/Resources", {}).get("/XObject", {})
    count = 0
    for names, operator in stream.operations if stream is not None else []:
        if operator == b"Do":
            thing = things[names[0]]
            count += 1 if thing["/Subtype"] == "/Image" else drawn_on(page, thing)
    return count


print(json.dumps([page_of(page) for page in PdfReader(sys.argv[1]).pages]))
