"""Where a lesson is live: its page, step by step, as one page of links."""

from __future__ import annotations

from html import escape

from raywalk.scene.model import Scene
from raywalk.slides.addresses import address, step_address
from raywalk.slides.lesson_words import plain_text, title_and_body, words_and_pictures
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import say, words


def links_page(lessons: list[Lesson], base: str) -> str:
    """HTML with nothing beside it."""
    title, code = say("teacher.links"), words().code
    parts = [
        f'<!doctype html>\n<html lang="{code}">\n<meta charset="utf-8">\n'
        f"<title>{escape(title)}</title>\n<h1>{escape(title)}</h1>",
    ]
    if not base:
        parts.append(f"<p>{escape(say('teacher.linksBelow'))}</p>")
    for lesson in lessons:
        scene = lesson.scene
        parts.append(f"<h2>{_link(address(scene, base=base), scene.title)}</h2>\n<ol>")
        for stop in lesson.stops:
            said = _head(scene, stop.step)
            there = step_address(scene, stop.step, stop.kind == "answer", base)
            if stop.kind == "answer":
                parts.append(f"<ul><li>{_link(there, say('teacher.answer'))}</li></ul>")
            else:
                parts.append(f'<li value="{stop.step + 1}">{_link(there, said)}</li>')
        parts.append("</ol>")
    return "\n".join([*parts, "</html>\n"])


LONGEST = 74  # letters of a link: a longer first sentence is told whole


def _head(scene: Scene, step: int) -> str:
    told = scene.lesson[step]
    if told.headline:
        return plain_text(told.headline)
    paragraphs, _ = words_and_pictures(told.text)
    head, _ = title_and_body(paragraphs, lambda sentence: len(sentence) <= LONGEST)
    return head or plain_text(told.text)


def _link(there: str, said: str) -> str:
    return f'<a href="{escape(there)}">{escape(said)}</a>'
