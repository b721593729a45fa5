"""What mirrors and glass have round them, for the stage's approximate look."""

from __future__ import annotations

import base64
import math
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raywalk.geometry.compiled import rays_from
from raywalk.scene.read import read_scene
from raywalk.trace.surroundings import ANGLES, PARALLEL, SIDE, directions, surroundings_of, turns
from raywalk.trace.wavefront import Tracer, eight_bit

SCENES = Path("scenes")
GLASS, MIRROR = "08-glass", "04-one-bounce"


def tracer_of(name: str) -> Tracer:
    return Tracer(read_scene(SCENES / name))


def test_a_picture_of_all_directions_has_each_octant_equally_often_and_all_are_unit() -> None:
    """But for the pixels on the folds, which lie in a plane between two octants."""
    way = directions(32)
    assert np.allclose((way**2).sum(axis=1), 1, atol=1e-12)
    octants = (way > 0) @ [1, 2, 4]
    on_folds = 32 // 4
    assert np.abs(np.bincount(octants, minlength=8) - 32 * 32 // 8).max() <= on_folds


def test_no_direction_lies_farther_than_two_pixels_from_one_of_the_pictures() -> None:
    """Seed 7. A square of side 2 holds all of them: a pixel is at most about 4 / side wide."""
    random = np.random.default_rng(7).normal(size=(200, 3))
    random /= np.linalg.norm(random, axis=1)[:, None]
    nearest = (random @ directions(64).T).max(axis=1)
    assert np.arccos(np.minimum(1, nearest)).max() < 2 * 4 / 64


def test_a_mirror_turns_a_ray_by_twice_the_angle_to_its_surface() -> None:
    material = tracer_of(MIRROR).scene.materials[
        next(o.material for o in tracer_of(MIRROR).scene.objects if "mirror" in o.name)
    ]
    for cosine, (turn, share, through, between) in zip(
        np.linspace(0, 1, ANGLES), turns(material), strict=True
    ):
        # From the way to its mirror image: twice the angle between way and surface.
        assert turn == pytest.approx(2 * math.asin(cosine), abs=2e-5)
        assert (share, through, between) == (1, 0, 0)


def test_glass_turns_a_ray_as_snell_says_and_shares_it_as_fresnel_does() -> None:
    scene = tracer_of(GLASS).scene
    material = next(m for m in scene.materials if m.transmit == 1)
    for cosine, (_, share, turn, between) in list(
        zip(np.linspace(0, 1, ANGLES), turns(material), strict=True)
    )[1:]:
        incidence = math.acos(cosine)
        refracted = math.asin(math.sin(incidence) / material.ior)
        assert turn == pytest.approx(-2 * (incidence - refracted), abs=2e-5)
        assert between == pytest.approx(math.pi - 2 * refracted, abs=2e-5)
        s = [
            (a - b) / (a + b)
            for a, b in (
                (math.cos(incidence), material.ior * math.cos(refracted)),
                (material.ior * math.cos(incidence), math.cos(refracted)),
            )
        ]
        assert share == pytest.approx((s[0] ** 2 + s[1] ** 2) / 2, abs=2e-5)


def test_through_parallel_faces_a_ray_goes_straight_on() -> None:
    material = next(m for m in tracer_of(GLASS).scene.materials if m.transmit == 1)
    assert all(row[2:] == [0, 0] for row in turns(material, flat=True))


def test_each_mirror_and_glass_body_has_its_surroundings_and_nothing_else() -> None:
    scene = tracer_of(GLASS).scene
    data = surroundings_of(tracer_of(GLASS))
    assert data is not None
    named = {scene.objects[each["object"]].name for each in data["objects"]}
    assert named == {
        "glass sphere",
        "glass ellipsoid",
        "glass cylinder",
        "glass slab",
        "mirror sphere",
    }
    assert isinstance(next(o.shape for o in scene.objects if o.name == "glass slab"), PARALLEL)


def test_of_flat_mirrors_the_share_is_told_and_of_a_floor_a_little_is_enough() -> None:
    """The moon is a disc; the floor's tiles mirror 18 %; gold mirrors 30 % and is no floor."""
    scene = tracer_of("09-dragon").scene
    data = surroundings_of(tracer_of("09-dragon"))
    assert data is not None
    told = {scene.objects[each["object"]].name: each["share"] for each in data["flat"]}
    assert told == {"floor": 0.18, "moon": 1.0}
    bodies = {scene.objects[each["object"]].name for each in data["objects"]}
    assert "moon" not in bodies and not any("gold" in name for name in bodies)


def test_a_scene_without_mirrors_and_glass_has_none() -> None:
    assert surroundings_of(tracer_of("01-shading")) is None


def test_the_picture_is_what_a_ray_from_the_place_sees_as_if_the_body_were_not_there(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Every 97th direction of a ball. WebP may be off by a few of 255, where two things meet in a
    pixel's neighbourhood by more: nine of ten are close."""
    tracer = tracer_of(MIRROR)
    monkeypatch.setattr("raywalk.trace.surroundings.MOST", 1)
    data = surroundings_of(tracer)
    assert data is not None
    body = data["objects"][0]
    file = BytesIO(base64.b64decode(body["picture"].split(",")[1]))
    picture = np.asarray(Image.open(file)).reshape(-1, 4)[::97].astype(int)
    way = directions(SIDE)[::97]
    away = np.array(body["centre"]) + body["radius"] * way
    start = rays_from(away, way)
    start.leaving[:] = body["object"]
    seen = tracer.to_the_end(start, [])[0]
    assert np.mean(np.abs(picture[:, :3] - eight_bit(seen.colour)).max(axis=1) < 16) > 0.9
    distance = np.linalg.norm(seen.hits.point - body["centre"], axis=1)
    near = np.where(seen.hits.object < 0, 0, 255 * body["radius"] / (body["radius"] + distance))
    assert np.abs(picture[:, 3] - near).max() <= 1


def test_of_many_mirrors_the_largest_have_surroundings(monkeypatch: pytest.MonkeyPatch) -> None:
    tracer = tracer_of(GLASS)
    monkeypatch.setattr("raywalk.trace.surroundings.MOST", 2)
    monkeypatch.setattr("raywalk.trace.surroundings.SIDE", 8)
    data = surroundings_of(tracer)
    assert data is not None
    named = [tracer.scene.objects[each["object"]].name for each in data["objects"]]
    assert named == ["glass cylinder", "glass slab"]  # 0.93 and 1.07 round; the sphere 0.85
