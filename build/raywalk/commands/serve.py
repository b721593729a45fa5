"""raywalk serve: the site at a local address, built anew whenever a file is saved."""

from __future__ import annotations

import traceback
from argparse import Namespace
from collections.abc import Iterator
from contextlib import suppress
from http.server import ThreadingHTTPServer
from pathlib import Path
from shutil import rmtree
from tempfile import TemporaryDirectory
from threading import Thread
from typing import Any

from raywalk.commands import build_site
from raywalk.errors import SourceError, SourceErrors, UserError, disk_trouble, shown_path
from raywalk.site.live import Live
from raywalk.work.progress import Message
from raywalk.work.snapshot import one_build

EXTRAS = build_site.SITE_SOURCE / "serve"
WATCHED = (build_site.SITE_SOURCE, Path("models"))  # besides the scenes
PAUSE = 2.0  # seconds without a save, after which slides are made too


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    about = "serve the site on this machine, and build it whenever a file is saved"
    parser = commands.add_parser("serve", help=about)
    build_site.add_options(parser)
    parser.add_argument("--site", type=Path, help="serve this built site as it is, build nothing")
    parser.add_argument("--port", type=int, default=8000)
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str | Message]:
    """Serves until stopped."""
    if chosen.site:
        yield from _serve_as_it_is(chosen)
        return
    live = Live()
    service = _server(chosen.out, chosen.port, live)
    Thread(target=service.serve_forever, daemon=True).start()
    yield f"http://127.0.0.1:{service.server_port}/  (Ctrl+C stops; saved files show by themselves)"
    try:
        with TemporaryDirectory() as scratch:
            yield from _follow(chosen, live, Path(scratch))
    finally:
        service.shutdown()


def _follow(chosen: Namespace, live: Live, scratch: Path) -> Iterator[str | Message]:
    """Builds pages at once and after each save, slides when their author pauses."""
    from raywalk.work.watch import changes

    pages_first = Namespace(**vars(chosen) | {"slides_later": True})
    is_first = True
    for changed in changes([chosen.scenes, *WATCHED], PAUSE):
        if changed:
            yield f"saved: {', '.join(shown_path(Path(path)) for path in changed[:3])}"
            live.begin()
            _show_grids(chosen, live, scratch)
        if changed or is_first:
            yield from _built(pages_first, live)
        elif not live.news.trouble:
            yield from _built(chosen, live)
        is_first = False


def _show_grids(chosen: Namespace, live: Live, scratch: Path) -> None:
    """Before a scene is traced as a whole, its grids, which take a moment. What is wrong with it is
    said by the build that follows."""
    from raywalk.pipeline.first_sight import first_sight

    folder = scratch / "sight"
    rmtree(folder, ignore_errors=True)  # the last one's, which no page gets since its build ended
    with suppress(Exception), one_build():
        if first_sight(chosen, folder):
            live.first_sight(folder)


def _built(chosen: Namespace, live: Live) -> Iterator[str | Message]:
    """One build; mistakes go to the pages and to the terminal."""
    live.begin()
    try:
        yield from build_site.run(chosen)
    except (UserError, OSError) as problems:
        trouble = disk_trouble(problems) if isinstance(problems, OSError) else str(problems)
        live.failed(trouble)
        yield trouble
    except Exception:  # a fault of ours: seen where the author looks, and the next save may do
        live.failed(traceback.format_exc())
        yield traceback.format_exc()
    else:
        live.done() if chosen.slides_later else live.slides_too()


def _serve_as_it_is(chosen: Namespace) -> Iterator[str | Message]:
    if not (chosen.site / "index.html").is_file():
        raise SourceErrors([SourceError(chosen.site, "", "is no built site", hint="run make")])
    service = _server(chosen.site, chosen.port, None)
    yield f"http://127.0.0.1:{service.server_port}/  (Ctrl+C stops)"
    service.serve_forever()


def _server(folder: Path, port: int, live: Live | None) -> ThreadingHTTPServer:
    from raywalk.site.serve import server

    try:
        return server(folder, port, live, EXTRAS)
    except (OSError, OverflowError) as problem:
        message = f"cannot serve on port {port} ({problem})"
        raise SourceErrors([SourceError(folder, "--port", message)]) from None
