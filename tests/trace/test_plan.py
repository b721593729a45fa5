"""What a scene needs, and that nothing else is done for it."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raywalk.pipeline.parts import TRACE, trace_parts
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.shapes import Mesh
from raywalk.trace.plan import plan_of
from raywalk.trace.tree import Kind, Visibility
from raywalk.trace.wavefront import LEAST_SHARE, Tracer, trace_picture

FOLDER = Path(__file__).parents[2] / "scenes"
SCENES = {scene.id: scene for scene in read_scenes(FOLDER)}


def small(scene: Scene) -> Scene:
    return replace(scene, render=replace(scene.render, size=105, resolutions=(5, 15, 35)))


def traced(scene: Scene, **options):
    return trace_picture(Tracer(scene, least_share=LEAST_SHARE, **options))


def unlit(scene: Scene, **change) -> Scene:
    """The scene with its first light changed."""
    first, *others = scene.lights
    return replace(scene, lights=(replace(first, **change), *others))


def test_the_plan_names_what_each_scene_of_the_course_needs():
    """Worked out from the scene file alone, without compiling or tracing anything."""
    plans = {id: plan_of(scene) for id, scene in SCENES.items()}
    assert plans["01-shading"].stages_not_run == [
        "meshes", "shadows", "reflection", "refraction",
    ]  # fmt: skip
    assert "shadows" not in plans["02-shadows"].stages_not_run
    assert plans["02-shadows"].depth == 0
    assert plans["04-one-bounce"].depth == 1 and not plans["04-one-bounce"].glass
    assert plans["08-glass"].glass and not plans["08-glass"].meshes
    assert plans["09-dragon"].meshes


def test_a_scene_without_a_mesh_never_imports_what_reads_or_meets_one(tmp_path):
    """Neither trimesh nor Embree: nothing of ours but what its key is made of, which is the same
    for all of them, so one process traces all."""
    plain = [id for id, scene in SCENES.items() if not plan_of(scene).meshes]
    code = f"""
import sys
from dataclasses import replace
from pathlib import Path
from raywalk.scene.read import read_scene
scenes = [read_scene(Path({str(FOLDER)!r}) / id) for id in {plain!r}]
before = set(sys.modules)
from {TRACE.module} import {TRACE.function} as write
for scene in scenes:
    folder = Path({str(tmp_path)!r}) / scene.id
    folder.mkdir()
    write(replace(scene, render=replace(scene.render, size=15, resolutions=(5,))), folder, 1)
print(*set(sys.modules) - before)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    imported = done.stdout.split()
    assert not {"trimesh", "embreex"} & {*imported}
    behind = {id: trace_parts(SCENES[id])["code"] for id in plain}
    for module in (name for name in imported if name.startswith("raywalk.")):
        place = module.removeprefix("raywalk.").replace(".", "/")
        for id, code in behind.items():
            assert f"{place}.py" in code or f"{place}/__init__.py" in code, (id, module)


@pytest.mark.parametrize("id", [id for id, scene in SCENES.items() if not plan_of(scene).glass])
def test_a_scene_without_glass_never_runs_refraction(id, monkeypatch):
    """Its kernels would fail if they were called."""

    def refuse(*_):
        raise AssertionError("refraction was run")

    from raywalk.trace import bounce

    for kernel in ("refracted_directions", "glass_shares"):
        monkeypatch.setattr(bounce, kernel, refuse)
    tally = traced(small(SCENES[id])).tally
    assert tally.rays[Kind.REFRACTED] == 0


@pytest.mark.parametrize("change", [{"intensity": 0.0}, {"colour": (0.0, 0.0, 0.0)}])
def test_a_light_that_gives_nothing_is_asked_by_no_shadow_ray(change):
    """The picture is that of the scene without it."""
    scene = small(SCENES["03-two-lights"])
    dark, without = traced(unlit(scene, **change)), traced(replace(scene, lights=scene.lights[1:]))
    np.testing.assert_array_equal(dark.picture, without.picture)
    assert dark.tally.shadow == without.tally.shadow
    assert dark.tally.dark > 0
    assert (dark.tree.visibility[:, 0] == Visibility.UNTESTED).all()


@pytest.mark.parametrize("skip", ["leave_turned", "leave_colourless"])
@pytest.mark.parametrize("id", ["05-many-bounces", "08-glass", "06-bunny-far"])
def test_a_skip_changes_no_pixel(id, skip):
    """What is left out would not have been seen."""
    scene = small(SCENES[id])
    plan = plan_of(scene)
    with_it, without = traced(scene), traced(scene, plan=replace(plan, **{skip: False}))
    np.testing.assert_array_equal(with_it.picture, without.picture)


def test_the_tally_adds_up():
    """Of every hit with a colour of its own, each light is asked or left out for a reason."""
    scene = small(SCENES["05-many-bounces"])
    result = traced(scene)
    tally = result.tally
    assert tally.pixels == 105 * 105 == tally.rays[Kind.CAMERA]
    assert tally.kept_pixels == result.tree.cameras
    everywhere = replace(scene, render=replace(scene.render, resolutions=(105,)))
    every = traced(everywhere)
    tree, lights = every.tree, len(scene.lights)
    assert every.tally.rays.tolist() == np.bincount(tree.kind, minlength=len(Kind)).tolist()
    own = int(((tree.object >= 0) & (tree.local_weight > 0)).sum())
    assert every.tally.shadow + every.tally.turned == own * lights
    assert every.tally.tests + every.tally.tests_saved == len(tree.kind) * len(scene.objects)
    assert (
        every.tally.colourless
        == int(((tree.object >= 0) & (tree.local_weight == 0)).sum()) * lights
    )


def test_rays_that_pass_by_the_box_round_a_mesh_are_counted():
    """Most of the bunny's picture is floor and sky."""
    scene = small(SCENES["06-bunny-far"])
    tally = traced(scene).tally
    assert 0 < tally.mesh_rays_saved < tally.mesh_rays
    assert isinstance(scene.objects[-1].shape, Mesh) or plan_of(scene).meshes


def test_a_scene_file_that_nothing_lights_needs_no_light():
    """Without lights there is neither a shadow ray nor a highlight."""
    scene = replace(read_scene(FOLDER / "02-shadows"), lights=())
    assert {"shadows", "highlights"} <= set(plan_of(scene).stages_not_run)
