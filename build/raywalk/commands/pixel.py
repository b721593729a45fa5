"""raywalk pixel: one pixel's colour and whole ray tree, without a build."""

from __future__ import annotations

import argparse
import json
import sys
from argparse import Namespace
from collections.abc import Iterator
from typing import Any

from raywalk.commands.check import scene_file
from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.read import read_scene

MOST_BOUNCES = 1000
LARGEST = 100_000  # pixels a side


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("pixel", help="one pixel's ray tree")
    parser.add_argument("scene", help="a scene file, folder or id")
    parser.add_argument("--size", type=picture_size, required=True, help="N or WxH pixels")
    parser.add_argument("--at", type=place, required=True, help="I,J: column, row from top left")
    parser.add_argument("--depth", type=bounces, help="bounces at most; the scene's if left out")
    parser.add_argument("--json", action="store_true", help="everything, as JSON")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """The tree as indented text, or as one JSON object."""
    from raywalk.trace.pixel_tree import as_text, pixel_tree

    (width, height), (column, row) = chosen.size, chosen.at
    scene = read_scene(scene_file(chosen.scene, chosen.scenes))
    if column >= width or row >= height:
        message = f"pixel {column},{row} is outside a picture of {width} x {height}"
        allowed = f"columns 0 to {width - 1}, rows 0 to {height - 1}, from the top left"
        raise SourceErrors([SourceError(scene.path, "--at", message, allowed=allowed)])
    answer = pixel_tree(scene, width, height, column, row, chosen.depth)
    # A path of 1000 bounces is as many objects inside one another.
    sys.setrecursionlimit(max(sys.getrecursionlimit(), 20 * MOST_BOUNCES))
    yield json.dumps(answer, allow_nan=False) if chosen.json else as_text(answer)


def picture_size(text: str) -> tuple[int, int]:
    """ "640" or "640x480" as (width, height)."""
    parts = text.lower().split("x")
    sides = [int(part) for part in parts if part.isascii() and part.isdigit()]
    if len(sides) != len(parts) or len(parts) > 2 or not all(0 < s <= LARGEST for s in sides):
        raise argparse.ArgumentTypeError(f"{text!r} is not N or WxH, each 1 to {LARGEST}")
    return sides[0], sides[-1]


def place(text: str) -> tuple[int, int]:
    """ "7,9" as (column, row)."""
    parts = [part.strip() for part in text.split(",")]
    if len(parts) != 2 or not all(part.isascii() and part.isdigit() for part in parts):
        raise argparse.ArgumentTypeError(f"{text!r} is not I,J, two whole numbers from 0")
    return int(parts[0]), int(parts[1])


def bounces(text: str) -> int:
    """A bounce limit."""
    if not (text.isascii() and text.isdigit() and int(text) <= MOST_BOUNCES):
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 0 to {MOST_BOUNCES}")
    return int(text)
