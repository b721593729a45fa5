"""The node process that runs the viewer's modules over built scenes: site_src/stops.mjs."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path
from types import TracebackType
from typing import Any

from raywalk.errors import SourceError, SourceErrors
from raywalk.home import HOME
from raywalk.node import MISSING, node_program

SCRIPT = HOME / "site_src" / "stops.mjs"
ANSWER, FAULT = '{"answer":', '{"fault":'


class Stops:
    """Answers requests as long as it is open; node starts with the first of them.

    script: stops.mjs, or another that answers lines in its way.
    """

    def __init__(self, script: Path = SCRIPT) -> None:
        self._script = script
        self._node: subprocess.Popen[str] | None = None

    def __enter__(self) -> Stops:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:  # fmt: skip
        if self._node:
            self._node.communicate()  # closes its input, at whose end it ends

    def ask(self, request: dict[str, Any], about: Path | None = None) -> str:
        """The answer as JSON text; requests are those that stops.mjs names.

        Raises SourceErrors if node or a package is missing, or the request cannot be followed:
        then they name the file that it is about.
        """
        node = self._node = self._node or self._started()
        assert node.stdin and node.stdout and node.stderr
        try:
            node.stdin.write(json.dumps(request) + "\n")
            node.stdin.flush()
        except BrokenPipeError:
            pass  # it ended: there is no answer either
        line = node.stdout.readline().rstrip("\n")
        if line.startswith(ANSWER):
            return line[len(ANSWER) : -1]
        if line.startswith(FAULT):
            raise _problem(json.loads(line)["fault"], about)
        said = node.stderr.read()
        cause = re.search(r"^\w*Error.*$", said, re.MULTILINE)
        raise _problem(
            f"node ended: {cause[0] if cause else said}\n  are its packages there? npm ci"
        )

    def _started(self) -> subprocess.Popen[str]:
        if not (node := node_program()):
            raise _problem(MISSING)
        return subprocess.Popen(
            [node, str(self._script)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, encoding="utf-8",
        )  # fmt: skip


def _problem(message: str, file: Path | None = None) -> SourceErrors:
    return SourceErrors([SourceError(file or SCRIPT, "", message)])
