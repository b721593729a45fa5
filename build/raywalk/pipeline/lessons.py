"""All lessons in all languages as slides and sheets have them, by way of the store, without drawing
any."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import replace
from pathlib import Path

from raywalk.commands.slides import traced
from raywalk.pipeline.figures import filled_lessons
from raywalk.pipeline.site import in_all_languages
from raywalk.pipeline.slides import Source, plans_of, sources_of
from raywalk.scene.read import read_scenes
from raywalk.slides.deck import Sources
from raywalk.stops.process import Stops
from raywalk.work.pool import Workers
from raywalk.work.progress import Message
from raywalk.work.store import Store


def all_lessons(
    folder: Path, store: Store
) -> Generator[str | Message, None, dict[str, list[Sources]]]:
    """Of a folder of scenes, by language, in the course's order; a lesson that is not translated
    is in its own language only. Tells what has to be traced. Raises SourceErrors."""
    spoken = in_all_languages(read_scenes(folder))
    with Workers() as workers:
        spoken = yield from filled_lessons(store, spoken, workers)
    of_scenes: dict[str, Source] = {}
    sources = []
    for code, lessons in spoken.items():
        for each in lessons:
            if not each.is_translated or not each.scene.lesson:
                continue
            if each.scene.id not in of_scenes:
                of_scenes[each.scene.id] = yield from traced(store, each.scene)
            own = of_scenes[each.scene.id]
            sources.append(replace(own, scene=each.scene, language=code))
    with Stops() as stops:
        plans = yield from plans_of(store, stops, sources)
    by_language: dict[str, list[Sources]] = {code: [] for code in spoken}
    place = {(each.scene.id, each.language): each for each in plans}
    for source in sources:
        by_language[source.language].append(sources_of(place[source.scene.id, source.language]))
    return by_language
