"""`raywalk inspect` tells a pixel's whole ray tree."""

from __future__ import annotations

import json

import numpy as np
import pytest
from conftest import Encoded

from raywalk.stops.pixel_rays import as_json, describe


def rays_in(node: dict) -> list[dict]:
    return [node, *(ray for child in node["children"] for ray in rays_in(child))]


@pytest.mark.parametrize("pixel", [(0, 0), (7, 9), (10, 10), (20, 20)])
def test_json_holds_every_number_of_every_ray(encoded: Encoded, pixel: tuple[int, int]) -> None:
    trace = encoded.trace
    as_read = json.loads(json.dumps(as_json(trace, pixel), allow_nan=False))
    rows = np.flatnonzero(trace.pixel == pixel[1] * trace.n + pixel[0])
    rays = rays_in(as_read["tree"])
    assert sorted(ray["row"] for ray in rays) == rows.tolist()
    for ray in rays:
        k = ray["row"]
        for name in ("point", "normal", "colour", "weight", "localWeight", "tests", "object"):
            assert ray[name] == getattr(trace, name)[k].tolist()
        assert ray["t"] == (trace.t[k] if ray["object"] >= 0 else None)
        for l, light in enumerate(ray["lights"]):
            for name in ("diffuse", "specular", "blockedAt", "blocker"):
                assert light[name] == getattr(trace, name)[k, l]


def test_text_marks_the_nearest_hit_and_sums_the_colour(glass: Encoded) -> None:
    text = describe(glass.trace, (7, 10))
    lines = text.splitlines()
    assert lines[0].startswith("90-test at 21 x 21, pixel 7,10: tile colour ")
    assert lines[2].endswith("<- nearest")
    assert any(line.lstrip().startswith("refracted ray meets") for line in lines)
    assert sum("colour (" in line for line in lines) == (glass.trace.pixel == 10 * 21 + 7).sum()


def test_a_pixel_outside_is_refused(glass: Encoded) -> None:
    with pytest.raises(ValueError, match="outside"):
        describe(glass.trace, (21, 0))
