"""What a scene file leaves out, and what it may hold."""

import pytest

from raywalk.scene.model import Render

BALL = '[[objects]]\ntype = "sphere"\ncenter = [0, 0, 0]\nradius = {}\nmaterial = "{}"\n'


def test_render_defaults_are_the_models(scene_from):
    """The reader and the model must not drift apart."""
    assert scene_from("").render == Render()


def test_resolutions_are_ascending(scene_from):
    """The viewer steps through them with + and -."""
    assert scene_from("[render]\nresolutions = [15, 5]\n").render.resolutions == (5, 15)


def test_unnamed_objects_are_named_by_kind_and_number(scene_from):
    """All of a kind are counted, named or not, so that numbers say the place in the file."""
    named = BALL.format(1, "white") + 'name = "ball"\n'
    plane = (
        '[[objects]]\ntype = "plane"\npoint = [0, -9, 0]\nnormal = [0, 1, 0]\nmaterial = "white"\n'
    )
    scene = scene_from(BALL.format(1, "white") + named + plane + BALL.format(2, "white"))
    assert [obj.name for obj in scene.objects] == ["sphere 1", "ball", "plane 1", "sphere 3"]


def test_the_camera_may_be_under_water(scene_from):
    """Inside something transparent there is something to see."""
    assert scene_from(BALL.format(6, "water")).objects


def test_the_camera_may_stand_on_a_surface(scene_from):
    """Strictly inside is what is refused."""
    assert scene_from(BALL.format(5, "white")).objects


def test_a_plane_may_border_a_half_space_of_glass(scene_from):
    """A pond: a plane has an inside, the half-space behind it."""
    plane = (
        '[[objects]]\ntype = "plane"\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\nmaterial = "water"\n'
    )
    assert scene_from(plane).objects


def test_a_view_keeps_only_the_keys_it_gives(scene_from):
    """What is absent stays as at the start; the rest is plain JSON."""
    step = (
        '[[lesson]]\ntext = """\nLook.\n"""\n'
        "view = { resolution = 15, pixel = [7, 9], rays = [], observer = { eye = [1, 2, 3], "
        "target = [0, 0, 0] } }\n"
    )
    [lesson] = scene_from(step).lesson
    assert lesson.text == "Look."
    assert lesson.view == {
        "resolution": 15,
        "pixel": [7, 9],
        "rays": [],
        "observer": {"eye": [1.0, 2.0, 3.0], "target": [0.0, 0.0, 0.0]},
    }


def test_a_view_may_switch_to_as_many_bounces_as_are_traced(scene_from):
    """The last bounce is there to be shown."""
    scene = scene_from(
        '[render]\ndepth = 3\n[[lesson]]\ntext = "Look."\nview = { switches = { bounces = 3 } }\n'
    )
    assert scene.lesson[0].view == {"switches": {"bounces": 3}}


def test_an_answer_is_a_stop_of_its_own_and_keeps_what_its_view_leaves_out(scene_from):
    """Question and answer one after the other, as a person walks through them."""
    step = (
        '[[lesson]]\ntext = "What colour?"\nview = { resolution = 15, rays = [] }\n'
        'answer = "Red."\nanswer_view = { rays = ["pixel"] }\n'
    )
    [lesson] = scene_from(step).lesson
    assert lesson.stops() == [
        ("What colour?", {"resolution": 15, "rays": []}),
        ("Red.", {"resolution": 15, "rays": ["pixel"]}),
    ]


@pytest.mark.parametrize(
    "size, fitting", [(105, (5, 7, 15, 21, 105)), (1155, Render().resolutions)]
)
def test_default_resolutions_divide_the_size_by_an_odd_number(size, fitting, scene_from):
    """Then every frustum ray is a ray of the picture."""
    resolutions = scene_from(f"[render]\nsize = {size}\n").render.resolutions
    assert resolutions == fitting
    assert all(size % n == 0 and size // n % 2 for n in resolutions)
