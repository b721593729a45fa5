"""raywalk site, end to end on two small scenes."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raywalk.__main__ import main
from raywalk.stops.decoded import read_trace
from raywalk.trace_file.container import unpack
from raywalk.work import pool

SMALL = """
version = 1
key = "{key}"
title = "{title}"
teaches = "Something <b>bold</b> & true."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
size = 63
resolutions = [7, 21]
depth = 2
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = {radius}
material = {{ like = "coloured", reflect = 0.5 }}
[[objects]]
name = "floor"
type = "plane"
point = [0, -1, 0]
normal = [0, 1, 0]
material = "white"
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "Look, **one** ray <script>alert(1)</script>."
view = {{ resolution = 7, pixel = [3, 3] }}
"""


def write_scenes(folder: Path) -> None:
    for key, radius in ("1", 0.9), ("2", 0.5):
        place = folder / "scenes" / f"0{key}-ball"
        place.mkdir(parents=True)
        text = SMALL.format(key=key, title=f"Ball {key}", radius=radius)
        (place / "scene.toml").write_text(text, encoding="utf-8")


def site(folder: Path, *options: str) -> int:
    places = {"--scenes": "scenes", "--out": "dist", "--work": "work"}
    named = (str(x) for key, name in places.items() for x in (key, folder / name))
    return main(["site", *named, *options])


@pytest.fixture(scope="module")
def built(tmp_path_factory, with_viewer, one_process):
    """A folder with two scenes and the site of them, for tests that only look."""
    folder = tmp_path_factory.mktemp("site")
    write_scenes(folder)
    with_viewer(folder / "work")
    assert site(folder) == 0
    return folder


@pytest.fixture
def scenes(tmp_path, built):
    """A folder with two scenes, traced before, for tests that change something."""
    shutil.copytree(built, tmp_path, dirs_exist_ok=True)
    return tmp_path / "scenes"


@pytest.fixture
def build(tmp_path, scenes, capsys):
    """A function that builds the site: exit code, what it printed, and the site's folder."""

    def run(*options):
        code = site(tmp_path, *options)
        printed = capsys.readouterr()
        return code, printed.out + printed.err, tmp_path / "dist"

    return run


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def test_a_site_has_pages_pictures_scene_data_and_every_grid(built):
    """Everything the viewer asks for, and nothing of the workshop."""
    files = contents(built / "dist")
    for scene in ("01-ball", "02-ball"):
        expected = "index.html picture.png thumb.png scene.js 7.js 7.json.gz 21.js 21.json.gz"
        assert all(f"scenes/{scene}/{name}" in files for name in expected.split())
    assert not [name for name in files if name.endswith((".npz", "facts.json", "manifest.json"))]


def test_every_tile_has_the_colour_of_the_pictures_pixel_at_its_centre(built):
    """One trace, many resolutions: the same rays, to the last bit."""
    out = built / "dist"
    for scene in (out / "scenes").iterdir():
        picture = np.asarray(Image.open(scene / "picture.png").convert("RGB"))
        for n in (7, 21):
            step = 63 // n
            centres = picture[step // 2 :: step, step // 2 :: step]
            tiles = read_trace(scene / f"{n}.json.gz").tiles.reshape(n, n, 3)
            np.testing.assert_array_equal(tiles, centres)


def test_a_pages_picture_has_the_pixels_of_the_one_to_save(built):
    """Where WebP takes fewer bytes than PNG it is shown instead: lossless, and named by the page
    and the scene's data."""
    out, shown = built / "dist", 0
    for scene in (out / "scenes").iterdir():
        for webp in scene.glob("*.webp"):
            png = webp.with_suffix(".png")
            assert webp.stat().st_size < png.stat().st_size
            pixels = [np.asarray(Image.open(path).convert("RGB")) for path in (webp, png)]
            np.testing.assert_array_equal(*pixels)
            shown += 1
        name = "picture.webp" if (scene / "picture.webp").exists() else "picture.png"
        assert json.loads(unpack((scene / "scene.js").read_bytes()))["picture"] == name
        page = (scene / "index.html").read_text(encoding="utf-8")
        assert f"{scene.name}/{name}" in page and f'{scene.name}/picture.png" download' in page
    assert shown > 0


def test_words_of_a_scene_file_cannot_become_markup(built):
    """A title is text, and a script in a lesson is shown, not run."""
    out = built / "dist"
    page = (out / "scenes" / "01-ball" / "index.html").read_text(encoding="utf-8")
    assert "<script>alert" not in page
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in page
    assert "<strong>one</strong>" in page
    assert "<b>bold" not in page


def test_the_same_input_gives_the_same_bytes_and_traces_nothing_again(
    build, tmp_path, with_viewer, monkeypatch
):
    """Once from the store, and once more from nothing, where two processes make it."""
    first = contents(tmp_path / "dist")
    _, said, out = build()
    assert "0 traced, 2 unchanged" in said
    assert contents(out) == first
    shutil.rmtree(tmp_path / "work")
    with_viewer(tmp_path / "work")
    monkeypatch.setattr(pool, "cores", lambda: 2)
    _, said, _ = build()
    assert "2 traced, 0 unchanged" in said
    assert contents(out) == first


def test_a_changed_colour_touches_that_scene_alone_and_a_changed_text_traces_nothing(build, scenes):
    """Keys are made of what a trace depends on."""
    path = scenes / "02-ball" / "scene.toml"
    path.write_text(path.read_text().replace("Look,", "See,"), encoding="utf-8")
    _, said, out = build()
    assert "0 traced, 2 unchanged" in said
    assert "See," in (out / "scenes/02-ball/index.html").read_text()
    path.write_text(path.read_text().replace("radius = 0.5", "radius = 0.6"), encoding="utf-8")
    _, said, _ = build()
    assert "1 traced, 1 unchanged" in said


def test_explain_says_why_each_thing_is_made_again(build, scenes, tmp_path):
    """The scene's key that changed; a text makes the page's data only; damage is named."""
    path = scenes / "02-ball" / "scene.toml"
    path.write_text(path.read_text().replace("radius = 0.5", "radius = 0.6"), encoding="utf-8")
    said = build("--explain")[1]
    assert "02-ball: trace made: objects[0].shape.radius 0.5 -> 0.6" in said
    assert "02-ball: slides made: objects[0].shape.radius 0.5 -> 0.6; its" in said
    assert "course: slides made: its decks" in said
    assert "01-ball" not in said.split("[1/1]")[0]
    path.write_text(path.read_text().replace("Look,", "See,"), encoding="utf-8")
    said = build("--explain")[1]
    assert "trace made" not in said and "02-ball: page data made: lesson[0].text" in said
    assert "02-ball: lesson made: its page data" in said and "sights made" not in said
    assert "nothing is made again" in build("--explain")[1]
    for kept in (tmp_path / "work").glob("*/thumb.png"):  # also what no build uses any longer
        kept.write_bytes(b"")
    shutil.rmtree(tmp_path / "dist")
    assert "its kept thumb.png is damaged" in build("--explain")[1]


def test_stats_tells_of_each_scene_what_it_did_not_need(build, tmp_path):
    """Also where nothing is made again; the page and the viewer tell the same."""
    said = build("--stats")[1]
    table = said[said.index("02-ball\n") :]
    for words in ("Rays traced", "3 969 camera", "Stages not run", "refraction"):
        assert words.replace(" ", "\u202f", words[0].isdigit()) in table
    assert "0 traced, 2 unchanged" in said
    page = (tmp_path / "dist/scenes/02-ball/index.html").read_text(encoding="utf-8")
    assert "What this scene did not need" in page and "Shadow rays shot" in page


def test_a_site_that_was_changed_by_hand_is_made_anew(build, tmp_path):
    """Though no input changed: what is there must be what was built."""
    before = contents(tmp_path / "dist")
    (tmp_path / "dist" / "index.html").write_text("mine", encoding="utf-8")
    (tmp_path / "dist" / "scenes" / "01-ball" / "7.js").unlink()
    build()
    assert contents(tmp_path / "dist") == before


def test_a_build_with_nothing_to_do_imports_nothing_that_traces_or_writes(built):
    """It hashes files and ends: neither numba nor numpy, neither pydantic nor jinja2."""
    code = (
        "import sys; from raywalk.__main__ import main; "
        f"code = main(['site', '--scenes', {str(built / 'scenes')!r}, "
        f"'--out', {str(built / 'dist')!r}, '--work', {str(built / 'work')!r}]); "
        "print(code, *sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    *_, said, imported = done.stdout.strip().splitlines()
    assert "0 traced, 2 unchanged" in said
    heavy = {"numba", "numpy", "pydantic", "jinja2", "trimesh", "embreex", "markdown", "PIL"}
    assert imported.startswith("0 ") and not heavy & set(imported.split())


def test_a_new_text_imports_no_engine(build, scenes):
    """Page edits never trace, and never pay for what traces."""
    path = scenes / "02-ball" / "scene.toml"
    path.write_text(path.read_text().replace("Look,", "See,"), encoding="utf-8")
    folder = scenes.parent
    code = (
        "import sys; from raywalk.__main__ import main; "
        f"code = main(['site', '--scenes', {str(scenes)!r}, "
        f"'--out', {str(folder / 'dist')!r}, '--work', {str(folder / 'work')!r}]); "
        "print(code, *sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert not {"numba", "trimesh", "embreex"} & set(done.stdout.splitlines()[-1].split())


def test_a_killed_build_leaves_a_whole_site_and_the_next_one_resumes(build, scenes, tmp_path):
    """kill -9 in its midst: the old site stands, or the new one; no scraps stay. At each instant of
    publishing tests/work/test_publish.py kills it."""
    before = contents(tmp_path / "dist")
    for scene in scenes.iterdir():
        path = scene / "scene.toml"
        path.write_text(path.read_text().replace("depth = 2", "depth = 3"), encoding="utf-8")
    command = [sys.executable, "-m", "raywalk", "site", "--scenes", str(scenes)]
    command += ["--out", str(tmp_path / "dist"), "--work", str(tmp_path / "work")]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, start_new_session=True) as process:
        time.sleep(1.0)
        os.killpg(process.pid, signal.SIGKILL)
    killed = contents(tmp_path / "dist")
    build()
    after = contents(tmp_path / "dist")
    assert killed in (before, after) and after != before
    assert after.keys() == before.keys()
    assert not [path.name for path in tmp_path.rglob("*.partial")]


@pytest.mark.slow
def test_a_site_is_whole_without_what_is_left_out(
    tmp_path, built, with_viewer, monkeypatch, capsys
):
    """Pages lead to check/ and mistakes/ only where these are, and one is told what may be left
    out. What is asked for otherwise is built anew."""
    monkeypatch.setenv("RAYWALK_WITHOUT", "slides")
    with pytest.raises(SystemExit):
        site(tmp_path)
    assert "slides cannot be left out: name check or mistakes" in capsys.readouterr().err
    shutil.copytree(built, tmp_path, dirs_exist_ok=True)
    for without in "mistakes", "check, mistakes", "":
        assert site(tmp_path, "--without", without) == 0
        page = (tmp_path / "dist/scenes/01-ball/index.html").read_text(encoding="utf-8")
        first = (tmp_path / "dist/index.html").read_text(encoding="utf-8")
        for part in "check", "mistakes":
            is_there = part not in without
            assert (tmp_path / "dist" / part / "index.html").is_file() is is_there
            assert (f'"{part}/index.html' in first) is is_there
        assert ("check/index.html#scene=01-ball" in page) is ("check" not in without)


@pytest.mark.slow
def test_two_builds_at_once_make_the_same_site_as_one(scenes, tmp_path, with_viewer):
    """Two processes on one tree, from a store that has the viewer only, into one folder."""
    before = contents(tmp_path / "dist")
    shutil.rmtree(tmp_path / "work")
    with_viewer(tmp_path / "work")
    shutil.rmtree(tmp_path / "dist")
    command = [sys.executable, "-m", "raywalk", "site", "--scenes", str(scenes)]
    command += ["--out", str(tmp_path / "dist"), "--work", str(tmp_path / "work")]
    both = [subprocess.Popen(command, stdout=subprocess.DEVNULL) for _ in range(2)]
    assert [process.wait() for process in both] == [0, 0]
    assert contents(tmp_path / "dist") == before
    assert not [path.name for path in tmp_path.rglob("*.partial")]


def test_bad_input_leaves_the_old_site_as_it_was(build, scenes):
    """All mistakes at once, exit code 1, dist untouched, nothing half-written beside it."""
    out = scenes.parent / "dist"
    before = contents(out)
    for key, bad in ("1", "radius = -1"), ("2", "radius = nan"):
        path = scenes / f"0{key}-ball" / "scene.toml"
        text = path.read_text()
        path.write_text(text.replace("radius = 0", bad + " #"), encoding="utf-8")
    code, said, _ = build()
    assert code == 1
    assert "01-ball" in said and "02-ball" in said
    assert said.rstrip().endswith("2 errors; nothing was traced")
    assert contents(out) == before
    assert [path.name for path in out.parent.iterdir() if path.name.startswith("dist")] == ["dist"]


def test_a_damaged_store_is_noticed_and_made_again(build, tmp_path):
    """A flipped byte in a kept picture does not reach the site."""
    before = contents(tmp_path / "dist")
    [kept, *_] = sorted((tmp_path / "work").glob("*/picture.png"))
    data = bytearray(kept.read_bytes())
    data[len(data) // 2] ^= 1
    kept.write_bytes(data)
    _, said, out = build()
    assert "1 traced, 1 unchanged" in said
    assert contents(out) == before


def test_the_viewers_data_names_what_the_scene_names(built):
    """scene.js holds the objects in the scene's order, with their places."""
    import base64
    import gzip

    out = built / "dist"
    script = (out / "scenes" / "01-ball" / "scene.js").read_text()
    name, payload = json.loads("[" + script.removeprefix("raywalkReceive(").rstrip(");\n") + "]")
    data = json.loads(gzip.decompress(base64.b64decode(payload)))
    assert name == "01-ball/scene"
    assert [obj["name"] for obj in data["objects"]] == ["ball", "floor"]
    # Column-major: a ball of radius 0.9 at the origin.
    assert data["objects"][0]["transform"] == [
        0.9, 0, 0, 0, 0, 0.9, 0, 0, 0, 0, 0.9, 0, 0, 0, 0, 1
    ]  # fmt: skip
    assert data["start"] == {"resolution": 7, "pixel": [3, 3]}


def test_inspect_prints_a_pixels_ray_tree_from_either_file(built, capsys):
    """As text from the script that the viewer loads, as JSON from the file for everyone."""
    out = built / "dist"
    place = out / "scenes" / "01-ball"
    assert main(["inspect", str(place / "7.js"), "--pixel", "3,3"]) == 0
    assert "camera ray meets ball" in capsys.readouterr().out
    assert main(["inspect", str(place / "7.json.gz"), "--pixel", "3,3", "--json"]) == 0
    tree = json.loads(capsys.readouterr().out)["tree"]
    assert (tree["kind"], tree["objectName"]) == ("camera", "ball")
    assert [child["kind"] for child in tree["children"]] == ["reflected"]


def test_inspect_tells_a_pixels_events(built, tmp_path, capsys):
    """In sentences with their numbers, as JSON too; what it needs besides the trace is named."""
    place = built / "dist" / "scenes" / "01-ball"
    assert main(["inspect", str(place / "7.js"), "--pixel", "3,3", "--events"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "  1  A camera ray leaves through pixel (3, 3)."
    assert lines[1] == "     from the eye (0.000, 0.000, 5.000)"
    assert main(["inspect", str(place / "7.js"), "--pixel", "3,3", "--events", "--json"]) == 0
    events = json.loads(capsys.readouterr().out)
    assert [event["what"] for event in events[:2]] == ["camera", "meets"]
    assert events[0]["says"] == "A camera ray leaves through pixel (3, 3)."
    assert events[1]["facts"]["name"] == "ball"
    shutil.copyfile(place / "7.js", tmp_path / "7.js")
    assert main(["inspect", str(tmp_path / "7.js"), "--pixel", "3,3", "--events"]) == 1
    assert "scene.js: cannot be read" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("file", "pixel", "words"),
    [("7.js", "7,0", "pixel 7,0"), ("9.js", "0,0", "cannot be read"), ("picture.png", "0,0", "")],
)
def test_inspect_names_what_it_cannot_read(built, capsys, file, pixel, words):
    """A pixel outside, a file that is not there, a file that is no trace: exit code 1."""
    out = built / "dist"
    assert main(["inspect", str(out / "scenes/01-ball" / file), "--pixel", pixel]) == 1
    error = capsys.readouterr().err
    assert file in error and words in error
    assert "Traceback" not in error


def test_a_file_over_its_budget_fails_the_build_and_leaves_the_site_alone(scenes, capsys):
    folder = scenes.parent
    budgets = folder / "budgets.toml"
    budgets.write_text(
        '[[budgets]]\nkey = "picture"\nwhat = "picture.png"\nlimit = 10\nunit = "bytes"\n'
        'counted = "each"\nreason = "a line of two bytes a second"\n'
    )
    before = {path: path.read_bytes() for path in (folder / "dist").rglob("*") if path.is_file()}
    assert site(folder, "--budgets", str(budgets)) == 1, "nothing else has changed"
    scene = scenes / "01-ball" / "scene.toml"
    scene.write_text(scene.read_text().replace("one", "another"))
    capsys.readouterr()
    assert site(folder, "--budgets", str(budgets)) == 1
    said = capsys.readouterr().err
    assert "01-ball/picture." in said and "the budget is 10.00 bytes" in said
    assert "a line of two bytes a second" in said and "Traceback" not in said
    after = {path: path.read_bytes() for path in (folder / "dist").rglob("*") if path.is_file()}
    assert after == before


def test_sizes_are_told_by_budget_beside_a_floor(built, capsys):
    assert site(built, "--sizes") == 0
    said = capsys.readouterr().out
    assert "ray trees at the finest grid: at most 1.70 bytes a ray" in said
    assert "of its PNG" in said and "of xz -9e" in said
    assert (built / "dist" / "sizes" / "index.html").is_file()
