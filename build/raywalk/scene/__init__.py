"""Scene files: TOML in, validated scenes out. Start with read.py."""

from raywalk.scene.read import read_scene, read_scenes

__all__ = ["read_scene", "read_scenes"]
