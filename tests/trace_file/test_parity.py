"""The encoder knows bit by bit what the viewer will read: the errors that it states are true."""

from __future__ import annotations

from conftest import Encoded

from raywalk.trace_file.encode import written


def test_the_viewer_decodes_the_bits_that_the_encoder_measured(encoded: Encoded) -> None:
    """Course scenes, glass, and random scenes: every column as 64-bit patterns."""
    _, known = written(encoded.tree, encoded.scene, encoded.picture)
    columns = {k: v for k, v in vars(encoded.trace).items() if k not in ("header", "n", "count")}
    assert len(columns) == 25
    for name, column in columns.items():
        own = known[name].astype(column.dtype).reshape(column.shape)
        assert own.tobytes() == column.tobytes(), f"column {name} differs"
