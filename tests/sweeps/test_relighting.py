"""Where only light changes from stop to stop, what rays hit is found once and lit again."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.sweeps.test_stops import WITH_SWEEPS, scene_of

from raywalk.geometry.compiled import CompiledScene, Hits, Rays
from raywalk.pipeline.parts import silent, trace_parts
from raywalk.pipeline.sweeps import stop_parts, sweeps_here
from raywalk.pipeline.trace_task import trace_into
from raywalk.scene.model import Scene, Sweep
from raywalk.sweeps.trace_stop import write_stop
from raywalk.trace.relighting import KnownPaths, unlit
from raywalk.work.digests import key_of
from raywalk.work.progress import say_nothing
from raywalk.work.store import Store

LIT_AGAIN = {"lamp height", "points", "paint"}


@pytest.fixture(scope="module", name="swept")
def swept_scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    return scene_of(WITH_SWEEPS, tmp_path_factory.mktemp("swept"))


def of(swept: Scene, name: str) -> Sweep:
    [sweep] = [each for each in swept.sweeps if each.name == name]
    return sweep


def files(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


@pytest.mark.parametrize("name", sorted(LIT_AGAIN))
def test_stops_lit_again_equal_full_traces(swept: Scene, tmp_path: Path, name: str) -> None:
    """Byte for byte, whichever stop was the first."""
    sweep, known = of(swept, name), KnownPaths()
    for k in (1, 0, *range(2, len(sweep.stops))):
        made = [tmp_path / f"{way} {k}" for way in ("again", "whole")]
        for folder, paths in zip(made, (known, None), strict=True):
            folder.mkdir()
            write_stop(sweep.stops[k], sweep.resolutions, sweep.picture, folder, 2, paths)
        assert files(made[0]) == files(made[1])
    assert known.relit > 0


def test_what_does_not_fit_is_followed_anew(swept: Scene, tmp_path: Path) -> None:
    """Room for no ray, and for none but a part of them: the same bytes."""
    sweep = of(swept, "lamp height")
    of_a_stop = 0
    for most in (10**9, 0, 1000):
        known = KnownPaths(most)
        for k in range(2):
            folder = tmp_path / f"{most} {k}"
            folder.mkdir()
            write_stop(sweep.stops[k], sweep.resolutions, sweep.picture, folder, 2, known)
        of_a_stop = of_a_stop or known.relit
        assert known.relit == (of_a_stop if most == 10**9 else 0)
    assert files(tmp_path / "0 1") == files(tmp_path / "1000 1") == files(tmp_path / f"{10**9} 1")


def test_only_sweeps_of_light_are_lit_again(swept: Scene) -> None:
    """Their stops differ in nothing that a ray's way depends on; those of all others do."""
    for sweep in swept.sweeps:
        ways = {key_of({"scene": silent(unlit(stop))}) for stop in sweep.stops}
        assert len(ways) == (1 if sweep.name in LIT_AGAIN else len(sweep.stops))


@pytest.mark.usefixtures("one_process")
def test_a_build_follows_the_rays_of_such_a_sweep_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three stops of a lamp: as many rays meet the scene as at one."""
    text = WITH_SWEEPS.split('\n[[sweeps]]\nname = "refraction"')[0]
    scene = scene_of(text, tmp_path / "02-test")
    store, parts = Store(tmp_path / "work"), trace_parts(scene)
    trace_into(store, {scene.id: parts}, scene, 2, say_nothing)
    met: list[int] = []
    hits = CompiledScene.hits

    def counted(self: CompiledScene, rays: Rays) -> Hits:
        met.append(len(rays.origin))
        return hits(self, rays)

    monkeypatch.setattr(CompiledScene, "hits", counted)
    [sweep] = scene.sweeps
    write_stop(sweep.stops[0], sweep.resolutions, sweep.picture, tmp_path, 1)
    once = sum(met)
    met.clear()
    sweeps_here(store, scene, store.get(key_of(parts)))
    assert all(store.find(key_of(stop_parts(stop, sweep))) for stop in sweep.stops)
    assert sum(met) == once > 0
