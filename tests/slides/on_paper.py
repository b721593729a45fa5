"""A student with a sheet of paper: reads what a worksheet prints, of what it asks works out the
answer from nothing else. Knows no scene file, no trace and no tracer."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from math import inf, radians, sqrt, tan
from typing import Any

import numpy as np

from raywalk.words.catalogue import Words, find

NUMBER = re.compile(r"[−-]?\d+(?:[.,]\d+)?")
CANONICAL = {"sphere": "ball", "ellipsoid": "ball", "movedSphere": "ball", "box": "cube",
             "movedBox": "cube", "cylinder": "drum", "movedCylinder": "drum"}  # fmt: skip


def numbers(text: str) -> list[float]:
    """All that stand in a text, in English or German."""
    return [float(found.replace("−", "-").replace(",", ".")) for found in NUMBER.findall(text)]


def pattern(words: Words, key: str) -> re.Pattern[str]:
    """What a sentence of the catalogue looks like, its slots as groups."""
    text = find(words.tree, key)
    made, seen = "", set()
    for k, part in enumerate(re.split(r"\{(\w+)\}", str(text))):
        if k % 2 == 0:
            made += re.escape(part)
        else:
            made += f"(?P={part})" if part in seen else f"(?P<{part}>.+)"
            seen.add(part)
    return re.compile(made)


@dataclass(eq=False)
class Thing:
    """An object as the sheet tells it: p = c + A x, x in a ball, cube or drum; or flat."""

    name: str
    kind: str
    linear: np.ndarray = field(default_factory=lambda: np.eye(3))
    centre: np.ndarray = field(default_factory=lambda: np.zeros(3))
    radius: float = inf  # of what is flat
    ior: float | None = None
    box: np.ndarray | None = None

    def meets(self, o: np.ndarray, d: np.ndarray) -> list[float]:
        """Each t at which its surface is met, smallest first."""
        if self.kind == "flat":
            if not d @ self.linear[1]:
                return []
            t = float((self.centre - o) @ self.linear[1] / (d @ self.linear[1]))
            near = np.linalg.norm(o + t * d - self.centre) <= self.radius
            return [t] if near else []
        back = np.linalg.inv(self.linear)
        own_o, own_d = back @ (o - self.centre), back @ d
        if self.kind == "ball":
            return sorted(_roots(own_d @ own_d, own_o @ own_d, own_o @ own_o - 1.0))
        if self.kind == "cube":
            return _slabs(own_o, own_d, 3)
        side = _roots(own_d[:2] @ own_d[:2], own_o[:2] @ own_d[:2], own_o[:2] @ own_o[:2] - 1.0)
        caps = [(end - own_o[2]) / own_d[2] for end in (-1.0, 1.0)] if own_d[2] else []
        found = [t for t in side if abs(own_o[2] + t * own_d[2]) <= 1.0]
        found += [t for t in caps if np.hypot(*(own_o + t * own_d)[:2]) <= 1.0]
        return sorted(found)

    def normal(self, p: np.ndarray, d: np.ndarray) -> np.ndarray:
        """At a point of its surface, against the direction from which the ray comes."""
        if self.kind == "flat":
            n = self.linear[1]
        else:
            back = np.linalg.inv(self.linear)
            x = back @ (p - self.centre)
            if self.kind == "cube":
                x = np.where(np.abs(x) == np.abs(x).max(), x, 0.0)
            if self.kind == "drum":
                is_cap = abs(x[2]) >= np.hypot(x[0], x[1])
                x = x * ([0, 0, 1] if is_cap else [1, 1, 0])
            n = back.T @ x
        n = n / np.linalg.norm(n)
        return -n if n @ d > 0 else n


def _roots(a: float, h: float, c: float) -> list[float]:
    """Of a t^2 + 2 h t + c."""
    under = h * h - a * c
    return [] if under < 0 or a == 0 else [(-h - sqrt(under)) / a, (-h + sqrt(under)) / a]


def _slabs(o: np.ndarray, d: np.ndarray, count: int) -> list[float]:
    with np.errstate(divide="ignore"):
        ends = np.sort(np.array([(-1 - o[:count]) / d[:count], (1 - o[:count]) / d[:count]]), 0)
    near, far = float(ends[0].max()), float(ends[1].min())
    return [near, far] if near <= far else []


class Student:
    """Who has read a sheet's facts, a line each."""

    def __init__(self, words: Words, lines: Iterable[str]) -> None:
        self.words = words
        self.lines = list(lines)
        self.things: list[Thing] = []
        self.lights: dict[str, np.ndarray] = {}
        self.passes = False
        for line in self.lines:
            self._read(line)

    def _read(self, line: str) -> None:
        if found := self._is("slides.givenCamera", line):
            self.eye, self.target = (np.array(numbers(found[k])) for k in ("eye", "target"))
            self.fov = numbers(found["fov"])[0]
        elif found := self._is("sheet.frame", line):
            frame = [np.array(numbers(found[k])) for k in ("right", "up", "forward")]
            self.right, self.up, self.forward = frame
        elif self._is("sheet.glassPasses", line):
            self.passes = True
        elif found := self._is("sheet.lampGrid", line):
            across, down = int(found["across"]), int(found["down"])
            at, step, row = (np.array(numbers(found[key])) for key in ("at", "step", "row"))
            for k in range(across * down):
                name = f"{found['light']} {k + 1}/{across * down}"
                self.lights[name] = at + k % across * step + k // across * row
        elif found := self._is("slides.givenLight", line):
            self.lights[found["light"]] = np.array(numbers(found["at"]))
        if not any(self._is(key, line) for key in ("slides.givenCamera", "sheet.frame")):
            self._read_thing(line)

    def _is(self, key: str, line: str) -> dict[str, str] | None:
        found = pattern(self.words, key).fullmatch(line)
        return found.groupdict() if found else None

    def _read_thing(self, line: str) -> None:
        name, _, rest = line.partition(": ")
        glass = re.search(pattern(self.words, "sheet.glass"), rest)
        ior = numbers(glass["ior"])[0] if glass else None
        rest = rest[: glass.start()] if glass else rest
        for word in find_group(self.words, "sheet.shape"):
            if found := self._is(f"sheet.shape.{word}", rest):
                slots = {key: np.array(numbers(text)) for key, text in found.items()}
                self.things.append(thing(name, word, slots, ior))
                return

    def ray(self, x: int, y: int, n: int) -> np.ndarray:
        """The direction of a camera ray, by the sheet's formula."""
        s = tan(radians(self.fov / 2))
        across, down = (2 * (x + 0.5) / n - 1) * s, (1 - 2 * (y + 0.5) / n) * s
        d = across * self.right + down * self.up + self.forward
        return np.asarray(d / np.linalg.norm(d))

    def all_hits(self, o: np.ndarray, d: np.ndarray, leaves: Thing | None = None) -> list[Any]:
        """(t, thing) of a ray, nearest first; where it starts it meets nothing."""
        least = {id(leaves): 1e-6}
        hits = [
            (t, each)
            for each in self.things
            if each.box is None
            for t in each.meets(o, d)
            if t > least.get(id(each), 1e-9)
        ]
        hits.sort(key=lambda hit: hit[0])
        for each in self.things:
            if each.box is not None:
                self.check_missed(each, o, d, hits[0][0] if hits else inf)
        return hits

    def check_missed(self, each: Thing, o: np.ndarray, d: np.ndarray, until: float) -> None:
        """What only its box is told of must not lie on the way."""
        low, high = each.box  # type: ignore[misc]
        inner = _slabs((o - (low + high) / 2) / ((high - low) / 2), d / ((high - low) / 2), 3)
        assert not inner or inner[1] < 0 or inner[0] > until, f"{each.name} may be met"

    def named(self, text: str) -> Thing:
        """The object that a question names, with its article or without."""
        return next(each for each in self.things if text in (each.name, self.words.the(each.name)))


def find_group(words: Words, key: str) -> Iterable[str]:
    group: Any = words.tree
    for part in key.split("."):
        group = group[part]
    return list(group)


def thing(name: str, word: str, slots: dict[str, np.ndarray], ior: float | None) -> Thing:
    def one(key: str) -> float:
        return float(slots[key][0])

    if word == "mesh":
        return Thing(name, "boxed", box=np.array([slots["low"], slots["high"]]), ior=ior)
    if word in ("plane", "disc"):
        n = slots["normal"] / np.linalg.norm(slots["normal"])
        is_disc = word == "disc"
        return Thing(
            name, "flat", np.array([n, n, n]), slots["center" if is_disc else "point"],
            one("radius") if is_disc else inf, ior,
        )  # fmt: skip
    placed: dict[str, Callable[[], tuple[np.ndarray, np.ndarray]]] = {
        "sphere": lambda: (one("radius") * np.eye(3), slots["center"]),
        "ellipsoid": lambda: (np.diag(slots["radii"]), slots["center"]),
        "box": lambda: (
            np.diag(slots["maximum"] - slots["minimum"]) / 2,
            (slots["maximum"] + slots["minimum"]) / 2,
        ),
        "cylinder": lambda: _drum(slots["start"], slots["end"], one("radius")),
    }
    moved = lambda: (np.column_stack([slots["a"], slots["b"], slots["d"]]), slots["center"])  # noqa: E731
    return Thing(name, CANONICAL[word], *placed.get(word, moved)(), ior=ior)


def _drum(start: np.ndarray, end: np.ndarray, radius: float) -> tuple[np.ndarray, np.ndarray]:
    axis = (end - start) / 2
    across = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    across = radius * across / np.linalg.norm(across)
    other = np.cross(axis / np.linalg.norm(axis), across)
    return np.column_stack([across, other, axis]), (start + end) / 2
