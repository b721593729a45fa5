"""What a worksheet asks, and what the tracer answers in all digits: of pixels whose answers anyone
finds who works them out by hand from the printed numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import gcd
from typing import Any

import numpy as np

from raywalk.trace.sheet_paths import solid_boxes
from raywalk.trace.sheet_sights import Sight, sights_of
from raywalk.trace.tree import Kind, Visibility
from raywalk.trace.wavefront import Tracer

NEAREST = 3  # questions of what is met first, each by another object
MOST_HITS = 6  # of a question that asks for all of them
MOST_PIXELS = 500  # that are looked at: of a fine grid those that are spread first
CHECKS = 10  # pixels of an assignment
GOLDEN = 0.381966  # of the pixels: a step that spreads them
# A colour is printed with three decimals, so 255 times it is off by up to 0.13 when it is rounded.
HALF_STEP = 0.14

Fact = dict[str, Any]


def sheet_facts(tracer: Tracer, n: int, walked: list[int]) -> Fact:
    """{"n", "boxes": (2, 3) of each object by its number whose shape a sheet cannot print, "asked":
    a fact each, "checks": what an assignment's programs are checked against}. Numbers are float64.
    walked: pixels (row * n + column) that are asked about first; n = 0: nothing is asked."""
    boxes = solid_boxes(tracer)
    if not n:
        return {"n": 0, "boxes": {}, "asked": [], "checks": []}
    seen = sights_of(tracer, spread(n, walked)[:MOST_PIXELS], n, list(boxes.values()))
    seen = [sight for sight in seen if sight.is_sure]
    return {
        "n": n,
        "boxes": {str(k): box.tolist() for k, box in boxes.items()},
        "asked": list(_asked(tracer, seen, n)),
        "checks": [
            _fact("check", sight, n, **sight.meeting, colour=sight.colour.tolist(),
                  bytes=_eight_bit(sight.colour))
            for sight in _varied(seen)
        ],
    }  # fmt: skip


def spread(n: int, walked: list[int]) -> list[int]:
    """All pixels, those that the lesson walks first, then spread over the picture."""
    count = n * n
    step = int(count * GOLDEN)
    while gcd(step, count) != 1:
        step += 1  # so it visits every pixel
    return list(dict.fromkeys([*walked, *(k * step % count for k in range(count))]))


def _asked(tracer: Tracer, seen: list[Sight], n: int) -> Iterator[Fact]:
    """seen: well conditioned, in the order of choice."""
    met: set[int] = set()
    for sight in seen:
        if len(met) < NEAREST and sight.object not in met and sight.is_clear_to_hit:
            met.add(sight.object)
            yield _fact("nearest", sight, n, **sight.meeting)
    hits = [s for s in seen if len({k for k, _ in s.listed}) > 1 and len(s.listed) <= MOST_HITS]
    for sight in [s for s in hits if s.is_clear_along][:1]:
        yield _fact("order", sight, n, hits=[list(hit) for hit in sight.listed])
    yield from _of_light(tracer, [s for s in seen if s.object >= 0 and s.is_clear_to_hit], n)
    yield from _sent(tracer, [s for s in seen if s.object >= 0 and s.is_clear_to_hit], n)
    for sight in [s for s in seen if _has_sure_bytes(s.colour)][:1]:
        colour = sight.colour
        yield _fact("bytes", sight, n, colour=colour.tolist(), bytes=_eight_bit(colour))


def _varied(seen: list[Sight]) -> list[Sight]:
    """CHECKS of them: one of each object first, then as they come; in the order of reading."""
    firsts = {sight.object: sight for sight in reversed(seen)}.values()
    rest = [sight for sight in seen if sight not in firsts]
    return sorted([*firsts, *rest][:CHECKS], key=lambda sight: sight.pixel)


def _eight_bit(colour: np.ndarray) -> list[int]:
    eight: list[int] = np.rint(255 * np.clip(colour, 0, 1)).astype(int).tolist()
    return eight


def _of_light(tracer: Tracer, seen: list[Sight], n: int) -> Iterator[Fact]:
    """Whether a light arrives, once each; and how squarely a surface faces one."""
    used = set()
    for wanted in (Visibility.BLOCKED, Visibility.REACHED):
        found = _light_where(seen, partial(_is_light, wanted))
        if found:
            sight, light = found
            used.add((sight.pixel, light))
            blocker = sight.blocker[light] if wanted == Visibility.BLOCKED else None
            yield _fact("shadow", sight, n, object=sight.object, light=light, blocker=blocker)
    found = _light_where(
        seen, lambda s, k: s.cosine[k] > 0 and s.is_matt and (s.pixel, k) not in used
    )
    if found:
        sight, light = found
        yield _fact("lambert", sight, n, object=sight.object, light=light,
                    cosine=sight.cosine[light])  # fmt: skip


def _is_light(wanted: Visibility, sight: Sight, light: int) -> bool:
    return sight.visibility[light] == wanted and sight.is_clear_to(light)


def _light_where(seen: list[Sight], test: Callable[[Sight, int], bool]) -> tuple[Sight, int] | None:
    pairs = ((sight, k) for sight in seen for k in range(len(sight.cosine)))
    return next(((sight, k) for sight, k in pairs if test(sight, k)), None)


def _sent(tracer: Tracer, seen: list[Sight], n: int) -> Iterator[Fact]:
    """What a reflected and a refracted ray meet; of glass only from outside everything."""
    kinds = [Kind.REFLECTED] if tracer.eye_media else [Kind.REFLECTED, Kind.REFRACTED]
    for kind in kinds:
        for sight in seen:
            ray = sight.sent.get(int(kind))
            if ray and ray.object >= 0 and ray.is_clear:
                yield _fact(kind.name.lower(), sight, n, object=sight.object, met=ray.object,
                            t=ray.t, point=ray.point.tolist())  # fmt: skip
                break


def _has_sure_bytes(colour: np.ndarray) -> bool:
    """Three numbers that are not all alike, and none near the border between two bytes."""
    off = 255 * np.clip(colour, 0, 1) % 1
    is_sure = bool((np.abs(off - 0.5) > HALF_STEP).all())
    return is_sure and len({round(float(part), 2) for part in colour}) > 1


def _fact(of: str, sight: Sight, n: int, **more: Any) -> Fact:
    return {"of": of, "pixel": [sight.pixel % n, sight.pixel // n], **more}
