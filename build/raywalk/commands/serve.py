"""raywalk serve: the site at a local address, built anew whenever a file is saved."""

from __future__ import annotations

import time
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
from raywalk.commands.slides_beside import Ended, SlidesBeside, trouble_of
from raywalk.errors import SourceError, SourceErrors, UserError, shown_path
from raywalk.site.live import Live
from raywalk.work.progress import Message
from raywalk.work.snapshot import one_build
from raywalk.work.watch import Saves

EXTRAS = build_site.SITE_SOURCE / "serve"
WATCHED = (build_site.SITE_SOURCE, Path("models"))  # besides the scenes
PAUSE = 2.0  # seconds without a save, after which slides are made too
TICK = 0.1  # seconds between two glances at how slides get on; a save is heard at once


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
    build_site.refuse_out(chosen)  # before anything in it is handed out
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
    pages_first = Namespace(**vars(chosen) | {"slides_later": True})
    saves, slides, sights = Saves([chosen.scenes, *WATCHED]), SlidesBeside(), Sights(scratch)
    try:
        yield from _built(pages_first, live, saves)
        pause_ends: float | None = time.monotonic() + PAUSE
        while True:
            if changed := saves.wait(TICK):
                slides.tell_to_stop()
                yield f"saved: {', '.join(shown_path(Path(path)) for path in changed[:3])}"
                live.begin()
                sights.show(chosen, live)
                slides.stop()
                yield from _built(pages_first, live, saves)
                pause_ends = time.monotonic() + PAUSE
            elif pause_ends and time.monotonic() > pause_ends and not live.news.trouble:
                pause_ends = None
                live.begin()
                slides.start(chosen)
            yield from _of_slides(slides, live)
    finally:
        slides.stop()


class Sights:
    """Before a scene is traced as a whole, its grids, which take a moment. What is wrong with it is
    said by the build that follows."""

    def __init__(self, scratch: Path):
        self._scratch, self._count = scratch, 0

    def show(self, chosen: Namespace, live: Live) -> None:
        """In a folder of its own: of another one, whose build was given up, pages may still get."""
        from raywalk.pipeline.first_sight import first_sight

        self._count += 1
        folder, last = (self._scratch / f"{self._count - k}" for k in (0, 1))
        with suppress(Exception), one_build():
            if first_sight(chosen, folder):
                live.first_sight(folder)
        if live.meanwhile != last:
            rmtree(last, ignore_errors=True)


def _built(chosen: Namespace, live: Live, saves: Saves) -> Iterator[str | Message]:
    """One build, given up when something is saved meanwhile, which the next one begins with;
    mistakes go to the pages and to the terminal."""
    live.begin()
    building = build_site.run(chosen)
    try:
        for message in building:
            yield message
            if saves.are_there:
                building.close()
                return
    except (UserError, OSError) as problems:
        live.failed(trouble_of(problems))
        yield trouble_of(problems)
    except Exception:  # a fault of ours: seen where the author looks, and the next save may do
        live.failed(traceback.format_exc())
        yield traceback.format_exc()
    else:
        live.done()


def _of_slides(slides: SlidesBeside, live: Live) -> Iterator[str | Message]:
    """What their build said, and what came of it."""
    for message in slides.messages():
        if not isinstance(message, Ended):
            yield message
        elif message.trouble:
            live.failed(message.trouble)
            yield message.trouble
        else:
            live.slides_too()


def _serve_as_it_is(chosen: Namespace) -> Iterator[str | Message]:
    if not (chosen.site / "index.html").is_file():
        raise SourceErrors(
            [SourceError(chosen.site, "", "is no built site", hint="run raywalk build, or make")]
        )
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
