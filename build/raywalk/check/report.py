"""What was found about pictures, for people, for programs, and as test cases.

The sentences come from site_src/check/report.ts, as on the page check/.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from xml.etree import ElementTree

from raywalk.scene.model import Scene


@dataclass(frozen=True)
class Report:
    """file: as it was named. found: what site_src/check.mjs answers to "check"."""

    file: str
    found: dict[str, Any]

    @property
    def is_right(self) -> bool:
        """False for a file that could not be compared."""
        return bool(self.found.get("isRight"))

    @property
    def headline(self) -> str:
        """One sentence: what became of it."""
        return str(self.found["written"][0])


def as_text(report: Report) -> str:
    """Several lines, as the page has them."""
    first, *others = report.found["written"]
    return "\n".join([f"{report.file}: {first}", *(f"  {line}" for line in others)])


def as_table(reports: Sequence[Report]) -> str:
    """A line a picture: what became of it, and the mistake it looks like most."""
    wide = max(len(report.file) for report in reports)
    return "\n".join(f"{report.file:{wide}}  {_line(report)}" for report in reports)


def _line(report: Report) -> str:
    answers = report.found.get("answers")
    return f"{report.headline} {', '.join(answers[0]['names'])}" if answers else report.headline


def as_json(scene: Scene, reports: Sequence[Report]) -> str:
    """{"scene", "pictures": [{"file", "isRight", ...}]}: all that is known."""
    pictures = [
        {"file": report.file, "isRight": report.is_right, **report.found} for report in reports
    ]
    return json.dumps({"scene": scene.id, "pictures": pictures}, ensure_ascii=False, indent=1)


def as_junit(scene: Scene, reports: Sequence[Report]) -> str:
    """A test suite; a picture that is not right is a failure, one that cannot be read an error."""
    failed = [report for report in reports if not report.is_right]
    errors = [report for report in failed if "comparison" not in report.found]
    counts = {"tests": len(reports), "failures": len(failed) - len(errors), "errors": len(errors)}
    about = {"name": f"raywalk {scene.id}"} | {key: str(count) for key, count in counts.items()}
    suite = ElementTree.Element("testsuite", about)
    for report in reports:
        case = ElementTree.SubElement(suite, "testcase", classname=scene.id, name=report.file)
        if report not in failed:
            continue
        kind = "error" if report in errors else "failure"
        trouble = ElementTree.SubElement(case, kind, message=report.headline)
        trouble.text = as_text(report)
    ElementTree.indent(suite)
    head = '<?xml version="1.0" encoding="UTF-8"?>\n'
    return head + ElementTree.tostring(suite, encoding="unicode")
