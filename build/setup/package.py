"""Writes Raywalk's wheel and sdist: `make package`, or package.py --out FOLDER [--work FOLDER].

Both are made of a tree beside the checkout's: the package's Python and, within it, its home
(raywalk/home.py), where what node makes of scripts is made. So the sdist needs no node either, and
the wheel that is built of it is the same to the byte.
"""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

from raywalk.home import HOME, WITHIN
from raywalk.node import node_program
from raywalk.pipeline.parts import viewer_parts
from raywalk.pipeline.site import bundle
from raywalk.site.assets import MADE
from raywalk.site.licences import FONT
from raywalk.slides.typeface import FILES
from raywalk.work.making import made
from raywalk.work.store import Store

PACKAGE = Path("build") / "raywalk"
#: Of the checkout, what a build of an installed Raywalk reads; of the site's sources not what is
#: bundled: scripts that run in pages, and what node runs.
WHOLE = ("models", "scenes", "LICENSE", "package-lock.json")
OF_SITE = (
    "templates", "styles", "words", "mistakes", "homework", "kiosk", "offline", "serve", "new",
)  # fmt: skip
RUN_BY_NODE = ("stops.mjs", "check.mjs")
LEFT_OUT = shutil.ignore_patterns("__pycache__", ".*", "*~", "*.partial")


def main() -> None:
    """Makes the tree, and both of it."""
    parser = argparse.ArgumentParser(description="Writes Raywalk's wheel and sdist.")
    parser.add_argument("--out", type=Path, default=HOME / "dist-package")
    parser.add_argument("--work", type=Path, default=HOME / ".work", help="has the viewer's bundle")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder, "raywalk")
        shutil.copytree(HOME / PACKAGE, tree / PACKAGE, ignore=LEFT_OUT)
        for name in ("pyproject.toml", "README.md", "LICENSE"):
            shutil.copyfile(HOME / name, tree / name)
        fill(tree / PACKAGE / WITHIN, Store(chosen.work))
        command = [sys.executable, "-m", "hatchling", "build", "-d", str(chosen.out.absolute())]
        subprocess.run(command, cwd=tree, check=True, stdout=subprocess.DEVNULL)
    for path in sorted(chosen.out.iterdir()):
        print(f"{path.name}: {path.stat().st_size / 1e6:.1f} MB")


def fill(home: Path, store: Store) -> None:
    """The home that the package carries."""
    for name in (*WHOLE, *(f"site_src/{each}" for each in OF_SITE)):
        copy(name, home)
    source = HOME / "site_src"
    viewer = made(store, viewer_parts(source), partial(bundle, source))
    (home / "site_src" / MADE).mkdir()
    for path in viewer.files():
        shutil.copyfile(path, home / "site_src" / MADE / path.name)
    script = str(source / "packaged.mjs")
    command = [node_program() or "node", script, "--out", str(home / "site_src"), *RUN_BY_NODE]
    subprocess.run(command, check=True)
    # Of npm's packages what LICENSES.txt tells of them (site/licences.py), and the typeface.
    for name in (*json.loads((viewer.folder / "packages.json").read_text("utf-8")), FONT):
        folder = f"node_modules/{name}"
        files = (path.name for path in (HOME / folder).glob("LICENSE*"))
        for file in ("package.json", *files, *(FILES.values() if name == FONT else ())):
            copy(f"{folder}/{file}", home)


def copy(name: str, home: Path) -> None:
    """A file or folder of the checkout, to the same place below a home."""
    (home / name).parent.mkdir(parents=True, exist_ok=True)
    if (HOME / name).is_dir():
        shutil.copytree(HOME / name, home / name, ignore=LEFT_OUT)
    else:
        shutil.copyfile(HOME / name, home / name)


if __name__ == "__main__":
    main()
