"""The large models that `raywalk stress --only memory` reads are good ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from raywalk.bench.model_memory import BYTES, torus, write
from raywalk.models.kept import read_cleaned


@pytest.mark.parametrize("name", BYTES)
def test_a_torus_is_whole_in_every_format(name: str, tmp_path: Path) -> None:
    """Closed, of one shell, nothing dropped: so reading does all that it does for a good file."""
    write(tmp_path / name, 3_000)
    cleaned = read_cleaned(tmp_path / name)
    assert len(cleaned.faces) == len(torus(3_000)[1]) == 2 * 39 * 39
    assert len(cleaned.vertices) == 39 * 39
    assert cleaned.shape.closed and len(cleaned.shape.shells) == 1 and not cleaned.dropped
