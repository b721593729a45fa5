"""A value is what it is written as: no text or truth becomes a number, no number another kind."""

import pytest

from raywalk.errors import SourceErrors

STEP = '[[lesson]]\ntext = "Look."\nview = { @ }\n'
LAMP = '[[lights]]\nname = "lamp"\nposition = [0, 3, 0]\n'
MESH = '[[objects]]\ntype = "mesh"\nmaterial = "white"\nfile = "flat.obj"\n'
# Where a whole number stands, as text with an @ for it, and one that is allowed there.
WHOLE = {
    "size": ("[render]\nresolutions = [15]\nsize = @\n", 105),
    "depth": ("[render]\ndepth = @\n", 1),
    "resolution": ("[render]\nresolutions = [@]\n", 15),
    "samples": (LAMP + "edges = [[1, 0, 0], [0, 0, 1]]\nsamples = [@, 2]\n", 3),
    "subdivide": (MESH + "subdivide = @\n", 1),
    "view's resolution": (STEP.replace("@", "resolution = @"), 15),
    "view's pixel": (STEP.replace("@", "resolution = 15, pixel = [@, 1]"), 7),
    "view's bounces": (STEP.replace("@", "switches = { bounces = @ }"), 1),
}


def is_read(scene_from, text):
    try:
        scene_from(text)
    except SourceErrors:
        return False
    return True


@pytest.mark.parametrize("key", WHOLE)
def test_whole_numbers_are_written_as_such(key, scene_from, tmp_path):
    """3 is one; 3.0, "3" and true are not."""
    (tmp_path / "flat.obj").touch()
    text, allowed = WHOLE[key]
    assert is_read(scene_from, text.replace("@", str(allowed)))
    for other in (f"{allowed}.0", f'"{allowed}"', "true", "-1"):
        assert not is_read(scene_from, text.replace("@", other))


@pytest.mark.parametrize("other", ['"1"', "true", "nan", "inf"])
def test_numbers_are_finite_and_no_texts(other, scene_from):
    """In a list and by themselves."""
    assert is_read(scene_from, LAMP + "intensity = 1\n")
    assert not is_read(scene_from, LAMP + f"intensity = {other}\n")
    assert not is_read(scene_from, LAMP + f"attenuation = [{other}, 0, 0]\n")


@pytest.mark.parametrize("other", ["1", "0", '"true"', "1.0"])
def test_switches_are_true_or_false(other, scene_from):
    """1 may be a mistake for a number elsewhere."""
    assert is_read(scene_from, "[render]\nshadows = false\n")
    assert not is_read(scene_from, f"[render]\nshadows = {other}\n")
