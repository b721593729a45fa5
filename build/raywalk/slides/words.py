"""Words on slides that are not the lesson's own, from the catalogue of sentences."""

from __future__ import annotations

from typing import TYPE_CHECKING

from raywalk.words import read_words

if TYPE_CHECKING:
    from raywalk.scene.model import Scene
    from raywalk.slides.sights import Seen

WORDS = read_words()
say = WORDS.say
vector = WORDS.numbers.vector
fixed = WORDS.numbers.fixed
number = WORDS.numbers.number
tone = WORDS.numbers.tone


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


def place(seen: Seen) -> dict[str, int]:
    """The slots of a sentence that names the selected pixel."""
    return {"x": seen.view.pixel[0], "y": seen.view.pixel[1], "n": seen.view.n}


def columns() -> list[str]:
    """Headings of the table of rays; x, y, z and t are symbols."""
    return [say("slides.columnRay"), say("slides.columnHits"), "x", "y", "z", "t", ""]


def sum_columns() -> list[str]:
    return [
        say("slides.columnRay"), say("slides.columnKind"), say("slides.columnAt"),
        say("slides.columnShare"), say("slides.columnOwn"), say("slides.columnGives"), "",
    ]  # fmt: skip


MOST_TOLD = 12  # rays in a description: more nobody listens to


def figure_alt(scene: Scene, seen: Seen) -> str:
    """A figure in a few sentences, for those who do not see it."""
    told = [say("slides.figureAlt", title=scene.title, n=seen.view.n)]
    for line in seen.chosen[:MOST_TOLD]:
        kind = kind_word(line.kind)
        if line.light >= 0:
            told.append(say("slides.shadowAlt", light=scene.lights[line.light].name, kind=kind))
        elif line.leaves:
            told.append(say("slides.leavesAlt", kind=kind))
        else:
            name = scene.objects[int(seen.trace.object[line.ray])].name
            told.append(say("slides.hitsAlt", kind=kind, name=name, point=vector(line.ends[1])))
    if len(seen.chosen) > MOST_TOLD:
        told.append(say("slides.moreAlt", count=len(seen.chosen) - MOST_TOLD))
    if seen.thin:
        told.append(say("slides.thinAlt", count=len(seen.thin)))
    return " ".join(told)
