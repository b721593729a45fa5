"""The events told: one sentence each, and under it its numbers, as viewer/event-words.ts does."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from raywalk.telling.events import LightShare, RayEvent, Term
from raywalk.telling.scene import Vector
from raywalk.telling.why import Reason, Why
from raywalk.words import Phrase, Words, plain

Facts = Mapping[str, Any]


@dataclass(frozen=True)
class Told:
    """A sentence in pieces (text, None plain, "" bold or a ray kind) and a line of numbers, ""
    if it has none."""

    says: tuple[Phrase, ...]
    numbers: str

    @property
    def sentence(self) -> str:
        """Without marks."""
        return plain(list(self.says))


def tell(event: RayEvent, words: Words) -> Told:
    """One event in a language."""
    says, numbers = TELLERS[event.what](event, event.facts, words)
    return Told(tuple(says), numbers)


Teller = Callable[[RayEvent, Facts, Words], tuple[list[Phrase], str]]


def _camera(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    x, y = facts["pixel"]
    says = words.phrases("event.camera.says", x=x, y=y)
    return says, words.say("event.camera.numbers", eye=words.numbers.vector(facts["eye"]))


def _meets(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    name, hits, number = facts["name"], facts["hits"], words.numbers.number
    point = words.numbers.vector(facts["point"])
    if len(hits) < 2:
        says = words.phrases("event.meets.says", name=name)
        return says, words.say("event.meets.numbers", t=number(facts["t"]), point=point)
    met = [words.say("event.meetsFirst.hit", name=h["name"], t=number(h["t"])) for h in hits]
    return words.phrases("event.meetsFirst.says", name=name), words.say(
        "event.meetsFirst.numbers", hits=words.numbers.listed(met), point=point
    )


def _background(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    return words.phrases("event.background.says"), words.numbers.tone(facts["colour"])


def _reached(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    says = words.phrases("event.reached.says", light=facts["name"])
    return says, words.say("event.reached.numbers", long=words.numbers.number(event.long))


def _blocked(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    says = words.phrases("event.blocked.says", light=facts["name"], name=facts["by"])
    return says, words.say("event.blocked.numbers", at=words.numbers.number(facts["at"]))


def _not_asked(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    return words.phrases(f"event.{event.what}.says", light=facts["name"]), ""


def _local(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    tone = words.numbers.tone
    parts = [words.say("event.local.ambient", colour=tone(facts["ambient"]))]
    parts += [_light(light, facts, words) for light in facts["lights"]]
    keeps = ""
    if facts["share"] < 1:
        keeps = words.say("event.local.keeps", share=words.numbers.percent(facts["share"]))
    total = f"{' + '.join(parts)} = {tone(facts['colour'])}"
    return words.phrases("event.local.says"), _beside(total, keeps)


def _light(light: LightShare, facts: Facts, words: Words) -> str:
    if light.seen == "blocked":
        return words.say("event.local.inShadow", light=light.name)
    if light.seen == "off":
        return words.say("event.local.isOff", light=light.name)
    if light.seen == "away":
        return words.say("event.local.facesAway", light=light.name)
    number, tone = words.numbers.number, words.numbers.tone
    parts = [
        words.say(f"event.local.{what}", factor=number(factor), colour=tone(paint))
        for what, factor, paint in (
            ("diffuse", light.diffuse, facts["diffuse"]),
            ("specular", light.specular, facts["specular"]),
        )
        if any(paint) and number(factor) != number(0)
    ]
    total, is_white = " + ".join(parts), _is_white(light.colour)
    if total == "" or is_white:
        return words.say("event.local.gives", light=light.name, sum=total or "0")
    total = f"({total})" if len(parts) > 1 else total
    return words.say(
        "event.local.givesColoured", light=light.name, sum=total, colour=tone(light.colour)
    )


def _reflected(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    how = "clear" if facts["clear"] else "coloured" if facts["keeps"] > 0 else "mirror"
    says = words.phrases(f"event.reflected.{how}", name=facts["name"])
    return says, _beside(_share(facts, words), _angle(facts, words))


def _refracted(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    straight = "Straight" if facts["from"] == facts["to"] else ""
    how = f"{'in' if facts['enters'] else 'out'}{straight}"
    bends = ""
    if facts["angle"] is not None and facts["bent"] is not None:
        angle, bent = (words.numbers.fixed(facts[name], 1) for name in ("angle", "bent"))
        bends = words.say("event.departure.bends", angle=angle, bent=bent)
    says = words.phrases(f"event.refracted.{how}", name=facts["name"])
    return says, _beside(_index(facts, words), bends, _share(facts, words))


def _total(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    numbers = _beside(_index(facts, words), _angle(facts, words), _share(facts, words))
    return words.phrases("event.total.says", name=facts["name"]), numbers


def _stops(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    why = "atLimit" if facts["atLimit"] else "tooLittle"
    limit = words.say("event.stops.limit", count=facts["limit"]) if facts["atLimit"] else ""
    return words.phrases(f"event.stops.{why}", name=facts["name"]), limit


def _gather(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    return words.phrases("event.gather.says", name=facts["name"]), _sum(facts, words)


def _pixel(event: RayEvent, facts: Facts, words: Words) -> tuple[list[Phrase], str]:
    x, y = facts["pixel"]
    tile = ", ".join(map(str, facts["bytes"]))
    of_255 = ", ".join(str(_eight_bit(value)) for value in facts["colour"])
    says = words.phrases("event.pixel.says", x=x, y=y, bytes=tile)
    if facts["why"]:
        says = [*says, (" ", None), *_why(facts["why"], words)]
    in_bytes = f"× 255, {words.say('sum.clamped')}: {of_255}"
    return says, _beside(_sum(facts, words), in_bytes)


def _why(why: Why, words: Words) -> list[Phrase]:
    """In one sentence why a pixel is dark, or partly so."""
    ray, share, name = why.ray, words.numbers.percent(why.share), why.name
    parts = [_reason(each, name, words) for each in why.reasons]
    if why.end == "stops" or (why.end == "local" and ray > 1):
        parts = [words.phrases("why.via", ray=ray, share=share, name=name), *parts]
    if why.end == "background":
        parts = [words.phrases("why.background", ray=ray, share=share)]
    if why.end == "stops":
        parts += [words.phrases("why.stops")]
    says = words.phrases("why.dark" if why.dark else "why.shadow")
    for number, part in enumerate(parts):
        says += [("; ", None), *part] if number else part
    return [*says, (".", None)]


def _reason(reason: Reason, name: str, words: Words) -> list[Phrase]:
    slots = {"lights": words.numbers.listed(reason.lights), "by": reason.by, "name": name}
    named = {"blocked": ("lights", "by"), "away": ("lights", "name"), "paint": ("name",)}
    wanted = named.get(reason.how, ("lights",))
    return words.phrases(f"why.{reason.how}", **{slot: slots[slot] for slot in wanted})


TELLERS: dict[str, Teller] = {
    "camera": _camera, "meets": _meets, "background": _background, "reached": _reached,
    "blocked": _blocked, "away": _not_asked, "unasked": _not_asked, "off": _not_asked,
    "local": _local,
    "reflected": _reflected, "refracted": _refracted, "total": _total, "stops": _stops,
    "gather": _gather, "pixel": _pixel,
}  # fmt: skip


def _sum(facts: Facts, words: Words) -> str:
    terms = [_term(term, words) for term in facts["terms"]]
    written = " + ".join(terms) or words.say("event.term.nothing")
    return f"{written} = {words.numbers.tone(facts['colour'])}"


def _term(term: Term, words: Words) -> str:
    of, colour = words.say(f"event.term.{term.of}"), words.numbers.tone(term.colour)
    if term.share == 1:
        return words.say("event.term.whole", of=of, colour=colour)
    share = words.numbers.percent(term.share)
    return words.say("event.term.part", of=of, share=share, colour=colour)


def _share(facts: Facts, words: Words) -> str:
    return words.say("event.departure.share", share=words.numbers.percent(facts["share"]))


def _angle(facts: Facts, words: Words) -> str:
    if facts["angle"] is None:
        return ""
    return words.say("event.departure.angle", angle=words.numbers.fixed(facts["angle"], 1))


def _index(facts: Facts, words: Words) -> str:
    fixed = words.numbers.fixed
    before, after = fixed(facts["from"], 2), fixed(facts["to"], 2)
    return words.say("event.departure.index", **{"from": before, "to": after})


def _beside(*parts: str) -> str:
    """Numbers that stand beside one another."""
    return " · ".join(part for part in parts if part)


def _is_white(colour: Vector) -> bool:
    return all(value == 1 for value in colour)


def _eight_bit(value: float) -> int:
    return int(255 * min(1.0, max(0.0, value)) + 0.5)
