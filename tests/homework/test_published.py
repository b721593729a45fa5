"""What the built site has for graders."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from tests.trace.schoolbook import SIZE, WORLDS

from raywalk.homework.rows import as_csv
from raywalk.homework.vectors import vectors_of
from raywalk.homework.write import as_json
from raywalk.scene.read import read_scene, read_scenes
from raywalk.trace.tree import level_pixels
from raywalk.trace.wavefront import Tracer

ROOT = Path(__file__).parents[2]
PUBLISHED = ROOT / "dist" / "homework"
OWN = [each for each in read_scenes(ROOT / "scenes") if not each.base and not each.has_mesh]


def test_each_scene_without_meshes_has_its_two_files() -> None:
    """Beside them the schema and, in both languages, how they are used; nothing else."""
    files = {path.name for path in PUBLISHED.iterdir()}
    of_scenes = {f"{scene.id}.{kind}" for scene in OWN for kind in ("json", "csv")}
    assert files == of_scenes | {"vectors.schema.json", "ABOUT.txt", "ABOUT.de.txt"}


def test_what_is_published_is_what_is_traced() -> None:
    """Byte by byte."""
    vectors = vectors_of(Tracer(read_scene(ROOT / "scenes" / "04-one-bounce")))
    assert (PUBLISHED / "04-one-bounce.json").read_text("utf-8") == as_json(vectors)
    assert (PUBLISHED / "04-one-bounce.csv").read_text("utf-8") == as_csv(vectors)


def test_visitors_do_not_carry_it() -> None:
    """The worker keeps none of it."""
    assert "homework/" not in (ROOT / "dist" / "sw.js").read_text("utf-8")


@pytest.mark.parametrize("name", WORLDS)
def test_a_schoolbook_tracer_is_right_within_the_tolerance(name: str) -> None:
    """One that writes b^2 - 4 a c and knows nothing of ours: each pixel's colour and bytes."""
    vectors = json.loads((PUBLISHED / f"{name}.json").read_text("utf-8"))
    within = vectors["tolerance"]["colour"]["float64"]
    for grid in vectors["grids"][:2]:
        n = grid["n"]
        centres = level_pixels(SIZE, n)
        for entry in grid["pixels"]:
            column, row = entry["pixel"]
            down, across = divmod(int(centres[row * n + column]), SIZE)
            colour = np.array(WORLDS[name].colour(across, down))
            assert np.abs(colour - entry["ray"]["colour"]).max() <= within, (n, entry["pixel"])
