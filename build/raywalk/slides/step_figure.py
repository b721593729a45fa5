"""A lesson step's figure: the scene from where the observer stands, and the rays in it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from raywalk.scene.model import Scene
from raywalk.slides.clip import clipped_area, clipped_line
from raywalk.slides.figure import Dot, Group, Item, Line, Picture, Point, Polygon, flat
from raywalk.slides.labels import Label, Places
from raywalk.slides.layout import Box
from raywalk.slides.lines import RayLine, tree_rows
from raywalk.slides.observer import NEAR
from raywalk.slides.palette import KIND_DASH
from raywalk.slides.pictures import tiles_picture, washed
from raywalk.slides.placing import Placed
from raywalk.slides.sights import Seen, Sight
from raywalk.slides.words import chosen_tile, figure_alt, ray_name, say, switched, vector

CHOSEN_WIDTH = 2.2
PASSED_WIDTH = 1.4  # of rays that a walk has behind it
THIN_WIDTH = 0.9
FEW_THIN = 60  # lines that are drawn at that width
HIDDEN_SHARE = 0.45  # of a line's width where something stands before it
DOT = 3.2
MOST_SQUARES = 15  # tiles across that are drawn one by one; finer grids are a picture
LEAST_SQUARE = 5.0  # points: below, grid lines would cover the tiles
NORMAL_LONG = 0.13  # of the scene's radius
MOST_NORMALS = 3


@dataclass(frozen=True, eq=False)
class Drawing:
    """What the parts of one figure share."""

    placed: Placed
    seen: Seen
    sight: Sight
    box: Box  # on the slide
    now: int | None = None  # the ray that a walk has come to: others are drawn less strongly

    @property
    def scene(self) -> Scene:
        return self.placed.scene

    @property
    def near(self) -> float:
        """World units before the observer, nearer than which nothing is drawn."""
        return NEAR * self.placed.radius

    def point(self, world: np.ndarray) -> Point | None:
        """Where a point is on the slide; None behind the observer or beyond the frame."""
        x, y, depth = self.seen.projection.project(world)
        inside = 0 <= x <= self.box.width and 0 <= y <= self.box.height
        if depth <= self.near or not inside:
            return None
        return (self.box.left + float(x), self.box.top + float(y))

    def line(self, ends: np.ndarray) -> tuple[np.ndarray, tuple[float, float]] | None:
        """(2, 2) slide coordinates of a world line's part before the observer (not cut at the
        frame), and between which shares of that part it is within the frame."""
        kept = self.seen.projection.in_front(ends, self.near)
        if kept is None:
            return None
        at = self.seen.projection.project(kept)[:, :2] + [self.box.left, self.box.top]
        inside = clipped_line(tuple(at[0]), tuple(at[1]), self.box)
        return (at, inside) if inside else None


def step_figure(drawing: Drawing) -> Group:
    """Everything of a step that is drawn; the group's alt tells it in words."""
    seen, scene = drawing.seen, drawing.scene
    places = Places(drawing.box)
    rays = _rays(drawing, seen.chosen, drawing.sight.chosen, CHOSEN_WIDTH, places)
    parts: list[Item] = [
        _view(drawing),
        *_tiles(drawing),
        *_frustum(drawing, places),
        *_lamps(drawing, places),
        *_thin(drawing, places),
        *rays,
        *_dots(drawing, places),
        *_normals(drawing, places),
    ]
    parts += _switched(drawing, places)
    parts += places.put(_labels(drawing))
    return Group(say("slides.figure"), figure_alt(scene, seen), tuple(parts), is_figure=True)


def _switched(drawing: Drawing, places: Places) -> list[Item]:
    """What is not as traced, in the figure's upper left corner."""
    told = switched(drawing.seen)
    if drawing.seen.view.colours != "picture":
        told.append(say(f"tileView.means.{drawing.seen.view.colours}"))
    items: list[Item] = []
    for k, words in enumerate(told):
        items += places.plate(words, drawing.box.left + 2, drawing.box.top + 2 + 18 * k)
    return items


def _view(drawing: Drawing) -> Picture:
    on_screen, on_paper, on_web = washed(drawing.sight.picture)
    return Picture(
        drawing.box,
        on_screen,
        on_paper,
        say("slides.shaded"),
        say("slides.shadedAlt", title=drawing.scene.title),
        on_web,
    )


def _tiles(drawing: Drawing) -> list[Item]:
    seen = drawing.seen
    n = seen.view.n
    if n > MOST_SQUARES and seen.view.filled:
        picture = tiles_picture(seen, drawing.sight.hidden_tiles, drawing.box)
        parts: list[Item] = [picture] if picture else []
    else:
        parts = _squares(drawing)
    if chosen := _chosen_tile(drawing):
        parts.append(chosen)
    return [Group(say("slides.tiles", n=n), "", tuple(parts))]


def _squares(drawing: Drawing) -> list[Item]:
    seen = drawing.seen
    n = seen.view.n
    outline = _area(drawing, 0, 0, n, n)
    if not outline:
        return []
    wide = max(p[0] for p in outline) - min(p[0] for p in outline)
    high = max(p[1] for p in outline) - min(p[1] for p in outline)
    if max(wide, high) / n < LEAST_SQUARE and not seen.view.filled:
        return [Polygon(tuple(outline), None, "grid", name=say("slides.grid"))]
    squares: list[Item] = []
    at = _on_plane(drawing, *np.meshgrid(np.arange(n + 1), np.arange(n + 1)))
    corners = np.stack([at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]], axis=2)
    for tile, quad in enumerate(corners.reshape(n * n, 4, 3).tolist()):
        points = _within(drawing, quad)
        if not points or tile in drawing.sight.hidden_tiles:
            continue
        fill = (
            "#{:02x}{:02x}{:02x}".format(*seen.tiles[tile].tolist()) if seen.view.filled else None
        )
        squares.append(Polygon(tuple(points), fill, "grid", 0.5, name=f"{tile % n}, {tile // n}"))
    return squares


def _area(drawing: Drawing, column: int, row: int, across: int, down: int) -> list[Point]:
    """A part of the picture plane within the frame; [] if a corner is behind the observer."""
    columns = np.array([column, column + across, column + across, column])
    rows = np.array([row, row, row + down, row + down])
    return _within(drawing, _on_plane(drawing, columns, rows).tolist())


def _on_plane(drawing: Drawing, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """(..., 3) x and y in the frame and depth of the grid's corners."""
    seen = drawing.seen
    return seen.projection.project(seen.plane.at(columns, rows, seen.view.n))


def _within(drawing: Drawing, corners: list[list[float]]) -> list[Point]:
    """What of an area is in the frame; [] if a corner (x, y, depth) is behind the observer."""
    if any(depth <= drawing.near for _, _, depth in corners):
        return []
    box = drawing.box
    return clipped_area([(box.left + x, box.top + y) for x, y, _ in corners], box)


def _chosen_tile(drawing: Drawing) -> Item | None:
    view = drawing.seen.view
    points = _area(drawing, *view.pixel, 1, 1)
    if not points:
        return None
    return Polygon(tuple(points), None, "chosen", 1.6, name=chosen_tile(view.pixel))


def _frustum(drawing: Drawing, places: Places) -> list[Item]:
    seen = drawing.seen
    if drawing.seen.view.observer == "camera":
        return []
    lines: list[Item] = []
    corners = seen.plane.corners()
    for corner in corners:
        found = drawing.line(np.array([seen.plane.eye, corner]))
        if found:
            at, inside = found
            a, b = (tuple((at[0] + s * (at[1] - at[0])).tolist()) for s in inside)
            lines.append(Line(a, b, "frustum", 0.8, name=say("slides.edge")))
            places.faint.append((a, b))
    outline = _area(drawing, 0, 0, seen.view.n, seen.view.n)
    places.faint += list(zip(outline, outline[1:] + outline[:1], strict=True))
    parts: list[Item] = [Group(say("slides.frustum"), "", tuple(lines))] if lines else []
    if eye := drawing.point(seen.plane.eye):
        parts.append(Dot(eye, 5, "sign", name=say("stage.camera")))
        places.boxes.append(_around(eye, 5))
    return parts


def _lamps(drawing: Drawing, places: Places) -> list[Item]:
    lamps: list[Item] = []
    for light in drawing.scene.lights:
        if at := drawing.point(np.array(light.position, float)):
            is_off = drawing.seen.view.switches.brightness(light.name) == 0
            fill = "ground" if is_off else "lamp"
            lamps.append(Dot(at, 6.5, fill, "lamp-edge", name=light.name))
            places.boxes.append(_around(at, 6.5))
    return lamps


def _thin(drawing: Drawing, places: Places) -> list[Item]:
    """Thinner still where they are many: a hundred lines must not become one area."""
    seen = drawing.seen
    width = THIN_WIDTH * min(1.0, (FEW_THIN / max(1, len(seen.thin))) ** 0.5)
    rays = _rays(drawing, seen.thin, drawing.sight.thin, width, None)
    places.faint += [(i.start, i.end) for i in flat(tuple(rays)) if isinstance(i, Line)]
    return [Group(say("slides.thin"), "", tuple(rays))] if rays else []


def _rays(
    drawing: Drawing, lines: list[RayLine], hidden: list[list[tuple[float, float]]], width: float,
    places: Places | None,
) -> list[Item]:  # fmt: skip
    """A group a ray: its stretches in order, those behind something thin and dashed."""
    numbers = {ray: k for k, ray in enumerate(ray_order(drawing.seen), start=1)}
    groups: list[Item] = []
    for line, stretches in zip(lines, hidden, strict=True):
        is_passed = drawing.now is not None and line.ray != drawing.now
        pieces = _pieces(drawing, line, stretches, PASSED_WIDTH if is_passed else width)
        if not pieces:
            continue
        name = ray_name(numbers.get(line.ray), line.kind)
        if places:
            places.strokes += [(piece.start, piece.end) for piece in pieces]
        groups.append(Group(name, "", tuple(pieces)) if places or len(pieces) > 1 else pieces[0])
    return groups


def _pieces(
    drawing: Drawing, line: RayLine, hidden: list[tuple[float, float]], width: float
) -> list[Line]:
    """The line's parts within the frame, from start to end; the last one has the arrow's head."""
    world = drawing.line(line.ends)
    if world is None:
        return []
    whole = drawing.seen.projection
    borders = sorted({0.0, 1.0, *(border for stretch in hidden for border in stretch)})
    pieces: list[Line] = []
    for a, b in pairwise(borders):
        ends = line.ends[0] + np.array([[a], [b]]) * (line.ends[1] - line.ends[0])
        found = drawing.line(ends)
        if found is None:
            continue
        at, (first, last) = found
        start, end = (tuple((at[0] + s * (at[1] - at[0])).tolist()) for s in (first, last))
        behind = any(low <= (a + b) / 2 <= high for low, high in hidden)
        reaches = b == 1.0 and last == 1.0 and whole.project(line.ends[1])[2] > drawing.near
        pieces.append(
            Line(
                start,
                end,
                line.kind,
                width * HIDDEN_SHARE if behind else width,
                "hidden" if behind else KIND_DASH[line.kind],
                arrow=bool(reaches) and width > THIN_WIDTH,
                name=say("slides.hidden" if behind else "slides.seen"),
            )
        )
    return pieces


def _dots(drawing: Drawing, places: Places) -> list[Item]:
    dots: list[Item] = []
    for line in drawing.seen.chosen:
        if line.light < 0 and not line.leaves and (at := drawing.point(line.ends[1])):
            dots.append(Dot(at, DOT, line.kind, "ground", name=say("slides.hit")))
            places.boxes.append(_around(at, DOT + 1))
    return dots


def _normals(drawing: Drawing, places: Places) -> list[Item]:
    seen = drawing.seen
    hits = [line for line in seen.chosen if line.light < 0 and not line.leaves]
    if len(hits) > MOST_NORMALS:
        return []
    parts: list[Item] = []
    for line in hits:
        start = line.ends[1]
        end = start + NORMAL_LONG * drawing.placed.radius * seen.trace.normal[line.ray]
        a, b = drawing.point(start), drawing.point(end)
        if a and b and np.hypot(b[0] - a[0], b[1] - a[1]) > 8:
            parts.append(Line(a, b, "normal", 1.2, arrow=True, name=say("slides.normal")))
            places.strokes.append((a, b))
    return parts


def _labels(drawing: Drawing) -> list[Label]:
    """The most important first: the first hit's place, ray numbers, camera, lights, normals."""
    seen, labels = drawing.seen, []
    if seen.view.observer == "camera" and seen.view.filled:
        return _light_names(drawing)  # the tiles hide what the others would name
    rays = ray_order(seen)
    for number, ray in enumerate(rays, start=1):
        line = next((each for each in seen.chosen if each.ray == ray and each.light < 0), None)
        if line and len(rays) > 1 and len(rays) <= 9 and (at := _middle(drawing, line)):
            labels.append(Label(str(number), at, bold=True))
    if seen.view.observer != "camera" and (eye := drawing.point(seen.plane.eye)):
        labels.append(Label(say("stage.camera"), eye))
    labels += _light_names(drawing)
    first = next((line for line in seen.chosen if line.light < 0 and not line.leaves), None)
    if first and (at := drawing.point(first.ends[1])):
        labels.append(Label(vector(first.ends[1]), at))
    return labels


def _light_names(drawing: Drawing) -> list[Label]:
    at = [drawing.point(np.array(light.position, float)) for light in drawing.scene.lights]
    return [
        Label(light.name, point)
        for light, point in zip(drawing.scene.lights, at, strict=True)
        if point
    ]


def _middle(drawing: Drawing, line: RayLine) -> Point | None:
    """The middle of what is seen of a ray, for its number."""
    found = drawing.line(line.ends)
    if not found:
        return None
    at, (first, last) = found
    middle = at[0] + (0.45 * first + 0.55 * last) * (at[1] - at[0])
    return (float(middle[0]), float(middle[1]))


def ray_order(seen: Seen) -> list[int]:
    """The selected pixel's rays as they are numbered: each followed by what it led to."""
    return tree_rows(seen.trace, seen.view.index) if seen.chosen else []


def _around(at: Point, radius: float) -> Box:
    return Box(at[0] - radius, at[1] - radius, 2 * radius, 2 * radius)
