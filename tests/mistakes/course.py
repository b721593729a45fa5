"""The scenes that the second tracer is held to."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

from raywalk.mistakes.features import Right
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene

FOLDER = Path(__file__).parents[2] / "scenes"
NAMES = (
    "01-shading", "02-shadows", "03-two-lights", "04-one-bounce", "05-many-bounces", "08-glass",
    "10-cornell-box",
)  # fmt: skip


@cache
def scene(name: str) -> Scene:
    return read_scene(FOLDER / name)


@cache
def right(name: str) -> Right:
    """Its right rays, which say what it has."""
    return Right(scene(name))


def at_size(one: Scene, n: int) -> Scene:
    """The scene with a picture of n x n alone."""
    return replace(one, render=replace(one.render, size=n, resolutions=(n,)))
