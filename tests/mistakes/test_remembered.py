"""What the right program worked out is taken over by others, and changes none of their pictures."""

from __future__ import annotations

import numpy as np
import pytest

from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.rays import free_rays
from raywalk.mistakes.remembered import Noting, remembered, remembering
from raywalk.mistakes.table import BY_NAME, Mistakes
from raywalk.mistakes.tracer import Version, picture, pictures

from .course import scene

GRID = 9
GLASS = pytest.param("08-glass", EXACT, marks=pytest.mark.slow)
FLOATS = Habits(precision=np.float32, offset=1e-3)


@pytest.mark.parametrize(
    ("name", "habits"),
    [("03-two-lights", FLOATS), ("05-many-bounces", EXACT), GLASS],
    ids=["03 in float32", "05", "08"],
)
def test_together_every_picture_is_what_it_is_alone(name: str, habits: Habits) -> None:
    """Of each mistake."""
    versions = [Version(frozenset([mistake]), habits) for mistake in BY_NAME]
    for version, made in zip(versions, pictures(scene(name), GRID, versions), strict=True):
        alone = picture(scene(name), GRID, version.mistakes, habits).bytes
        np.testing.assert_array_equal(made, alone, err_msg=str(set(version.mistakes)))


@remembered
def doubled(numbers: np.ndarray, mistakes: Mistakes) -> np.ndarray:
    TAKEN.append("doubled")
    return numbers * (3 if "tripled" in mistakes else 2)


@remembered
def raised(numbers: np.ndarray, mistakes: Mistakes) -> np.ndarray:
    TAKEN.append("raised")
    return doubled(numbers, mistakes) + ("one-more" in mistakes)


TAKEN: list[str] = []


def test_a_step_is_taken_again_only_for_a_mistake_that_it_or_a_step_in_it_asks_for() -> None:
    """And for other numbers, and each time where nothing is remembered."""
    one, tripled, one_more = np.arange(3.0), frozenset(["tripled"]), frozenset(["one-more"])
    with remembering():
        for mistakes, steps in (
            (frozenset(), ["raised", "doubled"]), (frozenset(), []),
            (frozenset(["mirrored"]), []), (one_more, ["raised"]),
            (tripled, ["raised", "doubled"]),
        ):  # fmt: skip
            TAKEN.clear()
            wrong = 1 if mistakes == one_more else 0
            factor = 3 if mistakes == tripled else 2
            assert (raised(one.copy(), mistakes) == factor * one + wrong).all()
            assert TAKEN == steps
        TAKEN.clear()
        assert (raised(one + 1, frozenset()) == 2 * (one + 1)).all()
        assert TAKEN == ["raised", "doubled"]
    TAKEN.clear()
    raised(one, frozenset())
    assert TAKEN == ["raised", "doubled"]


def test_nobody_can_change_what_is_remembered() -> None:
    """Whoever gets it again would have the change too."""
    with remembering():
        made = doubled(np.arange(3.0), frozenset())
        with pytest.raises(ValueError, match="read-only"):
            made[0] = 1.0


def test_who_notes_what_is_asked_for_does_not_answer_what_asks_for_all() -> None:
    """To go through the set is to ask for every mistake that there is."""
    noting = Noting()
    assert "far-root" not in noting and not noting & {"mirrored"}
    assert noting.asked == {"far-root", "mirrored"}
    for asks in (list, hash, lambda all_of: all_of | {"mirrored"}):
        with pytest.raises(TypeError, match="by their names"):
            asks(noting)


def test_rays_are_the_same_to_the_last_bit_or_others() -> None:
    """A sign of zero too: 1 / -0 is another infinity."""
    there, back = (np.array([[sign], [1.0], [0.0]]) for sign in (0.0, -0.0))
    with remembering():
        for direction in there, back:
            rays = free_rays(np.zeros((3, 1)), direction)
            assert (np.signbit(turned(rays.direction, frozenset())) == np.signbit(direction)).all()


@remembered
def turned(direction: np.ndarray, mistakes: Mistakes) -> np.ndarray:
    return np.zeros_like(direction) if "x" in mistakes else direction.copy()
