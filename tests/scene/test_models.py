"""The committed models are what models.toml says they are."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

from raywalk.errors import SourceErrors
from raywalk.models.clean import clean
from raywalk.models.read import read_model
from raywalk.scene.models import find_catalogue, read_catalogue

CATALOGUE = Path(__file__).parents[2] / "models/models.toml"
NAMES = sorted(tomllib.loads(CATALOGUE.read_text(encoding="utf-8")))


@pytest.fixture(params=NAMES)
def entry(request):
    models, problems = read_catalogue(CATALOGUE)
    assert not problems.errors
    return models.tables[request.param], models.path(request.param)


def test_counts_are_those_of_the_file(entry):
    """Provenance that nobody checks goes stale."""
    trimesh = pytest.importorskip("trimesh")
    table, path = entry
    mesh = trimesh.load(path, process=False, force="mesh")
    assert (len(mesh.faces), len(mesh.vertices)) == (table.triangles, table.vertices)


def test_the_bunny_is_closed_and_faces_outward():
    """Shadows, and glass one day, need an inside: every edge shared by two triangles."""
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.load(CATALOGUE.parent / "bunny.ply", process=False)
    assert mesh.is_watertight and mesh.is_winding_consistent
    assert mesh.volume > 0  # negative where the triangles face inward
    assert mesh.euler_number == 2  # one piece without a hole


def test_stanfords_terms_are_told_as_they_stand():
    """Research, free copies with credit, nothing for sale; the bunny's package says otherwise, and
    that is said as its word."""
    models, _ = read_catalogue(CATALOGUE)
    for name in ("bunny", "dragon"):
        licence = models.tables[name].licence
        for term in ("research", "redistributed free of charge with credit", "not for commercial",
                     "product for sale", "animated, morphed or damaged"):  # fmt: skip
            assert term in licence
    assert "public domain, which is that package's word" in models.tables["bunny"].licence


def test_the_teapot_is_closed_free_and_one_body_of_glass():
    """Pot, handle and spout overlap, and stand on the ground, 1 high."""
    models, _ = read_catalogue(CATALOGUE)
    assert models.tables["teapot"].licence.startswith("MIT")
    fit = clean(read_model(CATALOGUE.parent / "teapot.ply"))
    assert (fit.shape.closed, len(fit.shape.shells), fit.turned.any()) == (True, 3, False)
    assert len(fit.shape.overlapping) == 2
    ends = fit.vertices[fit.faces]
    assert np.allclose([ends[..., 1].min(), ends[..., 1].max()], [0, 1], rtol=0, atol=1e-6)


def test_the_catalogue_is_found_from_any_folder_below(tmp_path):
    """A scene of one's own, two folders deep, uses the models beside it."""
    (tmp_path / "models").mkdir()
    (tmp_path / "models/models.toml").touch()
    found = find_catalogue(tmp_path / "scenes/mine/scene.toml")
    assert found == tmp_path / "models/models.toml"


@pytest.mark.parametrize("broken", ["no toml", "[bunny]\nfile = 7\n"], ids=["text", "tables"])
def test_a_broken_catalogue_is_the_only_thing_that_is_reported(broken, scene_from, tmp_path):
    """By its own path. Whether it lists a model is not known, so that no mesh is blamed."""
    (tmp_path / "models").mkdir()
    (tmp_path / "models/models.toml").write_text(broken, encoding="utf-8")
    mesh = '[[objects]]\ntype = "mesh"\nmodel = "bunny"\nmaterial = "white"\n'
    with pytest.raises(SourceErrors) as caught:
        scene_from(mesh)
    reported = [line for line in str(caught.value).splitlines() if not line.startswith(" ")][:-1]
    assert reported
    assert all(line.startswith(f"{tmp_path}/models/models.toml: ") for line in reported)
