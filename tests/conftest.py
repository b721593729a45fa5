"""What several tests share."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from tests.lean_sites import build_lean_sites
from tests.with_viewer import with_viewer

build_lean_sites()


@pytest.fixture(params=[20261122], ids=["seed 20261122"])
def rng(request: pytest.FixtureRequest) -> np.random.Generator:
    """Random numbers, the same in every run; the seed stands in the test's id."""
    return np.random.default_rng(request.param)


@pytest.fixture(scope="session", name="with_viewer")
def with_viewer_of_make() -> Callable[[Path], Path]:
    """Makes a store that has the viewer already."""
    return with_viewer


@pytest.fixture(scope="module")
def one_process() -> Iterator[None]:
    """Builds in this process start no others: each of those would import and load for seconds what
    makes small scenes in a fraction of one."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("raywalk.work.pool.cores", lambda: 1)
        yield
