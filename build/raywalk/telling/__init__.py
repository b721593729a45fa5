"""A pixel's rays told: the events of its tree in true order, a sentence and its numbers each."""

from raywalk.telling.events import RayEvent, events_of
from raywalk.telling.scene import ToldScene, scene_beside, told_scene
from raywalk.telling.sentences import Told, tell

__all__ = ["RayEvent", "Told", "ToldScene", "events_of", "scene_beside", "tell", "told_scene"]
