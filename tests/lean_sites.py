"""Sites that tests build are of few parts, and what a test is not about takes no time.

What check/ and mistakes/ are made from takes seconds a scene; their tests look at the site that
`make` built, or ask for these parts by `--without ""`. Every process that a test starts has it too.
"""

from __future__ import annotations

import os

from raywalk.commands.build_site import PARTS


def build_lean_sites() -> None:
    """From here on, unless the person who runs the tests wants other parts."""
    os.environ.setdefault("RAYWALK_WITHOUT", ",".join(PARTS))
