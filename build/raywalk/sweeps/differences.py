"""A list of likes as differences, each from the one before where that is shorter: most of a moved
lamp's rays are those that they were. viewer/sweeps/whole.ts makes them whole again."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

Table = dict[str, Any]
INNER = "columns"  # the part of a trace file that is a table of long texts


def as_differences(tables: Sequence[Table]) -> list[Table]:
    """Tables by what is other than in the table before, null where a key is gone; {"whole": table}
    where that is as short, as it is of the first one."""
    found = []
    for k, table in enumerate(tables):
        whole = {"whole": table}
        given = _other(table, tables[k - 1]) if k else whole
        found.append(min(whole, given, key=_length))
    return found


def _other(table: Table, before: Table) -> Table:
    given: Table = {key: None for key in before if key not in table}
    for key, value in table.items():
        if value == before.get(key):
            continue
        inner = key == INNER and key in before
        given[key] = _other(value, before[key]) if inner else value
    return given


def whole_again(given: Sequence[Table]) -> list[Table]:
    """The tables that these differences were made from."""
    tables: list[Table] = []
    for each in given:
        tables.append(each["whole"] if "whole" in each else _laid(tables[-1], each))
    return tables


def _laid(before: Table, other: Table) -> Table:
    table = before | other
    if other.get(INNER) and INNER in before:
        table[INNER] = _laid(before[INNER], other[INNER])
    return {key: value for key, value in table.items() if value is not None}


def _length(table: Table) -> int:
    return len(json.dumps(table, separators=(",", ":")))
