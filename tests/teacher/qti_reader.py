"""QTI 2.1: what the specification demands of an item's XML, and what a response scores."""

from __future__ import annotations

import xml.etree.ElementTree as ET

NS = "{http://www.imsglobal.org/xsd/imsqti_v2p1}"
# Children of an assessmentItem in the schema's order.
ORDER = ["responseDeclaration", "outcomeDeclaration", "templateDeclaration", "templateProcessing",
         "stylesheet", "itemBody", "responseProcessing", "modalFeedback"]  # fmt: skip
# Attributes that an element must have, and that it may.
ATTRIBUTES = {
    "assessmentItem": ({"identifier", "title", "adaptive", "timeDependent"}, {"lang"}),
    "responseDeclaration": ({"identifier", "cardinality", "baseType"}, set()),
    "outcomeDeclaration": ({"identifier", "cardinality"}, {"baseType"}),
    "correctResponse": (set(), set()), "defaultValue": (set(), set()), "value": (set(), set()),
    "itemBody": (set(), set()), "p": (set(), set()), "prompt": (set(), set()),
    "choiceInteraction": ({"responseIdentifier", "shuffle", "maxChoices"}, {"minChoices"}),
    "simpleChoice": ({"identifier"}, {"fixed"}),
    "textEntryInteraction": ({"responseIdentifier"}, {"expectedLength"}),
    "responseProcessing": (set(), {"template"}), "responseCondition": (set(), set()),
    "responseIf": (set(), set()), "responseElse": (set(), set()), "match": (set(), set()),
    "equal": ({"toleranceMode"}, {"tolerance"}), "variable": ({"identifier"}, set()),
    "correct": ({"identifier"}, set()), "setOutcomeValue": ({"identifier"}, set()),
    "baseValue": ({"baseType"}, set()),
    "modalFeedback": ({"outcomeIdentifier", "identifier", "showHide"}, {"title"}),
}  # fmt: skip
CHILDREN = {
    "choiceInteraction": {"prompt", "simpleChoice"}, "itemBody": {"choiceInteraction", "p"},
    "p": {"textEntryInteraction"}, "responseDeclaration": {"correctResponse"},
    "correctResponse": {"value"}, "outcomeDeclaration": {"defaultValue"},
    "defaultValue": {"value"}, "responseCondition": {"responseIf", "responseElse"},
    "responseProcessing": {"responseCondition", "setOutcomeValue"},
    "responseIf": {"match", "equal", "setOutcomeValue"}, "responseElse": {"setOutcomeValue"},
    "match": {"variable", "correct"}, "equal": {"variable", "correct"},
    "setOutcomeValue": {"baseValue", "variable"}, "assessmentItem": set(ORDER),
}  # fmt: skip


def local(element: ET.Element) -> str:
    assert element.tag.startswith(NS), element.tag
    return element.tag.removeprefix(NS)


def check_item(item: ET.Element) -> None:
    """Elements, their order, attributes, and that what is referred to is declared."""
    assert local(item) == "assessmentItem"
    places = [ORDER.index(local(child)) for child in item]
    assert places == sorted(places), "children in the schema's order"
    declared = {e.get("identifier") for e in item if local(e).endswith("Declaration")}
    for element in item.iter():
        name = local(element)
        must, may = ATTRIBUTES[name]
        has = {key.rpartition("}")[2] for key in element.attrib} - {"schemaLocation"}
        assert must <= has <= must | may, (name, has)
        assert {local(child) for child in element} <= CHILDREN.get(name, set()), name
        for key in ("responseIdentifier", "outcomeIdentifier"):
            assert element.get(key) in declared | {None}
        if name in ("variable", "correct", "setOutcomeValue"):
            assert element.get("identifier") in declared


def score(item: ET.Element, response: str) -> tuple[float, str]:
    """SCORE, and the feedback that is shown, by the item's own response processing."""
    kind = item.find(f"{NS}responseDeclaration").get("baseType")  # type: ignore[union-attr]
    right = item.findtext(f"{NS}responseDeclaration/{NS}correctResponse/{NS}value", "")
    values = {"SCORE": "0", "FEEDBACK": "", "RESPONSE": response}
    for rule in item.find(f"{NS}responseProcessing") or ():
        if local(rule) == "setOutcomeValue":
            _set(rule, values)
            continue
        branches = list(rule)
        test = branches[0][0]
        taken = branches[0][1:] if _holds(test, kind, right, response) else branches[1]
        for each in taken:
            _set(each, values)
    shown = [
        each.text or "" for each in item.iter(f"{NS}modalFeedback")
        if each.get("identifier") == values["FEEDBACK"]
    ]  # fmt: skip
    return float(values["SCORE"]), "".join(shown)


def _holds(test: ET.Element, kind: str | None, right: str, response: str) -> bool:
    if local(test) == "match":
        return right == response
    assert kind == "float"
    if test.get("toleranceMode") == "exact":
        return float(response) == float(right)
    low, high = map(float, (test.get("tolerance") or "").split())
    return float(right) - low <= float(response) <= float(right) + high


def _set(rule: ET.Element, values: dict[str, str]) -> None:
    [of] = rule
    name = rule.get("identifier") or ""
    values[name] = of.text or "" if local(of) == "baseValue" else values[of.get("identifier") or ""]
