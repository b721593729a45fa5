"""A quiz as a QTI 2.1 content package: an item a file, a test with a section for each lesson, a
manifest. Canvas, Moodle's and Ilias' plugins, TAO, OPAL and others import it.

Source: IMS Question & Test Interoperability 2.1, Information Model and XML Binding, 2012.
"""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape, quoteattr

from raywalk.teacher.quiz import Item

QTI = "http://www.imsglobal.org/xsd/imsqti_v2p1"
PACKAGING = "http://www.imsglobal.org/xsd/imscp_v1p1"
WHERE = (
    f'xmlns="{QTI}" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" '
    f'xsi:schemaLocation="{QTI} http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd"'
)
HEAD = '<?xml version="1.0" encoding="UTF-8"?>\n'
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
TEST = "test.xml"

Lessons = list[tuple[str, list[Item]]]  # title and items


def package(lessons: Lessons, course: str, language: str) -> Iterator[tuple[str, str]]:
    """Name and content of each file."""
    lessons = [(title, items) for title, items in lessons if items]
    yield "imsmanifest.xml", _manifest(lessons, language)
    yield TEST, _test(lessons, course, language)
    for _, items in lessons:
        for item in items:
            yield _place(item), item_xml(item, language)


def item_xml(item: Item, language: str) -> str:
    body = _choices(item) if item.options else _number(item)
    kind, right = ("identifier", _right(item)) if item.options else ("float", f"{item.value:.12g}")
    return (
        f"{HEAD}<assessmentItem {WHERE} identifier={quoteattr(item.id)} "
        f'title={quoteattr(item.title)} xml:lang="{language}" adaptive="false" '
        'timeDependent="false">\n'
        f'<responseDeclaration identifier="RESPONSE" cardinality="single" baseType="{kind}">'
        f"<correctResponse><value>{right}</value></correctResponse></responseDeclaration>\n"
        '<outcomeDeclaration identifier="SCORE" cardinality="single" baseType="float">'
        "<defaultValue><value>0</value></defaultValue></outcomeDeclaration>\n"
        '<outcomeDeclaration identifier="FEEDBACK" cardinality="single" baseType="identifier"/>\n'
        f"<itemBody>\n{body}</itemBody>\n{_processing(item)}{_feedback(item)}</assessmentItem>\n"
    )


def _right(item: Item) -> str:
    return next(mark for mark, each in zip(LETTERS, item.options, strict=False) if each.right)


def _choices(item: Item) -> str:
    rows = "".join(
        f'<simpleChoice identifier="{mark}">{escape(option.text)}</simpleChoice>\n'
        for mark, option in zip(LETTERS, item.options, strict=False)
    )
    return (
        '<choiceInteraction responseIdentifier="RESPONSE" shuffle="true" maxChoices="1">\n'
        f"<prompt>{escape(item.asks)}</prompt>\n{rows}</choiceInteraction>\n"
    )


def _number(item: Item) -> str:
    return (
        f"<p>{escape(item.asks)}</p>\n"
        '<p><textEntryInteraction responseIdentifier="RESPONSE" expectedLength="10"/></p>\n'
    )


def _processing(item: Item) -> str:
    """The template match_correct, or within a tolerance; and which feedback is shown."""
    both = '<variable identifier="RESPONSE"/><correct identifier="RESPONSE"/>'
    if item.options:
        test, shown = f"<match>{both}</match>", '<variable identifier="RESPONSE"/>'
        after = f'<setOutcomeValue identifier="FEEDBACK">{shown}</setOutcomeValue>\n'
    else:
        off = f"{item.tolerance:.12g}"
        mode = f'toleranceMode="absolute" tolerance="{off} {off}"' if item.tolerance else (
            'toleranceMode="exact"'
        )  # fmt: skip
        test, after = f"<equal {mode}>{both}</equal>", ""

    def score(value: int) -> str:
        base = f'<baseValue baseType="float">{value}</baseValue>'
        return f'<setOutcomeValue identifier="SCORE">{base}</setOutcomeValue>'

    return (
        f"<responseProcessing>\n<responseCondition><responseIf>{test}{score(1)}</responseIf>"
        f"<responseElse>{score(0)}</responseElse></responseCondition>\n{after}"
        "</responseProcessing>\n"
    )


def _feedback(item: Item) -> str:
    return "".join(
        f'<modalFeedback outcomeIdentifier="FEEDBACK" identifier="{mark}" showHide="show">'
        f"{escape(option.because)}</modalFeedback>\n"
        for mark, option in zip(LETTERS, item.options, strict=False)
        if option.because
    )


def _test(lessons: Lessons, course: str, language: str) -> str:
    sections = "".join(
        f'<assessmentSection identifier="section-{k}" title={quoteattr(title)} visible="true">\n'
        + "".join(
            f"<assessmentItemRef identifier={quoteattr(item.id)} href={quoteattr(_place(item))}/>\n"
            for item in items
        )
        + "</assessmentSection>\n"
        for k, (title, items) in enumerate(lessons, start=1)
    )
    return (
        f'{HEAD}<assessmentTest {WHERE} identifier="raywalk-{language}" '
        f"title={quoteattr(course)}>\n"
        '<testPart identifier="part-1" navigationMode="nonlinear" submissionMode="individual">\n'
        f"{sections}</testPart>\n</assessmentTest>\n"
    )


def _manifest(lessons: Lessons, language: str) -> str:
    items = [item for _, each in lessons for item in each]
    rows = "".join(
        f'<resource identifier="r-{item.id}" type="imsqti_item_xmlv2p1" href="{_place(item)}">'
        f'<file href="{_place(item)}"/></resource>\n'
        for item in items
    )
    needs = "".join(f'<dependency identifierref="r-{item.id}"/>' for item in items)
    return (
        f'{HEAD}<manifest xmlns="{PACKAGING}" identifier="raywalk-manifest-{language}">\n'
        "<metadata><schema>QTIv2.1 Package</schema><schemaversion>1.0.0</schemaversion>"
        "</metadata>\n<organizations/>\n<resources>\n"
        f'<resource identifier="r-test" type="imsqti_test_xmlv2p1" href="{TEST}">'
        f'<file href="{TEST}"/>{needs}</resource>\n{rows}</resources>\n</manifest>\n'
    )


def _place(item: Item) -> str:
    return f"items/{item.id}.xml"
