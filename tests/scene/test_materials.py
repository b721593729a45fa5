"""Named materials and what they inherit."""

import pytest

from raywalk.scene.materials import BUILT_IN
from raywalk.scene.read import read_scene

SPHERE = '[[objects]]\ntype = "sphere"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = {}\n'


def material_of(scene, index=0):
    return scene.materials[scene.objects[index].material]


@pytest.mark.parametrize("name, ior", [("glass", 1.5168), ("water", 1.333), ("diamond", 2.417)])
def test_clear_materials_bend_light_as_measured(name, ior, scene_from):
    """Indices at the sodium or helium line, from the data sheets named beside them."""
    material = material_of(scene_from(SPHERE.format(f'"{name}"')))
    assert (material.ior, material.transmit, material.fresnel) == (ior, 1, True)


@pytest.mark.parametrize("name", BUILT_IN)
def test_every_built_in_material_can_be_used_as_it_is(name, scene_from):
    """No built-in needs a key that it does not have."""
    assert material_of(scene_from(SPHERE.format(f'"{name}"'))).name == name


def test_keys_of_a_material_stand_over_those_it_is_like(scene_from):
    """like fills in only what is left out, through several steps."""
    scene = scene_from(
        '[materials.base]\nlike = "coloured"\nshininess = 7\n'
        '[materials.mine]\nlike = "base"\ndiffuse = [0, 0.5, 1]\n' + SPHERE.format('"mine"')
    )
    material = material_of(scene)
    assert material.diffuse == (0, 0.5, 1)  # its own
    assert material.shininess == 7  # the parent's
    assert material.specular == (1, 1, 0.5)  # the grandparent's


def test_an_own_glass_is_built_on_the_built_in_one_wherever_it_stands_in_the_line(scene_from):
    """Its own name in `like` means the built-in of that name, also as somebody's parent."""
    scene = scene_from(
        '[materials.base]\nlike = "glass"\nshininess = 7\n'
        '[materials.glass]\nlike = "glass"\nior = 1.7\n' + SPHERE.format('"base"')
    )
    material = material_of(scene)
    assert (material.ior, material.shininess, material.transmit) == (1.7, 7, 1)


def test_a_material_given_in_place_is_named_after_its_object(scene_from):
    """A person reads the name in the panel of materials."""
    scene = scene_from(SPHERE.format('{ like = "white", diffuse = [1, 0, 0] }'))
    assert material_of(scene).name == "sphere 1"
    assert material_of(scene).diffuse == (1, 0, 0)


def test_objects_of_one_material_share_it(scene_from):
    """Materials are listed once, in the order of their first use."""
    scene = scene_from("".join(SPHERE.format(f'"{name}"') for name in ("white", "mirror", "white")))
    assert [obj.material for obj in scene.objects] == [0, 1, 0]
    assert [material.name for material in scene.materials] == ["white", "mirror"]


def test_a_checker_becomes_two_materials_that_differ_in_diffuse_only(scene_from):
    """Even squares are the object's material, odd ones the checker's."""
    scene = scene_from(
        '[[objects]]\nname = "floor"\ntype = "plane"\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n'
        'material = "coloured"\nchecker = { colours = [[1, 1, 1], [0, 0, 0]], size = 2 }\n'
    )
    [floor] = scene.objects
    even, odd = scene.materials[floor.material], scene.materials[floor.checker.material]
    assert (even.diffuse, odd.diffuse, floor.checker.size) == ((1, 1, 1), (0, 0, 0), 2)
    assert (even.name, odd.name) == ("floor, even squares", "floor, odd squares")
    assert even.specular == odd.specular == (1, 1, 0.5)


def test_shares_that_add_up_to_exactly_one_are_allowed(scene_from):
    """Two rounded decimals that sum to 1 must not be refused for a last bit."""
    for percent in range(1, 100):
        share = f"reflect = 0.{percent:02}, transmit = {(100 - percent) / 100}"
        material = material_of(scene_from(SPHERE.format(f"{{ {share}, ior = 1.5 }}")))
        assert material.reflect + material.transmit == 1


def test_an_own_material_hides_a_built_in_of_its_name_and_may_build_on_it(scene_from):
    """An author who writes [materials.glass] means theirs; like = "glass" in it is the built-in."""
    scene = scene_from('[materials.glass]\nlike = "glass"\nior = 1.7\n' + SPHERE.format('"glass"'))
    material = material_of(scene)
    assert (material.ior, material.transmit, material.fresnel) == (1.7, 1, True)


@pytest.mark.parametrize(
    ("ambient", "expected"),
    [
        ("", [(0.1, 0.1, 0.1), (0.1, 0.1, 0.1)]),  # that of "white"
        (", ambient = 0.5", [(0.5, 0.5, 0.5), (0.1, 0.05, 0.0)]),
        (", ambient = [[0, 0, 0], [0.3, 0.2, 0.1]]", [(0.0, 0.0, 0.0), (0.3, 0.2, 0.1)]),
    ],
)
def test_squares_of_a_checker_have_an_ambient_of_their_own(tmp_path, ambient, expected):
    """Of the material, a share of their colours, or two that are given."""
    colours = "colours = [[1, 1, 1], [0.2, 0.1, 0]]"
    path = tmp_path / "scene.toml"
    path.write_text(
        'version = 1\ntitle = "t"\nteaches = "t"\n'
        "[camera]\neye = [0, 1, 5]\ntarget = [0, 0, 0]\n"
        '[[objects]]\ntype = "plane"\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n'
        f'material = "white"\nchecker = {{ {colours}{ambient} }}\n',
        encoding="utf-8",
    )
    scene = read_scene(path)
    floor = scene.objects[0]
    found = [scene.materials[k].ambient for k in (floor.material, floor.checker.material)]
    assert found == expected
