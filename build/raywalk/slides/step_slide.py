"""A stop of the lesson as a slide: its words, its figure, its numbers; long words go on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from raywalk.scene.model import Scene
from raywalk.slides.blocks import (
    BODY_SIZE,
    Flow,
    continued,
    flow,
    flow_texts,
    footer,
    one_line,
    title,
)
from raywalk.slides.choices import (
    SIZE,
    choice_items,
    choice_marks,
    choice_slides,
    choice_words,
    in_notes,
)
from raywalk.slides.figure import Group, Item, Line, Polygon, Slide, Table, flat, hex_of
from raywalk.slides.layout import SMALLEST, Box, Layout
from raywalk.slides.lesson_pictures import picture_slides
from raywalk.slides.lesson_words import plain_text, title_and_body, words_and_pictures
from raywalk.slides.palette import KINDS
from raywalk.slides.pictures import PICTURE_SIDE, grid_picture, picture_of, traced_picture
from raywalk.slides.ray_table import ROW, is_whole, ray_table, ray_tables
from raywalk.slides.step_figure import CHOSEN_WIDTH, HIDDEN_SHARE, Drawing, step_figure
from raywalk.slides.stops import Stop
from raywalk.slides.typeface import width
from raywalk.slides.words import chosen_tile, kind_word, place, say

GAP = 12.0
LINE = 20.0
LEAST_PICTURE, MOST_PICTURE = 78.0, 170.0  # the least has pixel, swatch and numbers beside it
WIDEST_PICTURE = 300.0  # beside a table that has a slide to itself
BESIDE = 110.0  # of the pixel's numbers
MOST_ROWS = 10  # of a table under a picture
SAMPLE = 28.0  # of a line in the legend; a head would cover what its dashes tell
LEGEND_ROW = 18.0


@dataclass(frozen=True, eq=False)
class Lesson:
    """What all slides of one scene's lesson need."""

    scene: Scene
    stops: list[Stop]
    views: Path  # the folder of SIGHTS and view-<k>.png, shaded views
    picture: Path  # the traced picture
    layout: Layout

    def drawing(self, stop: Stop, now: int | None = None) -> Drawing:
        """now: the ray that a walk has come to."""
        view = self.views / f"view-{stop.viewpoint}.png"
        return Drawing(self.scene, stop, view, self.layout.figure, now)

    @property
    def place(self) -> str:
        """The scene in a footer."""
        return " ".join(part for part in (self.scene.key, self.scene.title) if part)


def step_slides(lesson: Lesson, index: int) -> list[Slide]:
    """One slide, and further ones for words and rays that do not fit."""
    layout, scene, stop = lesson.layout, lesson.scene, lesson.stops[index]
    paragraphs, shown = words_and_pictures(stop.text(scene))
    head, body = title_and_body(paragraphs)
    head = head or scene.title
    figure = step_figure(lesson.drawing(stop))
    choices = choice_words(scene, scene.lesson[stop.step]) if stop.kind != "step" else []
    marks = [*legend(figure, layout), *choice_marks(choices, stop, layout.figure)]
    figure = replace(figure, items=(*figure.items, *marks))
    words = flow(body, BODY_SIZE, layout.words.width)
    first, rest = words.split(layout.words.height)
    is_last = not _same_pixel_follows(lesson, index)
    if stop.kind == "question":
        room = _beside_figure(layout, first)
        numbers, high = choice_items(choices, room, SIZE, False)
        numbers = numbers if high <= room.height else []
    else:
        numbers = _numbers(lesson, stop, first, is_last)
    here = step_place(lesson, stop, 1, len(stop.rows))
    under = footer(where(lesson, stop), here, layout)
    items = [title(head, layout.title), *flow_texts(first, layout.words), figure, *numbers]
    notes = (here, *step_notes(scene, stop))
    slides = [Slide(head, (*items, *under), notes, stop.kind, figure=figure)]
    below = _below_title(layout)
    words_below = below._replace(left=layout.words.left, width=layout.words.width)
    slides += continued(rest, words_below, head, layout, stop.kind, under)
    if choices and not (stop.kind == "question" and numbers):
        slides += choice_slides(choices, head, below, layout, under, stop.kind == "answer")
    folder = scene.path.parent
    slides += picture_slides(shown, folder, head, below, layout, under, stop.kind)
    is_cut = any(isinstance(item, Table) and not is_whole(item, stop) for item in numbers)
    if is_cut and is_last:
        again = say("slides.continued", title=head)
        for table in ray_tables(stop, below):
            from_to = (int(table.rows[k][0].text) for k in (1, -1))
            under = footer(where(lesson, stop), step_place(lesson, stop, *from_to), layout)
            items = [title(again, layout.title), table, *_beside(lesson, stop, table), *under]
            slides.append(Slide(again, tuple(items), (), stop.kind, True))
    return slides


def step_place(lesson: Lesson, stop: Stop, first: int, last: int) -> str:
    """ "step 4 of 9 · ray 3 of 9": which rays of the selected pixel's tree a slide shows, by the
    numbers that they have in figure and table."""
    steps = say("slides.stepOf", step=stop.step + 1, of=len(lesson.scene.lesson))
    rays = len(stop.rows)
    if not rays:
        return steps
    shown = (
        say("slides.rayOf", ray=first, of=rays)
        if first == last
        else say("slides.raysOf", first=first, last=last, of=rays)
    )
    return f"{steps} · {shown}"


def _same_pixel_follows(lesson: Lesson, index: int) -> bool:
    """Steps that stay on a pixel have one whole table between them, after the last of them."""
    here, *following = lesson.stops[index : index + 2]
    return any(
        after.kind != "question"
        and (after.n, after.pixel) == (here.n, here.pixel)
        and after.switches == here.switches
        and bool(after.rows)
        for after in following
    )


def _below_title(layout: Layout) -> Box:
    """The whole slide between its title and its footer."""
    top = layout.title.bottom + 12
    return Box(layout.title.left, top, layout.title.width, layout.footer.top - 12 - top)


def where(lesson: Lesson, stop: Stop) -> str:
    parts = [say("slides.brand"), lesson.place]
    if stop.rows:
        parts.append(say("slides.pixelOf", **place(stop)))
    else:
        parts.append(f"{stop.n} × {stop.n}")
    if stop.one_in > 1:
        parts.append(say("slides.oneIn", count=stop.one_in))
    return " · ".join(parts)


def _beside(lesson: Lesson, stop: Stop, table: Table) -> list[Item]:
    """The picture in the room that a table on a slide of its own leaves."""
    whole = lesson.layout.title
    left = table.box.right + 3 * GAP
    side = min(WIDEST_PICTURE, whole.right - left - BESIDE)
    if side < LEAST_PICTURE:
        return []
    return _picture(lesson, stop, Box(left, table.box.top, whole.right - left, side))


def _numbers(lesson: Lesson, stop: Stop, words: Flow, is_last: bool) -> list[Item]:
    """The traced picture, the pixel's colour and its table, in what room the words leave.

    is_last: no later step has the table; a whole one then comes before the picture.
    """
    box = _beside_figure(lesson.layout, words)
    items: list[Item] = []
    room = box.height
    table = ray_table(stop, box, _most_rows(room))
    if is_last and table and not is_whole(table, stop):
        high = int((room - LINE - GAP) / ROW)
        whole = ray_table(stop, box, high)
        table = whole if whole and is_whole(whole, stop) else table
    if table:
        room -= table.box.height + GAP
    used = 0.0
    if room >= LEAST_PICTURE:
        used = min(room, MOST_PICTURE)
        items += _picture(lesson, stop, Box(box.left, box.top, box.width, used))
    elif room >= LINE and stop.rows:
        used = LINE
        items += _pixel_colour(stop, Box(box.left, box.top, box.width, used))
    if table:
        top = box.top + (used + GAP if used else 0)
        items.append(replace(table, box=Box(box.left, top, *table.box[2:])))
    return items


def _beside_figure(layout: Layout, words: Flow) -> Box:
    """What the words leave beside the figure."""
    above = words.height() + GAP
    left, top, wide, high = layout.words
    return layout.aside or Box(left, top + above, wide, high - above)


def _most_rows(room: float) -> int:
    """Of the table with its heading: at least three rays come before the picture, the picture
    before more rows."""
    picture = LEAST_PICTURE + GAP
    return min(int((room - (picture if room > picture + 4 * ROW else 0)) / ROW), MOST_ROWS)


def _picture(lesson: Lesson, stop: Stop, box: Box) -> list[Item]:
    """The traced picture with the selected tile marked, and the pixel's colour beside it."""
    side = box.height
    frame = Box(box.left, box.top, side, side)
    if stop.picture:  # with the step's switches set, as the finest grid has it
        data = grid_picture(stop.picture.tiles, stop.picture.n)
    else:
        data = traced_picture(lesson.picture, PICTURE_SIDE)
    alt = say("picture.alt", title=lesson.scene.title)
    items: list[Item] = [picture_of(data, frame, alt)]
    if not stop.rows:
        return items
    n, (column, row) = stop.n, stop.pixel
    tile = max(side / n, 5.0)
    x = frame.left + (column + 0.5) / n * side - tile / 2
    y = frame.top + (row + 0.5) / n * side - tile / 2
    square = Box(x, y, tile, tile).corners
    items.append(Polygon(square, None, "#000000", 3.0, name=chosen_tile(stop.pixel)))
    items.append(Polygon(square, None, "#ffffff", 1.4, name=chosen_tile(stop.pixel)))
    beside = Box(frame.right + GAP, frame.top, box.right - frame.right - GAP, side)
    return items + _pixel_colour(stop, beside)


def _pixel_colour(stop: Stop, box: Box) -> list[Item]:
    """ "Pixel 7, 9" and its colour as a swatch and three numbers; one line if there is no room."""
    colour = hex_of(stop.bytes)
    name = say("card.pixel", column=stop.pixel[0], row=stop.pixel[1])
    levels = ", ".join(map(str, stop.bytes))
    if box.height < 60:
        text_box = Box(box.left + 20, box.top, box.width - 20, LINE)
        return [
            _swatch(box.left, box.top + 3, 14, colour),
            one_line(f"{name}: {levels}", text_box),
        ]
    return [
        one_line(name, Box(box.left, box.top, box.width, 18), bold=True),
        _swatch(box.left, box.top + 24, 28, colour),
        one_line(levels, Box(box.left, box.top + 58, box.width, 18)),
    ]


def _swatch(left: float, top: float, side: float, colour: str) -> Polygon:
    return Polygon(
        Box(left, top, side, side).corners, colour, "rule", 0.75, name=say("slides.swatch")
    )


def legend(figure: Group, layout: Layout) -> list[Item]:
    """What the lines' styles mean, under the figure; only those that it draws: rays may run
    outside its frame."""
    lines = [item for item in flat(figure.items) if isinstance(item, Line)]
    drawn = {line.colour for line in lines}
    entries = [(kind_word(k), k, k, CHOSEN_WIDTH) for k in KINDS if k in drawn]
    if any(line.dash == "hidden" for line in lines):
        entries.append((say("slides.hidden"), "soft", "hidden", CHOSEN_WIDTH * HIDDEN_SHARE * 1.2))
    items: list[Item] = []
    left, top = layout.figure.left, layout.figure.bottom + 3
    for word, colour, dash, line_width in entries:
        wide = SAMPLE + 6 + width(word, SMALLEST)
        if left + wide > layout.figure.right and left > layout.figure.left:
            left, top = layout.figure.left, top + LEGEND_ROW
        middle = top + LEGEND_ROW / 2
        ends = ((left, middle), (left + SAMPLE, middle))
        items.append(Line(*ends, colour, line_width, dash, name=word))
        items.append(one_line(word, Box(left + SAMPLE + 6, top, wide, LEGEND_ROW), name=word))
        left += wide + 14
    return [Group(say("slides.legend"), "", tuple(items))] if items else []


def step_notes(scene: Scene, stop: Stop) -> Iterator[str]:
    """What a speaker reads: the step's words, then its rays event by event, as the player does.
    Paragraphs; an asking step's say nothing that gives its answer away."""
    yield plain_text(stop.text(scene))
    if stop.kind == "question":
        yield say("slides.questionNote")
    if stop.kind != "step":
        yield from in_notes(scene, scene.lesson[stop.step], stop.kind == "answer")
    yield from (event.in_words for event in stop.events)
