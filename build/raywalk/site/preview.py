"""The picture that shows where a link to a page is shared: 1200 x 630, as all of those want it."""

from __future__ import annotations

from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from raywalk.home import HOME

WIDTH, HEIGHT = 1200, 630  # pixels
FONTS = HOME / "node_modules" / "@expo-google-fonts" / "arimo"
BOLD = FONTS / "700Bold" / "Arimo_700Bold.ttf"
GROUND, WORDS, RAY = (13, 17, 22), (233, 237, 242), (240, 228, 66)
NAME = "preview.jpg"


def write_preview(picture: Path, folder: Path) -> None:
    """folder/preview.jpg: a scene's picture at the right, our name and a ray into it at the left.
    It holds no sentence, so it is the same in all languages."""
    card = Image.new("RGB", (WIDTH, HEIGHT), GROUND)
    traced = Image.open(picture).convert("RGB")
    card.paste(traced.resize((HEIGHT, HEIGHT), Image.Resampling.LANCZOS), (WIDTH - HEIGHT, 0))
    brush = ImageDraw.Draw(card)
    brush.text((64, 190), "Raywalk", WORDS, ImageFont.truetype(str(BOLD), 118), anchor="ls")
    eye, end = (64, 470), (WIDTH - HEIGHT + 190, 330)
    brush.line([eye, end], RAY, 7)
    for at, radius in ((eye, 17), (end, 12)):
        brush.ellipse([at[0] - radius, at[1] - radius, at[0] + radius, at[1] + radius], RAY)
    card.save(folder / NAME, "JPEG", quality=86, optimize=True, progressive=True)
