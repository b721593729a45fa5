"""The style sheet's part on kinds of rays, out of their table (trace/kinds.py).

`.camera` and so on give what is inside of them its kind's colour as --line; `.kind` is a word
in a sentence, `.ray` an entry on the card.
"""

from __future__ import annotations

from raywalk.trace.kinds import LINES, PAGE


def ray_sheet() -> str:
    """Custom properties of both pages, and a rule for each place that shows a kind."""
    rules = [_colours(":root", "dark"), _colours(".projector", "light")]
    for kind, row in PAGE.items():
        rules.append(f".{kind} {{ --line: var(--ray-{kind}); }}")
        rules.append(f".kind.{kind} {{ color: var(--word-{kind}); }}")
        drawn, empty = row["edge"]
        if empty:
            edge = f"--on: {drawn}px; --period: {drawn + empty}px;"
            rules.append(f".ray.{kind}::before {{ {edge} }}")
    return "\n".join(rules) + "\n"


def _colours(page: str, colour: str) -> str:
    colours = [
        f"--ray-{kind}: {LINES[kind][colour]}; --word-{kind}: {PAGE[kind][colour]};"
        for kind in LINES
    ]
    return f"{page} {{ {' '.join(colours)} }}"
