"""Tracing on a cluster: a real scheduler and workers on this machine's loopback address."""

from __future__ import annotations

import json
import pickle
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from raywalk.__main__ import main
from raywalk.errors import SourceError, SourceErrors
from raywalk.pipeline.cluster import (
    ClusterError,
    made_by,
    mesh_files,
    refuse_other_makers,
    scene_there,
    with_meshes,
)
from raywalk.scene.read import read_scene

SCENES = Path(__file__).parents[2] / "scenes"
# A mesh, glass and mirrors: what is sent, and what takes a while.
COURSE = ("05-many-bounces", "06-bunny-far", "08-glass")
PATIENCE = 600  # seconds: the machine may be busy, and kernels may have to be compiled

# Dask's own threads and sockets warn of what they leave open at the end; ours is in the asserts.
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(scope="module")
def folder(tmp_path_factory, with_viewer):
    """Three scenes of the course with small pictures."""
    folder = tmp_path_factory.mktemp("cluster")
    for name in COURSE:
        place = folder / "scenes" / name
        place.mkdir(parents=True)
        text = (SCENES / name / "scene.toml").read_text(encoding="utf-8")
        head, render, rest = text.partition("[render]\n")
        render = render or "[render]\n"
        body = "\n".join(
            line
            for line in rest.splitlines()
            if not line.startswith(("size", "resolutions", "picture"))
        )
        small = f"{head}{render}size = 315\nresolutions = [5, 7, 15]\n{body}\n"
        (place / "scene.toml").write_text(lesson_free(small), encoding="utf-8")
    (folder / "models").symlink_to(SCENES.parent / "models")
    for out in ("here", "there", "nowhere"):
        with_viewer(folder / f"{out}.work")
    return folder


def lesson_free(text: str) -> str:
    """Lessons name grids that a small picture does not have."""
    return text.partition("[[lesson]]")[0]


def command(folder: Path, out: str, *options: str) -> list[str]:
    places = (
        "--scenes",
        folder / "scenes",
        "--out",
        folder / out,
        "--work",
        folder / f"{out}.work",
    )
    return ["site", *map(str, places), *options]


def site(folder: Path, out: str, *options: str) -> int:
    return main(command(folder, out, *options))


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    """Address of a scheduler, and its two workers."""
    place = tmp_path_factory.mktemp("dask")
    file = place / "scheduler.json"
    quiet = {"cwd": place, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    options = ["--host", "127.0.0.1", "--no-dashboard"]
    scheduler = [sys.executable, "-m", "distributed.cli.dask_scheduler", *options]
    scheduler += ["--port", "0", "--scheduler-file", str(file)]
    processes = [subprocess.Popen(scheduler, **quiet)]
    address = wait_until(lambda: address_in(file) or processes[0].poll() is not None)
    assert address is not True, "the scheduler ended"
    worker = [sys.executable, "-m", "distributed.cli.dask_worker", address, *options]
    worker += ["--nthreads", "1", "--no-nanny", "--death-timeout", str(PATIENCE)]
    workers = [subprocess.Popen(worker, **quiet) for _ in range(2)]
    yield address, workers
    for process in [*workers, *processes]:
        process.kill()
        process.wait()


def address_in(file):
    """None while it is not there, or only begun."""
    try:
        return json.loads(file.read_text(encoding="utf-8"))["address"]
    except (OSError, ValueError):
        return None


def wait_until(holds):
    """What was true of it then; a moment later it may be otherwise."""
    end = time.monotonic() + PATIENCE
    while not (found := holds()):
        assert time.monotonic() < end, "never came true"
        time.sleep(0.05)
    return found


def at_work(client):
    """A worker that has something to do."""
    return next((worker for worker, tasks in client.processing().items() if tasks), None)


def contents(folder: Path) -> dict[str, bytes]:
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


@pytest.mark.slow
def test_a_cluster_makes_the_same_bytes_though_a_worker_is_killed_while_it_traces(folder, cluster):
    """Scenes and meshes are sent, files come back; the lost worker's scene goes to another."""
    from distributed import Client

    address, workers = cluster
    assert site(folder, "here") == 0
    with Client(address, timeout=PATIENCE, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=PATIENCE)
        process_of = client.run(__import__("os").getpid)
        arguments = command(folder, "there", "--scheduler", address)
        with subprocess.Popen([sys.executable, "-m", "raywalk", *arguments]) as build:
            busy = wait_until(lambda: at_work(client) or build.poll() is not None)
            assert busy is not True, "the build ended"
            [victim] = [worker for worker in workers if worker.pid == process_of[busy]]
            victim.send_signal(signal.SIGKILL)
            assert build.wait(PATIENCE) == 0
    assert victim.poll() is not None
    assert contents(folder / "there") == contents(folder / "here")


@pytest.mark.slow
def test_a_scene_that_cannot_be_traced_is_told_as_it_is_here(folder, cluster, tmp_path, capsys):
    """The error comes back from the worker whole: file, key, what is wrong."""
    place = tmp_path / "scenes" / "01-broken"
    place.mkdir(parents=True)
    text = (folder / "scenes/06-bunny-far/scene.toml").read_text(encoding="utf-8")
    (place / "mesh.ply").write_text("ply\n", encoding="utf-8")
    broken = text.replace('model = "bunny"', 'file = "mesh.ply"')
    (place / "scene.toml").write_text(broken, encoding="utf-8")
    assert site(tmp_path, "dist", "--scheduler", cluster[0]) == 1
    there = capsys.readouterr().err
    assert site(tmp_path, "dist") == 1
    assert there == capsys.readouterr().err
    assert "the file ends in its header" in there


def test_a_scheduler_that_is_not_there_is_told_with_what_helps(folder, capsys, monkeypatch):
    """Nothing listens on port 1; the site is left as it was."""
    monkeypatch.setattr("raywalk.pipeline.cluster.PATIENCE", 0.5)
    assert site(folder, "nowhere", "--scheduler", "tcp://127.0.0.1:1") == 1
    error = capsys.readouterr().err
    assert "--scheduler tcp://127.0.0.1:1: cannot be reached" in error
    assert "dask worker" in error and "Traceback" not in error
    assert not (folder / "nowhere").exists()


def test_without_the_package_it_is_told_how_to_install_it(folder, capsys, monkeypatch):
    """It is an optional extra."""
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert site(folder, "nowhere", "--scheduler", "tcp://127.0.0.1:1") == 1
    assert ".[cluster]" in capsys.readouterr().err


def test_a_worker_with_other_code_is_refused_by_name():
    """Its bytes could be others."""
    here = made_by()
    other = {**here, "code": {**here["code"], "trace/wavefront.py": "other"}}
    refuse_other_makers(here, here)
    with pytest.raises(ClusterError, match=r"other code than we do: trace/wavefront\.py"):
        refuse_other_makers(here, other)


def test_what_is_sent_is_the_scene_with_its_meshes_and_nothing_of_this_disk(tmp_path):
    """A worker needs no checkout of the scenes: paths are replaced by its own."""
    scene = read_scene(SCENES / "06-bunny-far")
    files = mesh_files(scene)
    assert [Path(path).name for path in files] == ["bunny.ply"]
    there = pickle.loads(pickle.dumps((scene, files)))
    placed = with_meshes(*there, tmp_path)
    [mesh] = [obj.shape.path for obj in placed.objects if hasattr(obj.shape, "model")]
    assert mesh.is_relative_to(tmp_path) and mesh.name == "bunny.ply"


def test_errors_survive_the_way_back():
    """Dask pickles what a worker raises."""
    error = SourceErrors([SourceError(Path("a.toml"), "key", "is wrong", allowed="right")])
    assert str(pickle.loads(pickle.dumps(error))) == str(error)
    assert callable(scene_there)
