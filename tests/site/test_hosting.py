"""What a host gets besides the pages: worker, manifest, icons, previews, sitemap, licences."""

from __future__ import annotations

import hashlib
import json
import os
import re
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
from PIL import Image
from pypdf import PdfReader

from raywalk.errors import UserError
from raywalk.scene.read import read_scenes
from raywalk.site.sitemap import base_of, write_sitemap

ROOT = Path(__file__).parent.parent.parent
DIST = ROOT / "dist"
PAGES = sorted(DIST.rglob("*.html"))
LICENCES = (DIST / "LICENSES.txt").read_text("utf-8") if DIST.is_dir() else ""


def build() -> dict:
    """What the worker was said of this build."""
    line = (DIST / "sw.js").read_text("utf-8").partition("\n")[0]
    return json.loads(line.removeprefix("const BUILD = ").removesuffix(";"))


class Addresses(HTMLParser):
    """Every href, src, srcset and content that is an address."""

    def __init__(self, page: str):
        super().__init__()
        self.found: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        said = dict(attrs)
        self.found += [said[name] for name in ("href", "src", "poster") if said.get(name)]
        if said.get("property") == "og:image":
            self.found.append(said["content"])


def test_every_address_in_every_page_is_relative_and_leads_to_a_file():
    """So the site works under any path, from a disk too; model pages may name their sources."""
    files = {str(path.relative_to(DIST)) for path in DIST.rglob("*") if path.is_file()}
    folders = {os.path.dirname(name) or "." for name in files}
    for page in PAGES:
        here = str(page.parent.relative_to(DIST))
        for address in {*Addresses(page.read_text("utf-8")).found}:
            parts = urlsplit(address)
            if parts.scheme in ("data", "http", "https") or not parts.path:
                continue
            assert not address.startswith("/"), f"{page}: {address}"
            to = os.path.normpath(os.path.join(here, unquote(parts.path)))
            to = os.path.normpath(f"{to}/index.html") if to in folders else to
            assert to in files, f"{page}: {address}"


def test_every_page_has_a_strict_policy_and_needs_nothing_from_elsewhere():
    """No page may load or run what is not the site's own."""
    assert len(PAGES) > 20
    for page in PAGES:
        text = page.read_text("utf-8")
        policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]+)"', text)
        assert policy, page
        rules = dict(rule.strip().split(" ", 1) for rule in policy[1].split(";"))
        assert rules["default-src"] == "'none'", page
        assert "unsafe-eval" not in policy[1] and "http" not in policy[1], page
        assert (
            rules.get("script-src", "'none'") in ("'self'", "'none'")
            or "sha256-" in rules["script-src"]
        ), page
        assert rules.get("worker-src", "'self'") == "'self'"


def test_assets_are_named_by_their_content():
    """A cache may keep them for ever."""
    for asset in (DIST / "assets").iterdir():
        assert hashlib.sha256(asset.read_bytes()).hexdigest()[:10] in asset.name


def test_the_worker_knows_every_file_that_pages_need_as_it_is():
    """Hashes and sizes are the files' own; what comes first is small."""
    said = build()
    for name, (digest, size) in said["files"].items():
        content = (DIST / name).read_bytes()
        assert (hashlib.sha256(content).hexdigest()[:16], len(content)) == (digest, size), name
    for needed in ("index.html", "de/index.html", "scenes/01-shading/15.js", "LICENSES.txt"):
        assert needed in said["files"]
    assert not any(name.endswith((".pdf", ".pptx", ".json.gz")) for name in said["files"])
    assert set(said["first"]) <= set(said["files"])
    first = sum(said["files"][name][1] for name in said["first"])
    assert first < 2_500_000, "bytes: both languages, thumbnails, icons; half of it gzipped"
    assert not any(name.startswith("scenes/") and "thumb" not in name for name in said["first"])


@pytest.mark.parametrize("home", ["", "de/"])
def test_the_manifest_names_its_language_and_icons_that_are_there(home):
    """Relative to itself, so it works under any path."""
    manifest = json.loads((DIST / f"{home}manifest.webmanifest").read_text("utf-8"))
    assert manifest["lang"] == (home.rstrip("/") or "en")
    assert {icon["sizes"] for icon in manifest["icons"]} == {"48x48", "192x192", "512x512"}
    for icon in manifest["icons"]:
        with Image.open(DIST / home / icon["src"]) as image:
            assert f"{image.width}x{image.height}" == icon["sizes"]
    assert (DIST / home / manifest["start_url"]).is_file()
    assert (DIST / home / manifest["scope"]).resolve() == DIST.resolve()


def test_every_scene_has_a_preview_picture_that_its_pages_name():
    """1200 x 630 and light: shared links are opened on phones."""
    for scene in read_scenes(ROOT / "scenes"):
        place = DIST / "scenes" / scene.traces / "preview.jpg"
        with Image.open(place) as image:
            assert image.size == (1200, 630)
        assert place.stat().st_size < 200_000
        for home in ("", "de/"):
            page = (DIST / f"{home}scenes/{scene.id}/index.html").read_text("utf-8")
            assert re.search(rf'og:image" content="[^"]*scenes/{scene.traces}/preview.jpg"', page)


def test_the_sitemap_has_every_page_and_is_not_there_without_an_address(tmp_path):
    """A sitemap of relative links would be none."""
    (tmp_path / "offline").mkdir()
    (tmp_path / "a b").mkdir()
    for name in ("index.html", "a b/index.html", "offline/index.html"):
        (tmp_path / name).touch()
    write_sitemap(tmp_path, base_of(""))
    assert not (tmp_path / "sitemap.xml").exists()
    write_sitemap(tmp_path, base_of("https://school.example/rays"))
    listed = re.findall("<loc>(.*?)</loc>", (tmp_path / "sitemap.xml").read_text("utf-8"))
    assert listed == ["https://school.example/rays/a%20b/", "https://school.example/rays/"]


@pytest.mark.parametrize(
    "url", ["school.example", "ftp://a/", "https://", "https://a/?b", "http://["]
)
def test_an_address_that_is_none_is_refused_before_anything_is_built(url):
    """With what is allowed."""
    with pytest.raises(UserError, match="not the address of a site\n  allowed: http"):
        base_of(url)


def test_the_licences_name_every_model_that_a_scene_shows():
    """With its credit and its terms, as models.toml has them."""
    for scene in read_scenes(ROOT / "scenes"):
        page = (DIST / "scenes" / scene.id / "index.html").read_text("utf-8")
        for title in ("The Stanford bunny", "The Stanford dragon"):
            if title in page:
                part = LICENCES.partition(title)[2]
                assert scene.id in part and "Stanford Computer Graphics Laboratory" in part


def test_the_licences_name_every_package_that_is_in_a_script():
    """In full, as their licences ask for."""
    assert "three 0." in LICENCES and "three.js authors" in LICENCES
    said = [re.search(r"Holds ([^*]+?)(?:, MIT|:)", path.read_text("utf-8"))
            for path in (DIST / "assets").glob("*.js")]  # fmt: skip
    held = {name for match in said if match for name in match[1].split(", ")}
    assert held == {"three.js", "fast-png", "fflate", "iobuffer", "jpeg-js"}
    for name in held - {"three.js"}:
        assert re.search(rf"^{name} \d", LICENCES, re.MULTILINE)
    assert (ROOT / "LICENSE").read_text("utf-8").strip() in LICENCES


def test_the_licences_name_every_font_that_is_embedded():
    """PDF readers come with the standard fonts; all others we ship."""
    embedded = set()
    for path in sorted((DIST / "slides").glob("01-*.pdf")):
        for page in PdfReader(path).pages:
            for font in (page["/Resources"].get("/Font") or {}).values():
                name = str(font.get_object()["/BaseFont"])
                if "+" in name:
                    embedded.add(re.sub(r"^/[A-Z]+\+|[-_,].*$", "", name))
    print(sorted(embedded))
    assert embedded and all("arimo" in name.lower() for name in embedded)
    assert "SIL OPEN FONT LICENSE" in LICENCES.upper()
    assert "python-pptx" in LICENCES
