"""A lesson step's figure: the scene from where the observer stands, and the rays in it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from raywalk.slides.clip import clipped_area
from raywalk.slides.drawing import Drawing, hits
from raywalk.slides.figure import Dot, Group, Item, Line, Picture, Point, Polygon, flat, hex_of
from raywalk.slides.figure_names import labels_of, rings_of
from raywalk.slides.labels import Inset, Places
from raywalk.slides.layout import Box
from raywalk.slides.legend import legend
from raywalk.slides.pictures import (
    PICTURE_SIDE,
    picture_of,
    tiles_picture,
    traced_picture,
    view_pixels,
    washed,
)
from raywalk.slides.stops import ChosenLine, ThinLine
from raywalk.slides.words import altered, chosen_tile, figure_alt, ray_name, say

CHOSEN_WIDTH = 3.0
PASSED_WIDTH = 1.8  # of rays that a walk has behind it
THIN_WIDTH = 1.0
FRAME = (("#000000", 5.0), ("#f0e442", 2.6))  # of the selected tile on the traced picture
FEW_THIN = 60  # lines that are drawn at that width
HIDDEN_SHARE = 0.45  # of a line's width where something stands before it
DOT = 4.0
MOST_SQUARES = 15  # tiles across that are drawn one by one; finer grids are a picture
LEAST_SQUARE = 5.0  # points: below, grid lines would cover the tiles
MOST_NORMALS = 3
PLATE = 24.0  # from one line of what is switched to the next
# Colour and width of a box's edges, by what came of it.
BOX_LINES = {
    "level": ("sign", 1.0), "entered": ("box", 1.4), "missed": ("soft", 0.7),
    "cutOff": ("sign", 0.9),
}  # fmt: skip


def step_figure(drawing: Drawing, insets: Sequence[Inset] = ()) -> Group:
    """Everything of a step that is drawn; the group's alt tells it in words. insets: what else is
    drawn, one after the other."""
    stop = drawing.stop
    places = Places(drawing.box, view_pixels(drawing.view))
    rays = _rays(drawing, stop.chosen, CHOSEN_WIDTH, places)
    parts: list[Item] = [
        _view(drawing),
        *_tiles(drawing),
        *_frustum(drawing, places),
        *_lamps(drawing, places),
        *rings_of(drawing),
        *_boxes(drawing),
        *_thin(drawing, places),
        *rays,
        *_dots(drawing, places),
        *_normals(drawing, places),
    ]
    for inset in insets:
        parts += inset(places)
    parts += _switched(drawing, places)
    parts += legend(parts, places, CHOSEN_WIDTH, CHOSEN_WIDTH * HIDDEN_SHARE * 1.2)
    parts += places.put(labels_of(drawing))
    return Group(
        say("slides.figure"), figure_alt(drawing.scene, stop), tuple(parts), is_figure=True
    )


def _switched(drawing: Drawing, places: Places) -> list[Item]:
    """What is not as traced, in the figure's upper left corner, or under what stands there."""
    settings = altered(drawing.stop)
    if drawing.stop.colours != "picture":
        settings.append(say(f"tileView.means.{drawing.stop.colours}"))
    if drawing.stop.is_elsewhere:
        settings.append(say("slides.seeLive"))
    items: list[Item] = []
    left, top = drawing.box.left + 10, drawing.box.top + 8
    if settings:
        corner = Box(left, top, PLATE, PLATE * len(settings))
        top = max([top, *(each.bottom + 8 for each in places.boxes if each.overlaps(corner))])
    for k, words in enumerate(settings):
        items += places.plate(words, left, top + k * PLATE)
    return items


def _view(drawing: Drawing) -> Picture:
    on_screen, on_paper, on_web = washed(drawing.view)
    return Picture(
        drawing.box,
        on_screen,
        on_paper,
        say("slides.shaded"),
        say("slides.shadedAlt", title=drawing.scene.title),
        on_web,
    )


def _tiles(drawing: Drawing) -> list[Item]:
    stop, n = drawing.stop, drawing.stop.n
    if drawing.picture and (outline := _area(drawing, 0, 0, n, n)):
        parts: list[Item] = [_traced(drawing, drawing.picture, outline)]
    elif n > MOST_SQUARES and stop.tiles is not None:
        picture = tiles_picture(stop.figure, stop.tiles, stop.hidden_tiles, drawing.box)
        parts = [picture] if picture else []
    else:
        parts = _squares(drawing)
    parts += _chosen_tile(drawing)
    return [Group(say("slides.tiles", n=n), "", tuple(parts))]


def _traced(drawing: Drawing, file: Path, outline: list[Point]) -> Picture:
    """The traced picture where the tiles are, as the ray-tracing camera sees them: upright."""
    left, right = (end(x for x, _ in outline) for end in (min, max))
    top, bottom = (end(y for _, y in outline) for end in (min, max))
    alt = say("picture.alt", title=drawing.scene.title)
    frame = Box(left, top, right - left, bottom - top)
    return picture_of(traced_picture(file, PICTURE_SIDE), frame, alt)


def _squares(drawing: Drawing) -> list[Item]:
    stop, n = drawing.stop, drawing.stop.n
    outline = _area(drawing, 0, 0, n, n)
    if not outline:
        return []
    wide = max(p[0] for p in outline) - min(p[0] for p in outline)
    high = max(p[1] for p in outline) - min(p[1] for p in outline)
    if max(wide, high) / n < LEAST_SQUARE and not stop.filled:
        return [Polygon(tuple(outline), None, "grid", name=say("slides.grid"))]
    squares: list[Item] = []
    at = stop.figure.on_plane(*np.meshgrid(np.arange(n + 1), np.arange(n + 1)))
    corners = np.stack([at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]], axis=2)
    for tile, quad in enumerate(corners.reshape(n * n, 4, 3).tolist()):
        points = _within(drawing, quad)
        if not points or tile in stop.hidden_tiles:
            continue
        fill = None if stop.tiles is None else hex_of(stop.tiles[tile].tolist())
        squares.append(Polygon(tuple(points), fill, "grid", 0.5, name=f"{tile % n}, {tile // n}"))
    return squares


def _area(drawing: Drawing, column: int, row: int, across: int, down: int) -> list[Point]:
    """A part of the picture plane within the frame; [] if a corner is behind the observer."""
    columns = np.array([column, column + across, column + across, column])
    rows = np.array([row, row, row + down, row + down])
    return _within(drawing, drawing.stop.figure.on_plane(columns, rows).tolist())


def _within(drawing: Drawing, corners: list[list[float]]) -> list[Point]:
    """What of an area is in the frame; [] if a corner (x, y, depth) is behind the observer."""
    if any(depth <= drawing.stop.figure.near for _, _, depth in corners):
        return []
    box = drawing.box
    return clipped_area([(box.left + x, box.top + y) for x, y, _ in corners], box)


def _chosen_tile(drawing: Drawing) -> list[Item]:
    pixel = drawing.stop.pixel
    points = _area(drawing, *pixel, 1, 1)
    if not points:
        return []
    name, pens = chosen_tile(pixel), FRAME if drawing.picture else (("chosen", 1.6),)
    return [Polygon(tuple(points), None, pen, wide, name=name) for pen, wide in pens]


def _frustum(drawing: Drawing, places: Places) -> list[Item]:
    stop = drawing.stop
    if stop.is_camera:
        return []
    lines: list[Item] = []
    for edge in stop.figure.edges:
        if found := drawing.line(edge):
            at, inside = found
            a, b = (tuple((at[0] + s * (at[1] - at[0])).tolist()) for s in inside)
            lines.append(Line(a, b, "frustum", 0.8, name=say("slides.edge")))
            places.faint.append((a, b))
    outline = _area(drawing, 0, 0, stop.n, stop.n)
    places.faint += list(zip(outline, outline[1:] + outline[:1], strict=True))
    parts: list[Item] = [Group(say("slides.frustum"), "", tuple(lines))] if lines else []
    if eye := drawing.point(stop.figure.eye):
        parts.append(Dot(eye, 5, "sign", name=say("stage.camera")))
        places.boxes.append(_around(eye, 5))
    return parts


def _lamps(drawing: Drawing, places: Places) -> list[Item]:
    lamps: list[Item] = []
    for lamp in drawing.stop.figure.lamps:
        if at := drawing.point(lamp.at):
            fill = "ground" if lamp.off else "lamp"
            lamps.append(Dot(at, 6.5, fill, "lamp-edge", name=lamp.name))
            places.boxes.append(_around(at, 6.5))
    return lamps


def _boxes(drawing: Drawing) -> list[Item]:
    """A mesh's boxes, edge by edge; nothing hides them: most lie inside of the mesh."""
    lines: list[Item] = []
    for edge in drawing.stop.figure.boxes:
        if found := drawing.line(edge.ends):
            at, inside = found
            a, b = (tuple((at[0] + s * (at[1] - at[0])).tolist()) for s in inside)
            lines.append(Line(a, b, *BOX_LINES[edge.what], name=say("slides.boxEdge")))
    return [Group(say("slides.boxes"), "", tuple(lines))] if lines else []


def _thin(drawing: Drawing, places: Places) -> list[Item]:
    """Thinner still where they are many: a hundred lines must not become one area."""
    thin = drawing.stop.thin
    width = THIN_WIDTH * min(1.0, (FEW_THIN / max(1, len(thin))) ** 0.5)
    rays = _rays(drawing, thin, width, None)
    places.faint += [(i.start, i.end) for i in flat(tuple(rays)) if isinstance(i, Line)]
    return [Group(say("slides.thin"), "", tuple(rays))] if rays else []


def _rays(
    drawing: Drawing, lines: Sequence[ThinLine], width: float, places: Places | None
) -> list[Item]:
    """A group a ray: its stretches in order, those behind something thin and dashed."""
    groups: list[Item] = []
    for line in lines:
        number = line.ray if isinstance(line, ChosenLine) else None
        is_passed = drawing.now is not None and number != drawing.now
        pieces = _pieces(drawing, line, PASSED_WIDTH if is_passed else width)
        if not pieces:
            continue
        name = ray_name(number, line.kind)
        if places:
            places.strokes += [(piece.start, piece.end) for piece in pieces]
        groups.append(Group(name, "", tuple(pieces)) if places or len(pieces) > 1 else pieces[0])
    return groups


def _pieces(drawing: Drawing, line: ThinLine, width: float) -> list[Line]:
    """The line's parts within the frame, from start to end; the last one has the arrow's head."""
    pieces: list[Line] = []
    for piece in line.pieces:
        found = drawing.line(piece.ends)
        if found is None:
            continue
        at, (first, last) = found
        start, end = (tuple((at[0] + s * (at[1] - at[0])).tolist()) for s in (first, last))
        pieces.append(
            Line(
                start,
                end,
                line.kind,
                width * HIDDEN_SHARE if piece.hidden else width,
                "hidden" if piece.hidden else line.kind,
                arrow=piece.arrives and bool(last == 1.0) and width > THIN_WIDTH,
                name=say("slides.hidden" if piece.hidden else "slides.seen"),
            )
        )
    return pieces


def _dots(drawing: Drawing, places: Places) -> list[Item]:
    dots: list[Item] = []
    for line in hits(drawing.stop):
        if at := drawing.point(line.end):
            dots.append(Dot(at, DOT, line.kind, "ground", name=say("slides.hit")))
            places.boxes.append(_around(at, DOT + 1))
    return dots


def _normals(drawing: Drawing, places: Places) -> list[Item]:
    lines = hits(drawing.stop)
    if len(lines) > MOST_NORMALS:
        return []
    parts: list[Item] = []
    for line in lines:
        a, b = drawing.point(line.end), drawing.point(line.tip)
        if a and b and np.hypot(b[0] - a[0], b[1] - a[1]) > 8:
            parts.append(Line(a, b, "normal", 1.2, arrow=True, name=say("slides.normal")))
            places.strokes.append((a, b))
    return parts


def _around(at: Point, radius: float) -> Box:
    return Box(at[0] - radius, at[1] - radius, 2 * radius, 2 * radius)
