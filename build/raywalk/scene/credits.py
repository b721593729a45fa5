"""Whose models stand in a scene."""

from __future__ import annotations

from raywalk.scene.model import Scene
from raywalk.scene.models import ModelTable, find_catalogue, read_catalogue
from raywalk.scene.shapes import Mesh


def named_models(scene: Scene) -> list[ModelTable]:
    """What models.toml says of each named model in the scene, once each: title, credit, licence."""
    named = {obj.shape.model for obj in scene.objects if isinstance(obj.shape, Mesh)}
    if not named:
        return []
    models, _ = read_catalogue(find_catalogue(scene.path))
    return [models.tables[name] for name in sorted(named) if name in models.tables]
