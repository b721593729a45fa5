"""A scene's rays as numbers for those who write a ray tracer of their own, and who grade it."""
