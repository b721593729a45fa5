"""A key of a scene's file by its name: objects, lights and materials by theirs, items by number."""

from __future__ import annotations

import tomllib
from typing import Any

from raywalk.scene.compile import light_names, object_names
from raywalk.scene.draft import Draft
from raywalk.scene.problems import Location, Problems
from raywalk.scene.wording import did_you_mean, joined, quoted, show

VARIED = ("camera", "lights", "materials", "objects", "render")
GIVE = "write the scene's own value there: it is one of the stops"
WHOLE = "background"  # no table, but a colour

Path = list[str | int]


def path_of(
    varies: str, raw: dict[str, Any], draft: Draft, at: Location, problems: Problems
) -> Path | None:
    """Where in the file the value stands; None, with the problem noted, if it is not there."""
    keys = _keys(varies)
    is_key = keys is not None and (keys[0] == WHOLE or (len(keys) > 1 and keys[0] in VARIED))
    if keys is None or not is_key:
        problems.add(
            at, f"{quoted(varies)} is no key whose value may change",
            allowed=f"allowed: {WHOLE}, or one below {joined(VARIED)}",
            hint='write it as lights."light 1".position, or camera.fov',
        )  # fmt: skip
        return None
    if keys[0] not in raw:
        problems.add(at, f"the file gives no {quoted(keys[0])}", hint=GIVE)
        return None
    path: Path = [keys[0]]
    known = {"lights": light_names(draft), "objects": object_names(draft)}.get(keys[0])
    if known is not None and keys[1] not in known.values():
        if not known or any(e.key.startswith(keys[0]) for e in problems.errors):
            return None  # its table may be one of those that could not be read
        problems.add(
            at, f"there is no {quoted(keys[1])} in {keys[0]}",
            allowed=f"known: {joined(map(quoted, known.values()))}",
            hint=did_you_mean(keys[1], known.values()),
        )  # fmt: skip
        return None
    if known is not None:
        path.append(next(place for place, name in known.items() if name == keys[1]))
    return _walk(varies, raw, path, keys[len(path) :], at, problems)


def _keys(varies: str) -> list[str] | None:
    """A dotted key as TOML reads it."""
    try:
        table: Any = tomllib.loads(f"{varies} = 0")
    except tomllib.TOMLDecodeError:
        return None
    keys = []
    while isinstance(table, dict):
        if len(table) != 1:
            return None
        [(key, table)] = table.items()
        keys.append(key)
    return keys if table == 0 else None


def _walk(
    varies: str, raw: dict[str, Any], path: Path, rest: list[str], at: Location, problems: Problems
) -> Path | None:  # fmt: skip
    """The whole path, through tables and lists, to a number or a list of numbers."""
    here: Any = value_at(raw, path)
    for key in rest:
        if isinstance(here, dict) and key in here:
            step: str | int = key
        elif isinstance(here, list) and key.isdecimal() and int(key) < len(here):
            step = int(key)
        else:
            known = list(here) if isinstance(here, dict) else []
            problems.add(
                at, f"{quoted(varies)}: the file gives no {quoted(key)} there",
                allowed=f"there: {joined(known)}" if known else "",
                hint=did_you_mean(key, known) or GIVE,
            )  # fmt: skip
            return None
        path, here = [*path, step], here[step]
    if not _is_number(here) and not (
        isinstance(here, list) and here and all(map(_is_number, here))
    ):
        problems.add(at, f"{quoted(varies)} is {show(here)}: neither a number nor a list of them")
        return None
    return path


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def value_at(raw: Any, path: Path) -> Any:
    for key in path:
        raw = raw[key]
    return raw
