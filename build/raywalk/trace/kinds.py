"""The table of ray kinds, ray_kinds.json; the viewer, its style sheet and the slides read it too.

    rays    code      in the column `kind` of ray trees
            branch    a hit sends on at most one ray of each branch
            part      the what-if switch that leaves it out (what is reflected totally belongs
                      to two, see what-if.ts)
            outline   the shape of its node in the card's tree
    lines   dash      on the viewer's stage, drawn and empty pixels; [1, 0] is a solid line
            wide      times as thick as other lines: a blocked ray says why a point is dark
            dark      colour on the dark page, and on slides for a screen
            light     colour on the projector's light page
    page    edge      beside its entry on the card, drawn and empty pixels
            dark, light   colour of its name in a sentence: at least 4.5:1 on the panels
    slides  dash      drawn and empty points of a line two points wide; [] is a solid line
            powerPoint   the nearest that PowerPoint has (ECMA-376, 20.1.10.48)
            paper     colour in print

A section is what one reader needs, so that the viewer carries no more than that.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

Rows = dict[str, dict[str, Any]]  # by kind, in the order of legends

_TABLE = json.loads((Path(__file__).parent / "ray_kinds.json").read_text(encoding="utf-8"))
RAYS: Rows = _TABLE["rays"]
LINES: Rows = _TABLE["lines"]  # shadow rays too
PAGE: Rows = _TABLE["page"]
SLIDES: Rows = _TABLE["slides"]

BRANCHES = 1 + max(row["branch"] for row in RAYS.values())
BRANCH_OF = np.array([row["branch"] for row in RAYS.values()], np.int64)  # by code
