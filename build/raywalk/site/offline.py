"""What makes a hosted site work without its network: service worker, manifest, icons."""

from __future__ import annotations

import hashlib
import json
from io import BytesIO
from pathlib import Path
from typing import Any

from PIL import Image

from raywalk.site.assets import named
from raywalk.site.pages import home_of
from raywalk.words import Words, languages
from raywalk.work.snapshot import text_of

WORKER = "sw.js"
MANIFEST = "manifest.webmanifest"
ICONS = (48, 192, 512)  # pixels: tab, home screen, splash screen
GROUND = "#0d1116"
# Plain twins of the traces, sheets for paper and PowerPoint, tables about the build: whoever
# wants them saves them; pages do not need them.
NEVER_KEPT = (".json.gz", ".pptx", ".pdf", ".svg", "sizes.json", WORKER)
NOT_PAGES = ("sizes/", "benchmarks/", "homework/", "check/")
HASH = 16  # hex digits


def write_icons(out: Path, picture: Path) -> dict[str, str]:
    """Icons out of a scene's picture, named by their content: icon_48, ... -> name in the site."""
    whole = Image.open(picture).convert("RGB")
    names = {}
    for side in ICONS:
        png = BytesIO()
        whole.resize((side, side), Image.Resampling.LANCZOS).save(png, "PNG", optimize=True)
        names[f"icon_{side}"] = named(out, f"icon-{side}", "png", png.getvalue())
    return names


def write_manifest(out: Path, words: Words, icons: dict[str, str]) -> None:
    """The web app manifest of one language; all its addresses are relative to it."""
    home = home_of(words.code)
    root = "../" * home.count("/") or "./"
    manifest = {
        "name": words.say("pages.gallery.title"),
        "short_name": "Raywalk",
        "description": words.say("pages.description"),
        "lang": words.code,
        "dir": words.direction,
        "start_url": "./index.html",
        "scope": root,
        "display": "standalone",
        "background_color": GROUND,
        "theme_color": GROUND,
        "icons": [
            {
                "src": f"{root}{icons[f'icon_{side}']}",
                "sizes": f"{side}x{side}",
                "type": "image/png",
            }
            for side in ICONS
            if f"icon_{side}" in icons
        ],
    }
    text = json.dumps(manifest, ensure_ascii=False, indent=1)
    (out / f"{home}{MANIFEST}").write_text(text + "\n", encoding="utf-8")


def write_worker(out: Path, source: Path) -> None:
    """sw.js: the worker's own code after what this build consists of. To be written last."""
    build = json.dumps(build_of(out), separators=(",", ":"))
    code = text_of(source / "offline" / WORKER)
    (out / WORKER).write_text(f"const BUILD = {build};\n{code}", encoding="utf-8")


def build_of(out: Path) -> dict[str, Any]:
    """version; files: path -> [hash, bytes]; first: what is kept before any scene is looked at;
    homes: the folders of the languages' pages."""
    files = {}
    for path in sorted(out.rglob("*")):
        name = path.relative_to(out).as_posix()
        if _is_shown(path) and not name.endswith(NEVER_KEPT) and not name.startswith(NOT_PAGES):
            content = path.read_bytes()
            files[name] = [hashlib.sha256(content).hexdigest()[:HASH], len(content)]
    homes = [home_of(code) for code in languages()]
    version = hashlib.sha256(json.dumps(files).encode()).hexdigest()[:HASH]
    return {
        "version": version,
        "files": files,
        "first": [name for name in files if _is_first(name, homes)],
        "homes": homes,
    }


def _is_shown(path: Path) -> bool:
    """A picture's PNG is to be saved where pages show its WebP."""
    return path.is_file() and not (path.suffix == ".png" and path.with_suffix(".webp").is_file())


def _is_first(name: str, homes: list[str]) -> bool:
    """The pages that are not a scene's, what all pages share, and the gallery's pictures."""
    own = next((name.removeprefix(home) for home in homes if home and name.startswith(home)), name)
    pages = (
        "index.html",
        "model/index.html",
        "glossary/index.html",
        "offline/index.html",
        MANIFEST,
        "LICENSES.txt",
    )
    return (
        own in pages or name.startswith("assets/") or name.endswith(("/thumb.png", "/thumb.webp"))
    )
