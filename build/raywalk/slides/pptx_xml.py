"""DrawingML as text: places, fills, namespaces. Lengths are points, written as EMU."""

from __future__ import annotations

from raywalk.slides.layout import Box

EMU = 12700  # in a point
NAMESPACES = (
    'xmlns:a="http://schemas.openxmlformats.org/drawingml/2006/main" '
    'xmlns:p="http://schemas.openxmlformats.org/presentationml/2006/main" '
    'xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"'
)


def place(box: Box, flips: str = "", tag: str = "a:xfrm", children: bool = False) -> str:
    off = f'x="{emu(box.left)}" y="{emu(box.top)}"'
    size = f'cx="{emu(box.width)}" cy="{emu(box.height)}"'
    inner = f"<a:chOff {off}/><a:chExt {size}/>" if children else ""
    return f"<{tag}{flips}><a:off {off}/><a:ext {size}/>{inner}</{tag}>"


def preset(shape: str) -> str:
    return f'<a:prstGeom prst="{shape}"><a:avLst/></a:prstGeom>'


def solid(hex_colour: str, opacity: float = 1.0) -> str:
    clear = f'<a:alpha val="{round(100_000 * opacity)}"/>' if opacity < 1 else ""
    return f'<a:solidFill><a:srgbClr val="{hex_colour}">{clear}</a:srgbClr></a:solidFill>'


def emu(points: float) -> int:
    return round(points * EMU)
