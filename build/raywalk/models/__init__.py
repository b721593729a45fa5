"""Files of triangles that other programs wrote: read, cleaned, reported. Knows no scene."""
