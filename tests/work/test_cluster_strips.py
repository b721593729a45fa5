"""One scene in strips over a real scheduler and two workers on this machine's loopback address."""

from __future__ import annotations

import signal
from dataclasses import fields, replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("distributed", reason='the extra "cluster" is not installed')

from raywalk.bench.own_cluster import PATIENCE, own_cluster
from raywalk.pipeline.cluster import connected, run_on_cluster
from raywalk.pipeline.cluster_strips import Wire, trace_there
from raywalk.pipeline.trace_products import write_products
from raywalk.scene.read import read_scene
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import Tracer, trace_picture
from raywalk.work.pool import Finished

SCENES = Path(__file__).parents[2] / "scenes"

# Dask's own threads and sockets warn of what they leave open at the end; ours is in the asserts.
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(scope="module")
def cluster():
    """A client of two workers, and their processes."""
    with own_cluster(2) as (address, workers):
        client, _ = connected(address)
        client.wait_for_workers(2, timeout=PATIENCE)
        yield client, workers
        client.close()


def scene_of_side(name: str, side: int, *grids: int):
    scene = read_scene(SCENES / name)
    return replace(scene, render=replace(scene.render, size=side, resolutions=grids), lesson=())


def test_a_scene_in_strips_makes_the_same_files_as_here(cluster, tmp_path):
    """A mesh is sent with it; grids and tallies come back with the picture."""
    client, _ = cluster
    scene, wire = scene_of_side("06-bunny-far", 735, 7, 21), Wire()
    for name, trace in (("here", trace_picture), ("there", partial(trace_there, client, wire))):
        (tmp_path / name).mkdir()
        write_products(scene, tmp_path / name, 1, trace=trace)
    here, there = (
        {path.name: path.read_bytes() for path in (tmp_path / name).iterdir()}
        for name in ("here", "there")
    )
    assert there == here and "21.js" in there
    assert 0 < wire.back < 3 * 735**2, "less than the bare colours of all pixels"
    assert wire.there > (SCENES.parent / "models" / "bunny.ply").stat().st_size


def test_a_worker_killed_in_the_middle_changes_nothing(cluster):
    """Its strips go to the other worker; what is recorded stays in the picture's order."""
    client, workers = cluster
    tracer = Tracer(scene_of_side("05-many-bounces", 1575, 5, 7, 15), least_share=LEAST_SHARE)

    def kill(share: float) -> None:
        if workers[0].poll() is None:
            workers[0].send_signal(signal.SIGKILL)
            workers[0].wait()

    there = trace_there(client, Wire(), tracer, report=kill)
    here = trace_picture(tracer, 1)
    np.testing.assert_array_equal(there.picture, here.picture)
    assert there.tally.as_dict() == here.tally.as_dict()
    for field in fields(here.tree):
        np.testing.assert_array_equal(
            getattr(there.tree, field.name), getattr(here.tree, field.name), err_msg=field.name
        )
    assert workers[0].poll() is not None


def test_a_large_scene_is_split_by_a_build_of_the_site(cluster, monkeypatch):
    """It comes as the files that a worker alone makes."""
    client, _ = cluster
    scene = scene_of_side("05-many-bounces", 315, 7)
    whole = dict(_finished(client, scene))
    monkeypatch.setattr("raywalk.pipeline.cluster.LARGE", 314)
    assert dict(_finished(client, scene)) == whole


def _finished(client, scene):
    [last] = [
        m for m in run_on_cluster(client.scheduler.address, [scene]) if isinstance(m, Finished)
    ]
    return last.result[1]
