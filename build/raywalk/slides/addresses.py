"""Where a lesson is live, as paper and notes say it."""

from __future__ import annotations

from raywalk.scene.model import Scene
from raywalk.slides.words import words
from raywalk.words.catalogue import DEFAULT


def address(scene: Scene, file: str = "", base: str = "") -> str:
    """Of the scene's page in the language that is spoken, or of a file of the site; base: what it
    begins with. Without one it counts from the site's first folder."""
    language = "" if words().code == DEFAULT else f"{words().code}/"
    return f"{base}{language}{file or f'scenes/{scene.id}/index.html'}"


def step_address(scene: Scene, step: int, answered: bool, base: str = "") -> str:
    """Of a step, from 0, or of the answer to it."""
    return f"{address(scene, base=base)}#step={step + 1}{'&answer=1' if answered else ''}"
