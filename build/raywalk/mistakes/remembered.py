"""What the right program worked out, kept for programs with a mistake.

A program with a mistake does all as the right one does up to the line that asks for the mistake. So
while the right one is traced, each step notes what it made of what, and which mistakes its lines
asked for. With a mistake that none of them asked for the same input has the same result, and that
is taken from here: a mistake of the light meets the same hits, one of glass the same first hits.

    with remembering():
        trace(scene, n, pixels)  # the right program: noted
        trace(scene, n, pixels, frozenset(["gamma-applied"]))  # all of it is there
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, fields, is_dataclass
from functools import wraps
from typing import Any, NamedTuple, TypeVar

import numpy as np

Taken = TypeVar("Taken", bound=Callable[..., Any])
MISTAKES = "mistakes"  # the argument's name, in every step that is remembered


class Noting(frozenset[str]):
    """No mistake, but it notes which are asked for. What else one may do with a set is refused: it
    would ask for all."""

    def __init__(self) -> None:
        self.asked: set[str] = set()

    def __contains__(self, name: object) -> bool:
        self.asked.add(str(name))
        return False

    def __and__(self, others: Any) -> Any:
        self.asked |= others
        return frozenset()

    def __sub__(self, others: Any) -> Any:
        return self

    def _refused(self, *_: Any) -> Any:
        raise TypeError("a step asks for mistakes by their names")

    __iter__ = __or__ = __xor__ = __eq__ = __hash__ = _refused


class Step(NamedTuple):
    """What was made, and which mistakes would have had a say in it."""

    made: Any
    asked: frozenset[str]


@dataclass
class Memory:
    """Steps of right programs, by what they are and were given."""

    steps: dict[Any, Step] = field(default_factory=dict)
    #: Arrays that steps have made, by their place in memory, where nothing else is as long as they
    #: are held here: these need not be read to be known again.
    known: dict[int, np.ndarray] = field(default_factory=dict)
    #: What of a scene was given, likewise, with its mark.
    marked: dict[int, tuple[Any, Any]] = field(default_factory=dict)

    def keep(self, key: Any, step: Step) -> None:
        """From here on nobody may change what was made."""
        self.steps[key] = step
        for array in _arrays(step.made):
            array.flags.writeable = False
            self.known[id(array)] = array

    def mark(self, given: Any) -> Any:
        """The same for what is the same to the last bit."""
        if isinstance(given, np.ndarray):
            if id(given) in self.known:
                return id(given)
            return given.dtype.str, given.shape, given.tobytes()
        if isinstance(given, tuple):
            return tuple(map(self.mark, given))
        if not is_dataclass(given):
            return given
        if id(given) not in self.marked:
            mark = tuple(self.mark(getattr(given, each.name)) for each in fields(given))
            self.marked[id(given)] = given, mark
        return self.marked[id(given)][1]


_memory: ContextVar[Memory | None] = ContextVar("memory", default=None)


@contextmanager
def remembering() -> Iterator[None]:
    """In here the steps of programs without a mistake are noted."""
    token = _memory.set(Memory())
    try:
        yield
    finally:
        _memory.reset(token)


def remembered(step: Taken) -> Taken:
    """A step that need not be taken twice. It changes nothing that it is given, in this order."""
    place = list(inspect.signature(step).parameters).index(MISTAKES)

    @wraps(step)
    def taken(*given: Any) -> Any:
        memory, mistakes = _memory.get(), given[place]
        if memory is None:
            return step(*given)
        before, after = given[:place], given[place + 1 :]
        key = (step, memory.mark(before), memory.mark(after))
        known = memory.steps.get(key)
        if known:
            return step(*given) if mistakes & known.asked else known.made
        if not isinstance(mistakes, Noting) and mistakes:
            return step(*given)
        noting = Noting()
        made = step(*before, noting, *after)
        memory.keep(key, Step(made, frozenset(noting.asked)))
        if isinstance(mistakes, Noting):  # of a step around this one, which so asks for them, too
            mistakes.asked.update(noting.asked)
        return made

    return taken  # type: ignore[return-value]


def _arrays(made: Any) -> Iterator[np.ndarray]:
    if isinstance(made, np.ndarray):
        yield made
    elif isinstance(made, tuple):
        for part in made:
            yield from _arrays(part)
