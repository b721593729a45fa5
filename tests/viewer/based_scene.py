"""python tests/viewer/based_scene.py FOLDER: a scene with base colours built into it, as JSON.

A textured ball and floor and a mesh with a colour at each corner before a mirror and glass: where
its files are, and its tiles traced anew for what-if switches (see fresh_traces.py).
"""

from __future__ import annotations

import base64
import json
import sys
from pathlib import Path

import numpy as np
from fresh_traces import all_switches, tiles
from PIL import Image

from raywalk.pipeline.trace_products import write_products
from raywalk.scene.read import read_scene
from raywalk.site.scene_data import write_page_data
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.tree import level_pixels
from raywalk.trace.wavefront import Tracer

N = 21
SCENE = """version = 1
title = "Base colours"
teaches = "What the viewer makes of them."
[camera]
eye = [0, 1, 6]
target = [0, 0, 0]
[render]
size = 63
resolutions = [21]
[[objects]]
name = "ball"
type = "sphere"
center = [-1, 0, 0]
radius = 1
material = { like = "coloured", reflect = 0.2, texture = { file = "noise.png", repeat = [3, 2] } }
[[objects]]
name = "floor"
type = "plane"
point = [0, -1, 0]
normal = [0, 1, 0]
material = { like = "white", texture = { file = "noise.png", filter = "nearest" } }
[[objects]]
name = "tetra"
type = "mesh"
file = "tetra.off"
transform = [{ translate = [1, 0, 0] }]
[[objects]]
name = "pane"
type = "box"
minimum = [0.2, -1, 1.5]
maximum = [1.2, 1, 1.7]
material = { like = "glass", transmit = 0.7, reflect = 0.1, fresnel = false }
[[objects]]
name = "plain"
type = "sphere"
center = [0.3, -0.6, 1]
radius = 0.3
material = { like = "coloured", diffuse = [0.2, 0.4, 0.9] }
[[lights]]
name = "high"
position = [3, 5, 4]
intensity = 0.8
[[lights]]
name = "warm"
position = [-4, 2, 5]
colour = [0.5, 0.3, 0.2]
"""
TETRA = """COFF
4 4 0
1 1 1 255 0 0
-1 -1 1 0 255 0
-1 1 -1 0 0 255
1 -1 -1 255 255 255
3 0 1 3
3 0 2 1
3 0 3 2
3 1 2 3
"""


def main() -> None:
    folder = Path(sys.argv[1])
    noise = np.random.default_rng(7).integers(0, 256, (5, 9, 3)).astype(np.uint8)
    Image.fromarray(noise).save(folder / "noise.png")
    (folder / "tetra.off").write_text(TETRA)
    (folder / "scene.toml").write_text(SCENE)
    scene = read_scene(folder)
    write_products(scene, folder, 1)
    write_page_data(scene, folder, folder)
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    pixels = level_pixels(scene.render.size, N)
    fresh = [
        {
            "switches": switches,
            "tiles": base64.b64encode(tiles(tracer, scene, switches, pixels).tobytes()).decode(),
        }
        for switches in all_switches(scene)
    ]
    print(json.dumps({"scene": scene.id, "n": N, "fresh": fresh}))


if __name__ == "__main__":
    main()
