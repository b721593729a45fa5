"""What can be taken away of a lesson: its slides in several forms, its sheets, its figures."""

from __future__ import annotations

from typing import Any

from raywalk.words import Words

# In the order of the panel; the ending of the file's name, after the deck's id -> its word's key.
FORMS = {
    ".html": "html",
    ".pdf": "pdf",
    ".pptx": "pptx",
    "-handout-2.pdf": "handout2",
    "-handout-3.pdf": "handout3",
    "-handout-6.pdf": "handout6",
    "-worksheet.pdf": "worksheet",
}
ABSENT = "-"  # in place of a size


def sorted_downloads(id: str, sizes: dict[str, int], words: Words) -> dict[str, Any]:
    """sizes: bytes by path from the site's root.

    {"files": [{word key, path, ending after the id, size in words}] as the panel shows them,
    "figures": paths of the SVG files, "compact": folder and sizes in one line, which the viewer
    reads when it turns to the scene}. Raises ValueError for a file that none of them names.
    """
    by_ending = {path.rpartition(f"/{id}")[2]: path for path in sizes}
    for ending, path in by_ending.items():
        if ending not in FORMS and not ending.endswith(".svg"):
            raise ValueError(f"{path} would be published and never linked: FORMS lacks {ending!r}")
    files = [
        {
            "word": word,
            "path": by_ending[ending],
            "after": ending,
            "size": size_words(sizes[by_ending[ending]], words),
        }
        for ending, word in FORMS.items()
        if ending in by_ending
    ]
    there = {file["after"]: file["size"] for file in files}
    folder = next(iter(sizes)).rpartition("/")[0]
    listed = [there.get(ending, ABSENT) for ending in FORMS]
    return {
        "files": files,
        "figures": sorted((path for path in sizes if path.endswith(".svg")), key=_in_order),
        "compact": "|".join([f"{folder}/", *listed]),
    }


def _in_order(path: str) -> tuple[int, str]:
    """Figures are numbered in two digits, and in more where there are a hundred."""
    return len(path), path


def size_words(size: int, words: Words) -> str:
    """As a browser's list of downloads has it: 152 KB, 1.2 MB."""
    if size < 999_500:
        return words.say("pages.slides.kilobytes", size=max(1, round(size / 1000)))
    return words.say("pages.slides.megabytes", size=words.numbers.fixed(size / 1e6, 1))
