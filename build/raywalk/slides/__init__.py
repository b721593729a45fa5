"""Printable slides from the lessons: a step becomes a figure, a figure SVG, PDF and PPTX."""
