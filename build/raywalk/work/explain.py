"""Why something is made again: which of its parts is not what it was."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

# Parts with names and values inside. Others are mostly keys of other work: only their names speak.
NAMED = {"what", "of", "scene", "models", "code", "read", "packages"}
MOST_NAMED = 4  # parts a line; a new version of everything is given by count


def why(before: Any, now: dict[str, Any], damage: str) -> str:
    """One line for one piece of work. before: what the newest earlier one was made from."""
    if damage:
        return f"its kept {damage} is damaged"
    if not before:
        return "was never made before"
    reasons = [
        *_listed("", _scene_changes(before.get("scene"), now.get("scene"))),
        *_listed("the model ", _names_changed(before.get("models"), now.get("models"))),
        *_listed("code: ", _names_changed(before.get("code"), now.get("code"))),
        *_listed("", _names_changed(before.get("read"), now.get("read"))),
        *_listed("", _values_changed("", before.get("packages"), now.get("packages"))),
        *(
            f"its {name}"
            for name in sorted({*before, *now} - NAMED)
            if before.get(name) != now.get(name)
        ),
    ]
    return "; ".join(reasons) or "what was made from this was cleared away"


def likest(before: Iterable[Any], now: dict[str, Any]) -> Any:
    """Of what earlier work was made from, what differs least from this; None if there is none.

    Of a scene there are many stops, and none of them is the one that was here before.
    """
    return min(before, key=lambda each: len([*_values_changed("", each, now)]), default=None)


def in_runs(numbers: Iterable[int]) -> str:
    """Ascending ones as a person tells them: 1, 2, 4 to 11."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    told = (f"{run[0]} to {run[-1]}" if len(run) > 2 else ", ".join(map(str, run)) for run in runs)
    return ", ".join(told)


def _listed(prefix: str, names: Iterator[str]) -> list[str]:
    found = list(names)
    shown = ", ".join(found[:MOST_NAMED])
    more = f" and {len(found) - MOST_NAMED} more" if len(found) > MOST_NAMED else ""
    return [f"{prefix}{shown}{more}"] if found else []


def _names_changed(before: Any, now: Any) -> Iterator[str]:
    """Names whose hash changed, or that are new or gone."""
    before, now = before or {}, now or {}
    for name in sorted({*before, *now}):
        if name not in before:
            yield f"{name} is new"
        elif name not in now:
            yield f"{name} is gone"
        elif before[name] != now[name]:
            yield f"{name} changed"


def _scene_changes(before: Any, now: Any) -> Iterator[str]:
    yield from _values_changed("", before, now)


def _values_changed(at: str, before: Any, now: Any) -> Iterator[str]:
    """Keys with their old and new values, as deep as they differ."""
    if before == now:
        return
    if isinstance(before, dict) and isinstance(now, dict):
        for key in [*before, *(key for key in now if key not in before)]:
            inner = f"{at}.{key}" if at else str(key)
            yield from _values_changed(inner, before.get(key), now.get(key))
    elif isinstance(before, list) and isinstance(now, list) and _is_table(before, now):
        for k in range(max(len(before), len(now))):
            old, new = (side[k] if k < len(side) else None for side in (before, now))
            yield from _values_changed(f"{at}[{k}]", old, new)
    else:
        yield f"{at} {_short(before)} -> {_short(now)}"


def _is_table(before: list[Any], now: list[Any]) -> bool:
    """Lists of objects, lights, steps: named one by one; a triple of numbers is one value."""
    return all(isinstance(item, dict) for item in [*before, *now])


def _short(value: Any) -> str:
    if value is None:
        return "none"
    if isinstance(value, dict):
        return f'"{value.get("name", "...")}"'
    text = f'"{value}"' if isinstance(value, str) else str(value)
    return text if len(text) <= 40 else text[:37] + "..."
