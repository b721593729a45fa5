"""What goes into a trace file comes out again, within the errors the file states."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import Encoded, decode
from scenes_for_tests import RED
from tiny_tracer import make_scene, trace_tiny

from raywalk.scene.shapes import Sphere
from raywalk.trace.tree import Visibility
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import TraceFileError
from raywalk.trace_file.precision import COLOUR, NORMAL, finite_extent

EXACT = ("kind", "parent", "depth", "object", "material", "inside", "tests", "pixel")


def test_structure_and_symbols_come_back_exactly(encoded: Encoded) -> None:
    """Rows keep their order; kinds, parents, objects, materials, tests are exact."""
    for name in EXACT:
        np.testing.assert_array_equal(
            getattr(encoded.trace, name), getattr(encoded.tree, name).astype(int), err_msg=name
        )
    hit = encoded.tree.object >= 0
    for name in ("visibility", "blocker"):
        np.testing.assert_array_equal(
            getattr(encoded.trace, name)[hit], getattr(encoded.tree, name)[hit], err_msg=name
        )


def test_no_number_is_off_by_more_than_the_header_says(encoded: Encoded) -> None:
    tree, trace, stated = encoded.tree, encoded.trace, encoded.trace.header["errors"]
    hit = tree.object >= 0

    def most(difference: np.ndarray) -> float:
        return float(np.abs(difference).max(initial=0.0))

    assert most(np.linalg.norm((trace.point - tree.point)[hit], axis=1)) <= stated["point"]
    assert most(trace.t[hit] - tree.t[hit]) <= stated["t"]
    assert most(np.linalg.norm(trace.normal - tree.normal, axis=1)) <= stated["normal"]
    assert most(trace.weight - tree.weight) <= stated["weight"]
    assert most(trace.colour - tree.colour) <= stated["colour"]
    assert most(trace.hitsT - tree.hits_t) <= stated["hits"]


def test_stated_errors_are_small_enough_to_read_three_decimals(encoded: Encoded) -> None:
    """Points 2e-5 of the finite extent, at most 5e-4; normals 2e-4; colours 0.1 of 255."""
    stated = encoded.trace.header["errors"]
    allowed = min(2e-5 * finite_extent(encoded.tree, encoded.scene), 5e-4) * 1.03  # digits stated
    assert stated["point"] <= allowed
    assert stated["hits"] <= allowed
    assert stated["normal"] <= 1.03 * NORMAL
    assert stated["colour"] <= COLOUR


def test_tiles_are_the_pictures_pixels(encoded: Encoded) -> None:
    np.testing.assert_array_equal(encoded.trace.tiles, encoded.picture.reshape(-1))


def test_every_light_can_be_switched_off_within_the_colour_error(encoded: Encoded) -> None:
    """local - its term, at every ray: the what-if switch of the viewer."""
    tree, trace, materials = encoded.tree, encoded.trace, encoded.scene.materials
    lit = np.isin(tree.visibility, (Visibility.REACHED, Visibility.UNTESTED))
    for l, light in enumerate(encoded.scene.lights):
        for c in range(3):
            kd = np.array([m.diffuse[c] for m in materials] + [0.0])[tree.material]
            ks = np.array([m.specular[c] for m in materials] + [0.0])[tree.material]
            true = (tree.diffuse[:, l] * kd + tree.specular[:, l] * ks) * tree.local_weight
            kept = (trace.diffuse[:, l] * kd + trace.specular[:, l] * ks) * trace.localWeight
            off = np.where(lit[:, l], (kept - true) * light.colour[c], 0.0)
            assert np.abs(off).max(initial=0.0) <= COLOUR


def test_blockers_stand_where_they_stood(encoded: Encoded) -> None:
    """Along the way to the light, in world units."""
    tree, trace = encoded.tree, encoded.trace
    for l, light in enumerate(encoded.scene.lights):
        way = np.linalg.norm(np.array(light.position) - tree.point, axis=1)
        blocked = tree.visibility[:, l] == Visibility.BLOCKED
        off = ((trace.blockedAt - tree.blocked_at)[:, l] * way)[blocked]
        assert np.abs(off).max(initial=0.0) <= trace.header["errors"]["blocked"]


def test_hits_along_a_camera_ray_never_go_back(encoded: Encoded) -> None:
    trace = encoded.trace
    inner = np.ones(len(trace.hitsT), bool)
    inner[trace.hitsStart[:-1][np.diff(trace.hitsStart) > 0]] = False
    steps = np.diff(trace.hitsT, prepend=0.0)
    assert (steps[inner] >= 0).all()
    np.testing.assert_array_equal(trace.hitsObject, encoded.tree.hits_object)


def test_encoding_twice_gives_the_same_bytes(encoded: Encoded) -> None:
    assert encode(encoded.tree, encoded.scene, encoded.picture) == encoded.json


def test_colours_that_do_not_add_up_are_not_written(glass: Encoded) -> None:
    wrong = replace(glass.tree, colour=glass.tree.colour + 0.01)
    with pytest.raises(TraceFileError, match="do not add up"):
        encode(wrong, glass.scene, glass.picture)


def test_rays_that_all_leave_are_a_trace_too() -> None:
    """One sphere, behind the camera."""
    sky = (0.2, 0.3, 0.4)
    scene = make_scene([(Sphere((0, 0, 50), 1), 0)], [RED], [], size=5, background=sky)
    tree, picture = trace_tiny(scene)
    trace = decode(encode(tree, scene, picture))
    assert (trace.object == -1).all()
    assert np.isinf(trace.t).all()
    np.testing.assert_array_equal(trace.tiles, picture.reshape(-1))
