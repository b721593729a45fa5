"""Serves the built site to this machine only, for looking at it, and for writing scenes.

While scenes are being written, pages get a script more than the built ones have: it reloads
them after a build and shows mistakes. The site itself is not touched by that.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote_to_bytes

from raywalk.site.live import Live, News

WORKER = "sw.js"
THIS_MACHINE = re.compile(r"(127\.0\.0\.1|localhost|\[::1\])(:\d+)?", re.IGNORECASE)
OURS = "/@raywalk/"  # addresses that are not the site's
HEARTBEAT = 10.0  # seconds after which a page that has gone is noticed
SWAP = 0.2  # seconds: longer than a build takes to put the new site in the old one's place
NOTHING_YET = b"<!doctype html><meta charset=utf-8><title>Raywalk</title><body></body>"


class _Quiet(SimpleHTTPRequestHandler):
    """Plain files, never cached: a rebuilt site shows at the next reload. Only for pages of this
    machine: a page from elsewhere could name its own host for this address (DNS rebinding)."""

    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".webp": "image/webp"}

    def parse_request(self) -> bool:
        if not super().parse_request():
            return False
        if not THIS_MACHINE.fullmatch(self.headers.get("Host", "")):
            self.send_error(HTTPStatus.FORBIDDEN, "This server answers 127.0.0.1 and localhost")
            return False
        if not _is_path(self.path):
            self.send_error(HTTPStatus.BAD_REQUEST, "No file can have this address")
            return False
        return True

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, format: str, *args: object) -> None:
        """Says nothing: the page shows what is missing."""


class _Live(_Quiet):
    """Pages with the script that follows the builds."""

    def __init__(self, *args: object, live: Live, extras: Path, **options: str):
        self.live, self.extras = live, extras
        super().__init__(*args, **options)  # type: ignore[arg-type]

    def do_GET(self) -> None:
        asked = self.path.split("?")[0].split("#")[0]
        if asked == OURS + "events":
            self._events()
        elif asked in (OURS + "reload.js", OURS + "reload.css"):
            self._whole(self.extras / asked.removeprefix(OURS))
        elif asked == f"/{WORKER}":
            self._whole(self.extras / "no-worker.js")
        elif asked.endswith(("/", ".html")):
            self._page(Path(self.translate_path(asked)))
        else:
            if not Path(self.translate_path(asked)).exists():
                time.sleep(SWAP)
            super().do_GET()

    def translate_path(self, path: str) -> str:
        """Where a file is: the built site's, or what is shown until the next one is there."""
        place = super().translate_path(path)
        if self.live.meanwhile:
            newer = self.live.meanwhile / Path(place).relative_to(self.directory)
            return str(newer) if newer.is_file() else place
        return place

    def _events(self) -> None:
        """News as they come, until the page goes away."""
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", "text/event-stream")
        self.end_headers()
        seen: News | None = None
        try:
            while True:
                news = self.live.after(seen, HEARTBEAT)
                self.wfile.write(b":\n\n" if news == seen else news.as_event())
                self.wfile.flush()
                seen = news
        except OSError:
            return

    def _page(self, file: Path) -> None:
        version = self.live.news.version  # before the file is read: never newer than it
        file = file / "index.html" if file.is_dir() or self.path.endswith("/") else file
        for _ in range(2):
            try:
                self._answer(HTTPStatus.OK, "text/html; charset=utf-8",
                             followed(file.read_bytes(), version))  # fmt: skip
                return
            except FileNotFoundError:
                time.sleep(SWAP)
        page = followed(NOTHING_YET, version)
        self._answer(HTTPStatus.NOT_FOUND, "text/html; charset=utf-8", page)

    def _whole(self, file: Path) -> None:
        kind = "text/javascript" if file.suffix == ".js" else "text/css"
        self._answer(HTTPStatus.OK, kind, file.read_bytes())

    def _answer(self, status: HTTPStatus, kind: str, body: bytes) -> None:
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)


def _is_path(address: str) -> bool:
    """Whether a file could have such a name: UTF-8 without a zero byte."""
    name = unquote_to_bytes(address.partition("?")[0])
    try:
        return "\0" not in name.decode()
    except UnicodeDecodeError:
        return False


def followed(page: bytes, version: int) -> bytes:
    """A page with the script that follows the builds; it may talk to this server, no other."""
    script = f'<script src="{OURS}reload.js" data-version="{version}"></script></body>'
    sheet = f'<link rel="stylesheet" href="{OURS}reload.css"></head>'
    page = page.replace(f' data-worker="{WORKER}"'.encode(), b"", 1)  # it would show what it kept
    page = page.replace(b"default-src 'none';", b"default-src 'none'; connect-src 'self';", 1)
    page = page.replace(b"</head>", sheet.encode(), 1)
    return script.encode().join(page.rsplit(b"</body>", 1))


def server(
    folder: Path, port: int, live: Live | None = None, extras: Path | None = None
) -> ThreadingHTTPServer:
    """A server on the loopback address; raises OSError if the port is taken.

    live, extras: what pages are to follow, and the folder of reload.js and reload.css.
    """
    handler: Callable[..., SimpleHTTPRequestHandler] = partial(_Quiet, directory=str(folder))
    if live and extras:
        handler = partial(_Live, directory=str(folder), live=live, extras=extras)
    service = ThreadingHTTPServer(("127.0.0.1", port), handler)
    service.daemon_threads = True  # a page that is open does not keep the server from ending
    return service
