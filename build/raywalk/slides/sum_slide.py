"""How a pixel's colour adds up: each ray's own colour times its share in the pixel."""

from __future__ import annotations

from dataclasses import replace

from raywalk.slides.blocks import BODY_SIZE, flow, flow_texts, footer, title
from raywalk.slides.figure import Cell, Run, Slide, Table
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.notes import lit_hits
from raywalk.slides.ray_table import SAMPLE, SWATCH, eight_bit
from raywalk.slides.sights import Seen
from raywalk.slides.step_figure import ray_order
from raywalk.slides.step_slide import Lesson
from raywalk.slides.typeface import shortened, width
from raywalk.slides.words import kind_word, number, place, say, sum_columns, tone
from raywalk.trace_file import Kind

ROW = 22.0
MOST_RAYS = 5  # a longer sum takes more than one slide


def told_pixel(lesson: Lesson) -> int | None:
    """Which stop's pixel has most to tell of its sum; None if no step walks one pixel's rays."""
    walked = [
        k for k, s in enumerate(lesson.seen)
        if s.chosen and s.view.filled and s.stop.kind != "question" and not s.view.switches.is_set
    ]  # fmt: skip
    fitting = [k for k in walked if len(ray_order(lesson.seen[k])) <= MOST_RAYS] or walked[:1]
    return max(fitting, key=lambda k: _telling(lesson.seen[k]), default=None)


def sum_slides(lesson: Lesson) -> list[Slide]:
    """How that pixel's colour adds up; none if no step walks one pixel's rays."""
    index = told_pixel(lesson)
    return [] if index is None else _slides(lesson, lesson.seen[index])


def _slides(lesson: Lesson, seen: Seen) -> list[Slide]:
    layout = lesson.layout
    head = say("slides.sum", x=seen.view.pixel[0], y=seen.view.pixel[1])
    says = flow([Paragraph((Run(say("slides.sumSays")),))], BODY_SIZE, layout.title.width)
    words = Box(layout.title.left, layout.title.bottom + 4, layout.title.width, says.height())
    top = words.bottom + 12
    rows = [_row(lesson, seen, k, ray) for k, ray in enumerate(ray_order(seen), start=1)]
    rows += _total(seen)
    fits = int((layout.footer.top - 10 - top) / ROW) - 1
    slides: list[Slide] = []
    while rows:
        part, rows = rows[:fits], rows[fits:]
        name = say("slides.continued", title=head) if slides else head
        table = _table(part, Box(words.left, top, words.width, 0))
        under = footer(
            f"{say('slides.brand')} · {lesson.place} · {say('slides.pixelOf', **place(seen))}",
            "", layout,
        )  # fmt: skip
        items = (title(name, layout.title), *flow_texts(says, words), table, *under[:1])
        notes = (say("slides.sumSays"), *(" · ".join(_spoken(row)) for row in part))
        slides.append(Slide(name, items, notes, "sum", bool(len(slides))))
    return _with_lights(lesson, seen, slides)


def _with_lights(lesson: Lesson, seen: Seen, slides: list[Slide]) -> list[Slide]:
    """The slides with what each light gives to each hit, under the table and on further ones."""
    layout, order = lesson.layout, ray_order(seen)
    sums = [
        Paragraph((Run(say("slides.sumOfRay", count=order.index(ray) + 1), True), Run(f" {told}")))
        for ray, told in lit_hits(lesson.placed, seen)
    ]
    *done, last = slides
    under = last.items[-1]
    top = next(item.box.bottom for item in last.items if isinstance(item, Table)) + 14
    room = layout.footer.top - 8 - top
    rest = flow(sums, SMALLEST + 1, layout.title.width)
    if rest.height() > room:
        rest = flow(sums, SMALLEST, layout.title.width)
    while rest.lines:
        space = layout.footer.top - 8 - top
        if space >= rest.line_height:
            part, rest = rest.split_between(space)
            texts = flow_texts(part, Box(layout.title.left, top, layout.title.width, space))
            last = replace(last, items=(*last.items, *texts))
        if rest.lines:
            done.append(last)
            head = say("slides.continued", title=slides[0].title)
            last = Slide(head, (title(head, layout.title), under), (), "sum", True)
            top = layout.title.bottom + 12
    return [*done, last]


def _telling(seen: Seen) -> tuple[int, int]:
    """How much a sum has to tell: rays that give something, rays in all."""
    rays = ray_order(seen)
    return sum(share_of(seen, ray) * sum(own_colour(seen, ray)) > 0.002 for ray in rays), len(rays)


def share_of(seen: Seen, ray: int) -> float:
    """The ray's share in its pixel: the product of weights from the camera on."""
    share = 1.0
    while ray >= 0:
        share *= float(seen.trace.weight[ray])
        ray = int(seen.trace.parent[ray])
    return share


def own_colour(seen: Seen, ray: int) -> list[float]:
    """What the ray brings without those it led to: colour minus their weighted colours."""
    trace = seen.trace
    colour = trace.colour[ray].copy()
    for child in (trace.parent == ray).nonzero()[0].tolist():
        colour -= trace.weight[child] * trace.colour[child]
    return [max(0.0, float(c)) for c in colour]


def _row(lesson: Lesson, seen: Seen, count: int, ray: int) -> tuple[Cell, ...]:
    scene, trace = lesson.placed.scene, seen.trace
    kind = Kind(int(trace.kind[ray])).name.lower()
    met = int(trace.object[ray])
    at = scene.objects[met].name if met >= 0 else say("event.term.background")
    own, share = own_colour(seen, ray), share_of(seen, ray)
    gives = [share * c for c in own]
    first = (Cell(str(count), sample=kind), Cell(kind_word(kind)), Cell(at), Cell(number(share)))
    if met >= 0 and trace.localWeight[ray] == 0:
        return (*first, Cell(say("slides.sendsOn")), Cell(), Cell())
    return (*first, Cell(_colour(own)), Cell(_colour(gives)), Cell(swatch=_hex(gives)))


def _total(seen: Seen) -> list[tuple[Cell, ...]]:
    colour = seen.trace.colour[seen.view.index].tolist()
    tile = seen.trace.tiles[3 * seen.view.index : 3 * seen.view.index + 3].tolist()
    told = Cell(_colour(colour), bold=True)
    blank = Cell()
    swatch = Cell(swatch="#{:02x}{:02x}{:02x}".format(*tile))
    last = Cell(", ".join(map(str, tile)), bold=True)
    return [
        (Cell(say("slides.sumTotal"), bold=True), blank, blank, blank, blank, told, swatch),
        (Cell(say("slides.ofBytes"), bold=True), blank, blank, blank, blank, last, blank),
    ]


def _table(rows: list[tuple[Cell, ...]], box: Box) -> Table:
    heading = tuple(Cell(word, bold=True) for word in sum_columns())
    needs = [
        max(width(cell.text, SMALLEST, cell.bold) for cell in column) + 16
        for column in zip(heading, *rows, strict=True)
    ]
    needs[0] += SAMPLE
    needs[-1] = SWATCH + 8
    over = sum(needs) - box.width
    if over > 0:  # names give way first, then kinds
        for k in (2, 1):
            less = min(over, needs[k] - 60)
            needs[k] -= less
            over -= less
    cut = [
        tuple(
            cell if cell.sample or cell.swatch or k == 0
            else Cell(shortened(cell.text, SMALLEST, needs[k] - 6, cell.bold), bold=cell.bold)
            for k, cell in enumerate(row)
        )
        for row in rows
    ]  # fmt: skip
    frame = Box(box.left, box.top, sum(needs), ROW * (len(rows) + 1))
    align = ("left", "left", "left", "right", "right", "right", "right")
    return Table(
        frame, tuple(needs), align, (heading, *cut), ROW, SMALLEST, say("slides.sumTable"),
        say("slides.sumAlt"),
    )  # fmt: skip


def _colour(colour: list[float]) -> str:
    return tone(colour)


def _hex(colour: list[float]) -> str:
    return "#{:02x}{:02x}{:02x}".format(*eight_bit(colour))


def _spoken(row: tuple[Cell, ...]) -> list[str]:
    return [cell.text for cell in row if cell.text]
