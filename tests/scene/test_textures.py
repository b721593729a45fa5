"""Textures in scene files: what rays meet of them, and what is wrong with their pictures."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from warnings import catch_warnings

import numpy as np
import pytest
from PIL import Image

from raywalk.errors import SourceErrors
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import BASE_STEPS, Scene, Texture
from raywalk.scene.pictures import PictureFault, decoded, read_texture

# Row 0 on top: a b over c d.
A, B, C, D = [255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]
FOUR = np.array([[A, B], [C, D]], np.uint8)
SCENE = """
[[objects]]
{shape}
material = {{ like = "white", texture = {{ file = "four.png", filter = "nearest"{more} }} }}
"""


@pytest.fixture
def seen(scene_from: Callable[[str], Scene], tmp_path: Path) -> Callable[..., list[list[float]]]:
    """A function: 255 times the base colours that rays meet on a shape with the four pixels."""
    Image.fromarray(FOUR).save(tmp_path / "four.png")

    def look(
        shape: str, *rays: tuple[list[float], list[float]], more: str = ""
    ) -> list[list[float]]:
        compiled = CompiledScene(scene_from(SCENE.format(shape=shape, more=more)))
        origin, direction = (np.array(part, float) for part in zip(*rays, strict=True))
        found = compiled.base_colours(compiled.hits(rays_from(origin, direction)))
        assert found is not None
        return [[float(value) for value in row] for row in 255 * found]

    return look


BALL = 'type = "sphere"\ncenter = [1, 2, 3]\nradius = 2'


def test_a_ball_shows_its_picture_and_its_transform_turns_it(seen: Callable[..., list]) -> None:
    """Seen from +z a b over c d; a quarter turn about y brings its right half to the front: b and
    a of the next picture are left and right of the seam then."""
    front = [([1 + x, 2 + y, 9], [0, 0, -1]) for y in (1, -1) for x in (-1, 1)]
    assert seen(BALL, *front) == [A, B, C, D]
    there, back = "{ translate = [1, 2, 3] }", "{ translate = [-1, -2, -3] }"
    about = f'transform = [{there}, {{ rotate = {{ axis = "y", degrees = %d }} }}, {back}]'
    assert seen(f"{BALL}\n{about % 180}", *front) == [B, A, D, C]
    assert seen(f"{BALL}\n{about % -90}", *front[:2]) == [B, B]
    assert seen(f"{BALL}\n{about % 90}", *front[2:]) == [C, C]


def test_each_face_of_a_box_shows_the_whole_picture(seen: Callable[..., list]) -> None:
    """From +z, and from above with -z on top, whatever its sides measure."""
    box = 'type = "box"\nminimum = [0, 0, 0]\nmaximum = [4, 1, 2]'
    front = [([x, y, 9], [0, 0, -1]) for y in (0.7, 0.3) for x in (1, 3)]
    above = [([x, 9, z], [0, -1, 0]) for z in (0.5, 1.5) for x in (1, 3)]
    left = [([-9, y, z], [1, 0, 0]) for y in (0.7, 0.3) for z in (0.5, 1.5)]
    for rays in (front, above, left):
        assert seen(box, *rays) == [A, B, C, D]


def test_a_plane_has_a_picture_a_unit_from_its_point_on(seen: Callable[..., list]) -> None:
    """A floor is read from +z; a thousand thousand units away it is as sharp."""
    floor = 'type = "plane"\npoint = [0, -1, 0]\nnormal = [0, 3, 0]'
    rays = [([x, 5, z], [0, -1, 0]) for z in (-0.75, -0.25) for x in (0.25, 0.75)]
    assert seen(floor, *rays) == [A, B, C, D]
    far = [([x + 1e6, 5, z - 1e6], [0, -1, 0]) for z in (-0.75, -0.25) for x in (0.25, 0.75)]
    assert seen(floor, *far) == [A, B, C, D]
    wide = [([2 * x, 5, z], [0, -1, 0]) for z in (-0.75, -0.25) for x in (0.25, 0.75)]
    assert seen(floor, *wide, more=", repeat = [0.5, 1]") == [A, B, C, D]


def test_a_disc_a_triangle_and_a_cylinder_show_it(seen: Callable[..., list]) -> None:
    """A disc its square, a triangle the half below the diagonal, a cylinder once round."""
    four = [([x, y, 9], [0, 0, -1]) for y in (0.5, -0.5) for x in (-0.5, 0.5)]
    assert seen('type = "disc"\ncenter = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 2', *four) == [
        A,
        B,
        C,
        D,
    ]
    three = 'type = "triangle"\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]'
    inner = [([x, y, 9], [0, 0, -1]) for x, y in ((0.2, 0.7), (0.7, 0.2), (0.2, 0.2))]
    assert seen(three, *inner) == [A, D, C]
    can = 'type = "cylinder"\nstart = [0, -1, 0]\nend = [0, 1, 0]\nradius = 1'
    assert seen(can, *four) == [A, B, C, D]
    lid = [([x, 9, z], [0, -1, 0]) for z in (-0.5, 0.5) for x in (-0.5, 0.5)]
    assert seen(can, *lid) == [A, B, C, D]
    cone = 'type = "cone"\nstart = [0, -1, 0]\nend = [0, 1, 0]\nradius = 2\nend_radius = 1'
    assert seen(cone, *four) == seen(cone, *lid) == [A, B, C, D]


def test_a_seam_of_longitude_cannot_be_seen(
    scene_from: Callable[[str], Scene], tmp_path: Path, rng: np.random.Generator
) -> None:
    """Bilinear, on both sides of -z, from pole to pole: no step larger than rounding to steps."""
    Image.fromarray(rng.integers(0, 256, (8, 16, 3)).astype(np.uint8)).save(tmp_path / "four.png")
    scene = scene_from(SCENE.format(shape=BALL, more="").replace("nearest", "bilinear"))
    compiled = CompiledScene(scene)
    high = np.linspace(-1.9, 1.9, 40)
    sides = []
    for aside in (-1e-9, 1e-9):
        origin = np.column_stack([np.full(40, 1 + aside), 2 + high, np.full(40, -9.0)])
        hits = compiled.hits(rays_from(origin, np.tile([0, 0, 1.0], (40, 1))))
        sides.append(compiled.base_colours(hits))
    assert sides[0] is not None
    assert sides[1] is not None
    assert np.abs(sides[0] - sides[1]).max() <= 1.01 / BASE_STEPS


def refused(scene_from: Callable[[str], Scene], table: str) -> str:
    with pytest.raises(SourceErrors) as caught:
        scene_from(f"[materials.wood]\ntexture = {table}\n")
    return str(caught.value)


def test_what_is_wrong_with_a_picture_is_said(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """File, key, value, what is allowed and a hint; also of a material that nothing is made of."""
    Image.fromarray(FOUR).save(tmp_path / "wood.png")
    (tmp_path / "words.png").write_text("no picture")
    (tmp_path / "cut.png").write_bytes((tmp_path / "wood.png").read_bytes()[:45])
    Image.new("L", (4097, 1)).save(tmp_path / "wide.png")
    Image.fromarray(FOUR).save(tmp_path.parent / "outside.png")
    message = refused(scene_from, '{ file = "wod.png" }')
    assert (
        'materials.wood.texture.file: the picture "wod.png" is not in the scene\'s folder'
        in message
    )
    assert 'did you mean "wood.png"?  there are cut.png, wide.png, wood.png, words.png' in message
    said = {
        "words.png": "is no picture that is read\n  save it as one of .png, .jpg, .jpeg, .webp",
        "cut.png": "is a damaged picture",
        "wide.png": "has 4097 x 1 pixels; at most 4096 x 4096 are read\n  save it smaller",
        "../outside.png": "lies outside of the scene's folder\n  copy it beside scene.toml",
        "scene.toml": "ends in .toml, and is no picture that is read",
        "x" * 5000 + ".png": "is not in the scene's folder",
        "a\\u0000b.png": "is not in the scene's folder",
    }
    for name, words in said.items():
        assert words in refused(scene_from, f'{{ file = "{name}" }}'), name
    message = refused(scene_from, '{ file = "wood.png", filter = "linear", repeat = [1, 0] }')
    assert 'texture.filter: "linear" is not one of "bilinear", "nearest"' in message
    assert "texture.repeat[1]: 0 is not a number above 0" in message
    assert "texture.file: missing" in refused(scene_from, "{}")
    assert 'did you mean "texture"?' in refused(scene_from, "1\ntextur = { }")


def test_pictures_of_all_kinds_are_colours_as_they_are(tmp_path: Path) -> None:
    """Palettes, greys of 8 and 16 bits, transparent ones, WebP; a photograph's turn is followed."""
    grey = np.array([[0, 51], [102, 255]], np.uint8)
    made: dict[str, Image.Image] = {
        "palette.png": Image.fromarray(FOUR).convert("P", palette=Image.Palette.ADAPTIVE),
        "clear.png": Image.fromarray(np.dstack([FOUR, np.array([[0, 9], [99, 255]], np.uint8)])),
        "lossless.webp": Image.fromarray(FOUR),
    }
    for name, picture in made.items():
        picture.save(tmp_path / name, **({"lossless": True} if name.endswith("webp") else {}))
        assert read_texture(Texture(tmp_path / name)).tolist() == FOUR.tolist(), name
    for name, picture in (
        ("8.png", Image.fromarray(grey)), ("16.png", Image.fromarray(grey.astype(np.uint16) * 257)),
    ):  # fmt: skip
        picture.save(tmp_path / name)
        assert (read_texture(Texture(tmp_path / name)) == grey[:, :, None]).all(), name
    turned = Image.Exif()
    turned[0x0112] = 3  # upside down
    Image.fromarray(np.kron(FOUR, np.ones((8, 8, 1), np.uint8))).save(
        tmp_path / "photo.jpg", exif=turned, quality=100
    )
    photo = read_texture(Texture(tmp_path / "photo.jpg"))
    assert np.abs(photo[4, 4].astype(int) - D).max() < 40


def test_a_texture_is_inherited_and_replaced_as_a_whole(
    scene_from: Callable[[str], Scene], tmp_path: Path
) -> None:
    """`like` passes it on; an object of another material has none."""
    for name in ("a.png", "b.png"):
        Image.fromarray(FOUR).save(tmp_path / name)
    scene = scene_from("""
[materials.wood]
like = "coloured"
texture = { file = "a.png", filter = "nearest", repeat = [2, 3] }
[[objects]]
type = "sphere"
center = [0, 0, 0]
radius = 1
material = { like = "wood", diffuse = [0.5, 0.5, 0.5] }
[[objects]]
type = "sphere"
center = [3, 0, 0]
radius = 1
material = { like = "wood", texture = { file = "b.png" } }
[[objects]]
type = "sphere"
center = [6, 0, 0]
radius = 1
material = "white"
""")
    textures = [obj.base and obj.base.texture for obj in scene.objects]
    assert textures == [
        Texture(tmp_path / "a.png", "nearest", (2, 3)), Texture(tmp_path / "b.png"), None
    ]  # fmt: skip
    assert scene.materials[0].diffuse == (0.5, 0.5, 0.5)


def test_a_damaged_picture_is_a_sentence_or_still_a_picture(rng: np.random.Generator) -> None:
    """500 files cut short, or with bytes changed, put in or left out: never another error, nor a
    warning of a library's."""
    whole = []
    for format in ("PNG", "JPEG", "WEBP"):
        out = BytesIO()
        Image.fromarray(rng.integers(0, 256, (24, 31, 3)).astype(np.uint8)).save(out, format)
        whole.append(out.getvalue())
    said = 0
    with catch_warnings(action="error"):
        for k in range(500):
            data = bytearray(whole[k % 3])
            for _ in range(rng.integers(1, 6)):
                at = int(rng.integers(len(data)))
                some = rng.integers(0, 256, rng.integers(0, 5)).astype(np.uint8).tobytes()
                data[at : at + int(rng.integers(0, 5))] = some
                data = data[:at] if rng.random() < 0.1 else data
                data = data or bytearray(b"\0")
            try:
                found = decoded(bytes(data))
                assert (found.ndim, found.shape[2], found.dtype) == (3, 3, np.uint8)
            except PictureFault as fault:
                said += bool(fault.cause and fault.remedy)
    assert said > 200
