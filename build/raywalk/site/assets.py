"""The viewer's script and the style sheet, named by their content so that caches never lie."""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

from raywalk.node import MISSING, node_program
from raywalk.trace.kinds import LINES, PAGE
from raywalk.words import Words
from raywalk.work.snapshot import bytes_of

MADE = "bundled"  # in the site's sources of a wheel: what bundle_viewer makes
BUNDLED = ("viewer", "kiosk", "page", "check", "check-mistake")
PART = "part-"  # what comes when asked for, as bundle.mjs names it
CHECK = "check"  # the sentences of the page check/, which no other page says
PAGES_ONLY = ("pages", "slides", "sheet", "teacher", CHECK)  # those that the viewer never says


class BundleError(Exception):
    """The viewer could not be bundled; str() says what esbuild or the check said."""


def write_assets(out: Path, site_src: Path, bundled: Path) -> dict[str, str]:
    """Writes the bundled scripts of a folder and the joined styles into out/assets; returns their
    names in the site, and as `parts` those of the viewer's parts beside its script, as JSON."""
    styles = sorted((site_src / "styles").glob("*.css"))
    sheet = b"\n".join([*(bytes_of(style) for style in styles), ray_sheet().encode()])
    scripts = {
        f"{name.replace('-', '_')}_js": named(
            out, name, "js", (bundled / f"{name}.js").read_bytes()
        )
        for name in BUNDLED
    }
    parts = {
        path.stem.removeprefix(PART): named(out, path.stem, "js", path.read_bytes())
        for path in sorted(bundled.glob(f"{PART}*.js"))
    }
    return scripts | {
        "parts": json.dumps({name: Path(address).name for name, address in parts.items()}),
        "style_css": named(out, "style", "css", sheet),
    }


def write_words(out: Path, words: Words) -> dict[str, str]:
    """A language's sentences as a classic script that sets raywalkWords: apart from the viewer,
    which is the same in every language, and to be loaded before it."""
    said = {key: part for key, part in words.tree.items() if key not in PAGES_ONLY}
    return {"words_js": _said(out, f"words-{words.code}", said)}


def write_check_words(out: Path, words: Words) -> dict[str, str]:
    """The same for the page check/: what it says, and no more."""
    said = {key: words.tree[key] for key in ("language", CHECK)}
    return {"check_words_js": _said(out, f"{CHECK}-words-{words.code}", said)}


def _said(out: Path, stem: str, said: dict[str, Any]) -> str:
    text = json.dumps(said, ensure_ascii=False, separators=(",", ":"))
    return named(out, stem, "js", f"raywalkWords={text};\n".encode())


def bundle_viewer(site_src: Path, folder: Path) -> None:
    """Writes folder/<name>.js of all BUNDLED. Needs node and the packages of package-lock.json,
    but where a wheel brought them.

    Raises BundleError.
    """
    if (site_src / MADE).is_dir():
        shutil.copytree(site_src / MADE, folder, dirs_exist_ok=True)
        return
    if not (node := node_program()):
        raise BundleError(MISSING)
    command = [node, str(site_src / "bundle.mjs"), "--out", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise BundleError((done.stderr or done.stdout).strip())


def named(out: Path, stem: str, ending: str, content: bytes) -> str:
    """Writes an asset under a name with its hash; returns that name in the site."""
    name = f"assets/{stem}-{hashlib.sha256(content).hexdigest()[:10]}.{ending}"
    (out / "assets").mkdir(parents=True, exist_ok=True)
    (out / name).write_bytes(content)
    return name


def ray_sheet() -> str:
    """The style sheet's part on kinds of rays, out of their table: custom properties of both pages,
    and a rule for each place that shows a kind. `.camera` and so on give what is inside of them
    its kind's colour as --line; `.kind` is a word in a sentence, `.ray` an entry on the card."""
    rules = [_colours(":root", "dark"), _colours(".projector", "light")]
    for kind, row in PAGE.items():
        rules.append(f".{kind} {{ --line: var(--ray-{kind}); }}")
        rules.append(f".kind.{kind} {{ color: var(--word-{kind}); }}")
        drawn, empty = row["edge"]
        if empty:
            edge = f"--on: {drawn}px; --period: {drawn + empty}px;"
            rules.append(f".ray.{kind}::before {{ {edge} }}")
    return "\n".join(rules) + "\n"


def _colours(page: str, colour: str) -> str:
    colours = [
        f"--ray-{kind}: {LINES[kind][colour]}; --word-{kind}: {PAGE[kind][colour]};"
        for kind in LINES
    ]
    return f"{page} {{ {' '.join(colours)} }}"
