"""Colours by what they mean. On paper the line's style tells the ray's kind in greyscale too."""

from __future__ import annotations

from dataclasses import dataclass

from raywalk.trace.kinds import LINES, SLIDES


@dataclass(frozen=True)
class Palette:
    name: str  # screen, print
    colours: dict[str, str]  # role -> #rrggbb
    wash: float  # how strongly the shaded view shows on the ground

    def __getitem__(self, colour: str) -> str:
        """The colour of a role; "#rrggbb" stands for itself."""
        return colour if colour.startswith("#") else self.colours[colour]


SCREEN = Palette(
    "screen",
    {
        "ground": "#0d1116", "ink": "#e9edf2", "soft": "#a9b4c1", "rule": "#3a4552",
        "accent": "#f0e442", "lamp": "#ffe9a8", "lamp-edge": "#6b5c1e", "sign": "#e8ecf1",
        "frustum": "#8b95a3", "grid": "#6f7a87", "chosen": "#f0e442", "normal": "#e9edf2",
        "box": "#56b4e9",
        **{kind: row["dark"].lower() for kind, row in LINES.items()},
    },
    wash=0.55,
)  # fmt: skip
PRINT = Palette(
    "print",
    {
        "ground": "#ffffff", "ink": "#111111", "soft": "#4a4a4a", "rule": "#bdbdbd",
        "accent": "#0072b2", "lamp": "#ffcf33", "lamp-edge": "#5c4700", "sign": "#111111",
        "frustum": "#6a6a6a", "grid": "#7a7a7a", "chosen": "#111111", "normal": "#333333",
        "box": "#0072b2",
        **{kind: row["paper"].lower() for kind, row in SLIDES.items()},
    },
    wash=0.5,
)  # fmt: skip
PALETTES = {palette.name: palette for palette in (SCREEN, PRINT)}

KINDS = tuple(SLIDES)  # of rays and shadow rays, in the order of legends
# Each kind has a dash of its own. Drawn and empty lengths in points of lines 2 points wide;
# hidden stretches are thinner.
DASH_LENGTHS: dict[str, tuple[float, ...]] = {
    "solid": (), "hidden": (3, 3), **{kind: tuple(row["dash"]) for kind, row in SLIDES.items()},
}  # fmt: skip
