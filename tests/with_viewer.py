"""Puts the viewer's scripts as `make` bundled them into a new store.

To bundle them takes seconds, and is not what tests of other things are about. Where they are not
there, a test's own build makes them. `python -m tests.with_viewer STORE`
"""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def with_viewer(store: Path) -> Path:
    """The store, made here."""
    from raywalk.pipeline.parts import viewer_parts
    from raywalk.work.digests import key_of

    made = ROOT / ".work" / key_of(viewer_parts(ROOT / "site_src"))
    store.mkdir(parents=True)
    if made.is_dir():
        shutil.copytree(made, store / made.name)
    return store


if __name__ == "__main__":
    with_viewer(Path(sys.argv[1]))
