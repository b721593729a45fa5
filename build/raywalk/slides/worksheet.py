"""A worksheet: questions whose answers the trace knows, and the sheet with the answers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Triple
from raywalk.slides.blocks import flow, flow_texts, one_line, text
from raywalk.slides.figure import Deck, Item, Line, Run, Slide, Text
from raywalk.slides.handout import A4
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph, plain_text
from raywalk.slides.sights import Seen
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import number, say, vector, words
from raywalk.trace_file import DecodedTrace, Kind, Visibility
from raywalk.words.catalogue import find, slots_of

SIZE = 12.0
HEAD = 20.0
MARGIN = 54.0
BOTTOM = 50.0
ANSWER_LINES = 2
LINE = 24.0
GAP = 12.0
FOOT = 11.0
COUNT = 60.0  # kept for the sheet's number at the foot


@dataclass(frozen=True)
class Question:
    asks: str
    answer: str


def worksheet(lesson: Lesson, with_answers: bool) -> Deck:
    """A4 pages: what stands where, the questions, lines to write on or the answers."""
    scene = lesson.placed.scene
    key = "slides.answersTitle" if with_answers else "slides.worksheetTitle"
    title = say(key, title=scene.title)
    blocks = [_given(scene)]
    for k, question in enumerate(questions(lesson), start=1):
        blocks.append(_block(k, question, with_answers))
    return Deck(scene.id, title, *A4, tuple(_numbered(_pages(title, blocks))), words().code)


def questions(lesson: Lesson) -> list[Question]:
    """From the trace of the lesson's first grid, and the lesson's own."""
    scene = lesson.placed.scene
    asked: list[Question] = []
    as_traced = [seen for seen in lesson.seen if not seen.view.switches.is_set]
    if as_traced:
        trace = as_traced[0].trace
        pixels = _pixels(as_traced, trace)
        for ask in (_nearest, _order, _shadow, _sent_on, _eight_bit):
            asked += ask(scene, trace, pixels)
    return asked + [
        Question(plain_text(step.text), plain_text(step.answer))
        for step in scene.lesson
        if step.answer
    ]


def _pixels(seen: list[Seen], trace: DecodedTrace) -> list[int]:
    """All pixels, those that the lesson walks first, then spread over the picture."""
    n = trace.n
    walked = [each.view.index for each in seen if each.view.n == n and each.chosen]
    # A step that has no common factor with n * n visits every pixel, far from the last one.
    step = next(k for k in range(int(n * n * 0.381966), n * n + 1) if np.gcd(k, n * n) == 1)
    return list(dict.fromkeys([*walked, *(k * step % (n * n) for k in range(n * n))]))


def _name(scene: Scene, trace: DecodedTrace, ray: int) -> str:
    return scene.objects[int(trace.object[ray])].name


def _at(pixel: int, n: int) -> dict[str, int]:
    return {"x": pixel % n, "y": pixel // n, "n": n}


def _nearest(scene: Scene, trace: DecodedTrace, pixels: list[int]) -> Iterator[Question]:
    """Three rays that meet different things, one of which may be nothing."""
    met: list[int] = []
    for pixel in pixels:
        thing = int(trace.object[pixel])
        if thing in met or len(met) == 3:
            continue
        met.append(thing)
        asks = say("slides.askNearest", **_at(pixel, trace.n))
        if thing < 0:
            yield Question(asks, say("slides.answerLeaves"))
            continue
        t, point = number(float(trace.t[pixel])), vector(trace.point[pixel].tolist())
        answer = say("slides.answerNearest", name=scene.objects[thing].name, t=t, point=point)
        yield Question(asks, answer)


def _order(scene: Scene, trace: DecodedTrace, pixels: list[int]) -> Iterator[Question]:
    for pixel in pixels:
        hits = range(int(trace.hitsStart[pixel]), int(trace.hitsStart[pixel + 1]))
        if len({int(trace.hitsObject[k]) for k in hits}) > 1:
            told = [
                say(
                    "event.meetsFirst.hit",
                    name=scene.objects[int(trace.hitsObject[k])].name,
                    t=number(float(trace.hitsT[k])),
                )
                for k in hits
            ]
            yield Question(say("slides.askOrder", **_at(pixel, trace.n)), "; ".join(told))
            return


def _shadow(scene: Scene, trace: DecodedTrace, pixels: list[int]) -> Iterator[Question]:
    """A light that is blocked, and one that arrives."""
    for wanted in (Visibility.BLOCKED, Visibility.REACHED):
        for pixel in pixels:
            lights = np.flatnonzero(trace.visibility[pixel] == wanted)
            if trace.object[pixel] < 0 or not len(lights):
                continue
            k = int(lights[0])
            light, name = scene.lights[k].name, _name(scene, trace, pixel)
            asks = say("slides.askShadow", light=light, name=name, **_at(pixel, trace.n))
            if wanted == Visibility.REACHED:
                yield Question(asks, say("slides.answerArrives"))
            else:
                by = scene.objects[int(trace.blocker[pixel, k])].name
                yield Question(asks, say("slides.answerBlocked", name=by))
            break


def _sent_on(scene: Scene, trace: DecodedTrace, pixels: list[int]) -> Iterator[Question]:
    """The first reflected and the first refracted ray that meets something."""
    for kind in (Kind.REFLECTED, Kind.REFRACTED):
        for pixel in pixels:
            sent = np.flatnonzero((trace.parent == pixel) & (trace.kind == kind))
            if not len(sent) or trace.object[sent[0]] < 0:
                continue
            ray = int(sent[0])
            word = kind.name.title()
            name = _name(scene, trace, pixel)
            asks = say(f"slides.ask{word}", name=name, **_at(pixel, trace.n))
            t, point = number(float(trace.t[ray])), vector(trace.point[ray].tolist())
            name = _name(scene, trace, ray)
            yield Question(asks, say("slides.answerNearest", name=name, t=t, point=point))
            break


def _eight_bit(scene: Scene, trace: DecodedTrace, pixels: list[int]) -> Iterator[Question]:
    for pixel in pixels:
        colour = trace.colour[pixel].tolist()
        if len({round(c, 2) for c in colour}) > 1:
            asks = say("slides.askBytes", colour=vector(colour), **_at(pixel, trace.n))
            tile = trace.tiles[3 * pixel : 3 * pixel + 3].tolist()
            yield Question(asks, say("slides.answerBytes", bytes=", ".join(map(str, tile))))
            return


def _given(scene: Scene) -> tuple[list[Item], float]:
    """What one needs to know of the scene to work it out."""
    told = [say("slides.givenCamera", eye=vector(scene.camera.eye),
                target=vector(scene.camera.target), fov=f"{scene.camera.fov:g}")]  # fmt: skip
    told += [f"{obj.name}: {shape_words(obj)}" for obj in scene.objects]
    told += [
        say("slides.givenLight", light=light.name, at=vector(light.position))
        for light in scene.lights
    ]
    points = [Paragraph((Run(say("slides.given"), bold=True),))]
    points += [Paragraph((Run(each),), "•") for each in told]
    return _flowed(points)


def shape_words(obj: SceneObject) -> str:
    """A shape in its own coordinates; the transform, if it has one, is only named."""
    word = obj.shape.word
    slots = slots_of(find(words().tree, f"slides.shape.{word}"))
    numbers = {slot: _written(getattr(obj.shape, slot)) for slot in slots}
    shape = say(f"slides.shape.{word}", **numbers)
    moved = not np.array_equal(obj.transform, np.eye(4))
    return say("slides.moved", shape=shape) if moved else shape


def _written(value: str | float | Triple) -> str:
    if isinstance(value, str):
        return value
    return number(value) if isinstance(value, float | int) else vector(value)


def _block(count: int, question: Question, with_answers: bool) -> tuple[list[Item], float]:
    items, high = _flowed([Paragraph((Run(question.asks),), f"{count}.")])
    if with_answers:
        answer, more = _flowed([Paragraph((Run(question.answer, bold=True),))], indent=20.0)
        return items + [_moved(item, high + 4) for item in answer], high + 4 + more
    wide = A4[0] - 2 * MARGIN
    lines: list[Item] = [
        Line((20.0, high + k * LINE), (wide, high + k * LINE), "rule", 0.75, name="answer")
        for k in range(1, ANSWER_LINES + 1)
    ]
    return items + lines, high + ANSWER_LINES * LINE


def _flowed(points: list[Paragraph], indent: float = 0.0) -> tuple[list[Item], float]:
    """Items from (0, 0) down, and their height."""
    wide = A4[0] - 2 * MARGIN - indent
    whole = flow(points, SIZE, wide)
    return flow_texts(whole, Box(indent, 0, wide, whole.height())), whole.height()


def _pages(title: str, blocks: list[tuple[list[Item], float]]) -> Iterator[Slide]:
    """Blocks one under the other, the first ones under the title."""
    for k, page in enumerate(_parted(blocks)):
        items, top = ([], MARGIN) if k else (_heading(title), MARGIN + HEAD * 1.6)
        for block, high in page:
            items += [_moved(item, top, MARGIN) for item in block]
            top += high + GAP
        yield Slide(title, tuple(items), kind="worksheet")


def _parted(blocks: list[tuple[list[Item], float]]) -> list[list[tuple[list[Item], float]]]:
    """Pages: a block that does not fit begins the next; the last one takes one along rather than
    stand alone."""
    pages, top = [[blocks[0]]], MARGIN + HEAD * 1.6 + blocks[0][1] + GAP
    for block in blocks[1:]:
        if top + block[1] > A4[1] - BOTTOM:
            pages.append([])
            top = MARGIN
        pages[-1].append(block)
        top += block[1] + GAP
    if len(pages) > 1 and len(pages[-1]) == 1 and len(pages[-2]) > 2:
        pages[-1].insert(0, pages[-2].pop())
    return pages


def _numbered(pages: Iterable[Slide]) -> list[Slide]:
    """Where there are several, each says at its foot which one it is: copied sheets get apart."""
    sheets = list(pages)
    if len(sheets) == 1:
        return sheets
    box = Box(MARGIN, A4[1] - BOTTOM + 10, A4[0] - 2 * MARGIN, FOOT * 1.3)
    numbered = []
    for k, slide in enumerate(sheets, start=1):
        count = say("slides.sheetOf", sheet=k, of=len(sheets))
        foot = (
            one_line(slide.title, Box(*box[:2], box.width - COUNT, box.height), FOOT, "soft"),
            one_line(count, box, FOOT, "soft", "right", name="sheet"),
        )
        numbered.append(replace(slide, items=(*slide.items, *foot)))
    return numbered


def _heading(title: str) -> list[Item]:
    box = Box(MARGIN, MARGIN - 6, A4[0] - 2 * MARGIN, HEAD * 1.2)
    return [text([(Run(title, bold=True),)], box, HEAD, name="title", is_title=True)]


def _moved(item: Item, down: float, right: float = 0.0) -> Item:
    """The item further down and to the right."""
    if isinstance(item, Line):
        (x1, y1), (x2, y2) = item.start, item.end
        return replace(item, start=(x1 + right, y1 + down), end=(x2 + right, y2 + down))
    assert isinstance(item, Text)
    box = item.box
    return replace(item, box=Box(box.left + right, box.top + down, box.width, box.height))
