"""What the model says of itself is what the reader makes of a file."""

import dataclasses

import pytest

from raywalk.scene import model, shapes

WHITE = 'material = "white"\n'
CAMERA = "[camera]\neye = [0, 0, 9]\ntarget = [0, 0, 0]\n"
SHAPES = {
    shapes.Ellipsoid: "center = [0, 0, 0]\nradii = [1, 2, 3]\n",
    shapes.Cylinder: "start = [0, 0, 0]\nend = [0, 1, 0]\nradius = 1\n",
    shapes.Mesh: 'file = "flat.obj"\n',
}


def kinds_of_data():
    """Every dataclass of the model, shapes too."""
    named = vars(model) | vars(shapes)
    return [kind for kind in named.values() if dataclasses.is_dataclass(kind)]


def defaults_of(kind):
    """What a dataclass says of fields that are left out."""
    fields = dataclasses.fields(kind)
    return {f.name: f.default for f in fields if f.default is not dataclasses.MISSING}


@pytest.mark.parametrize("kind", kinds_of_data(), ids=lambda kind: kind.__name__)
def test_nothing_that_was_read_can_be_changed(kind):
    """Stages share one scene, in threads and under one key: none may alter it."""
    assert kind.__dataclass_params__.frozen


@pytest.mark.parametrize("kind", SHAPES, ids=lambda kind: kind.__name__)
def test_a_shapes_defaults_are_the_models(kind, scene_from, tmp_path):
    """The reader and the model must not drift apart."""
    (tmp_path / "flat.obj").touch()
    table = f'[[objects]]\ntype = "{kind.__name__.lower()}"\n{SHAPES[kind]}{WHITE}'
    [obj] = scene_from(table, CAMERA).objects
    left_out = defaults_of(kind)
    assert left_out
    assert {name: getattr(obj.shape, name) for name in left_out} == left_out


def test_the_defaults_of_camera_light_and_material_are_the_models(scene_from):
    """As for shapes; a material without a key of its own is a black one."""
    ball = '[[objects]]\ntype = "sphere"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = {}\n'
    scene = scene_from(ball + '[[lights]]\nname = "lamp"\nposition = [1, 2, 3]\n')
    assert scene.camera == model.Camera((0, 0, 5), (0, 0, 0))
    assert scene.lights == (model.Light("lamp", (1, 2, 3)),)
    assert scene.materials == (model.Material("sphere 1"),)
