"""The commands. Only this file exits, and only it and terminal.py print."""

from __future__ import annotations

import argparse
import gc
import os
import sys
from importlib import import_module
from pathlib import Path

from raywalk.commands.terminal import Terminal
from raywalk.errors import UserError, disk_trouble, visible
from raywalk.home import HOME

# Every core has a scene or a strip of its own: numpy's linear algebra with threads besides took a
# third longer to write the trace files, and sums in another order give other last bits.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# A scene of thousands of objects makes many small things that stay: to look through them again and
# again for circles, of which there are none, took a tenth of its reading.
gc.set_threshold(100_000, 50, 50)

# A wheel that pip made of a checkout by itself has Python alone.
HOMELESS = """Raywalk's templates and words are not in {place}
  hint: install the wheel that `make package` writes into dist-package/"""

# Word on the command line -> its module in commands/. Only the one that runs is imported: what
# the others need takes longer than a build with nothing to do.
COMMANDS = {
    "new": "new",
    "site": "build_site",
    "build": "build_site",
    "check": "check",
    "model": "model",
    "inspect": "inspect",
    "probe": "probe",
    "pixel": "pixel",
    "compare": "compare",
    "slides": "slides",
    "serve": "serve",
    "kiosk": "kiosk",
    "teacher": "teacher",
    "bench": "bench",
    "stress": "stress",
}


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns its exit code: 0 done, 1 bad input, 2 wrong usage."""
    arguments = sys.argv[1:] if arguments is None else arguments
    if not (HOME / "site_src").is_dir():
        print(HOMELESS.format(place=HOME), file=sys.stderr)
        return 1
    chosen = _parser(arguments).parse_args(arguments)
    terminal = Terminal()
    try:
        for message in chosen.run(chosen):
            terminal.show(message)
    except UserError as problems:
        terminal.close()
        print(visible(str(problems)), file=sys.stderr)
        return 1
    except BrokenPipeError:
        return 1
    except OSError as trouble:
        terminal.close()
        print(visible(disk_trouble(trouble)), file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        terminal.close()
        print("\nstopped; the site is as it was before", file=sys.stderr)
        return 130
    finally:
        terminal.close()
    return 0


def _parser(arguments: list[str]) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="raywalk", description="Walk every ray.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    named = arguments[0] if arguments else ""
    wanted = [COMMANDS[named]] if named in COMMANDS else list(COMMANDS.values())
    for module in dict.fromkeys(wanted):  # some have two words
        import_module(f"raywalk.commands.{module}").add_to(commands)
    for command in dict.fromkeys(commands.choices.values()):
        command.add_argument(
            "--scenes", type=Path, default=Path("scenes"), help="folder of scene folders"
        )
    return parser


if __name__ == "__main__":
    sys.exit(main())
