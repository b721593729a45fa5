"""Why a piece of work is made again, in words."""

from __future__ import annotations

import pytest

from raywalk.work.explain import why

MADE = {
    "scene": {
        "objects": [{"name": "ball", "shape": {"radius": 0.5}}],
        "lights": [{"name": "lamp", "colour": [1.0, 1.0, 1.0]}],
    },
    "models": {"bunny.ply": "aa"},
    "code": {"trace/wavefront.py": "aa", "geometry/bvh.py": "bb"},
    "read": {"site_src/words/en.json": "aa"},
    "packages": {"numba": "0.68.1"},
    "trace": "aa",
}


def changed(**parts):
    return {**MADE, **parts}


@pytest.mark.parametrize(
    ("now", "reason"),
    [
        (
            changed(scene={**MADE["scene"], "objects": [{"name": "ball", "shape": {"radius": 1}}]}),
            "objects[0].shape.radius 0.5 -> 1",
        ),
        (
            changed(scene={**MADE["scene"], "lights": []}),
            'lights[0] "lamp" -> none',
        ),
        (changed(models={"bunny.ply": "bb"}), "the model bunny.ply changed"),
        (changed(code={"trace/wavefront.py": "cc", "geometry/bvh.py": "bb"}),
         "code: trace/wavefront.py changed"),
        (changed(code={"trace/wavefront.py": "aa"}), "code: geometry/bvh.py is gone"),
        (changed(packages={"numba": "0.69.0"}), 'numba "0.68.1" -> "0.69.0"'),
        (changed(read={"site_src/words/en.json": "bb"}), "site_src/words/en.json changed"),
        (changed(trace="bb"), "its trace"),
        (changed(models={"bunny.ply": "bb"}, packages={}),
         'the model bunny.ply changed; numba "0.68.1" -> none'),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)  # fmt: skip
def test_the_part_that_changed_is_named(now, reason):
    """Scene keys with both values, files and packages by name; several at once."""
    assert why(MADE, now, "") == reason


def test_many_changed_files_are_told_by_count():
    """A new version of everything is one line."""
    code = {f"trace/{k}.py": "new" for k in range(9)}
    assert why({"code": {}}, {"code": code}, "").endswith("and 5 more")


def test_damage_and_first_making_are_told_apart():
    """What is there but broken is no change of inputs."""
    assert why(MADE, MADE, "picture.png") == "its kept picture.png is damaged"
    assert why(None, MADE, "") == "was never made before"
