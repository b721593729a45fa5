"""What was found about pictures, for people, for programs, and as test cases."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from xml.etree import ElementTree

from raywalk.scene.model import Scene
from raywalk.words import Words

BACKGROUND = -1  # in the place of an object
Titles = Mapping[str, str]  # what a mistake is called, by its name
STEPS = (1, 8, 32)  # of 255: the shares of check/compare.ts


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
    def wrong(self) -> float:
        """Share of the pixels further than rounding from the right ones."""
        return float(1 - self.found["comparison"]["within"][0])


def headline(report: Report, words: Words) -> str:
    """One sentence: what became of it."""
    if fault := report.found.get("fault"):
        return str(fault)
    if refusal := report.found.get("refusal"):
        return _refused(refusal, words)
    if report.is_right:
        is_exact = report.found["source"]["isExact"]
        return words.say("check.verdict.right" if is_exact else "check.verdict.nearly")
    return words.say("check.verdict.wrong", share=words.numbers.percent(report.wrong))


def _refused(refusal: dict[str, Any], words: Words) -> str:
    figures, key = refusal["figures"], f"check.verdict.{refusal['word']}"
    return words.say(key, **{slot: figures[slot] for slot in SLOTS[refusal["word"]]})


SLOTS = {"tall": ("width", "height"), "tiny": ("width", "height", "least")}


def as_text(scene: Scene, report: Report, words: Words, titles: Titles) -> str:
    """Several lines, as the page has them."""
    details = _details(scene, report, words, titles)
    return "\n".join([f"{report.file}: {headline(report, words)}", *details])


def _details(scene: Scene, report: Report, words: Words, titles: Titles) -> Iterator[str]:
    found, percent = report.found, words.numbers.percent
    if "comparison" not in found:
        return
    for note in _notes(found, words):
        yield f"  {note}"
    comparison = found["comparison"]
    for steps, share in zip(STEPS, comparison["within"], strict=True):
        yield f"  {words.say('check.how.within', steps=steps)}: {percent(share)}"
    for key, digits in (("mean", 2), ("largest", 0)):
        value = words.numbers.fixed(comparison[key], digits)
        steps_said = words.say("check.how.steps", value=value)
        yield f"  {words.say(f'check.how.{key}')}: {steps_said}"
    for told in found["where"]["told"]:
        yield f"  {_place(scene, told, words)}"
    if not report.is_right:
        yield from (f"  {line}" for line in _looks(found, words, titles))
    for tile in found["tiles"]:
        yield f"  {_tile(scene, tile, words)}"


def _notes(found: dict[str, Any], words: Words) -> Iterator[str]:
    square, source, comparison = found["square"], found["source"], found["comparison"]
    size = square["size"]
    if square["isCut"]:
        yield words.say("check.verdict.cut", size=size)
    if not source["isExact"]:
        yield words.say(
            "check.verdict.sampled", size=size, nearest=found["nearest"], **{"from": source["from"]}
        )
    if square["isLossy"]:
        yield words.say("check.verdict.lossy")
    if square["hadAlpha"]:
        yield words.say("check.verdict.alpha")
    if comparison["isTruncated"]:
        yield words.say("check.how.truncated")
    if comparison["fits"]:
        yield words.say(f"check.fits.{comparison['fits']['as']}")


def _place(scene: Scene, told: dict[str, Any], words: Words) -> str:
    percent, kind = words.numbers.percent, told["kind"]
    name = {"name": words.the(_name(scene, told["object"], words))} if kind == "object" else {}
    place = words.say(f"check.where.{kind}", **name)
    share, part = percent(told["ofWrong"]), percent(told["ofPicture"])
    return words.say("check.where.only", share=share, place=place, part=part)


def _name(scene: Scene, place: int, words: Words) -> str:
    is_background = place == BACKGROUND
    return words.say("check.where.backgroundName") if is_background else scene.objects[place].name


def _looks(found: dict[str, Any], words: Words, titles: Titles) -> Iterator[str]:
    if not found["answers"]:
        left = found["leftOut"]
        yield words.say(f"check.looks.left.{left}" if left else "check.looks.none")
        return
    yield words.say("check.looks.pair" if found["isPair"] else "check.looks.says")
    for answer in found["answers"]:
        named = " / ".join(f"{titles[name]} ({name})" for name in answer["names"])
        share = words.numbers.percent(answer["agreement"])
        yield f"- {named}: {words.say('check.looks.agree', share=share)}"


def _tile(scene: Scene, tile: dict[str, Any], words: Words) -> str:
    where = {"x": tile["x"], "y": tile["y"], "n": tile["n"]}
    colours = {"yours": tile["own"], "right": tile["right"]}
    said = {key: words.numbers.listed(map(str, bytes_)) for key, bytes_ in colours.items()}
    place = words.say("check.walk.pixel", name=_name(scene, tile["object"], words), **where)
    return f"{place}: {words.say('check.walk.colours', **said)}"


def as_table(reports: Sequence[Report], words: Words) -> str:
    """A line a picture: what became of it, and the mistake it looks like most."""
    wide = max(len(report.file) for report in reports)
    lines = [f"{report.file:{wide}}  {_line(report, words)}" for report in reports]
    return "\n".join(lines)


def _line(report: Report, words: Words) -> str:
    said = headline(report, words)
    answers = report.found.get("answers")
    return f"{said} {', '.join(answers[0]['names'])}" if answers else said


def as_json(scene: Scene, reports: Sequence[Report]) -> str:
    """{"scene", "pictures": [{"file", "isRight", ...}]}: all that is known."""
    pictures = [
        {"file": report.file, "isRight": report.is_right, **report.found} for report in reports
    ]
    return json.dumps({"scene": scene.id, "pictures": pictures}, ensure_ascii=False, indent=1)


def as_junit(scene: Scene, reports: Sequence[Report], words: Words, titles: Titles) -> str:
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
        trouble = ElementTree.SubElement(case, kind, message=headline(report, words))
        trouble.text = as_text(scene, report, words, titles)
    ElementTree.indent(suite)
    head = '<?xml version="1.0" encoding="UTF-8"?>\n'
    return head + ElementTree.tostring(suite, encoding="unicode")
