"""One frustum resolution read out of the whole ray tree, whose order the file keeps."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np

from raywalk.trace.tree import RayTree, level_pixels


class TraceFileError(ValueError):
    """A ray tree of which no trace file can be written, and why."""


PER_HIT = ("hits_t", "hits_object")


def level_of(tree: RayTree, n: int) -> RayTree:
    """The rays of one n x n frustum; `pixel` keeps counting in the full picture."""
    wanted = np.zeros(tree.size * tree.size, bool)
    wanted[level_pixels(tree.size, n)] = True
    chosen = wanted[tree.pixel]
    missing = n * n - int(np.count_nonzero(chosen[: tree.cameras]))
    if missing:
        raise TraceFileError(f"{missing} pixels of level {n} were not kept")
    return rows_of(tree, np.flatnonzero(chosen))


def rows_of(tree: RayTree, rows: np.ndarray) -> RayTree:
    """The tree of these rows alone; they must hold the parent of each."""
    new_row = np.full(len(tree.pixel) + 1, -1, np.int32)  # the last serves parent -1
    new_row[rows] = np.arange(len(rows))
    columns = {
        f.name: getattr(tree, f.name).take(rows, axis=0)
        for f in fields(tree)
        if f.name not in ("size", "hits_start", *PER_HIT) and getattr(tree, f.name) is not None
    }
    columns["parent"] = new_row[columns["parent"]]
    cameras = rows[rows < tree.cameras]
    counts = np.diff(tree.hits_start)[cameras]
    start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int32)
    hits = np.repeat(tree.hits_start[cameras] - start[:-1], counts) + np.arange(start[-1])
    for name in PER_HIT:
        columns[name] = getattr(tree, name)[hits]
    return replace(tree, hits_start=start, **columns)


def side_of(tree: RayTree) -> int:
    """n of a level's n x n camera rays. Raises TraceFileError if they are not of one level."""
    n = int(np.sqrt(tree.cameras) + 0.5)
    if n * n != tree.cameras or (tree.pixel[: n * n] != level_pixels(tree.size, n)).any():
        raise TraceFileError("these are not the camera rays of one resolution")
    return n
