"""A strict reader of GIFT by Moodle's documented rules: what is not allowed is refused."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

MARKS = "~=#{}:"


class NotGift(ValueError):
    """What is wrong."""


@dataclass
class Answer:
    text: str
    weight: float
    feedback: str = ""


@dataclass
class Question:
    category: str
    title: str
    text: str
    answers: list[Answer] = field(default_factory=list)
    number: tuple[float, float] | None = None  # value and tolerance
    feedback: str = ""


def read(source: str) -> list[Question]:
    """Blank lines part questions; lines that begin with // are comments."""
    category, questions = "", []
    for block in re.split(r"\n[ \t]*\n", source.strip()):
        lines = [line for line in block.splitlines() if not line.lstrip().startswith("//")]
        text = "\n".join(lines).strip()
        if text.startswith("$CATEGORY:"):
            category = text.removeprefix("$CATEGORY:").strip()
            if "\n" in category:
                raise NotGift(f"a category stands alone: {text}")
        elif text:
            questions.append(_question(text, category))
    return questions


def _split(text: str, mark: str) -> list[str]:
    """At marks that no backslash stands before."""
    return re.split(rf"(?<!\\)(?:\\\\)*{re.escape(mark)}", text)


def plain(text: str) -> str:
    """Without backslashes; a mark without one is refused, as is a backslash before anything
    else."""
    out, k = "", 0
    text = text.strip()
    while k < len(text):
        if text[k] == "\\":
            if k + 1 == len(text) or text[k + 1] not in MARKS + "\\n":
                raise NotGift(f"a lone backslash in {text!r}")
            out += "\n" if text[k + 1] == "n" else text[k + 1]
            k += 2
            continue
        if text[k] in MARKS:
            raise NotGift(f"{text[k]!r} stands bare in {text!r}")
        out += text[k]
        k += 1
    return out


def _question(text: str, category: str) -> Question:
    found = re.fullmatch(
        r"::((?:[^:\\]|\\.)+)::\[plain\]((?:[^{\\]|\\.)+)\{(.*)\}", text, re.DOTALL
    )
    if not found:
        raise NotGift(f"no question: {text!r}")
    title, asks, inside = found.groups()
    inside, *after = re.split(r"(?<!\\)####", inside)
    question = Question(category, plain(title), plain(asks), feedback="".join(map(plain, after)))
    inside = inside.strip()
    if inside.startswith("#"):
        number = re.fullmatch(r"#(-?\d+(?:\.\d+)?):(\d+(?:\.\d+)?)", inside)
        if not number:
            raise NotGift(f"no number: {inside!r}")
        question.number = (float(number[1]), float(number[2]))
        return question
    if "->" in inside:
        raise NotGift("an arrow makes pairs to match of a choice")
    for part in re.findall(r"[~=](?:[^~=\\]|\\.)*", inside):
        answer, *told = re.split(r"(?<!\\)#", part[1:])
        if len(told) > 1:
            raise NotGift(f"two feedbacks: {part!r}")
        question.answers.append(
            Answer(plain(answer), 1.0 if part[0] == "=" else 0.0, "".join(map(plain, told)))
        )
    if sum(answer.weight for answer in question.answers) != 1.0:
        raise NotGift(f"not one right answer: {text!r}")
    return question
