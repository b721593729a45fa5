"""What several tests share."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(params=[20261122], ids=["seed 20261122"])
def rng(request: pytest.FixtureRequest) -> np.random.Generator:
    """Random numbers, the same in every run; the seed stands in the test's id."""
    return np.random.default_rng(request.param)


@pytest.fixture(scope="session")
def with_viewer() -> Callable[[Path], Path]:
    """Puts the viewer's scripts as `make` bundled them into an empty store, and returns that: to
    bundle them takes seconds, and is not what tests of other things are about. Where these are
    not there, a test's own build makes them."""
    from raywalk.pipeline.parts import viewer_parts
    from raywalk.work.digests import key_of

    made = ROOT / ".work" / key_of(viewer_parts(ROOT / "site_src"))

    def copied(store: Path) -> Path:
        store.mkdir(parents=True)
        if made.is_dir():
            shutil.copytree(made, store / made.name)
        return store

    return copied
