"""What steps work out, on slides and sheets: figures are those of the trace. Key rows stand on the
slides of their steps, all rows behind the lesson."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.slides.course import ROOT, CourseDeck, decks_of

from raywalk.scene.read import read_scene
from raywalk.slides import worked_tree
from raywalk.slides.figure import (
    Dot,
    Group,
    Item,
    Line,
    Picture,
    Polygon,
    Slide,
    Table,
    Text,
    flat,
)
from raywalk.slides.stops import Stop
from raywalk.slides.words import numbers, say, speaking
from raywalk.slides.worked_curve import OF
from raywalk.slides.worked_figures import MOST_ROWS, view_of
from raywalk.slides.worked_panel import walks_tree
from raywalk.trace.equations import equations_of
from raywalk.trace.pixel_tree import tree_at
from raywalk.trace.wavefront import Tracer

EQUATION, TREE, AVERAGE = "11-what-is-a-ray", "17-boxes-in-boxes", "18-jagged-edges"
WORKING = (EQUATION, TREE, AVERAGE)


@pytest.fixture(scope="module", params=WORKING)
def of_lesson(request: pytest.FixtureRequest) -> list[CourseDeck]:
    return decks_of(request.param)


def firsts(each: CourseDeck) -> list[tuple[Stop, Slide]]:
    """Each stop with the first of its slides."""
    slides = [slide for slide in each.slides if slide.figure]
    return list(zip(each.lesson.stops, slides, strict=True))


def rows_on(items: tuple[Item, ...]) -> list[list[str]]:
    """The words of a panel's table, row by row."""
    cells = [i for i in flat(items) if isinstance(i, Text) and i.name == "cell"]
    tops = sorted({cell.box.top for cell in cells})
    return [[cell.words for cell in cells if cell.box.top == top] for top in tops]


def figure_of(slide: Slide) -> Group:
    assert slide.figure
    return slide.figure


def curves_on(slide: Slide) -> list[Group]:
    return [i for i in figure_of(slide).items if isinstance(i, Group) and i.name == OF]


def tables_behind(each: CourseDeck) -> list[list[str]]:
    """The rows of all tables of what was worked out, their cells' words."""
    names = {say("slides.table"), say("slides.sumTable")}
    tables = [
        item for slide in each.deck.slides if slide.kind == "table"
        for item in slide.items if isinstance(item, Table) and item.name not in names
    ]  # fmt: skip
    return [[cell.text for cell in row] for table in tables for row in table.rows]


def test_a_step_shows_its_key_rows_and_no_more(of_lesson):
    """A heading and up to four rows, 18 points high, on a plate; none while a question is open."""
    for each in of_lesson:
        with speaking(each.language):
            for stop, slide in firsts(each):
                rows = rows_on(figure_of(slide).items)
                works = view_of(each.lesson.scene, stop).get("works")
                if stop.kind == "question" or not works:
                    assert not rows, (each.name, slide.title)
                    continue
                assert 2 <= len(rows) <= MOST_ROWS + 1, (each.name, slide.title)
                plates = [
                    i for i in flat(figure_of(slide).items)
                    if isinstance(i, Polygon) and i.name == say("slides.worked.plate")
                ]  # fmt: skip
                assert len(plates) == (2 if curves_on(slide) else 1)
                assert not any(
                    s.figure and rows_on(s.figure.items) for s in each.slides if s.kind == "build"
                )


def test_a_panel_is_told_to_who_does_not_see_it(of_lesson):
    for each in of_lesson:
        with speaking(each.language):
            for _, slide in firsts(each):
                figure = figure_of(slide)
                for row in rows_on(figure.items)[1:]:
                    assert all(word in figure.alt for word in row), (each.name, slide.title)


def test_all_rows_stand_behind_the_lesson(of_lesson):
    """Whatever a step's slide shows of a ray or tile is there, with the rest."""
    for each in of_lesson:
        with speaking(each.language):
            behind = {word for row in tables_behind(each) for word in row}
            for stop, slide in firsts(each):
                if stop.kind == "step":
                    shown = rows_on(figure_of(slide).items)
                    rows = [row for row in shown if "+" not in row[0]]  # o + 2.00 d: on its way
                    figures = {word for row in rows for word in row} - {"…"}
                    assert figures <= behind, (each.name, slide.title, figures - behind)


def test_roots_and_discriminants_are_the_tracers_and_those_of_raywalk_pixel():
    """To all digits in what slides are made from; on them rounded as on the page. No letter stands
    on a slide before the lesson's words had it."""
    scene = read_scene(ROOT / "scenes" / "01-shading")
    tracer = Tracer(scene)
    for each in decks_of(EQUATION):
        rays = each.lesson.worked["equations"]
        asked = [(ray["n"], *ray["pixel"]) for ray in rays]
        assert rays == equations_of(tracer, asked)
        for ray in rays:
            n, (column, row) = ray["n"], ray["pixel"]
            hits = tree_at(tracer, row * n + column, n, n)["tree"]["hits"]
            roots = [
                (scene.objects[sphere["object"]].name, t)
                for sphere in ray["spheres"] for t in sphere["t"]
            ]  # fmt: skip
            assert sorted(roots, key=lambda root: root[1]) == [(h["object"], h["t"]) for h in hits]
        with speaking(each.language):
            shown = [rows_on(figure_of(slide).items) for _, slide in firsts(each)]
            letters = [rows[0] for rows in shown if rows]
            assert "b" not in letters[1] and "b" in letters[2] and "D" not in letters[2]
            assert letters[3][-3:] == ["D", "t₁", "t₂"]
            blue = next(s for s in rays[0]["spheres"] if s["t"])
            assert shown[3][1][1:] == [
                numbers().fixed(blue["b"], 2), numbers().fixed(blue["c"], 2),
                numbers().fixed(blue["discriminant"], 2), *map(numbers().number, blue["t"]),
            ]  # fmt: skip


def test_a_step_that_speaks_of_a_curve_shows_it():
    """From D on, for each sphere it is about: it crosses the line at the roots, touches it where
    the ray grazes, and stays above it where the ray misses. None while a question is open."""
    for each in decks_of(EQUATION):
        rays = each.lesson.worked["equations"]
        with speaking(each.language):
            shown = [(stop, curves_on(slide)) for stop, slide in firsts(each)]
        assert [bool(curves) for _, curves in shown[:4]] == [False, False, False, True]
        assert not any(curves for stop, curves in shown if stop.kind == "question")
        seen = set()
        for stop, curves in shown:
            for curve in curves:
                meant = view_of(each.lesson.scene, stop)["highlight"]
                ray = next(r for r in rays if tuple(r["pixel"]) == stop.pixel)
                spheres = [
                    s
                    for s in ray["spheres"]
                    if each.lesson.scene.objects[s["object"]].name in meant
                ]
                zero, *pieces = [i for i in curve.items if isinstance(i, Line)]
                line = zero.start[1]
                dots = [i for i in curve.items if isinstance(i, Dot)]
                assert len(dots) == sum(len(s["t"]) for s in spheres)
                assert all(dot.centre[1] == line for dot in dots)
                least = max(max(i.start[1], i.end[1]) for i in pieces)  # y goes down
                misses = not dots
                assert misses == (least < line)
                seen.add("misses" if misses else "meets")
        assert seen == {"misses", "meets"}


def test_means_are_those_of_the_pictures_own_pixels():
    """Of pixels of the picture that was traced, a finer grid's in the tile."""
    for each in decks_of(AVERAGE):
        picture = np.asarray(Image.open(each.sources.traced / "picture.png").convert("RGB"), float)
        with speaking(each.language):
            for stop, slide in firsts(each):
                for row in rows_on(figure_of(slide).items)[1:]:
                    k = round(int(row[0]) ** 0.5)
                    rays = tile_rays(picture, stop, k)
                    mean = np.floor(rays.mean(axis=(0, 1)) + 0.5).astype(int).tolist()
                    assert row[1] == ", ".join(map(str, mean)), (each.name, slide.title)


def tile_rays(picture: np.ndarray, stop: Stop, k: int) -> np.ndarray:
    """(k, k, 3) the picture's pixels at the middles of a tile's k x k parts."""
    step = len(picture) // (stop.n * k)
    columns, rows = ((stop.pixel[a] * k + np.arange(k)) * step + step // 2 for a in (0, 1))
    return picture[np.ix_(rows, columns)]


def test_the_enlarged_tile_shows_each_ray(tmp_path: Path):
    """A square a ray, without loss."""
    [each, *_] = decks_of(AVERAGE)
    picture = np.asarray(Image.open(each.sources.traced / "picture.png").convert("RGB"))
    with speaking(each.language):
        inner = [
            (stop, i) for stop, slide in firsts(each) for i in flat(figure_of(slide).items)
            if isinstance(i, Picture) and i.name == say("slides.worked.inside", count=49)
        ]  # fmt: skip
    assert inner
    for stop, shown in inner:
        file = tmp_path / "tile.png"
        file.write_bytes(shown.on_paper)
        pixels = np.asarray(Image.open(file).convert("RGB"))
        side = len(pixels) // 7
        middles = pixels[side // 2 :: side, side // 2 :: side][:7, :7]
        assert (middles == tile_rays(picture, stop, 7)).all()


def test_tests_of_the_tree_are_counted_as_raywalk_pixel_counts_them():
    """The last of a ray's boxes has its sum; so has the table of depths."""
    scene = read_scene(ROOT / "scenes" / "06-bunny-far")
    tracer = Tracer(scene)
    for each in decks_of(TREE):
        worked = each.lesson.worked
        walked = {s.pixel for s in each.lesson.stops if walks_tree(each.lesson.scene, s)}
        assert {(6, 3), (12, 10), (7, 2)} <= walked
        with speaking(each.language):
            behind = tables_behind(each)
        for column, row in walked:
            tests = tree_at(tracer, row * 15 + column, 15, 15)["tree"]["tests"]
            visits = worked_tree.visits_of(worked, (column, row))
            assert visits[-1].tests == tests == worked_tree.tests_of(worked, (column, row), "all")
            assert any(cells[0] == str(len(visits)) and cells[-1] == str(tests) for cells in behind)
