"""What several tests share."""

from __future__ import annotations

import numpy as np
import pytest


@pytest.fixture(params=[20261122], ids=["seed 20261122"])
def rng(request: pytest.FixtureRequest) -> np.random.Generator:
    """Random numbers, the same in every run; the seed stands in the test's id."""
    return np.random.default_rng(request.param)
