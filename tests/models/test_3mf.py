"""3MF: items, components, colours; damage is a sentence."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
import pytest
from tests.models.solids import cube, triangles, volume

from raywalk.models.clean import clean
from raywalk.models.faults import ModelFault
from raywalk.models.read import read_model

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
MESH = (
    "<mesh><vertices>"
    + "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in cube().tolist())
    + "</vertices><triangles>"
    + "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in triangles().tolist())
    + "</triangles></mesh>"
)
CUBE = f'<object id="1" name="cube" type="model">{MESH}</object>'
ITEM = '<item objectid="1"/>'


def package(
    folder: Path, resources: str = CUBE, build: str = ITEM, name: str = "3D/3dmodel.model"
) -> Path:
    path = folder / "made.3mf"
    text = f'<?xml version="1.0"?><model unit="inch" xmlns="{CORE}"><resources>{resources}'
    text += f"</resources><build>{build}</build></model>"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as made:
        made.writestr("[Content_Types].xml", "")
        made.writestr(name, text)
    return path


PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"


def in_parts(folder: Path, path: str = "/3D/Objects/Object_1.model") -> Path:
    """As slicers write it: the mesh in a part of its own, where an object has the same id as the
    one that places it, in a colour whose group has the same id too."""
    red = '<basematerials id="5"><base name="red" displaycolor="#FF0000"/></basematerials>'
    blue = red.replace("red", "blue").replace("#FF0000", "#0000FF")
    mesh = CUBE.replace('type="model"', 'type="model" pid="5" pindex="0"')
    made = package(
        folder,
        red + f'<object id="1" name="both"><components><component xmlns:p="{PRODUCTION}" '
        f'p:path="{path}" objectid="1"/></components></object>',
    )
    part = f'<model unit="inch" xmlns="{CORE}"><resources>{blue}{mesh}</resources><build/></model>'
    with zipfile.ZipFile(made, "a") as more:
        more.writestr("3D/Objects/object_1.model", part)
    return made


def test_an_object_in_a_part_of_its_own_is_found_there(tmp_path: Path) -> None:
    """With the colours of its own part; a path's capitals do not count, as in a package."""
    model = read_model(in_parts(tmp_path))
    assert (model.parts, len(model.faces), model.unit) == (("both",), 12, "inch")
    assert model.material is not None
    assert {model.materials[row].name for row in model.material} == {"blue"}


def test_a_part_that_is_not_in_the_package_is_named(tmp_path: Path) -> None:
    said = refused(in_parts(tmp_path, "/3D/Objects/gone.model"))
    assert 'its part "3d/objects/gone.model" is not in the package' in said


def refused(path: Path) -> str:
    with pytest.raises(ModelFault) as caught:
        clean(read_model(path))
    return str(caught.value)


def test_items_and_components_stand_where_their_transforms_put_them(tmp_path: Path) -> None:
    """A cube twice in an object, which stands in the build twice, once mirrored: four parts of
    volume 1, the unit said."""
    both = (
        '<object id="2" name="pair"><components><component objectid="1"/>'
        '<component objectid="1" transform="1 0 0 0 1 0 0 0 1 2 0 0"/></components></object>'
    )
    build = '<item objectid="2"/><item objectid="2" transform="-1 0 0 0 1 0 0 0 1 0 9 0"/>'
    model = read_model(package(tmp_path, CUBE + both, build))
    assert (model.unit, model.parts, model.format) == ("inch", ("pair",), "3MF")
    centres = [model.vertices[8 * k : 8 * k + 8].mean(axis=0).tolist() for k in range(4)]
    assert centres == [[0, 0, 0], [2, 0, 0], [0, 9, 0], [-2, 9, 0]]
    fit = clean(model)
    assert not fit.turned.any()
    assert volume(fit.vertices, fit.faces) == pytest.approx(4, abs=1e-12)


def test_colours_are_read_as_materials(tmp_path: Path) -> None:
    """Of base materials, for the object as a whole and for single triangles."""
    base = (
        '<basematerials id="5"><base name="red" displaycolor="#FF0000"/>'
        '<base name="sea" displaycolor="#003366FF"/></basematerials>'
    )
    painted = CUBE.replace('id="1"', 'id="1" pid="5" pindex="0"').replace(
        "<triangle ", '<triangle pid="5" p1="1" ', 1
    )
    model = read_model(package(tmp_path, base + painted))
    assert [(m.name, m.diffuse) for m in model.materials] == [
        ("red", (1, 0, 0)), ("sea", (0, 0.2, 0.4)),
    ]  # fmt: skip
    assert model.material_of().tolist() == [1] + [0] * 11


RED_AND_BLUE = (
    '<basematerials id="5"><base name="red" displaycolor="#FF0000"/>'
    '<base name="blue" displaycolor="#0000FF"/></basematerials>'
)


def test_a_triangle_that_names_no_group_means_its_objects(tmp_path: Path) -> None:
    """Core specification, 4.1.4.1: `pid` of a triangle overrides that of the object."""
    painted = CUBE.replace('id="1"', 'id="1" pid="5" pindex="0"').replace(
        "<triangle ", '<triangle p1="1" ', 1
    )
    model = read_model(package(tmp_path, RED_AND_BLUE + painted))
    assert model.material_of().tolist() == [1] + [0] * 11


MATERIALS = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
LAYERS = (
    f'<m:texture2dgroup xmlns:m="{MATERIALS}" id="6" texid="7"/>'
    f'<m:multiproperties xmlns:m="{MATERIALS}" id="8" pids="6 5">'
    '<m:multi pindices="0 1"/><m:multi pindices="3"/></m:multiproperties>'
)


def test_of_several_layers_the_lowest_material_counts(tmp_path: Path) -> None:
    """A <multi> lays a texture, which is not read, over base materials; an index left out is 0."""
    painted = CUBE.replace('id="1"', 'id="1" pid="8" pindex="1"').replace(
        "<triangle ", '<triangle pid="8" p1="0" ', 1
    )
    model = read_model(package(tmp_path, RED_AND_BLUE + LAYERS + painted))
    assert [each.name for each in model.materials] == ["red", "blue"]
    assert model.material_of().tolist() == [1] + [0] * 11


@pytest.mark.parametrize(
    ("prefix", "declared"), [("m", MATERIALS), ("p", PRODUCTION), ("slic3rpe", "...")]
)
def test_a_prefix_that_is_not_declared_is_named(tmp_path: Path, prefix: str, declared: str) -> None:
    """With what to write, where it is one of the consortium's."""
    layers = f'<{prefix}:multiproperties id="8" pids="5"/>'
    assert refused(package(tmp_path, RED_AND_BLUE + "\n" + layers + CUBE)) == (
        f'made.3mf, 3d/3dmodel.model, line 2: the prefix "{prefix}" of its XML is declared '
        f'nowhere; write xmlns:{prefix}="{declared}" into its <model>, or export it again'
    )


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ((' x="-0.5"', ""), ', a <vertex> of "cube": it has no x'),
        (
            (' v1="0"', ' v1="80"'),
            ', object "cube": a triangle names vertex 80, and there are 0 to 7',
        ),
        ((' v1="0"', ' v1="-1"'), ', a <triangle> of "cube": v1 is "-1", which is no vertex'),
        (("</mesh>", ""), ": its XML is broken (mismatched tag"),
    ],
    ids=["no x", "beyond", "negative", "broken"],
)
def test_what_is_wrong_is_one_sentence(
    tmp_path: Path, change: tuple[str, str], sentence: str
) -> None:
    """File, element, value, cause and remedy."""
    message = refused(package(tmp_path, CUBE.replace(*change, 1)))
    assert message.startswith("made.3mf" + sentence)
    assert message.endswith("; it is cut short or damaged: copy or export it again")


def test_a_decimal_comma_is_told_as_such(tmp_path: Path) -> None:
    """The file is whole, and another copy of it would be the same."""
    assert refused(package(tmp_path, CUBE.replace(' x="-0.5"', ' x="-0,5"', 1))).startswith(
        'made.3mf, x of a <vertex> of "cube": "-0,5" has a decimal comma; decimals have a point'
    )


def test_a_package_that_is_none_says_so(tmp_path: Path) -> None:
    """Cut short, without a model, with an item of nothing, with an object in itself, or with XML
    that unpacks to hundreds of times its size."""
    path = package(tmp_path)
    path.write_bytes(path.read_bytes()[:-40])
    assert "its package cannot be unpacked" in refused(path)
    assert "there is no 3D/3dmodel.model" in refused(package(tmp_path, name="other.xml"))
    assert 'it names object "7"' in refused(package(tmp_path, build='<item objectid="7"/>'))
    inner = '<component objectid="2"/>' * 2
    circle = f'<object id="2"><components>{inner}</components></object>'
    assert "hold one another too often" in refused(
        package(tmp_path, CUBE + circle, '<item objectid="2"/>')
    )
    assert "times as large as the file" in refused(package(tmp_path, CUBE + " " * 100_000_000))


def test_a_big_one_is_read_without_keeping_its_elements(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    """20,000 triangles: the very corners."""
    places = rng.normal(size=(20_000, 3))
    corners = rng.integers(0, 20_000, (20_000, 3))
    text = "".join(f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>' for x, y, z in places.tolist())
    faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in corners.tolist())
    mesh = f"<mesh><vertices>{text}</vertices><triangles>{faces}</triangles></mesh>"
    model = read_model(package(tmp_path, f'<object id="1">{mesh}</object>'))
    assert np.array_equal(model.vertices, places)
    assert np.array_equal(model.faces, corners)
