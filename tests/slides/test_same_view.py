"""The slides' onlooker stands where the viewer's does, and sees a point at the same place."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
from numpy.testing import assert_allclose

from raywalk.pipeline import read_display
from raywalk.products import write_display
from raywalk.scene import read_scene
from raywalk.site.scene_data import scene_data
from raywalk.slides.frustum import picture_plane
from raywalk.slides.observer import Projection, observer_of
from raywalk.slides.placing import read_placed
from raywalk.slides.views import stops_of
from raywalk.trace.wavefront import Tracer

ROOT = Path(__file__).parent.parent.parent
# A start view, places of an onlooker, the camera's view, a mesh, a room of planes, answers.
SCENES = ("01-shading", "05-many-bounces", "06-bunny-far", "08-glass", "10-cornell-box")
SIZES = ((520.0, 360.0), (330.0, 248.0))  # the figures of both aspects


def test_every_stop_of_every_kind_of_scene(tmp_path):
    """Views, frusta, onlookers and projections equal the bundled TypeScript's."""
    placed, asked = [], []
    for id in SCENES:
        scene = read_scene(ROOT / "scenes" / id)
        write_display(tmp_path / f"{id}.npz", scene, Tracer(scene))
        data = scene_data(scene, read_display(scene, tmp_path / f"{id}.npz"))
        for width, height in SIZES:
            placed.append((read_placed(scene, tmp_path / f"{id}.npz"), width, height))
            asked.append({"scene": data, "width": width, "height": height})
    (tmp_path / "asked.json").write_text(json.dumps(asked), encoding="utf-8")
    command = ["node", str(Path(__file__).with_name("observer-numbers.mjs")),
               str(tmp_path / "asked.json")]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT)
    for (known, width, height), answers in zip(placed, json.loads(done.stdout), strict=True):
        plane = picture_plane(known)
        for stop, viewer in zip(stops_of(known.scene), answers, strict=True):
            observer = observer_of(stop.view.observer, known, plane, width / height)
            points = np.array([
                *plane.corners(), *(light.position for light in known.scene.lights), known.centre,
            ])  # fmt: skip
            seen = Projection(observer, width, height).project(points)
            assert [stop.view.n, list(stop.view.pixel)] == [viewer["n"], viewer["pixel"]]
            assert list(stop.view.rays) == viewer["rays"]
            assert stop.view.filled == (viewer["tiles"] == "filled")
            # float64 on both sides, in another order of sums: 1e-9 is 10^5 roundings or more
            # after the start view's 12 rounds of fitting.
            near = {"rtol": 1e-9, "atol": 1e-9}
            assert_allclose(observer.eye, viewer["eye"], **near)
            assert_allclose(observer.target, viewer["target"], **near)
            assert_allclose(observer.fov, viewer["fov"], **near)
            assert_allclose(plane.corners(), viewer["corners"], **near)
            assert_allclose(seen, viewer["seen"], rtol=1e-8, atol=1e-7)
