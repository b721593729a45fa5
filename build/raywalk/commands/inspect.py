"""raywalk inspect: one pixel's ray tree out of a built trace file, or its events in words."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raywalk.commands.pixel import place
from raywalk.errors import SourceError, SourceErrors

if TYPE_CHECKING:
    from raywalk.stops.process import Stops


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    from raywalk.words import languages

    parser = commands.add_parser("inspect", help="one pixel's ray tree out of a trace file")
    parser.add_argument("trace", type=Path, help="<n>.js or <n>.json.gz of a built scene")
    parser.add_argument("--pixel", type=place, required=True, help="I,J: column, row from top left")
    parser.add_argument("--events", action="store_true", help="what happens, as the player says it")
    parser.add_argument(
        "--language", choices=languages(), default="en", help="of the sentences of --events"
    )
    parser.add_argument("--json", action="store_true", help="everything, as JSON")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """The tree as indented text, or as one JSON object with every stored number; with --events
    its events, a sentence and a line of numbers each."""
    from raywalk.stops.decoded import read_trace
    from raywalk.stops.pixel_rays import as_json, describe
    from raywalk.stops.process import Stops

    try:
        chosen.trace.stat()  # what is missing is said as of any file
        with Stops() as stops:
            trace = read_trace(chosen.trace, stops)
            tree = as_json(trace, chosen.pixel)  # refuses a pixel outside
            if chosen.events:
                yield from _events(chosen, stops)
            elif chosen.json:
                yield json.dumps(tree, allow_nan=False)
            else:
                yield describe(trace, chosen.pixel)
    except OSError as problem:
        message = f"cannot be read ({problem.strerror})"
        file = Path(problem.filename or chosen.trace)
        raise SourceErrors([SourceError(file, "", message)]) from None
    except ValueError as problem:
        raise SourceErrors([SourceError(chosen.trace, "", str(problem))]) from None


def _events(chosen: Namespace, stops: Stops) -> Iterator[str]:
    from raywalk.words import read_words

    scene = chosen.trace.with_name("scene.js")
    scene.stat()
    request = {
        "do": "events", "scene": str(scene), "trace": str(chosen.trace),
        "pixel": chosen.pixel, "words": read_words(chosen.language).tree,
    }  # fmt: skip
    answer = stops.ask(request, chosen.trace)
    if chosen.json:
        yield answer
        return
    for number, event in enumerate(json.loads(answer), start=1):
        numbers = f"\n     {event['numbers']}" if event["numbers"] else ""
        yield f"{number:>3}  {event['says']}{numbers}"
