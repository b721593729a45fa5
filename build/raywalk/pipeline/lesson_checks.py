"""What an author should know of a lesson's words, though nothing is wrong: asked by `check`."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator
from pathlib import Path

from raywalk.errors import shown_path
from raywalk.pipeline.agreeing_figures import disagreements
from raywalk.pipeline.figures import (
    FILE,
    asked_elsewhere,
    scenes_beside,
    wanted_pixels,
    with_others,
)
from raywalk.pipeline.filling import Figures, filled
from raywalk.pipeline.shown_names import unseen
from raywalk.pipeline.typed_figures import typed_figures
from raywalk.scene.measures import Facts
from raywalk.scene.model import Scene
from raywalk.scene.slots import Pixel, own_pixel
from raywalk.scene.translation import Spoken, translation_file
from raywalk.scene.wording import key_path, quoted
from raywalk.trace.lesson_figures import write_figures
from raywalk.trace.wavefront import Tracer
from raywalk.words import read_words
from raywalk.words.catalogue import DEFAULT

NAMING = ("headline", "text", "answer")  # choices name what is not there, too


def lesson_warnings(tracer: Tracer, spoken: dict[str, Spoken]) -> list[str]:
    """A line for each: file, step, what is odd about its words. spoken: the scene by language.

    Raises SourceErrors for slots that ask for what there is not.
    """
    own = spoken[DEFAULT].scene
    figures = figures_now(own, [each.scene for each in spoken.values()])
    filled({code: [each] for code, each in spoken.items()}, [figures])  # refuses slots
    return [
        line
        for code, each in spoken.items()
        if code == DEFAULT or each.is_translated
        for line in _warnings(tracer, own, each.scene, code, figures)
    ]


def _warnings(
    tracer: Tracer, own: Scene, scene: Scene, code: str, figures: Figures
) -> Iterator[str]:
    words = read_words(code)
    file = shown_path(own.path if code == DEFAULT else translation_file(own, code))
    for i, step in enumerate(scene.lesson):
        views = own.lesson[i].said()
        for key, (text, _) in step.said().items():
            view, pixel = views[key][1], own_pixel(views[key][1])
            is_alternative = key[0] == "choices" and key[-1] == "text"  # mostly a wrong one
            at = f"{file}: {key_path(('lesson', i, *key))}: warning: "
            given = [shown for _, shown in own.lesson[i].stops()]
            figures_typed = [] if is_alternative else typed_figures(text, given, scene, words)
            for figure in figures_typed:
                hint = "a slot, {t} say, stays right when the scene changes"
                yield f"{at}the figure {quoted(figure)} is typed: {hint}"
            here, known = figures.at(view, own)
            for said in disagreements(text, here, known, pixel, words.numbers):
                yield at + said
            if key[0] in NAMING:
                yield from (at + said for said in unseen(text, view, scene, tracer, code))


def figures_now(own: Scene, scenes: list[Scene]) -> Figures:
    """For the slots of a scene's languages, traced on the spot; what needs the whole picture stays
    open."""
    wanted = wanted_pixels(scenes)
    if wanted is None:
        return Figures({}, Facts({}, None))
    elsewhere = asked_elsewhere(scenes, scenes_beside(scenes))
    found = {name: (there, _traced(there, pixels)) for name, (there, pixels) in elsewhere.items()}
    return with_others(_traced(own, wanted[0]), found)


def _traced(scene: Scene, pixels: list[Pixel]) -> Figures:
    with tempfile.TemporaryDirectory() as folder:
        write_figures(scene, pixels, Path(folder))
        found = json.loads((Path(folder) / FILE).read_text(encoding="utf-8"))
    trees = {(n, column, row): ray for (n, column, row), ray in found["pixels"]}
    return Figures(trees, Facts(found["meshes"], None))
