"""The table of ray kinds: Python's names agree with it; its lines can be distinguished and read."""

from __future__ import annotations

from itertools import combinations

import pytest

from raywalk.site.assets import ray_sheet
from raywalk.slides.palette import DASH_LENGTHS, PALETTES, PRINT
from raywalk.trace.kinds import BRANCHES, LINES, PAGE, RAYS, SLIDES
from raywalk.trace.tree import SENT_ON, Kind


def luminance(colour: str) -> float:
    """WCAG 2.2, relative luminance of #rrggbb."""
    shares = [int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in shares]
    return sum(v * part for v, part in zip(linear, (0.2126, 0.7152, 0.0722), strict=True))


def contrast(a: str, b: str) -> float:
    dark, light = sorted([luminance(a), luminance(b)])
    return (light + 0.05) / (dark + 0.05)


def test_each_row_of_a_ray_has_its_name_in_python_and_its_code_is_its_place() -> None:
    """Columns are looked up by code, so codes count on without a gap."""
    assert {kind.name.lower(): int(kind) for kind in Kind} == {
        name: place for place, name in enumerate(RAYS)
    }
    assert [row["code"] for row in RAYS.values()] == list(range(len(RAYS)))


def test_every_section_has_a_row_for_each_line() -> None:
    """Shadow rays follow the rays: the order of legends."""
    assert list(LINES) == [*RAYS, "reached", "blocked"]
    assert list(PAGE) == list(SLIDES) == list(LINES)


def test_a_set_of_kinds_sent_on_is_a_sum_of_bits_of_their_own() -> None:
    """As FORMAT.md has them: 1 reflected, 2 refracted, 4 totally reflected."""
    assert [kind.bit for kind in SENT_ON] == [1 << k for k in range(len(SENT_ON))]
    assert (Kind.REFLECTED.bit, Kind.REFRACTED.bit, Kind.TOTAL.bit) == (1, 2, 4)


def test_only_totally_reflected_rays_stand_in_place_of_another() -> None:
    """A hit sends on at most one ray of a branch; the branches count from 0."""
    shared = {
        frozenset((a.name, b.name)) for a, b in combinations(SENT_ON, 2) if a.branch == b.branch
    }
    assert shared == {frozenset(("REFLECTED", "TOTAL"))}
    assert {kind.branch for kind in SENT_ON} == set(range(BRANCHES))


@pytest.mark.parametrize("palette", PALETTES.values(), ids=PALETTES)
def test_lines_and_samples_on_slides_stand_out_from_the_ground(palette) -> None:  # type: ignore[no-untyped-def]
    """4.5 to 1, as for words: legends and tables name a kind beside a sample two points thick."""
    for kind in LINES:
        assert contrast(palette[kind], palette["ground"]) >= 4.5, (palette.name, kind)


def test_on_paper_no_two_kinds_look_alike_without_their_hue() -> None:
    """Greyscale printing leaves the dash."""
    dashes = [DASH_LENGTHS[kind] for kind in SLIDES]
    assert len(set(dashes)) == len(dashes)
    assert PRINT["total"] == PRINT["reflected"]  # one hue: both are mirrored


def test_slides_for_a_screen_have_the_viewers_colours() -> None:
    """The dark page's; the sheet's custom properties are the same values."""
    sheet = ray_sheet()
    for kind, row in LINES.items():
        assert PALETTES["screen"][kind] == row["dark"].lower()
        assert (
            f"--ray-{kind}: {row['dark']};" in sheet and f"--ray-{kind}: {row['light']};" in sheet
        )


@pytest.mark.parametrize(("words", "panel"), [("dark", "#1b222b"), ("light", "#ffffff")])
def test_a_kinds_name_in_a_sentence_can_be_read(words: str, panel: str) -> None:
    """4.5 to 1 on the pages' panels (styles/00-base.css: raised, 88-projector.css)."""
    for kind, row in PAGE.items():
        assert contrast(row[words], panel) >= 4.5, kind
