"""What the viewer's own modules know of a lesson, asked of them in node."""
