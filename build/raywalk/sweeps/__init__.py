"""Scenes in which something moves: each stop's trace, and what is published of all stops."""
