"""The commands. Only this file prints and exits."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from raywalk.bench.cases import BrokenBounds
from raywalk.commands import bench, build_site, check, inspect, pixel, probe, serve, stress
from raywalk.errors import SourceErrors


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns its exit code: 0 done, 1 bad input, 2 wrong usage."""
    chosen = _parser().parse_args(arguments)
    try:
        for line in chosen.run(chosen):
            print(line, flush=True)
    except (SourceErrors, BrokenBounds) as problems:
        print(problems, file=sys.stderr)
        return 1
    except BrokenPipeError:
        return 1
    except KeyboardInterrupt:
        print("\nstopped; the site is as it was before", file=sys.stderr)
        return 130
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="raywalk", description="Walk every ray.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for module in (build_site, check, inspect, probe, pixel, serve, bench, stress):
        module.add_to(commands)
    for command in commands.choices.values():
        command.add_argument(
            "--scenes", type=Path, default=Path("scenes"), help="folder of scene folders"
        )
    return parser


if __name__ == "__main__":
    sys.exit(main())
