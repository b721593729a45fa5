"""Words on slides that are not the lesson's own, from the catalogue of sentences.

Slides are written in one language at a time: `with speaking("de"):` says in which.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING

from raywalk.words import Words, read_words
from raywalk.words.numbers import Numbers

if TYPE_CHECKING:
    from raywalk.scene.model import Scene
    from raywalk.slides.stops import Stop, Switches

_SPOKEN: ContextVar[Words | None] = ContextVar("spoken", default=None)


@contextmanager
def speaking(code: str) -> Iterator[None]:
    """Within it all slides are written in the language of this code."""
    token = _SPOKEN.set(read_words(code))
    try:
        yield
    finally:
        _SPOKEN.reset(token)


def words() -> Words:
    """The language that is spoken now; the default one if none was chosen."""
    return _SPOKEN.get() or read_words()


def say(key: str, /, **slots: object) -> str:
    return words().say(key, **slots)


def numbers() -> Numbers:
    """How the language writes them."""
    return words().numbers


def kind_word(kind: str) -> str:
    """A kind of ray as the viewer's legend has it."""
    return say(f"line.{kind}")


def ray_name(count: int | None, kind: str) -> str:
    """ "Ray 2, reflected"; without a number for rays of other pixels."""
    if count is None:
        return kind_word(kind)
    return say("slides.ray", count=count, kind=kind_word(kind))


def chosen_tile(pixel: tuple[int, int]) -> str:
    return say("slides.chosen", x=pixel[0], y=pixel[1])


def place(stop: Stop) -> dict[str, int]:
    """The slots of a sentence that names the selected pixel."""
    return {"x": stop.pixel[0], "y": stop.pixel[1], "n": stop.n}


def switched(switches: Switches) -> list[str]:
    """What a step's switches alter, a piece each; [] where all is as traced."""
    parts = []
    if switches.bounces is not None:
        parts.append(say("slides.mostBounces", count=switches.bounces))
    for name, factor in switches.lamps:
        if factor == 0:
            parts.append(say("slides.lampOff", light=name))
        else:
            parts.append(say("slides.lampDimmed", light=name, factor=numbers().number(factor)))
    if not switches.shadows:
        parts.append(say("slides.noShadows"))
    parts += [say(f"slides.without.{part}") for part in switches.without]
    return parts


def altered(stop: Stop) -> list[str]:
    """What is not as the scene is by itself: switches, and the stop of a sweep."""
    return [*switched(stop.switches), *([stop.moved] if stop.moved else [])]


def columns() -> list[str]:
    """Headings of the table of rays; x, y, z and t are symbols."""
    return [say("slides.columnRay"), say("slides.columnHits"), "x", "y", "z", "t", ""]


def sum_columns() -> list[str]:
    return [
        say("slides.columnRay"), say("slides.columnKind"), say("slides.columnAt"),
        say("slides.columnShare"), say("slides.columnOwn"), say("slides.columnGives"), "",
    ]  # fmt: skip


MOST_TOLD = 12  # rays in a description: more nobody listens to


def figure_alt(scene: Scene, stop: Stop) -> str:
    """A figure in a few sentences, for those who do not see it."""
    parts = [say("slides.figureAlt", title=scene.title, n=stop.n)]
    for line in stop.chosen[:MOST_TOLD]:
        kind = kind_word(line.kind)
        if line.light >= 0:
            light = words().the(stop.figure.lamps[line.light].name)
            parts.append(say(f"slides.shadowAlt.{line.kind}", light=light))
        elif line.leaves:
            parts.append(say("slides.leavesAlt", kind=kind))
        else:
            met, point = stop.rows[line.ray - 1].object, numbers().vector(line.to)
            parts.append(say("slides.hitsAlt", kind=kind, name=words().the(met), point=point))
    if len(stop.chosen) > MOST_TOLD:
        parts.append(say("slides.moreAlt", count=len(stop.chosen) - MOST_TOLD))
    if stop.thin:
        parts.append(say("slides.thinAlt", count=len(stop.thin)))
    return " ".join(parts)
