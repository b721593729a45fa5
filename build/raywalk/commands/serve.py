"""raywalk serve: the built site at a local address."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.errors import SourceError, SourceErrors


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("serve", help="serve the built site on this machine")
    parser.add_argument("--site", type=Path, default=Path("dist"), help="the built site")
    parser.add_argument("--port", type=int, default=8000)
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """Serves until stopped."""
    from raywalk.site.serve import server

    if not (chosen.site / "index.html").is_file():
        raise SourceErrors([SourceError(chosen.site, "", "is no built site", hint="run make")])
    try:
        service = server(chosen.site, chosen.port)
    except (OSError, OverflowError) as problem:
        message = f"cannot serve on port {chosen.port} ({problem})"
        raise SourceErrors([SourceError(chosen.site, "--port", message)]) from None
    yield f"http://127.0.0.1:{service.server_port}/  (Ctrl+C stops)"
    service.serve_forever()
