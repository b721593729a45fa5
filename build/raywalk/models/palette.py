"""Colours of a model's triangles, few enough that each is a material of its own.

A triangle has its face's colour, or the mean of its corners'. Colours that differ by less than 8
bits show are one; of more than MOST the lowest bits go until so many are left.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.models.clean import Cleaned

MOST = 256


class Palette(NamedTuple):
    """The most frequent colour stands first."""

    colours: np.ndarray  # (n, 3) from 0 to 1; of fewer than 8 bits the mean of what is one
    which: np.ndarray  # (f,) int64 of each chosen triangle
    bits: int  # that are told apart in each channel


def palette_of(cleaned: Cleaned, chosen: np.ndarray) -> Palette:
    """Of these triangles (f,) bool of a model that has colours."""
    told = cleaned.model.colours
    assert told is not None
    rows = told.row[cleaned.source[chosen]]
    known = (rows >= 0)[:, :, None]
    at = np.where(known, told.table[rows], 1.0)  # told for others only: white
    colour = at[:, 0] + (at - at[:, :1]).mean(axis=1)  # of three equal ones it is that one
    eight = np.floor(255.0 * colour + 0.5).astype(np.int64)
    for bits in range(8, 0, -1):
        key = (eight >> (8 - bits)) @ np.array([1 << 16, 1 << 8, 1])
        _, first, which, count = np.unique(
            key, return_index=True, return_inverse=True, return_counts=True
        )
        if len(count) <= MOST:
            break
    which = which.reshape(-1)
    one_each = colour[first]
    if bits < 8:
        sums = [np.bincount(which, weights=channel) for channel in colour.T]
        one_each = np.column_stack(sums) / count[:, None]
    order = np.argsort(-count, kind="stable")
    place = np.empty(len(order), np.int64)
    place[order] = np.arange(len(order))
    return Palette(np.clip(one_each, 0.0, 1.0)[order], place[which], bits)
