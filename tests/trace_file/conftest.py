"""Makes the small tracer and the scenes beside this file importable; shares encoded ones."""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import NamedTuple

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))

import scenes_for_tests
from tiny_tracer import in_file_order, trace_tiny

from raywalk.scene.model import Scene
from raywalk.stops.decoded import DecodedTrace, read_trace
from raywalk.stops.process import Stops
from raywalk.trace.tree import RayTree
from raywalk.trace_file.container import pack
from raywalk.trace_file.encode import encode

SIZE = 21
SEEDS = range(12)
STOPS = Stops()  # one node process for all of these tests


def pytest_sessionfinish() -> None:
    STOPS.__exit__(None, None, None)


def decode(data: bytes, scene: str | None = None, n: int | None = None) -> DecodedTrace:
    """The trace of these JSON bytes, as the viewer's modules read it."""
    with NamedTemporaryFile(suffix=".json.gz") as file:
        file.write(pack(data))
        file.flush()
        return read_trace(Path(file.name), STOPS, scene, n)


class Encoded(NamedTuple):
    """A scene, its tree, and what the codec makes of it."""

    scene: Scene
    tree: RayTree
    picture: np.ndarray
    json: bytes
    trace: DecodedTrace


@cache
def encoded_scene(name: str) -> Encoded:
    kind, _, seed = name.partition(" seed ")
    if seed:
        scene = scenes_for_tests.random_scene(int(seed), SIZE)
    else:
        scene = getattr(scenes_for_tests, kind)(SIZE)
    tree, picture = trace_tiny(scene)
    tree = in_file_order(tree)
    json = encode(tree, scene, picture)
    return Encoded(scene, tree, picture, json, decode(json))


NAMES = ["shading", "two_lights", "mirrors", "glass", *(f"random seed {k}" for k in SEEDS)]


@pytest.fixture(params=NAMES)
def encoded(request: pytest.FixtureRequest) -> Encoded:
    return encoded_scene(request.param)


@pytest.fixture
def glass() -> Encoded:
    return encoded_scene("glass")
