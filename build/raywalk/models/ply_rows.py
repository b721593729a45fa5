"""The rows of a PLY file's elements, as columns."""

from __future__ import annotations

from array import array
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Literal, NoReturn

import numpy as np

from raywalk.models.faults import ModelFault, quoted
from raywalk.models.ply_header import Element, Header, Property
from raywalk.models.text import a_number, lines, one_encoding

CHUNK = 20_000  # lines made into numbers at once
SHORT_RUN = 64  # rows: after fewer whose lists are of one length, so many are looked at one by one
RUN = 1 << 16  # rows that are compared at once
CUT = "it is cut short: copy or export it again"

MANY = 1 << 16  # values that are taken together


@dataclass(frozen=True, eq=False)
class Listed:
    counts: np.ndarray  # (n,) int64
    values: np.ndarray  # (sum,)


@dataclass(frozen=True, eq=False)
class Rows:
    """Columns of one element, by the properties' names."""

    single: dict[str, np.ndarray]
    lists: dict[str, Listed]


def read_rows(path: Path, data: bytes, header: Header) -> dict[str, Rows]:
    """All elements. Raises ModelFault with the line, or the element."""
    reader = _Text(path, data, header) if header.format == "ascii" else _Binary(path, data, header)
    return {element.name: reader.rows(element) for element in header.elements}


class _Text:
    """One row a line."""

    def __init__(self, path: Path, data: bytes, header: Header):
        self.path = path
        self._lines = (
            (number + header.lines, line)
            for number, line in lines(one_encoding(data[header.end :]))
            if line.strip()
        )

    def rows(self, element: Element) -> Rows:
        """The next ones."""
        if any(each.count_kind for each in element.properties):
            return self._listed(element)
        wide, parts = len(element.properties), []
        for first in range(0, element.count, CHUNK):
            count = min(CHUNK, element.count - first)
            chunk = list(islice(self._lines, count))
            if len(chunk) < count:
                self._ends(element, first + len(chunk))
            parts.append(self._numbers(chunk, wide))
        table = np.concatenate(parts) if parts else np.empty((0, wide))
        return Rows({each.name: table[:, k] for k, each in enumerate(element.properties)}, {})

    def _ends(self, element: Element, reached: int) -> NoReturn:
        raise ModelFault(
            self.path,
            f"{element.name} {reached} of {element.count}",
            "the file ends before it",
            CUT,
        )

    def _numbers(self, chunk: list[tuple[int, bytes]], wide: int) -> np.ndarray:
        rows = [line.split() for _, line in chunk]
        try:
            if all(len(row) == wide for row in rows):
                return np.array([[float(word) for word in row] for row in rows]).reshape(-1, wide)
        except ValueError:
            pass
        for (number, line), row in zip(chunk, rows, strict=True):
            if len(row) < wide:
                cause = f"{quoted(line.strip())} has {len(row)} of {wide} numbers"
                raise ModelFault(self.path, f"line {number}", cause, "export the model again")
        return np.array(
            [
                [a_number(word, self.path, number) for word in row[:wide]]
                for (number, _), row in zip(chunk, rows, strict=True)
            ]
        )

    def _listed(self, element: Element) -> Rows:
        single = {each.name: array("d") for each in element.properties if not each.count_kind}
        counts = {each.name: array("q") for each in element.properties if each.count_kind}
        values = {name: array("d") for name in counts}
        for k in range(element.count):
            found = next(self._lines, None)
            if found is None:
                self._ends(element, k)
            self._row(element, *found, single, counts, values)
        return Rows(
            {name: np.frombuffer(each or array("d")) for name, each in single.items()},
            {
                name: Listed(
                    np.frombuffer(counts[name] or array("q"), np.int64),
                    np.frombuffer(values[name] or array("d")),
                )
                for name in counts
            },
        )

    def _row(
        self, element: Element, number: int, line: bytes, single: dict[str, array],
        counts: dict[str, array], values: dict[str, array],
    ) -> None:  # fmt: skip
        words, at = line.split(), 0
        for each in element.properties:
            if at >= len(words):
                self._short(number, line, each)
            if not each.count_kind:
                single[each.name].append(a_number(words[at], self.path, number))
                at += 1
                continue
            if not words[at].isdigit():
                cause = f"{quoted(words[at])} is not a number of {each.name}"
                raise ModelFault(self.path, f"line {number}", cause, "export the model again")
            count = int(words[at])
            if at + 1 + count > len(words):
                self._short(number, line, each)
            found = [a_number(word, self.path, number) for word in words[at + 1 : at + 1 + count]]
            counts[each.name].append(count)
            values[each.name].extend(found)
            at += 1 + count

    def _short(self, number: int, line: bytes, wanted: Property) -> NoReturn:
        cause = f"{quoted(line.strip())} ends before its {wanted.name}"
        raise ModelFault(self.path, f"line {number}", cause, "export the model again")


class _Binary:
    """Rows one behind the other."""

    def __init__(self, path: Path, data: bytes, header: Header):
        self.path, self.data, self.at = path, data, header.end
        self.order = "<" if header.format == "binary_little_endian" else ">"
        self._little: Literal["little", "big"] = "little" if self.order == "<" else "big"
        self._layouts: dict[str, list[tuple[int, int, bool, str]]] = {}

    def rows(self, element: Element) -> Rows:
        """The next ones."""
        listed = [each for each in element.properties if each.count_kind]
        least = sum(np.dtype(each.count_kind or each.kind).itemsize for each in element.properties)
        if element.count * least > len(self.data) - self.at:  # before anything is made for them
            there = (len(self.data) - self.at) // max(1, least)
            self._ends(element, there if not listed else None)
        if not listed:
            table = np.frombuffer(self.data, self._record(element), element.count, self.at)
            self.at += table.nbytes
            with np.errstate(invalid="ignore"):
                columns = [table[f"p{k}"].astype(float) for k in range(len(element.properties))]
            names = [each.name for each in element.properties]
            return Rows(dict(zip(names, columns, strict=True)), {})
        return self._listed(element)

    def _ends(self, element: Element, reached: int | None) -> NoReturn:
        where = "" if reached is None else f" {reached} of"
        raise ModelFault(
            self.path, f"{element.name}{where} {element.count}" if where else element.name,
            f"the file ends before the last of {element.count}", CUT,
        )  # fmt: skip

    def _record(self, element: Element, sizes: tuple[int, ...] = ()) -> np.dtype:
        """A row's layout with lists of these lengths."""
        fields: list[tuple] = []
        lengths = iter(sizes)
        for k, each in enumerate(element.properties):
            if each.count_kind:
                fields.append((f"n{k}", self.order + each.count_kind))
                fields.append((f"p{k}", self.order + each.kind, (next(lengths),)))
            else:
                fields.append((f"p{k}", self.order + each.kind))
        return np.dtype(fields)

    def _listed(self, element: Element) -> Rows:
        """Where rows begin is found first, as that depends on the lists before; then each column
        is taken at once."""
        if (table := self._alike(element)) is not None:
            return self._of(element, table)
        starts, left = array("q"), element.count
        while left:
            found = self._run(element, min(left, RUN))
            starts.extend(found)
            left -= len(found)
            for _ in range(min(left, SHORT_RUN) if len(found) < SHORT_RUN else 0):
                starts.append(self.at)
                self._lengths(element)
                left -= 1
        return self._columns(element, np.frombuffer(starts or array("q"), np.int64))

    def _alike(self, element: Element) -> np.ndarray | None:
        """All rows, if all have lists of the lengths of the first: nearly every file's have, and
        where each begins need not be kept."""
        begin = self.at
        if not element.count:
            return None
        record = self._record(element, self._lengths(element))
        self.at = begin
        if element.count * record.itemsize > len(self.data) - begin:
            return None
        table = np.frombuffer(self.data, record, element.count, begin)
        for k, each in enumerate(element.properties):
            if each.count_kind and (table[f"n{k}"] != record[f"p{k}"].shape[0]).any():
                return None
        self.at += table.nbytes
        return table

    def _of(self, element: Element, table: np.ndarray) -> Rows:
        single, lists = {}, {}
        for k, each in enumerate(element.properties):
            with np.errstate(invalid="ignore"):
                values = table[f"p{k}"].astype(float).reshape(-1)
            if each.count_kind:
                lists[each.name] = Listed(table[f"n{k}"].astype(np.int64), values)
            else:
                single[each.name] = values
        return Rows(single, lists)

    def _run(self, element: Element, most: int) -> array:
        """Where the next rows begin that have lists of the same lengths; at least one."""
        begin, lengths = self.at, self._lengths(element)
        record = self._record(element, lengths)
        there = (len(self.data) - begin) // record.itemsize
        run = np.frombuffer(self.data, record, min(most, there), begin)
        alike = np.full(len(run), True)
        for k, each in enumerate(element.properties):
            if each.count_kind:
                alike &= run[f"n{k}"] == record[f"p{k}"].shape[0]
        size = len(run) if alike.all() else int(alike.argmin())
        self.at = begin + size * record.itemsize
        return array("q", range(begin, self.at, record.itemsize))

    def _lengths(self, element: Element) -> tuple[int, ...]:
        """Of the lists in the next row, which is passed."""
        at, lengths, end = self.at, [], len(self.data)
        for kind, wide, signed, name in self._layout(element):
            if wide:
                word = self.data[at : at + wide]
                count = int.from_bytes(word, self._little, signed=signed)
                if len(word) < wide or not 0 <= count * kind <= end - at - wide:
                    raise ModelFault(
                        self.path, element.name, f"a list of {count} {name} does not fit into "
                        "what is left of the file", "it is cut short or damaged: export it again",
                    )  # fmt: skip
                lengths.append(count)
                at += wide + count * kind
            else:
                at += kind
        if at > end:
            self._ends(element, None)
        self.at = at
        return tuple(lengths)

    def _layout(self, element: Element) -> list[tuple[int, int, bool, str]]:
        """Of each property: bytes of a value, bytes of its count, whether that has a sign."""
        if element.name not in self._layouts:
            self._layouts[element.name] = [
                (
                    np.dtype(each.kind).itemsize,
                    np.dtype(each.count_kind).itemsize if each.count_kind else 0,
                    each.count_kind[:1] == "i", each.name,
                )
                for each in element.properties
            ]  # fmt: skip
        return self._layouts[element.name]

    def _columns(self, element: Element, starts: np.ndarray) -> Rows:
        at, single, lists = starts.copy(), {}, {}
        for each in element.properties:
            size = np.dtype(each.kind).itemsize
            if not each.count_kind:
                single[each.name] = self._taken(at, each.kind)
                at += size
                continue
            counts = self._taken(at, each.count_kind).astype(np.int64)
            at += np.dtype(each.count_kind).itemsize
            begun = np.cumsum(counts) - counts
            place = np.arange(int(counts.sum())) - np.repeat(begun, counts)
            lists[each.name] = Listed(
                counts, self._taken(np.repeat(at, counts) + size * place, each.kind)
            )
            at += counts * size
        return Rows(single, lists)

    def _taken(self, at: np.ndarray, kind: str) -> np.ndarray:
        """(n,) float64 values that begin at these bytes (n,)."""
        size = np.dtype(kind).itemsize
        whole = np.frombuffer(self.data, np.uint8)
        taken = np.empty((len(at), size), np.uint8)
        for k in range(0, len(at), MANY):  # a place in the file weighs more than a byte
            taken[k : k + MANY] = whole[at[k : k + MANY, None] + np.arange(size)]
        with np.errstate(invalid="ignore"):
            return taken.view(self.order + kind).reshape(-1).astype(float)
