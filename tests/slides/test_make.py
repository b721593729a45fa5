"""`make slides`: what the site holds, and on demand the other shape and palette."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    ("wanted", "command"),
    [
        ([], "ls dist/slides"),
        (["ASPECT=4:3"], "--aspect 4:3 --out slides/4x3 "),
        (["PALETTE=print"], "--palette print --out slides/16x9-print "),
        (
            ["ASPECT=4:3", "PALETTE=screen"],
            "--aspect 4:3 --palette screen --out slides/4x3-screen ",
        ),
    ],
)
def test_make_slides_hands_on_what_is_asked_for(wanted, command):
    """Only printed, not run; each shape and palette has a folder of its own, outside the site."""
    ended = subprocess.run(
        ["make", "-n", "slides", *wanted], cwd=ROOT, capture_output=True, text=True, check=True
    )
    words = " ".join(ended.stdout.split())
    assert command in words
