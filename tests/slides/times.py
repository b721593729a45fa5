"""python tests/slides/times.py SCENE: processor seconds and bytes of each form of its slides.

Works on what `make` left in .work; not a test, as times are the machine's.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

from conftest import Made

from raywalk.pipeline.slide_products import deck_files
from raywalk.scene.read import read_scene
from raywalk.slides.deck import scene_deck
from raywalk.slides.formats import FORMATS
from raywalk.slides.layout import WIDE
from raywalk.work.store import Store


def main(id: str) -> None:
    """All is done twice; the second time is printed: fonts and modules are there by then."""
    sources = Made(read_scene(Path("scenes") / id), Store(Path(".work"))).sources()
    for _ in range(2):
        begun = time.process_time()
        lesson = sources.lesson(WIDE)
        deck = scene_deck(sources, WIDE, lesson=lesson)
        laid_out = time.process_time() - begun
    print(f"{len(deck.slides)} slides laid out, once for all forms: {laid_out:.3f} s")
    for form in FORMATS:
        for _ in range(2):
            begun = time.process_time()
            files = dict(deck_files(deck, (form,), None, lesson))
            seconds = time.process_time() - begun
        print(f"{form}: {seconds:.3f} s, {sum(map(len, files.values())) / 1000:.0f} KB")


if __name__ == "__main__":
    main(sys.argv[1])
