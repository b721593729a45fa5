"""raywalk inspect: one pixel's ray tree out of a built trace file."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.commands.pixel import place
from raywalk.errors import SourceError, SourceErrors


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("inspect", help="one pixel's ray tree out of a trace file")
    parser.add_argument("trace", type=Path, help="<n>.js or <n>.json.gz of a built scene")
    parser.add_argument("--pixel", type=place, required=True, help="I,J: column, row from top left")
    parser.add_argument("--json", action="store_true", help="everything, as JSON")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """The tree as indented text, or as one JSON object with every stored number."""
    from raywalk.trace_file import TraceFileError, read_trace
    from raywalk.trace_file.inspect import as_json, describe

    try:
        trace = read_trace(chosen.trace)
        if chosen.json:
            yield json.dumps(as_json(trace, chosen.pixel), allow_nan=False)
        else:
            yield describe(trace, chosen.pixel)
    except OSError as problem:
        message = f"cannot be read ({problem.strerror})"
        raise SourceErrors([SourceError(chosen.trace, "", message)]) from None
    except TraceFileError as problem:
        raise SourceErrors([SourceError(chosen.trace, "", str(problem))]) from None
