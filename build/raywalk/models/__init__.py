"""Files of triangles that other programs wrote: read, cleaned, told about. Knows no scene."""
