"""Students' mistakes are named: a small sample of what `raywalk bench --only mistakes` asks."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.cases import cases

from raywalk.bench import recognition
from raywalk.bench.recognition import HABITS, SCRIPT, Asked, Tally, tally, tally_pairs, tally_right
from raywalk.mistakes.tracer import picture
from raywalk.scene.read import read_scene
from raywalk.stops.process import Stops

SEED = 17
NONE_AND_ONE: tuple[frozenset[str], frozenset[str]] = (
    frozenset(),
    frozenset({"shadows-forgotten"}),
)
SCENE = Path(__file__).parents[2] / "scenes" / "03-two-lights"


@pytest.fixture(scope="module")
def atlas(tmp_path_factory: pytest.TempPathFactory):
    return Asked(read_scene(SCENE), tmp_path_factory.mktemp("atlas"))


@pytest.fixture(scope="module")
def node():
    with Stops(SCRIPT) as node:
        yield node


@pytest.mark.parametrize("n", cases([5, 33, 105, 128], [5, 128]))
def test_right_pictures_of_all_habits_are_called_right(atlas, node, n):
    found = Tally()
    tally_right(found, node, atlas, picture(atlas.scene, n).bytes)
    assert found.first == found.asked == len(HABITS), found.missed


@pytest.mark.parametrize("n", cases([105, 128], [128]))
def test_a_single_mistake_is_the_first_answer(n, atlas, node):
    """Every third that shows, from a seeded one on, with seeded habits."""
    rng, found = np.random.default_rng(SEED + n), Tally()
    right = picture(atlas.scene, n).bytes
    for name in atlas.names[int(rng.integers(3)) :: 3]:
        habits = HABITS[rng.integers(len(HABITS))]
        tally(found, node, atlas, right, {name}, habits)
    assert found.asked > 8
    assert found.first == found.asked, found.missed


def test_of_ten_pairs_seven_are_named(atlas, node):
    """The bench asks 200 and wants 80 in 100; ten are named by chance once in a while less."""
    found = Tally()
    tally_pairs(found, node, atlas, 10, np.random.default_rng(SEED))
    assert found.asked == 10
    assert found.among >= 7, found.missed


def test_what_is_no_mistake_that_we_know_is_not_named(atlas, node):
    """Noise, black, white and another scene: no picture of a tracer with one mistake."""
    right = picture(atlas.scene, 105).bytes
    noise = np.random.default_rng(SEED).integers(0, 256, right.shape).astype(np.uint8)
    other = picture(read_scene(SCENE.parent / "08-glass"), 105).bytes
    for student in (noise, other, np.full_like(right, 255)):
        found = atlas.ask(node, student, right)
        assert not found["isRight"] and found["answers"] == []


def test_a_good_jpeg_of_the_right_picture_is_called_right(atlas, node, tmp_path):
    """Quality 90, colours at full size: single pixels are up to 30 steps away, means are not."""
    right, wrong = (picture(atlas.scene, 231, names).bytes for names in NONE_AND_ONE)
    (tmp_path / "right").write_bytes(b"P6 231 231 255\n" + right.tobytes())
    found = []
    for values in (right, wrong):
        Image.fromarray(values).save(tmp_path / "own.jpg", quality=90, subsampling=0)
        named = {"picture": str(tmp_path / "own.jpg"), "right": str(tmp_path / "right")}
        found.append(atlas.asked(node, named))
    assert found[0]["isRight"]
    assert found[1]["answers"][0]["names"] == ["shadows-forgotten"]


def test_a_tally_without_pictures_breaks_every_bound():
    empty = {key: Tally() for key in ("single", "pairs", "right", "other sizes")}
    assert not any(case.holds for case in recognition.cases(empty, SEED))


def test_other_sizes_are_asked_of_what_is_built_alone(tmp_path):
    """Without a built site none are, which breaks the bound."""
    assert recognition.at_other_sizes([read_scene(SCENE)], tmp_path).asked == 0
