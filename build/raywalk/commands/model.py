"""raywalk model: what a model file holds, what was done to make it fit, where it is open."""

from __future__ import annotations

import json
from argparse import ArgumentTypeError, Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.errors import SourceError, SourceErrors, UserError


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("model", help="what a model file holds")
    parser.add_argument(
        "file", type=Path, help="a .obj, .stl, .ply, .off, .gltf, .glb or .3mf file"
    )
    parser.add_argument("--json", action="store_true", help="everything, as JSON")
    parser.add_argument(
        "--picture", type=Path, metavar="FILE.png", help="draw it from three sides, open edges red"
    )
    parser.add_argument(
        "--weld", type=share, help="join corners of open edges nearer than this share of its size"
    )
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """A line each, or one JSON object. Raises UserError with the sentence that helps."""
    from raywalk.models.clean import clean
    from raywalk.models.faults import ModelFault
    from raywalk.models.read import read_model
    from raywalk.models.report import report
    from raywalk.models.telling import in_full
    from raywalk.optics.heap import hand_back_freed_memory

    hand_back_freed_memory()
    try:
        cleaned = clean(read_model(chosen.file), chosen.weld)
    except ModelFault as fault:
        raise UserError(str(fault)) from None
    facts = report(cleaned)
    if chosen.json:
        yield json.dumps(facts, allow_nan=False)
    else:
        yield from in_full(facts)
    if chosen.picture:
        from raywalk.models.picture import draw

        try:
            draw(cleaned, chosen.picture)
        except (OSError, ValueError) as problem:
            error = SourceError(chosen.picture, "--picture", f"cannot be written ({problem})")
            raise SourceErrors([error]) from None
        if not chosen.json:
            yield f"  picture: {chosen.picture}"


def share(text: str) -> float:
    """A number from 0 to 0.1."""
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0.0 <= value <= 0.1:
        raise ArgumentTypeError(f"{text!r} is not a number from 0 to 0.1")
    return value
