"""What a step works out, on its slide: its key rows on a plate in the figure, with a tile enlarged
above them or curves on another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from raywalk.scene.model import Scene
from raywalk.slides import worked_average, worked_curve, worked_equation, worked_tree
from raywalk.slides.clip import clipped_line
from raywalk.slides.figure import Item, Picture, Point, Polygon
from raywalk.slides.labels import Inset, Places
from raywalk.slides.layout import Box
from raywalk.slides.stops import Stop
from raywalk.slides.table_parts import table_parts
from raywalk.slides.words import say
from raywalk.slides.worked_figures import MOST_ROWS, Figures, Worked, table_of, view_of

SIDE = 150.0  # of a tile, enlarged
PAD, EDGE = 8.0, 10.0  # round what stands on the plate; from it to the figure's edge
OPACITY = 0.9
TENTHS = 10  # of a plate: less of the scene under it is no reason


@dataclass(frozen=True, eq=False)
class Panel:
    """What stands on a stop's slide beside its figure."""

    figures: Figures
    rays_inside: int = 0  # of the selected tile, shown enlarged
    spheres: Sequence[worked_equation.Json] = ()  # whose curves are drawn, on a plate beside


def panel_of(scene: Scene, stops: Sequence[Stop], stop: Stop, worked: Worked) -> Panel | None:
    """None where the step works nothing out, or its question is still open."""
    works = view_of(scene, stop).get("works")
    if stop.kind == "question" or not works:
        return None
    if works == "average":
        count = worked_average.rays_of(scene, stop)
        return Panel(worked_average.key_figures(scene, stop, worked), count if count > 1 else 0)
    if works == "equation":
        ray = worked_equation.equation_of(worked, stop)
        if not ray:
            return None
        spheres = worked_equation.key_curves(scene, stop, ray)
        return Panel(worked_equation.key_figures(scene, stop, ray), spheres=spheres)
    return Panel(_of_tree(scene, stops, stop, worked))


def _of_tree(scene: Scene, stops: Sequence[Stop], stop: Stop, worked: Worked) -> Figures:
    """A ray's first boxes when it is walked first, those that are cut off when it is walked again,
    then how many there are on each level; in an answer, the ray beside those before it."""
    cut = view_of(scene, stop).get("tree_depth") or "all"
    if cut != "all":
        return worked_tree.depth_figures(worked, stop, cut)
    before = [each.pixel for each in stops[: stops.index(stop)] if walks_tree(scene, each)]
    visits = worked_tree.visits_of(worked, stop.pixel)
    cut_off = [visit for visit in visits if visit.what == worked_tree.CUT_OFF]
    times = before.count(stop.pixel)
    if stop.kind == "answer" and before and not times:
        rays = [*dict.fromkeys(before), stop.pixel][-MOST_ROWS:]
        return worked_tree.compared(worked, stop.n, rays)
    if times == 0:
        return worked_tree.first_visits(stop, visits)
    if times == 1 and cut_off:
        return worked_tree.visit_figures(stop, cut_off[:MOST_ROWS])
    return worked_tree.level_figures(stop, visits)


def walks_tree(scene: Scene, stop: Stop) -> bool:
    """Whether a stop follows its ray through the whole tree."""
    view = view_of(scene, stop)
    is_whole = view.get("tree_depth") in (None, "all")
    return view.get("works") == "tree" and is_whole and stop.kind != "question"


def panel_inset(panel: Panel, scene: Scene, stop: Stop, worked: Worked) -> Inset:
    """What draws it where it covers least of the figure."""

    def draw(places: Places) -> list[Item]:
        table = table_of(panel.figures, 0.0, 0.0)
        items: list[Item] = []
        if panel.spheres:
            ground, left, top = _plate(places, worked_curve.WIDE, worked_curve.HIGH)
            items += [ground, worked_curve.curves(scene, panel.spheres, left, top)]
        above = SIDE + PAD if panel.rays_inside else 0.0
        wide = max(table.box.width, SIDE if panel.rays_inside else 0.0)
        ground, left, top = _plate(places, wide, table.box.height + above)
        items.append(ground)
        if panel.rays_inside:
            frame = Box(left, top, SIDE, SIDE)
            inner: Picture = worked_average.inside(worked, stop, panel.rays_inside, frame)
            items += [inner, Polygon(frame.corners, None, "rule", 1.0, name=inner.name)]
        at = Box(left, top + above, table.box.width, table.box.height)
        return [*items, *table_parts(replace(table, box=at))]

    return draw


def _plate(places: Places, wide: float, high: float) -> tuple[Polygon, float, float]:
    """A plate where it covers little, and where what stands on it begins: left, top."""
    box = _free(places, wide + 2 * PAD, high + 2 * PAD)
    places.boxes.append(box)
    name = say("slides.worked.plate")
    ground = Polygon(box.corners, "ground", "rule", 0.75, OPACITY, name)
    return ground, box.left + PAD, box.top + PAD


def _free(places: Places, wide: float, high: float) -> Box:
    """Where it covers the least of other plates, then of rays, of the scene, of thin lines; of
    equal places the first."""
    frame = places.frame
    lefts = (frame.left + EDGE, frame.right - EDGE - wide, frame.left + (frame.width - wide) / 2)
    tops = (frame.top + EDGE, frame.bottom - EDGE - high, frame.top + (frame.height - high) / 2)
    found = [Box(left, top, wide, high) for left in lefts for top in tops]

    def crossed(box: Box, lines: list[tuple[Point, Point]]) -> int:
        return sum(clipped_line(*line, box) is not None for line in lines)

    def covers(box: Box) -> tuple[float, int, int, int]:
        taken = sum(_common(box, other) for other in places.boxes)
        seen = round(TENTHS * places.seen(box))
        return taken, crossed(box, places.strokes), seen, crossed(box, places.faint)

    return min(found, key=covers)


def _common(a: Box, b: Box) -> float:
    """The area that two boxes share."""
    wide = min(a.right, b.right) - max(a.left, b.left)
    high = min(a.bottom, b.bottom) - max(a.top, b.top)
    return wide * high if wide > 0 and high > 0 else 0.0
