"""Area lights are grids of point lights."""

import math

LAMP = """
[[lights]]
name = "lamp"
position = [1, 2, 3]
edges = [[4, 0, 0], [0, 0, 2]]
samples = [4, 2]
colour = [1, 0.5, 0]
intensity = 2
attenuation = [0, 0, 1]
"""


def test_an_area_light_becomes_point_lights_at_its_cells_centres(scene_from):
    """4 x 2 cells of 1 x 1, the first edge fastest."""
    lights = scene_from(LAMP).lights
    assert [light.position for light in lights] == [
        (1 + i + 0.5, 2, 3 + j + 0.5) for j in range(2) for i in range(4)
    ]


def test_the_point_lights_together_are_as_bright_as_the_lamp(scene_from):
    """However finely it is sampled; colour and fading are the lamp's."""
    lights = scene_from(LAMP).lights
    assert math.isclose(sum(light.intensity for light in lights), 2, rel_tol=1e-15)
    for light in lights:
        assert (light.colour, light.attenuation) == ((1, 0.5, 0), (0, 0, 1))


def test_the_point_lights_are_numbered(scene_from):
    """A person can tell which part of the lamp a shadow ray goes to."""
    lights = scene_from(LAMP).lights
    assert (lights[0].name, lights[-1].name) == ("lamp 1/8", "lamp 8/8")


def test_an_area_light_has_sixteen_samples_if_none_are_given(scene_from):
    """Enough for a soft edge, few enough to draw."""
    assert len(scene_from(LAMP.replace("samples = [4, 2]\n", "")).lights) == 16


def test_unnamed_lights_are_numbered_by_their_place(scene_from):
    """A number that a person has given already is skipped."""
    light = "[[lights]]\nposition = [0, 1, 0]\n"
    scene = scene_from(light + light + 'name = "light 1"\n' + light)
    assert [light.name for light in scene.lights] == ["light 2", "light 1", "light 3"]
