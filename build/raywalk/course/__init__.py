"""A course of one's own: its folder, and how it begins."""
