"""python tests/slides/times.py SCENE: processor seconds and bytes of each form of its slides.

Works on what `make` left in .work; not a test, as times are the machine's.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

from raywalk.scene import read_scene
from raywalk.slide_pipeline import plan
from raywalk.slide_products import FORMATS, deck_files
from raywalk.slides.deck import Sources, scene_deck
from raywalk.slides.layout import WIDE
from raywalk.work.digests import key_of
from raywalk.work.keys import trace_parts
from raywalk.work.store import Store


def main(id: str) -> None:
    """All is done twice; the second time is told: fonts and modules are there by then."""
    scene, store = read_scene(Path("scenes") / id), Store(Path(".work"))
    key = key_of(trace_parts(scene))
    traced = store.get(key).folder
    sights = store.get(key_of(plan(scene, traced, key).sights)).folder
    for _ in range(2):
        begun = time.process_time()
        sources = Sources(scene, traced, sights)
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
