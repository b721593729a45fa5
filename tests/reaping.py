"""Runs a command so that all that it starts counts as its work: `python tests/reaping.py COMMAND`.

A browser's processes are ended and not waited for: they are left to the system's first process,
and the time that they worked to nobody. Here they are left to this one (Linux alone can that).
"""

from __future__ import annotations

import ctypes
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence

#: <linux/prctl.h>
PR_SET_CHILD_SUBREAPER = 36
#: Seconds that what was told to end may take to do so. What stays longer is not waited for.
LEAVING = 10.0


def run(command: Sequence[str]) -> int:
    """Its exit code, or 128 and the signal that ended it, as a shell has it."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # it is the command's, which ends this, too
    code = subprocess.run(command, check=False, preexec_fn=_hears).returncode
    end = time.monotonic() + LEAVING
    while time.monotonic() < end:
        try:
            if os.waitpid(-1, os.WNOHANG) == (0, 0):
                time.sleep(0.01)
        except ChildProcessError:
            break
    return code if code >= 0 else 128 - code


def _hears() -> None:
    """What is ignored stays ignored in what is started, unless it says otherwise."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


if __name__ == "__main__":
    sys.exit(run(sys.argv[1:]))
