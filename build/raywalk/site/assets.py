"""The viewer's script and the style sheet, named by their content so that caches never lie."""

from __future__ import annotations

import hashlib
import subprocess
import tempfile
from pathlib import Path


class BundleError(Exception):
    """The viewer could not be bundled; str() says what esbuild or the check said."""


def write_assets(out: Path, site_src: Path) -> dict[str, str]:
    """Bundles the viewer and joins the styles into out/assets; returns their names in the site.

    Needs node and the packages of package-lock.json. Raises BundleError.
    """
    with tempfile.TemporaryDirectory() as scratch:
        _bundle(site_src / "bundle.mjs", Path(scratch))
        script = (Path(scratch) / "viewer.js").read_bytes()
    styles = sorted((site_src / "styles").glob("*.css"))
    sheet = b"\n".join(style.read_bytes() for style in styles)
    return {
        "viewer_js": _named(out, "viewer", "js", script),
        "style_css": _named(out, "style", "css", sheet),
    }


def _bundle(bundler: Path, out: Path) -> None:
    command = ["node", str(bundler), "--out", str(out)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        raise BundleError("node is not installed (see README: what is needed)") from None
    if done.returncode:
        raise BundleError((done.stderr or done.stdout).strip())


def _named(out: Path, stem: str, ending: str, content: bytes) -> str:
    name = f"assets/{stem}-{hashlib.sha256(content).hexdigest()[:10]}.{ending}"
    (out / "assets").mkdir(parents=True, exist_ok=True)
    (out / name).write_bytes(content)
    return name
