"""sitemap.xml, and the address that absolute links begin with. Both need to know where the site
will be; without that there are neither."""

from __future__ import annotations

from pathlib import Path
from urllib.parse import quote, urlsplit
from xml.sax.saxutils import escape

from raywalk.errors import UserError

FILE = "sitemap.xml"


def base_of(url: str) -> str:
    """The address with a slash at its end, "" if none is given. Raises UserError."""
    if not url:
        return ""
    try:
        parts = urlsplit(url)
    except ValueError:
        parts = urlsplit("")
    if parts.scheme not in ("http", "https") or not parts.netloc or parts.query or parts.fragment:
        raise UserError(
            f'--url (or RAYWALK_URL): "{url}" is not the address of a site\n'
            "  allowed: http:// or https://, a host, a path; e.g. https://school.example/rays/\n"
            "1 error; nothing was traced"
        )
    return url.rstrip("/") + "/"


def write_sitemap(out: Path, base: str) -> None:
    """Every page that a person would look for, by its absolute address."""
    if not base:
        return
    pages = sorted(path.relative_to(out).as_posix() for path in out.rglob("index.html"))
    wanted = [page for page in pages if "offline/" not in page]
    rows = "".join(
        f"<url><loc>{escape(base + quote(page.removesuffix('index.html')))}</loc></url>\n"
        for page in wanted
    )
    text = (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n{rows}</urlset>\n'
    )
    (out / FILE).write_text(text, encoding="utf-8")
