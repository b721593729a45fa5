"""A ray's line on a slide ends where its hit point is seen, in every format."""

from __future__ import annotations

import io
import re
from xml.etree import ElementTree

import numpy as np
import pytest
from pptx import Presentation
from pypdf import PdfReader

from raywalk.slides.figure import Deck
from raywalk.slides.layout import LAYOUTS
from raywalk.slides.palette import PRINT, SCREEN
from raywalk.slides.pdf import deck_pdf
from raywalk.slides.pptx import deck_pptx
from raywalk.slides.svg import standalone

NEAR = 0.1  # points: what the eye cannot tell apart on any projector
STEP = 1  # of the lesson: the selected pixel's rays alone


@pytest.fixture(scope="module", params=["16:9", "4:3"])
def expected(request, balls):
    """(rays, 2, 2) both ends of the step's rays, projected by hand to the slide's points; the deck
    and the slide's place in it."""
    layout = LAYOUTS[request.param]
    lesson = balls.lesson(request.param)
    stop = lesson.stops[STEP]
    eye = np.array(stop.observer["eye"])
    forward = np.array(stop.observer["target"]) - eye
    forward = forward / np.linalg.norm(forward)
    right = np.cross(forward, [0, 1, 0])
    right = right / np.linalg.norm(right)
    up = np.cross(right, forward)
    box = layout.figure
    focal = min(box.width, box.height) / 2 / np.tan(np.radians(stop.observer["fov"] / 2))
    start = {1: balls.scene.camera.eye, 2: stop.rows[0].point}  # the camera ray, its reflection
    ends = np.array([
        [start[line.ray] if line.light < 0 else stop.rows[line.ray - 1].point, line.to]
        for line in stop.chosen
    ]) - eye  # fmt: skip
    depth = ends @ forward
    x = box.left + box.width / 2 + focal * (ends @ right) / depth
    y = box.top + box.height / 2 - focal * (ends @ up) / depth
    at = np.stack([x, y], axis=-1)
    inside = (at > [box.left, box.top]).all((1, 2)) & (at < [box.right, box.bottom]).all((1, 2))
    assert inside.sum() >= 3  # of camera, reflected and shadow rays
    deck = balls.deck(request.param)
    title = "The mirror sends the ray on."
    slide = next(k for k, s in enumerate(deck.slides) if s.figure and s.title == title)
    return at[inside], deck, slide


def assert_all_drawn(rays: np.ndarray, starts: np.ndarray, ends: np.ndarray) -> None:
    """Some drawn stretch starts at each ray's start, and some ends at its end."""
    for start, end in rays:
        assert np.abs(starts - start).max(axis=1).min() < NEAR
        assert np.abs(ends - end).max(axis=1).min() < NEAR


def test_in_svg(expected):
    rays, deck, k = expected
    figure = deck.slides[k].figure
    root = ElementTree.fromstring(standalone([figure], figure.items[0].box, PRINT, "t", "a"))
    lines = root.findall(".//{http://www.w3.org/2000/svg}line")
    at = np.array([[[float(line.get(f"{c}{e}")) for c in "xy"] for e in (1, 2)] for line in lines])
    assert_all_drawn(rays, at[:, 0], at[:, 1])


def test_in_pdf(expected):
    rays, deck, k = expected
    page = PdfReader(io.BytesIO(deck_pdf(deck, PRINT))).pages[k]
    number = r"(-?[\d.]+)"
    stroke = rf"{number} {number} m {number} {number} l S"
    found = re.findall(stroke, page.get_contents().get_data().decode("latin-1"))
    at = np.array(found, float).reshape(-1, 2, 2)
    at[..., 1] = deck.height - at[..., 1]
    assert_all_drawn(rays, at[:, 0], at[:, 1])


def test_in_pptx(expected):
    rays, deck, k = expected
    slide = Presentation(io.BytesIO(deck_pptx(deck, SCREEN))).slides[k]
    at = np.array(connectors(slide))
    assert_all_drawn(rays, at[:, 0], at[:, 1])


def connectors(slide) -> list:
    """[[begin x, y], [end x, y]] in points of every connector, those in groups too."""
    name = {"p": "http://schemas.openxmlformats.org/presentationml/2006/main",
            "a": "http://schemas.openxmlformats.org/drawingml/2006/main"}  # fmt: skip
    found = []
    for line in slide._element.iterfind(".//p:cxnSp", name):
        frame = line.find("p:spPr/a:xfrm", name)
        off, ext = frame.find("a:off", name), frame.find("a:ext", name)
        x, y = int(off.get("x")), int(off.get("y"))
        w, h = int(ext.get("cx")), int(ext.get("cy"))
        left, right = (x + w, x) if frame.get("flipH") else (x, x + w)
        top, bottom = (y + h, y) if frame.get("flipV") else (y, y + h)
        found.append([[left / 12700, top / 12700], [right / 12700, bottom / 12700]])
    return found


def test_groups_do_not_move_what_is_in_them(expected):
    """In PPTX a group's children have coordinates of their own: here the slide's."""
    _, deck, k = expected
    slide = Presentation(io.BytesIO(deck_pptx(deck, SCREEN))).slides[k]
    uri = "{http://schemas.openxmlformats.org/drawingml/2006/main}"
    frames = [f for f in slide._element.iter(f"{uri}xfrm") if f.find(f"{uri}chOff") is not None]
    assert frames
    for frame in frames:
        assert dict(frame.find(f"{uri}off").attrib) == dict(frame.find(f"{uri}chOff").attrib)
        assert dict(frame.find(f"{uri}ext").attrib) == dict(frame.find(f"{uri}chExt").attrib)


def test_a_deck_is_a_deck(deck: Deck):
    """Title, goals, four steps with one answer, of a pixel's rays a slide each before the step
    that has them all, credits, and behind them the numbers."""
    kinds = [slide.kind for slide in deck.slides]
    assert [kind for kind in kinds if kind != "build"] == [
        "title", "goals", "step", "step", "step", "question", "answer", "credits", "backup",
        "sum", "sum", "sum",
    ]  # fmt: skip
    assert kinds[2:5] == ["step", "build", "build"]
