"""Each law is asked in every run, of the cases where it breaks most easily; `make stress` asks all.

A case that costs much beside others is marked `slow`, or left out unless EVERY; the viewer's tests
have the same in tests/viewer/cases.mjs.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

import pytest

EVERY = bool(os.environ.get("RAYWALK_EVERY_CASE"))


def cases(every: Iterable[Any], few: Iterable[Any]) -> list[Any]:
    """For `parametrize`. few: those of a law's cases that each run asks."""
    asked = list(few)
    return [
        one if one in asked else pytest.param(one, marks=pytest.mark.slow) for one in every
    ]  # fmt: skip
