"""What students' pictures are held against, as the site has it."""

from __future__ import annotations

import base64
import gzip
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from raywalk.check.atlas import CHANGED, GRID, changed
from raywalk.check.places import EDGE, IN_SHADOW, LIT, MIRROR, places
from raywalk.check.right_pictures import USUAL_SIZES, other_sizes, right_picture, shared_sizes
from raywalk.check.rows import packed_rows, rows_of
from raywalk.check.write import STEP
from raywalk.mistakes.tracer import picture
from raywalk.scene.read import read_scene, read_scenes
from raywalk.trace.tree import level_pixels
from raywalk.trace_file.container import script

ROOT = Path(__file__).parents[2]
PUBLISHED = ROOT / "dist" / "check"
OWN = [each for each in read_scenes(ROOT / "scenes") if not each.base]
SHADOWS = read_scene(ROOT / "scenes" / "02-shadows")
LEFT_OUT = {
    "06-bunny-far": "meshes", "07-bunny-near": "meshes", "09-dragon": "meshes",
    "14-soft-shadows-16": "lamps", "15-soft-shadows-64": "lamps", "16-soft-shadows-large": "lamps",
}  # fmt: skip
#: Gzipped, as sent: what a check of one scene loads at most.
MOST_BYTES = 1_500_000


def packed(scene: str, name: str) -> bytes:
    return base64.b64decode((PUBLISHED / scene / f"{name}.js").read_text("ascii").split('"')[3])


def about(scene: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(gzip.decompress(packed(scene, "about")))
    return found


def strips_of(scene: str) -> np.ndarray:
    whole = np.frombuffer(gzip.decompress(packed(scene, "atlas")), np.uint8)
    return whole.reshape(-1, GRID, GRID, 3)


def image(scene: str, name: str) -> np.ndarray:
    return rows_of((PUBLISHED / scene / f"{name}.js").read_bytes())


@pytest.mark.parametrize("scene", OWN, ids=lambda scene: scene.id)
def test_each_scene_has_its_sizes_and_says_what_it_leaves_out(scene) -> None:
    said = about(scene.id)
    assert (said["own"], said["others"]) == (shared_sizes(scene), other_sizes(scene))
    assert said["leftOut"] == LEFT_OUT.get(scene.id, "")
    names = {path.stem for path in (PUBLISHED / scene.id).iterdir()}
    atlas = set() if said["leftOut"] else {"atlas"}
    sizes = {str(n) for n in (scene.render.size, *said["others"])}
    assert names == {"about", "places", "tiles"} | atlas | sizes
    assert bool(said["mistakes"]) == (not said["leftOut"])


@pytest.mark.parametrize("scene", OWN, ids=lambda scene: scene.id)
def test_a_check_loads_at_most_a_megabyte_and_a_half(scene) -> None:
    """About, places, atlas, and the largest right picture; base64 packs to what it holds."""
    files = {path.stem: path for path in (PUBLISHED / scene.id).iterdir()}
    pictures = [path for name, path in files.items() if name.isdigit()]
    rest = [path for name, path in files.items() if not name.isdigit()]
    loaded = [*rest, max(pictures, key=lambda path: path.stat().st_size)]
    assert sum(len(gzip.compress(path.read_bytes(), 6)) for path in loaded) <= MOST_BYTES


@pytest.mark.parametrize("n", [1, 2, 231])
def test_a_picture_of_any_bytes_comes_back_from_its_packed_rows(n: int) -> None:
    picture = np.random.default_rng(n).integers(0, 256, (n, n, 3), np.uint8)
    assert np.array_equal(rows_of(script("check/any", packed_rows(picture))), picture)


def test_sizes_that_are_parts_of_the_picture_share_its_centres() -> None:
    sizes = shared_sizes(SHADOWS)
    assert sizes == [5, 7, 11, 15, 21, 33, 35, 55, 77, 105, 165, 231, 385, 1155]
    whole = image("02-shadows", "1155").reshape(-1, 3)
    part = right_picture(SHADOWS, 33)
    assert np.array_equal(whole[level_pixels(1155, 33)].reshape(33, 33, 3), part)


@pytest.mark.parametrize("n", [100, 256])
def test_other_sizes_are_what_the_second_tracer_makes(n) -> None:
    """But for a pixel in a thousand, where rounding decides."""
    assert n in USUAL_SIZES
    second = picture(SHADOWS, n).bytes
    assert changed(image("02-shadows", str(n)), second) <= 1e-3


def test_the_atlas_holds_each_wrong_picture_within_half_a_step() -> None:
    """And nothing of what is less than that beside the right one."""
    strips = strips_of("02-shadows")
    rows = {row["name"]: row for row in about("02-shadows")["mistakes"]}
    assert len(strips) == 1 + sum(len(row["wrong"]) for row in rows.values())
    for name in ("shadows-forgotten", "fov-not-halved", "not-clamped"):
        if name not in rows:
            continue
        exact = picture(SHADOWS, GRID, frozenset([name])).bytes
        laid = strips[rows[name]["wrong"][0]] + strips[0]  # modulo 256
        assert np.abs(laid.astype(int) - exact).max() <= STEP // 2
        assert changed(laid, strips[0]) > CHANGED


def test_a_mistake_that_does_not_show_is_not_in_the_atlas() -> None:
    """No glass, no mirror: no mistake of theirs."""
    families = {row["family"] for row in about("02-shadows")["mistakes"]}
    assert not families & {"glass", "mirror"} and "shadow" in families


def test_places_know_objects_light_mirrors_and_edges() -> None:
    """Of two spheres over a black back: the shadow on the green one, edges all round."""
    found = places(SHADOWS)
    met, bits = found[..., 0].astype(int) - 1, found[..., 1]
    names = [obj.name for obj in SHADOWS.objects]
    green = met == names.index("green sphere")
    assert (met == -1).any() and not bits[(met == -1) & (bits & EDGE == 0)].any()
    assert (bits[green] & IN_SHADOW).any() and (bits[green] & LIT).any()
    assert not (bits & MIRROR).any()
    inside = bits & EDGE == 0
    right = np.roll(met, -1, axis=1)[:, :-1]
    assert np.array_equal(met[:, :-1][inside[:, :-1]], right[inside[:, :-1]])
    mirrors = places(read_scene(ROOT / "scenes" / "04-one-bounce"))[..., 1] & MIRROR
    assert mirrors.any() and not mirrors.all()


def test_visitors_and_kiosks_do_not_carry_it() -> None:
    assert '"check/' not in (ROOT / "dist" / "sw.js").read_text("utf-8")


@pytest.mark.parametrize("scene", ["02-shadows", "12-soft-shadows-1"])
def test_tiles_have_the_colours_of_the_pixels_in_their_middle(scene) -> None:
    """Of the finest grid, in the scene's own picture: what a tile's rays add up to."""
    said = about(scene)
    tiles, whole = image(scene, "tiles"), image(scene, str(said["own"][-1]))
    n, step = len(tiles), len(whole) // len(tiles)
    assert n == max(said["grids"]) and step % 2
    assert all((tiles[y, x] == whole[y * step + step // 2, x * step + step // 2]).all()
               for y in range(n) for x in range(n))  # fmt: skip


def test_all_scenes_are_told_of_in_the_courses_order_with_their_mistakes() -> None:
    """Of each mistake that shows, the squares of its pictures: those of the right one where it
    changes nothing there."""
    text = (PUBLISHED / "scenes.js").read_text("ascii").split('"')[3]
    told = json.loads(gzip.decompress(base64.b64decode(text)))
    assert told["scenes"] == [scene.id for scene in OWN]
    for id, wrong in zip(told["scenes"], told["wrong"], strict=True):
        pictures = {each["name"]: len(each["wrong"]) for each in about(id)["mistakes"]}
        assert {name: len(means) for name, means in wrong.items()} == pictures
    swapped = np.array(told["wrong"][told["scenes"].index("02-shadows")]["red-and-blue-swapped"])
    size = told["wrongAlong"]
    right = Image.fromarray(strips_of("02-shadows")[0]).resize((size, size), Image.Resampling.BOX)
    assert np.abs(swapped.reshape(-1, 3)[:, ::-1] - np.asarray(right).reshape(-1, 3)).max() <= STEP
