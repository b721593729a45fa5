"""Large scene files stay quick, and spoilt ones are refused in words."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import pytest

from raywalk.bench.stress_fuzz import spoilt
from raywalk.errors import SourceErrors
from raywalk.scene.read import read_scene
from raywalk.trace.scene_warnings import scene_warnings
from raywalk.trace.wavefront import Tracer

HEAD = 'version = 1\ntitle = "t"\nteaches = "t"\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n'
BALL = '[[objects]]\ntype = "sphere"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = "white"\n'


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ("target = [0, 0, 0]", "target = [1e300, 0, 0]", "camera.target[0]: 1e+300"),
        ("radius = 1", "radius = 1e300", "objects[0].radius: 1e+300"),
        ("center = [0, 0, 0]", "center = [0, -1e300, 0]", "objects[0].center[1]: -1e+300"),
    ],
)
def test_a_number_without_a_square_is_refused(tmp_path: Path, old: str, new: str, key: str) -> None:
    """No direction leads there: it would be NaN."""
    path = tmp_path / "scene.toml"
    path.write_text((HEAD + BALL).replace(old, new), encoding="utf-8")
    with pytest.raises(SourceErrors) as caught:
        read_scene(path)
    assert f"{key} is too large: its square is no number, so no direction is left" in str(
        caught.value
    )


def test_of_very_many_mistakes_the_first_are_told_and_all_are_counted(tmp_path: Path) -> None:
    """A hundred thousand would take a terminal minutes."""
    path = tmp_path / "scene.toml"
    path.write_text(HEAD + f"[render]\nresolutions = {[15] * 2000}\n" + BALL, encoding="utf-8")
    with pytest.raises(SourceErrors) as caught:
        read_scene(path)
    assert "and 1,499 more\n1999 errors" in str(caught.value)


def _ball(k: int, material: str) -> str:
    return BALL.replace("[0, 0, 0]", f"[{k}, 0, 0]").replace("white", material)


MANY: dict[str, Callable[[int], str]] = {
    "resolutions": lambda n: f"[render]\nresolutions = {[15] * n}\n" + BALL,
    "chain": lambda n: (
        "".join(f'[materials.m{k}]\nlike = "m{k + 1}"\n' for k in range(n))
        + f'[materials.m{n}]\nlike = "white"\n' + _ball(0, "m0")
    ),
    "objects": lambda n: "".join(_ball(k, "white") for k in range(n)),
    "circle": lambda n: (
        "".join(f'[materials.m{k}]\nlike = "m{(k + 1) % n}"\n' for k in range(n)) + _ball(0, "m0")
    ),
    "materials": lambda n: (
        "".join(f"[materials.k{k}]\ndiffuse = [{k / n}, 0, 0]\n" for k in range(n))
        + "".join(_ball(k, f"k{k}") for k in range(n))
    ),
    "lesson": lambda n: BALL + "".join(f'[[lesson]]\ntext = "step **{k}**"\n' for k in range(n)),
    "unknown": lambda n: (
        "".join(f"[materials.k{k}]\ndiffuse = [1, 0, 0]\n" for k in range(n))
        + "".join(_ball(k, f"u{k}") for k in range(n))
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", MANY)
def test_eight_times_as_much_takes_not_much_more_than_eight_times_as_long(
    tmp_path: Path, kind: str
) -> None:
    """In processor time; where each asks all others it is 64 times, and 24 tells them apart."""
    path = tmp_path / "scene.toml"

    def read(n: int) -> Callable[[], object]:
        path.write_text(HEAD + MANY[kind](n), encoding="utf-8")

        def once() -> None:
            try:
                read_scene(path)
            except SourceErrors as problems:
                str(problems)

        return once

    assert _is_no_slower(read(250), lambda: read(2_000))


IN_A_ROW = {
    "balls": 'type = "sphere"\ncenter = [{k}, 0, 0]\nradius = 0.4',
    "boxes": 'type = "box"\nminimum = [{k}, 0, 0]\nmaximum = [{next}, 1, 1]',
    "triangles": 'type = "triangle"\na = [{k}, 0, 0]\nb = [{next}, 0, 0]\nc = [{k}, 1, 0]',
    "pipes": 'type = "cylinder"\nstart = [{k}, 0, 0]\nend = [{next}, 0, 0]\nradius = 1',
}


@pytest.mark.parametrize("kind", IN_A_ROW)
def test_warnings_of_eight_times_as_many_objects_take_not_much_longer(
    tmp_path: Path, kind: str
) -> None:
    """Objects of which each touches the next, as a wall's stones and a fan's triangles do: shared
    corners, rims and faces are found without asking all pairs."""
    path = tmp_path / "scene.toml"

    def check(n: int) -> Callable[[], object]:
        rows = (IN_A_ROW[kind].format(k=k, next=k + 1) for k in range(n))
        objects = "".join(f'[[objects]]\nmaterial = "white"\n{row}\n' for row in rows)
        path.write_text(HEAD + objects, encoding="utf-8")
        scene = read_scene(path)
        return lambda: scene_warnings(Tracer(scene))

    check(10)()  # kernels are compiled
    assert _is_no_slower(check(250), lambda: check(2_000))


def _is_no_slower(few: Callable[[], object], make: Callable[[], Callable[[], object]]) -> bool:
    """Whether the best of three of `few` takes more than a 24th of the best of three of what `make`
    makes, which is tried again only while it does not."""
    most = 24 * min(_seconds(few) for _ in range(3))
    many = make()
    return any(_seconds(many) < most for _ in range(3))


def _seconds(work: Callable[[], object]) -> float:
    """Of processor time."""
    start = time.process_time()
    work()
    return time.process_time() - start


def test_spoilt_scenes_are_refused_in_words() -> None:
    """300 mutants of the ten scenes; 100,000 are a row of `make stress`."""
    assert spoilt(300, seed=20261122) == (0, 0)
