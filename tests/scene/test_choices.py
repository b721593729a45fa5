"""What the course says is right is right: each question's choices, recomputed by the tracer."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from raywalk.scene.model import Choice, LessonStep, Scene
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.translation import read_spoken
from raywalk.trace.pixel_tree import pixel_tree
from raywalk.trace.wavefront import Tracer

SCENES = Path(__file__).parents[2] / "scenes"
N = 15  # the grid of the questions that are recomputed here
BYTE = 1 / 255


@cache
def scene_of(key: str) -> Scene:
    return next(scene for scene in read_scenes(SCENES) if scene.key == key)


def tree(scene: Scene, pixel: tuple[int, int], n: int = N) -> dict[str, Any]:
    """What `raywalk pixel` tells."""
    return pixel_tree(scene, n, n, *pixel)["tree"]


def colour(scene: Scene, pixel: tuple[int, int]) -> np.ndarray:
    return np.array(pixel_tree(scene, N, N, *pixel)["colour"])


def question(key: str, says: str) -> LessonStep:
    """The one with a right choice that says so."""
    [found] = [
        step
        for step in scene_of(key).lesson
        for choice in step.choices
        if choice.right and says in f"{choice.text} {choice.because}"
    ]
    return found


def right(step: LessonStep) -> Choice:
    return next(choice for choice in step.choices if choice.right)


def bounced(scene: Scene, depth: int) -> Scene:
    return replace(scene, render=replace(scene.render, depth=depth))


def lit(scene: Scene, factors: dict[str, float]) -> Scene:
    lights = tuple(
        replace(light, intensity=light.intensity * factors.get(light.name, 1.0))
        for light in scene.lights
    )
    return replace(scene, lights=lights)


def every_question() -> list[tuple[str, int]]:
    scenes = read_scenes(SCENES)
    return [(s.id, k) for s in scenes for k, step in enumerate(s.lesson) if step.choices]


def test_a_colour_that_is_right_is_the_pixels_and_the_others_are_not():
    """Each within half a byte, or further away than one could take for the same."""
    for scene in read_scenes(SCENES):
        for step in scene.lesson:
            if any(choice.colour for choice in step.choices):
                view = step.view | step.answer_view
                assert view["resolution"] == N
                true = np.clip(colour(scene, tuple(view["pixel"])), 0, 1)
                for choice in step.choices:
                    away = np.abs(true - choice.colour).max()
                    assert away < BYTE / 2 if choice.right else away > 20 * BYTE


def test_scene_1_twice_the_light_is_less_than_twice_as_bright():
    """0.1 and the light's part, which alone is doubled: so the reason's slots say it."""
    step = question("1", "Less than twice")
    pixel = tuple(step.view["pixel"])
    [light] = tree(scene_of("1"), pixel)["lights"]
    once = colour(scene_of("1"), pixel)[2]
    twice = colour(lit(scene_of("1"), {"light 1": 2}), pixel)[2]
    assert (
        "{ka.blue.blue} + {diffuse : 1} becomes {ka.blue.blue} + {2 * diffuse : 1}"
        in right(step).because
    )
    assert once == pytest.approx(0.1 + light["diffuse"], abs=1e-6)  # of the highlight is less left
    assert twice == pytest.approx(0.1 + 2 * light["diffuse"], abs=1e-6)
    assert twice < 2 * once - 0.09


def test_scene_1_a_pixel_behind_something_is_green_all_the_same():
    """The surface faces the light; no shadow ray is sent in scene 1, and scene 2's is blocked."""
    step = question("1", "bright green")
    pixel = tuple(step.view["pixel"])
    [light] = tree(scene_of("1"), pixel)["lights"]
    assert not light["faces_away"] and light["blocker"] is None
    red, green, blue = colour(scene_of("1"), pixel)
    assert green > 0.5 > 3 * max(red, blue)
    [asked] = tree(scene_of("2"), pixel)["lights"]
    assert asked["blocker"] == "blue sphere"


def test_scene_2_costs_at_most_two_rays_and_at_least_one():
    """Over the whole grid: a camera ray, and a shadow ray where the hit faces the light."""
    waves = Tracer(scene_of("2")).waves(np.arange(N * N), N, N)
    assert len(waves) == 1
    asked = (waves[0].lighting.visibility[:, 0] < 2) & (waves[0].hits.object >= 0)
    assert {int(each) for each in 1 + asked} == {1, 2}
    assert question("2", "At most 2, at least 1")


def seen_by(node: dict[str, Any]) -> list[str]:
    return [each["name"] for each in node["lights"] if each["visible"]]


def test_scene_3_which_light_arrives():
    """Of the partial shadow light 1, of the floor on the left light 2, and no other."""
    for says, light in (("Nothing changes", "light 1"), ("The one at the back", "light 2")):
        pixel = tuple(question("3", says).view["pixel"])
        assert seen_by(tree(scene_of("3"), pixel)) == [light]
    pixel = tuple(question("3", "Nothing changes").view["pixel"])
    without = lit(scene_of("3"), {"light 2": 0})
    assert (colour(without, pixel) == colour(scene_of("3"), pixel)).all()


def test_scene_4_black_without_a_bounce_and_the_wall_with_two():
    """Both from fresh traces with another limit."""
    scene = scene_of("4")
    mirror = tuple(question("4", "no colour of its own").view["pixel"])
    assert not colour(bounced(scene, 0), mirror).any()
    both = tuple(question("4", "back wall").view["pixel"])
    assert not colour(bounced(scene, 1), both).any()
    node = tree(bounced(scene, 2), both)
    while node["children"]:
        [node] = node["children"]
    assert node["object"] == "back wall"


def test_scene_5_only_the_right_pixel_turns_black_at_one_bounce():
    """The others keep their colour to the last bit, black ones too."""
    step = question("5", "two bounces, and one is not enough")
    for choice in step.choices:
        assert choice.pixel is not None
        before = colour(scene_of("5"), choice.pixel)
        after = colour(bounced(scene_of("5"), 1), choice.pixel)
        if choice.right:
            assert before.any() and not after.any()
        else:
            assert (before == after).all()


def test_scene_6_the_right_pixel_takes_the_most_tests():
    """At least twice as many as the next one, and it hits nothing."""
    step = question("6", "just above the back")
    tracer = Tracer(scene_of("6"))
    [wave] = tracer.waves(np.arange(N * N), N, N)
    far = np.where(wave.hits.object < 0, np.inf, wave.hits.t)
    tests = tracer.compiled.count_tests(wave.rays, far)
    counts: dict[bool, int] = {}
    for choice in step.choices:
        assert choice.pixel is not None
        k = choice.pixel[1] * N + choice.pixel[0]
        counts[choice.right] = max(counts.get(choice.right, 0), int(tests[k]))
        assert choice.right is False or wave.hits.object[k] < 0
    assert counts[True] > 2 * counts[False]


def test_scene_7_the_point_under_the_belly_faces_the_light_and_is_blocked():
    """By the bunny itself."""
    pixel = tuple(question("7", "Something is in the way").view["pixel"])
    [light] = tree(scene_of("7"), pixel)["lights"]
    assert not light["visible"] and light["blocker"] == "bunny" and light["diffuse"] > 0


def test_scene_7_moved_first_and_scaled_afterwards():
    """The numbers of the choices are those of the two orders."""
    step = question("7", "x = 4.5")
    assert [c.text for c in step.choices if c.right] == [f"x = {(1 + 2) * 1.5:g}"]
    assert f"x = {1 * 1.5 + 2:g}" in [c.text for c in step.choices if not c.right]


def test_scene_8_half_is_mirrored_where_a_ray_grazes():
    """The reflected ray's weight at the ball."""
    pixel = tuple(question("8", "About 50").view["pixel"])
    reflected = tree(scene_of("8"), pixel)["children"][0]
    assert reflected["kind"] == "reflected"
    assert 0.45 < reflected["weight"] < 0.55


def test_scene_8_without_refracted_rays_almost_nothing_is_left():
    """A few hundredths, as the reason says."""
    pixel = tuple(question("8", "a few hundredths").view["pixel"])
    reflected = next(
        each for each in tree(scene_of("8"), pixel)["children"] if each["kind"] == "reflected"
    )
    assert 0.02 < reflected["weight"] < 0.08


def test_scene_9_the_moon_is_a_mirror_that_asks_no_light():
    """At its hit nothing of its own is weighed."""
    pixel = tuple(question("9", "A mirror: none").view["pixel"])
    node = tree(scene_of("9"), pixel)
    assert node["object"] == "moon" and node["local_weight"] == 0


def test_scene_9_the_blue_and_the_rose_light_light_the_dragons_back():
    """Of four, and the pixel shows the dragon by way of the moon."""
    step = question("9", "The blue and the rose light")
    node = tree(scene_of("9"), tuple(step.view["pixel"]), step.view["resolution"])
    [back] = node["children"]
    assert (node["object"], back["object"]) == ("moon", "dragon")
    assert seen_by(back) == ["blue light", "rose light"]


def test_scene_10_only_the_camera_light_arrives_in_the_columns_shadow():
    """So only its going makes the place darker."""
    step = question("0", "the only one that")
    pixel = tuple(step.view["pixel"])
    scene = scene_of("0")
    assert seen_by(tree(scene, pixel)) == ["camera light"]
    now = colour(scene, pixel)
    assert (colour(lit(scene, {"camera light": 0}), pixel) < now).all()
    assert (colour(lit(scene, {"ceiling light": 0}), pixel) == now).all()


def brought(node: dict[str, Any], weight: float = 1.0) -> dict[str, float]:
    """Share of the pixel that each object gives by its own colour."""
    share = {str(node["object"]): weight * node.get("local_weight", 1.0)}
    for child in node["children"]:
        for name, each in brought(child, weight * child["weight"]).items():
            share[name] = share.get(name, 0.0) + each
    return share


def test_scene_10_most_of_the_balls_left_rim_is_the_right_wall():
    """More than half, and more than of any other wall that is to be chosen."""
    scene = scene_of("0")
    step = question("0", "left and right round")
    shares = brought(tree(scene, tuple(step.view["pixel"])))
    walls = {c.right: scene.objects[c.object].name for c in step.choices if c.object is not None}
    assert shares[walls[True]] > 0.5
    for choice in step.choices:
        if not choice.right and choice.object is not None:
            assert shares.get(scene.objects[choice.object].name, 0.0) < 0.2


def test_right_choices_do_not_all_stand_in_the_same_place():
    """Who always takes the first one is right less than half of the time."""
    scenes = read_scenes(SCENES)
    places = [
        [choice.right for choice in step.choices].index(True)
        for scene in scenes
        for step in scene.lesson
        if step.choices
    ]
    for place in set(places):
        assert places.count(place) < len(places) / 2


def test_a_reason_is_read_at_a_glance():
    """In both languages: two of them stand on a slide, which has 40 words at most."""
    scenes = read_scenes(SCENES)
    for scene in [*scenes, *(each.scene for each in read_spoken(scenes, "de"))]:
        for choice in (choice for step in scene.lesson for choice in step.choices):
            reason = re.sub(r"\{[^}]*\}", "1", choice.because)  # a slot is a figure
            assert len(reason.split()) <= 20, (scene.title, reason)


SCENE = """
version = 1
title = "Ball"
teaches = "Something."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "white"
[[lesson]]
text = "What?"
answer = "That."
view = { resolution = 15 }
choices = [
  { text = "This", because = "No." },
  { object = "ball", right = true, because = "Yes." },
  { pixel = [1, 2], because = "No." },
]
"""
GERMAN = """
title = "Ball"
teaches = "Etwas."
[names]
ball = "Ball"
white = "Weiß"
[[lesson]]
text = "Was?"
answer = "Das."
"""


@pytest.fixture
def spoken(tmp_path: Path) -> Callable[[str], Any]:
    def read(choices: str) -> Any:
        (tmp_path / "scene.toml").write_text(SCENE, encoding="utf-8")
        (tmp_path / "lesson.de.toml").write_text(GERMAN + choices, encoding="utf-8")
        [each] = read_spoken([read_scene(tmp_path)], "de")
        return each.scene.lesson[0].choices

    return read


def test_a_translation_gives_words_and_leaves_the_rest(spoken):
    """What is right, pixels and objects stand once."""
    first, second, third = spoken(
        'choices = [{ text = "Dies", because = "Nein." }, { because = "Ja." }, { because = "N." }]'
    )
    assert (first.text, first.because, first.right) == ("Dies", "Nein.", False)
    assert (second.object, second.because, second.right) == (0, "Ja.", True)
    assert third.pixel == (1, 2)


@pytest.mark.parametrize(
    "choices, says",
    [
        ("", "lesson[0].choices: there are 0, in scene.toml 3"),
        ('choices = [{ because = "N." }, { because = "J." }, { because = "N." }]',
         'lesson[0].choices[0].text: missing: there it is "This"'),
        ('choices = [{ text = "D", because = "N." }, { text = "B", because = "J." }, '
         '{ because = "N." }]',
         "lesson[0].choices[1].text: this choice is a pixel or an object, which has no text"),
    ],
)  # fmt: skip
def test_a_translation_with_other_choices_is_refused(spoken, choices, says):
    """In words that name the choice."""
    with pytest.raises(Exception, match="error") as caught:
        spoken(choices)
    assert says in str(caught.value)
