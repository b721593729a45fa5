"""Each law is asked in every run, of the cases where it breaks most easily; `make stress` asks all.

A case that costs much beside others is marked `slow`, or left out unless EVERY; the viewer's tests
have the same in tests/viewer/cases.mjs.
"""

from __future__ import annotations

import os

EVERY = bool(os.environ.get("RAYWALK_EVERY_CASE"))
