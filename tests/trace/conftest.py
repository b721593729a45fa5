"""The course's scenes, as they are and small."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene

FOLDER = Path(__file__).parents[2] / "scenes"
NAMES = (
    "01-shading", "02-shadows", "03-two-lights", "04-one-bounce", "05-many-bounces",
    "06-bunny-far", "07-bunny-near",
)  # fmt: skip


@pytest.fixture(scope="session")
def course() -> dict[str, Scene]:
    """Scenes 1 to 7 by their folders' names."""
    return {name: read_scene(FOLDER / name) for name in NAMES}


def small(scene: Scene, size: int, *resolutions: int) -> Scene:
    """The same scene with a smaller picture."""
    return replace(scene, render=replace(scene.render, size=size, resolutions=resolutions))


@pytest.fixture(scope="session")
def small_course(course: dict[str, Scene]) -> dict[str, Scene]:
    """Scenes 1 to 7 at 105 x 105, every ray of it kept by the finest frustum."""
    return {name: small(scene, 105, 5, 15, 21, 105) for name, scene in course.items()}
