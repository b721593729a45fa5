"""What paper prints is the tracer's to the last digit, though trace files round."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

from raywalk.errors import UserError
from raywalk.slides.formats import ASKED, SIGHTS
from raywalk.slides.layout import WIDE
from raywalk.stops.decoded import read_trace
from raywalk.trace.pixel_tree import pixel_tree

from .conftest import BALLS, make

GLASS = BALLS.replace('material = "mirror"', 'material = "glass"')
STEP = '[[lesson]]\ntext = "A."\nview = { resolution = 7, pixel = [2, 4], tiles = "filled" }\n'


def walked(node: dict[str, Any]) -> list[dict[str, Any]]:
    """Each ray followed by what it led to; reflected before refracted, as rays are numbered."""
    return [node, *(ray for child in node["children"] for ray in walked(child))]


@pytest.mark.parametrize("scene", [BALLS, GLASS], ids=["mirror", "glass"])
def test_a_slides_rows_are_the_tracers(scene: str, tmp_path: Path):
    """Distance, point, share and colour of each ray of the selected pixel."""
    made = make(tmp_path, scene + STEP)
    [stop] = made.lesson().stops
    # Tile (2, 4) of 7 x 7 has the centre of pixel (22, 40) of 63 x 63.
    rays = walked(pixel_tree(made.scene, 63, 63, 22, 40)["tree"])
    assert [row.kind for row in stop.rows] == [ray["kind"] for ray in rays]
    for row, ray in zip(stop.rows, rays, strict=True):
        assert (row.object or None, row.t) == (ray["object"], ray["t"])
        if ray["point"]:
            assert list(row.point) == ray["point"]
        # Sums of the same products in another order: a few roundings.
        assert_allclose(row.colour, ray["colour"], rtol=0, atol=1e-14)
    total = np.sum([row.gives for row in stop.rows], axis=0)
    assert_allclose(total, rays[0]["colour"], rtol=0, atol=1e-14)
    stored = read_trace(made.sources().traced / "7.json.gz")
    assert stop.rows[0].t != stored.t[4 * 7 + 2], "the file rounds, or this test shows nothing"


def test_rays_that_are_not_those_of_the_file_are_refused(tmp_path: Path):
    """A tracer and a trace file that disagree are named, with scene, pixel and grid."""
    from raywalk.stops.process import Stops
    from raywalk.words import read_words

    made = make(tmp_path, BALLS + STEP)
    sources = made.sources()
    [asked] = made.store.folder.glob(f"*/{ASKED}")
    [scene] = made.store.folder.glob("*/scene.js")
    sights = json.loads((sources.sights / SIGHTS).read_text(encoding="utf-8"))
    sights["exact"][0]["object"][0] = 2
    (tmp_path / SIGHTS).write_text(json.dumps(sights), encoding="utf-8")
    request = {
        "do": "lesson", "scene": str(scene), "traces": str(sources.traced), "asked": str(asked),
        "sights": str(tmp_path / SIGHTS), "words": read_words().tree, "spoken": None,
        "size": {"width": WIDE.figure.width, "height": WIDE.figure.height},
    }  # fmt: skip
    with Stops() as stops, pytest.raises(UserError, match=r"04-balls: the rays of pixel \d,\d"):
        stops.ask(request)
