"""What can be taken away of a lesson: its slides in several forms, its sheets, its figures."""

from __future__ import annotations

# In the order of the panel; the ending of the file's name, after the deck's id -> its word's key.
FORMS = {
    ".html": "html",
    ".pdf": "pdf",
    ".pptx": "pptx",
    "-handout-2.pdf": "handout2",
    "-handout-3.pdf": "handout3",
    "-handout-6.pdf": "handout6",
    "-worksheet.pdf": "worksheet",
    "-answers.pdf": "answers",
}


def sorted_downloads(id: str, names: list[str]) -> dict[str, list[dict[str, str]]]:
    """{"files": word keys and file names as the panel shows them, "figures": the SVG files}."""
    there = set(names)
    return {
        "files": [
            {"word": word, "name": id + ending}
            for ending, word in FORMS.items()
            if id + ending in there
        ],
        "figures": [{"name": name} for name in sorted(there) if name.endswith(".svg")],
    }
