"""How a pixel's colour adds up: each ray's own colour times its share in the pixel."""

from __future__ import annotations

from dataclasses import replace

from raywalk.slides.blocks import BODY_SIZE, flow, flow_texts, title
from raywalk.slides.figure import Cell, Item, Run, Slide, Table, hex_of
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.ray_table import SAMPLE, SWATCH
from raywalk.slides.step_slide import Lesson, source_line
from raywalk.slides.stops import Row, Stop
from raywalk.slides.typeface import shortened, width
from raywalk.slides.words import kind_word, numbers, say, sum_columns, switched

ROW = 25.0
GAP = 18.0  # between the tables


def sum_slides(lesson: Lesson, stop: Stop, rays: Table | None = None) -> list[Slide]:
    """How the colour of a walked pixel adds up. rays: a short table of its rays, above it."""
    layout = lesson.layout
    head = say("slides.sum", x=stop.pixel[0], y=stop.pixel[1])
    head = ", ".join([head, *switched(stop.switches)])  # a pixel may have several
    says = flow([Paragraph((Run(say("slides.sumSays")),))], BODY_SIZE, layout.title.width)
    left, top, wide, _ = layout.below_title
    rows = [*map(_row, stop.rows), *_total(stop)]
    slides: list[Slide] = []
    while rows:
        above: list[Item] = [rays] if rays and not slides else []
        words = Box(left, rays.box.bottom + GAP if rays and above else top, wide, says.height())
        place = Box(left, words.bottom + 6, wide, 0)
        fits = int((layout.footer.top - 10 - place.top) / ROW) - 1
        part, rows = rows[:fits], rows[fits:]
        name = say("slides.continued", title=head) if slides else head
        items = (
            title(name, layout.title), *above, *flow_texts(says, words), _table(part, place),
            *source_line(lesson, stop),
        )  # fmt: skip
        notes = (say("slides.sumSays"), *(" · ".join(_spoken(row)) for row in part))
        slides.append(Slide(name, items, notes, "sum", bool(len(slides))))
    return _with_lights(lesson, stop, slides)


def _with_lights(lesson: Lesson, stop: Stop, slides: list[Slide]) -> list[Slide]:
    """The slides with what each light gives to each hit, under the table and on further ones."""
    layout = lesson.layout
    sums = [
        Paragraph((Run(say("slides.sumOfRay", count=hit.ray), True), Run(f" {hit.numbers}")))
        for hit in stop.events
        if hit.what == "local"
    ]
    *done, last = slides
    top = max(item.box.bottom for item in last.items if isinstance(item, Table)) + 14
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
            items = (title(head, layout.title), *source_line(lesson, stop))
            last = Slide(head, items, (), "sum", True)
            top = layout.title.bottom + 12
    return [*done, last]


def _row(ray: Row) -> tuple[Cell, ...]:
    at = ray.object or say("event.term.background")
    first = (Cell(str(ray.number), sample=ray.kind), Cell(kind_word(ray.kind)), Cell(at))
    share = Cell(numbers().number(ray.share))
    if ray.object and ray.keeps == 0:
        return (*first, share, Cell(say("slides.sendsOn")), Cell(), Cell())
    given = (Cell(numbers().tone(ray.own)), Cell(numbers().tone(ray.gives)))
    return (*first, share, *given, Cell(swatch=ray.shows_given))


def _total(stop: Stop) -> list[tuple[Cell, ...]]:
    total, blank = Cell(numbers().tone(stop.rows[0].colour), bold=True), Cell()
    swatch = Cell(swatch=hex_of(stop.bytes))
    last = Cell(", ".join(map(str, stop.bytes)), bold=True)
    return [
        (Cell(say("slides.sumTotal"), bold=True), blank, blank, blank, blank, total, swatch),
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


def _spoken(row: tuple[Cell, ...]) -> list[str]:
    return [cell.text for cell in row if cell.text]
