"""What a runner's output gives as the cause of each failure: its name and what it said first."""

from __future__ import annotations

import re
from collections.abc import Iterator

#: Characters of one cause: the end of a log is read by eye.
ENOUGH = 300
#: A test of TAP's, not its file, and what follows it between --- and ... one step further in.
TAP = re.compile(
    r"^(?P<inset> *)not ok \d+ - (?P<name>(?!.*\.test\.mjs$).*)\n"
    r"(?P<block>(?:(?P=inset) .*\n|\s*\n)*)",
    re.MULTILINE,
)
#: A group of tests only says that one of them failed, which then is a cause of its own.
OF_OTHERS = re.compile(r"failureType: '(?:subtestsFailed|cancelledByParent)'")
ERROR = re.compile(
    r"^(?P<inset> *)error: (?:\|-?\n(?P<long>(?:(?P=inset) .*\n|\s*\n)*)|(?P<short>.*))",
    re.MULTILINE,
)
PLACE = re.compile(r"([\w-]+\.test\.mjs:\d+)")
#: pytest's headline of one failed test, and its summary at the end.
HEADLINE = re.compile(r"^_{3,} (?:ERROR at \w+ of )?(\S+) _{3,}$", re.MULTILINE)
SUMMARY = re.compile(r"^(?:FAILED|ERROR) ([^\s:]+)(?:::(\S+))?", re.MULTILINE)
SAID = re.compile(r"^E +(.*)", re.MULTILINE)
#: A check's: mypy, tsc.
CHECKED = re.compile(r"^.*: error\b.*", re.MULTILINE)
#: Where no test is named the whole run failed.
OF_ALL = re.compile(r"^.*\b\w*(?:Error|ERROR)\b.*", re.MULTILINE)


def causes(output: str) -> tuple[str, ...]:
    """Of what failed. What names no failure it can read gives its first error, or its last line."""
    found = (*_of_tap(output), *_of_pytest(output), *CHECKED.findall(output))
    if found:
        return found
    first = OF_ALL.search(output)
    last = [line for line in output.splitlines() if line.strip()][-1:]
    return (_short(first[0]),) if first else tuple(map(_short, last))


def _of_tap(output: str) -> Iterator[str]:
    for failed in TAP.finditer(output):
        block = failed["block"]
        if OF_OTHERS.search(block):
            continue
        error = ERROR.search(block)
        said = (error["long"] or error["short"] or "").strip("'\"") if error else ""
        place = PLACE.search(block.partition("stack:")[2]) or PLACE.search(block)
        yield f"{failed['name']}: {_short(said)}" + (f" ({place[1]})" if place else "")


def _of_pytest(output: str) -> Iterator[str]:
    """Its summary names files but cuts what was said; the sections above it tell both."""
    _, *parts = HEADLINE.split(output)
    said: dict[str, list[str]] = {}
    for name, section in zip(parts[::2], parts[1::2], strict=True):
        said.setdefault(name, []).append(_short("\n".join(SAID.findall(section))))
    for path, name in SUMMARY.findall(output):
        here = said.get(name.replace("::", "."))
        yield f"{path}::{name}: {here.pop(0)}" if here else f"{path}::{name}".rstrip(":")


def _short(text: str) -> str:
    """In one line."""
    line = " ".join(text.split())
    return line if len(line) <= ENOUGH else f"{line[:ENOUGH]} ..."
