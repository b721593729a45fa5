"""Where what Raywalk needs besides its Python lies: templates, words, scripts, models, licences.

In a checkout they stand around build/. A wheel carries them within the package, laid out as in a
checkout, with what node bundles there already bundled (build/setup/package.py): so what is found
below HOME is found in both.
"""

from __future__ import annotations

from pathlib import Path

WITHIN = "_home"  # the folder in a wheel's package


def home_of(package: Path) -> Path:
    """The home of a package's sources."""
    carried = package / WITHIN
    return carried if carried.is_dir() else package.parents[1]


HOME = home_of(Path(__file__).resolve().parent)
