"""Scenes 8, 9 and 0 show what their lessons say: rays, shares, angles, credits."""

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from raywalk.pipeline.figures import filled_here
from raywalk.scene.models import read_catalogue
from raywalk.scene.read import read_scenes
from raywalk.trace.tree import Kind
from raywalk.trace.wavefront import LEAST_SHARE, Tracer
from raywalk.work.store import Store

ROOT = Path(__file__).parents[2]
BLOCKED, REACHED, BEHIND = 0, 1, 2
NARROW = "\u202f"  # before a percent sign, and between groups of digits

# (key, resolution, pixel): the objects along the ray that carries most of the colour, the
# one thing to see; and what its last hit knows of each light.
SAID = {
    ("8", 15, (8, 11)): ("glass sphere > glass sphere > orange sphere", [REACHED, REACHED]),
    ("8", 15, (12, 7)): ("glass slab > glass slab > right wall", [REACHED, REACHED]),
    ("8", 15, (12, 12)): ("glass slab > glass slab > glass slab > right wall", [REACHED, REACHED]),
    ("8", 15, (5, 13)): ("floor", [REACHED, REACHED]),
    ("8", 15, (8, 12)): ("glass sphere > floor", [REACHED, REACHED]),
    ("9", 15, (5, 5)): ("dragon", [REACHED, REACHED, BEHIND, REACHED]),
    ("9", 15, (4, 10)): ("dragon", [REACHED, BEHIND, BEHIND, REACHED]),
    ("9", 15, (7, 13)): ("floor", [REACHED, REACHED, BLOCKED, REACHED]),
    ("9", 15, (12, 6)): ("back wall", [BLOCKED, REACHED, BLOCKED, BLOCKED]),
    ("9", 15, (2, 4)): ("back wall", [REACHED, BLOCKED, REACHED, REACHED]),
    ("9", 15, (1, 11)): ("glass sphere > glass sphere > dragon", None),
    ("9", 15, (13, 10)): (" > ".join(["glass bunny"] * 4 + ["left wall"]), None),
    ("9", 15, (7, 4)): ("moon > wall behind the camera", [REACHED, REACHED, REACHED, REACHED]),
    ("9", 33, (14, 19)): ("moon > dragon", [BEHIND, REACHED, REACHED, BEHIND]),
    ("0", 15, (9, 11)): ("glass sphere > glass sphere > column", None),
    ("0", 15, (1, 7)): ("left wall", [REACHED, REACHED]),
    ("0", 15, (11, 9)): ("back wall", [BLOCKED, REACHED]),
    ("0", 15, (5, 10)): ("mirror sphere > right wall", None),
    ("0", 15, (4, 11)): ("mirror sphere > yellow sphere", [BEHIND, BEHIND]),
    ("0", 15, (8, 11)): ("glass sphere > glass sphere > column", None),
    ("0", 33, (4, 30)): ("floor", [REACHED, REACHED]),
    ("0", 15, (7, 11)): ("glass sphere > glass sphere > right wall", None),
}


@pytest.fixture(scope="module")
def tracers():
    """With the share below which the site's rays are not followed: what users get to see."""
    scenes = [scene for scene in read_scenes(ROOT / "scenes") if scene.key in list("890")]
    return {scene.key: Tracer(scene, least_share=LEAST_SHARE) for scene in scenes}


class Ray:
    """One ray of a pixel's tree, with its children."""

    def __init__(self, tracer, waves, depth=0, row=0, share=1.0):
        wave, objects = waves[depth], tracer.scene.objects
        hit = int(wave.hits.object[row])
        self.name = objects[hit].name if hit >= 0 else ""
        self.kind = Kind(wave.kind[row])
        self.weight = float(wave.weight[row])
        self.share = share * self.weight
        self.local_share = self.share * float(wave.lighting.local_weight[row])
        self.visibility = list(wave.lighting.visibility[row])
        self.blockers = [objects[k].name if k >= 0 else "" for k in wave.lighting.blocker[row]]
        cosine = -wave.rays.direction[row] @ wave.hits.normal[row]
        self.angle = float(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))
        after = waves[depth + 1].parent if depth + 1 < len(waves) else []
        self.children = [
            Ray(tracer, waves, depth + 1, child, self.share)
            for child in np.flatnonzero(np.equal(after, row))
        ]

    def heaviest(self):
        """This ray and its heaviest descendants, down to where most of the colour arises."""
        heaviest = max(self.children, key=lambda child: child.share, default=None)
        if heaviest is None or heaviest.share < self.local_share:
            return [self]
        return [self, *heaviest.heaviest()]


def tree(tracers, key, n, pixel):
    column, row = pixel
    tracer = tracers[key]
    return Ray(tracer, tracer.waves(np.array([row * n + column]), n, n))


@pytest.fixture(scope="module")
def said(tracers, tmp_path_factory):
    """All texts of the lessons as one reads them, by key, with single spaces."""
    store = Store(tmp_path_factory.mktemp("work"))
    scenes = {key: filled_here(store, tracer.scene) for key, tracer in tracers.items()}
    texts = {
        key: [text for step in scene.lesson for text, _ in step.stops()]
        for key, scene in scenes.items()
    }
    return {key: " ".join(" ".join(of).replace(NARROW, " ").split()) for key, of in texts.items()}


@pytest.mark.parametrize("key, n, pixel", SAID)
def test_a_lessons_ray_meets_what_the_text_says(key, n, pixel, tracers):
    """Objects in order, and whether the last one sees the lights."""
    path = tree(tracers, key, n, pixel).heaviest()
    names, visibility = SAID[key, n, pixel]
    assert " > ".join(ray.name for ray in path) == names
    if visibility is not None:
        assert path[-1].visibility == visibility


@pytest.mark.parametrize("key", list("890"))
def test_no_step_is_left_unchecked(key, tracers):
    """A step whose pixel is not in the table above would be a claim without a test."""
    steps = tracers[key].scene.lesson
    views = [view for step in steps for _, view in step.stops()]
    chosen = {(key, view["resolution"], tuple(view["pixel"])) for view in views}
    assert chosen <= set(SAID)
    assert 7 <= len(views) <= 15  # twelve steps, three of them answered


# (key, stop): the same at the stops of sweeps, through the pixel of the step that shows them.
AT_STOPS = {
    ("8", "glass-sphere-height:2"): ("glass sphere > glass sphere > ceiling", None),
    ("8", "index-of-refraction:6"): ("glass sphere > glass sphere > orange sphere", None),
    ("8", "index-of-refraction:1"): ("glass sphere > glass sphere > floor", None),
    ("9", "camera-round-the-dragon:19"): ("dragon", None),
    ("0", "yellow-ball-left-and-right:3"): ("mirror sphere > yellow sphere", [REACHED, BEHIND]),
}


@pytest.mark.parametrize("key", list("890"))
def test_a_lessons_ray_meets_what_the_text_says_at_stops_too(key, tracers):
    """Each stop that a step shows is in the table above."""
    scene = tracers[key].scene
    views = [view for step in scene.lesson for _, view in step.stops() if "sweep" in view]
    assert {(key, view["sweep"]) for view in views} == {at for at in AT_STOPS if at[0] == key}
    for view in views:
        names, visibility = AT_STOPS[key, view["sweep"]]
        there = Tracer(scene.at_stop(view["sweep"]), least_share=LEAST_SHARE)
        path = tree({key: there}, key, view["resolution"], tuple(view["pixel"])).heaviest()
        assert " > ".join(ray.name for ray in path) == names
        if visibility is not None:
            assert path[-1].visibility == visibility


def test_the_numbers_of_the_ray_through_the_glass_sphere(tracers, said):
    """Fresnel's share, Snell's angles and the 88.5 %, as the lesson of scene 8 words them."""
    camera, inside, out = tree(tracers, "8", 15, (8, 11)).heaviest()
    said = said["8"]
    mirrored, entered = camera.children
    assert (mirrored.kind, mirrored.name) == (Kind.REFLECTED, "floor")
    assert f"**{100 * mirrored.weight:.1f} % is mirrored**" in said
    assert f"**{100 * entered.weight:.1f} % goes in**" in said
    assert f"{camera.angle:.2f} degrees outside, {inside.angle:.2f} inside" in said
    index = np.sin(np.radians(camera.angle)) / np.sin(np.radians(inside.angle))
    assert f"ratio of their sines is always {index:.3f}" in " ".join(said.split())
    assert f"**{100 * out.share:.1f} % of this pixel is the orange ball**" in said
    straight = ((1.5168 - 1) / (1.5168 + 1)) ** 2  # Fresnel at normal incidence
    assert f"head-on, {100 * straight:.1f} % is mirrored" in said


def test_the_slab_gives_the_ray_its_direction_back(tracers, said):
    """Parallel faces: the angles are the lesson's, and the way out is parallel to the way in."""
    tracer = tracers["8"]
    waves = tracer.waves(np.array([7 * 15 + 12]), 15, 15)
    camera, inside, _ = Ray(tracer, waves).heaviest()
    assert f"{camera.angle:.1f} degrees outside, {inside.angle:.1f} inside" in said["8"]
    out = waves[2].rays.direction[waves[2].kind == Kind.REFRACTED][0]
    # Two refractions, about 10 roundings each in float64.
    np.testing.assert_allclose(out, waves[0].rays.direction[0], rtol=0, atol=1e-14)


def test_total_reflection_is_where_the_lesson_says(tracers, said):
    """The bottom of the slab, beyond the critical angle; nothing leaves there."""
    _, inside, reflected, _ = tree(tracers, "8", 15, (12, 12)).heaviest()
    assert reflected.kind == Kind.TOTAL and reflected.weight == 1.0
    assert inside.children == [reflected]
    assert f"at {inside.angle:.1f} degrees" in said["8"]
    assert f"**{np.degrees(np.arcsin(1 / 1.5168)):.1f} degrees**" in said["8"]


def test_a_grazing_ray_is_mirrored_as_much_as_the_answer_says(tracers, said):
    camera = tree(tracers, "8", 15, (8, 12))
    assert round(camera.angle) == 83
    assert f"**{100 * camera.children[0].weight:.0f} %**, more than half" in said["8"]


def test_a_shadow_ray_runs_through_the_glass_sphere(tracers):
    """The floor tile of the lesson sees the ceiling light; the straight way crosses the ball."""
    tracer = tracers["8"]
    scene = tracer.scene
    waves = tracer.waves(np.array([13 * 15 + 5]), 15, 15)
    point = waves[0].hits.point[0]
    way = np.array(next(x.position for x in scene.lights if x.name == "ceiling light")) - point
    ball = next(obj.shape for obj in scene.objects if obj.name == "glass sphere")
    to_ball = np.array(ball.center) - point
    nearest = to_ball - (to_ball @ way) / (way @ way) * way
    assert np.linalg.norm(nearest) < 0.5 * ball.radius  # well inside, not at the rim
    assert scene.render.glass_shadows == "pass"


@pytest.mark.parametrize("key", list("89"))
def test_rays_go_through_every_glass_object_and_some_are_totally_reflected(key, tracers):
    """Each glass object has a ray that was bent on entering and met its far side from inside."""
    tracer, n = tracers[key], 33
    waves = tracer.waves(np.arange(n * n), n, n)
    objects = tracer.scene.objects
    entered = set()
    for before, wave in pairwise(waves):
        same = before.hits.object[wave.parent] == wave.hits.object
        bent = (wave.kind == Kind.REFRACTED) & wave.hits.inside & same
        entered |= set(wave.hits.object[bent].tolist())
    glass = {k for k, obj in enumerate(objects) if obj.name.startswith("glass")}
    assert entered == glass and glass
    if key == "8":
        shapes = sorted(type(objects[k].shape).__name__ for k in glass)
        assert shapes == ["Box", "Cylinder", "Ellipsoid", "Sphere"]
    assert any((wave.kind == Kind.TOTAL).any() for wave in waves)


def test_shares_named_in_scenes_9_and_0(tracers, said):
    """Percentages of the texts, from the trees of their pixels."""
    nine, zero = said["9"], said["0"]
    lacquer = tree(tracers, "9", 15, (4, 10))
    assert f"{100 * lacquer.local_share:.0f} % of this colour is red paint" in nine
    assert [ray.name for ray in lacquer.children] == ["floor"]
    tile = tree(tracers, "9", 15, (7, 13))
    mirrored = tile.children[0]
    assert f"{100 * tile.local_share:.0f} % tile, {100 * mirrored.share:.0f} % mirror" in nine
    assert (mirrored.name, tile.blockers[2]) == ("dragon", "dragon")
    assert tree(tracers, "9", 15, (12, 6)).blockers == ["moon", "", "moon", "dragon"]
    assert tree(tracers, "9", 15, (2, 4)).blockers[1] == "moon"
    ball = tree(tracers, "9", 15, (1, 11)).heaviest()[-1]
    assert f"{100 * ball.share:.0f} % of this pixel" in nine
    bunny = tree(tracers, "9", 15, (13, 10)).heaviest()
    assert [ray.kind for ray in bunny].count(Kind.TOTAL) == 2  # "totally reflected twice"
    column = tree(tracers, "0", 15, (8, 11)).heaviest()[-1]
    assert f"{100 * column.share:.0f} % of this pixel is the column" in zero
    rim = tree(tracers, "0", 15, (7, 11))
    assert f"{100 * rim.heaviest()[-1].share:.0f} % of the pixel comes through" in zero
    mirrored = rim.children[0]
    assert f"{100 * mirrored.weight:.0f} % is mirrored" in zero
    assert (mirrored.name, mirrored.children[0].name) == ("mirror sphere", "left wall")


def test_triangles_are_counted_as_the_file_has_them(said):
    """One round of subdivision makes four triangles of one."""
    models, _ = read_catalogue(ROOT / "models/models.toml")
    count = f"{models.tables['dragon'].triangles:,}".replace(",", " ")
    assert f"scanned as {count} triangles, each split into four" in said["9"]


@pytest.mark.parametrize("key, most", [("8", 0.0), ("9", 0.002), ("0", 0.0)])
def test_no_black_holes_where_the_depth_ran_out(key, most, tracers):
    """Share of nearly black pixels; the rooms are closed, so black can only be a ray cut short."""
    n = 105
    colour = tracers[key].waves(np.arange(n * n), n, n)[0].colour
    assert (colour.max(axis=1) < 0.03).mean() <= most


def test_the_cornell_box_fills_the_frame(tracers):
    """The open front's corners are the picture's corners: half the side over its distance."""
    camera = tracers["0"].scene.camera
    front = 1.0  # the room is the cube from -1 to 1
    half_height = np.tan(np.radians(camera.fov / 2)) * (camera.eye[2] - front)
    assert half_height == pytest.approx(1, abs=1e-3)  # a thousandth: half a pixel


def test_models_are_credited_small_and_closed():
    """What is passed on with the site says whose it is; glass and shadows need an inside."""
    trimesh = pytest.importorskip("trimesh")
    models, problems = read_catalogue(ROOT / "models/models.toml")
    assert not problems.errors
    text = (ROOT / "scenes/09-dragon/scene.toml").read_text("utf-8")
    named = re.findall(r'^model = "(.+)"', text, re.MULTILINE)
    assert sorted(named) == ["bunny", "dragon"]
    for name in named:
        assert "Stanford" in models.tables[name].credit and models.tables[name].licence
        assert models.path(name).stat().st_size < 600_000
        mesh = trimesh.load(models.path(name), process=False)
        assert mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0
