"""Kernels of the encoder: neighbours, predictions and what they leave, for whole columns.

They note what the viewer's columns.ts reads, operation by operation: the order of these sums is
part of the format. A column of symbols (which surface, which blocker) continues the edge that two
neighbours show: if up-left equals left, the edge runs down between the columns, so up is taken,
else left. What is only weighed, to choose a predictor, is summed here too: a library's sums may
depend on how many cores it finds, and so would the bytes.
"""

from __future__ import annotations

import numpy as np

from raywalk.optics.compiled import kernel
from raywalk.trace_file.expected import CLASSES, KEPT, MOST, SHARES

NONE = -1
# How a kind is predicted: by its affine part alone, by left + up - up-left, by six taps.
ALONE, PLANE, TAPS = 0, 1, 2
UNIT = 256.0  # of taps
SIZES = 40  # what a class keeps of residuals is counted one by one below it
FULL, CORNER = 6, 3  # neighbours that a fit needs: all, or left, up, up-left


@kernel
def symbol_codes(symbol, group, kind, sides):
    """(m,) codes: 0 where the guess is right, else 1 + symbol."""
    codes = np.empty(symbol.shape[0], np.int64)
    last = np.full(kind.max() + 2 if len(kind) else 1, NONE)
    for i in range(symbol.shape[0]):
        left, up, up_left = sides[0, i], sides[1, i], sides[2, i]
        has_left = left >= 0 and group[left] == group[i]
        has_up = up >= 0 and group[up] == group[i]
        has_corner = up_left >= 0 and group[up_left] == group[i]
        take = NONE
        if has_left:
            take = left
        if has_up and (not has_left or (has_corner and symbol[up_left] == symbol[left])):
            take = up
        if take < 0:
            take = last[kind[i] + 1]
        guess = symbol[take] if take >= 0 else 0
        codes[i] = 0 if symbol[i] == guess else 1 + symbol[i]
        last[kind[i] + 1] = i
    return codes


@kernel
def near_in(group, kind, sides):
    """(m, 7) left, up, up-left, up-right, left of left, up of up, the last of the kind; NONE
    where not of the group."""
    near = np.full((group.shape[0], 7), NONE)
    last = np.full(kind.max() + 2 if len(kind) else 1, NONE)
    for i in range(group.shape[0]):
        if kind[i] < 0:
            continue
        for k in range(6):
            at = sides[k, i] if k < 4 else sides[k - 4, i]
            if k >= 4 and at >= 0:
                at = sides[k - 4, at]
            if at >= 0 and group[at] == group[i]:
                near[i, k] = at
        near[i, 6] = last[kind[i] + 1]
        last[kind[i] + 1] = i
    return near


@kernel
def rows_by_kind(kind):
    """Rows in the order of their kinds, and where each kind starts; negative kinds left out."""
    start = np.zeros(kind.max() + 2 if len(kind) else 1, np.int64)
    for of in kind:
        if of >= 0:
            start[of + 1] += 1
    start = np.cumsum(start)
    rows, filled = np.empty(start[-1], np.int64), start.copy()
    for i in range(kind.shape[0]):
        if kind[i] >= 0:
            rows[filled[kind[i]]] = i
            filled[kind[i]] += 1
    return rows, start


@kernel
def predicted(off, near, i, how, taps):
    """Row i's distance from the affine part as its neighbours' tell it."""
    left, up, up_left, up_right = near[i, 0], near[i, 1], near[i, 2], near[i, 3]
    left2, up2 = near[i, 4], near[i, 5]
    if left >= 0:
        if up >= 0 and up_left >= 0:
            if how == PLANE or up_right < 0 or left2 < 0 or up2 < 0:
                return off[left] + off[up] - off[up_left]
            whole = off[left] * taps[0] + off[up] * taps[1] + off[up_left] * taps[2]
            whole = whole + off[up_right] * taps[3] + off[left2] * taps[4]
            return (whole + off[up2] * taps[5]) / UNIT
        if left2 >= 0:
            return 2 * off[left] - off[left2]
    if up >= 0 and up2 >= 0:
        return 2 * off[up] - off[up2]
    for k in (0, 1, 2, 3, 6):
        if near[i, k] >= 0:
            return off[near[i, k]]
    return 0.0


@kernel
def expected_class(size, near, i):
    """Row i's class, from the sizes of its neighbours' residuals in the row above. The one at the
    left is the last that was read: a reader that need not wait for it is a seventh faster (files
    are 1 % larger). It stands in where there are no others, and the last of the kind for it."""
    sizes, count = 0, 0
    for k in range(1, 4):
        if near[i, k] >= 0:
            times = 2 if k == 1 else 1  # the one straight above
            sizes += times * size[near[i, k]]
            count += times
    if count == 0:
        before = near[i, 0] if near[i, 0] >= 0 else near[i, 6]
        sizes, count = 0 if before < 0 else size[before], 1
    four_times, digits = (sizes * SHARES[count]) >> 6, 0
    while four_times > 0:
        four_times >>= 1
        digits += 1
    return digits


@kernel
def residuals(number, base, kind, near, how, taps):
    """(m,) int64 residuals of whole numbers, and the class of each (see expected.py).
    base: (m,) affine part; how: (kinds,); taps: (kinds, 6)."""
    off = number - base
    left, size = np.zeros(number.shape[0], np.int64), np.zeros(number.shape[0], np.int64)
    classes = np.zeros(number.shape[0], np.int64)
    for i in range(number.shape[0]):
        if kind[i] < 0:
            continue
        guess = base[i]
        if how[kind[i]] != ALONE:
            guess = guess + predicted(off, near, i, how[kind[i]], taps[kind[i]])
        left[i] = np.int64(number[i] - np.floor(guess + 0.5))
        size[i] = min(abs(left[i]), MOST)
        classes[i] = expected_class(size, near, i)
    return left, classes


@kernel
def residual_bits(number, off, rows, near, how, taps):
    """Bits that these rows' residuals take, about: the entropy of each class, what is noise in it,
    and more for those that are large for their class. near: none that is not of the rows."""
    size = np.zeros(number.shape[0], np.int64)
    counts, bits = np.zeros((CLASSES, SIZES + 1), np.int64), 0.0
    for i in rows:
        guess = number[i] - off[i]
        if how != ALONE:
            guess = guess + predicted(off, near, i, how, taps)
        left = number[i] - np.floor(guess + 0.5)
        size[i] = int(min(abs(left), MOST))
        of = expected_class(size, near, i)
        low = max(of - KEPT, 0)
        code = (2 * size[i] - (1 if left < 0 else 0)) >> low
        counts[of, min(code, SIZES)] += 1
        bits += low
        if code > SIZES:
            bits += 2.0 * np.log2(code / SIZES)
    for of in range(CLASSES):
        together = counts[of].sum()
        for count in counts[of]:
            if count > 0:
                bits -= count * np.log2(count / together)
    return bits


@kernel
def surrounded(rows, near, sides):
    """Those of the rows that have their first `sides` neighbours."""
    found, filled = np.empty_like(rows), 0
    for i in rows:
        has_all = True
        for k in range(sides):
            has_all = has_all and near[i, k] >= 0
        if has_all:
            found[filled] = i
            filled += 1
    return found[:filled]


@kernel
def bends(values, rows, near):
    """(r,) by how much values differ from left + up - up-left."""
    bend = np.empty(rows.shape[0])
    for r in range(rows.shape[0]):
        i = rows[r]
        bend[r] = values[i] - (values[near[i, 0]] + values[near[i, 1]] - values[near[i, 2]])
    return bend


@kernel
def tap_columns(off, rows, near, target, most):
    """(7, r) neighbours' distances from left + up - up-left, and the target, of rows where that
    is at most `most`: edges must not set the taps."""
    table, filled = np.empty((7, rows.shape[0])), 0
    for r in range(rows.shape[0]):
        if abs(target[r]) > most:
            continue
        i = rows[r]
        start = off[near[i, 0]] + off[near[i, 1]] - off[near[i, 2]]
        for k in range(6):
            table[k, filled] = off[near[i, k]] - start
        table[6, filled] = target[r]
        filled += 1
    return table[:, :filled].copy()  # else `products` would be compiled for another layout too


@kernel
def products(table):
    """(c, c) sums of products of the columns of a table (c, r)."""
    columns = table.shape[0]
    sums = np.zeros((columns, columns))
    for a in range(columns):
        for b in range(a, columns):
            total = 0.0
            for r in range(table.shape[1]):
                total += table[a, r] * table[b, r]
            sums[a, b] = total
            sums[b, a] = total
    return sums


@kernel
def off_affine(number, rows, features, affine, off):
    """Fills off[rows]: what constant + sum of coefficient * feature leaves of the number."""
    for i in rows:
        part = affine[0]
        for k in range(features.shape[0]):
            part = part + affine[k + 1] * features[k, i]
        off[i] = number[i] - part


@kernel
def centred(values, features, rows):
    """(f + 1, r) features and values of the rows less their means, and those (f + 1,)."""
    count = features.shape[0]
    table, mean = np.empty((count + 1, rows.shape[0])), np.zeros(count + 1)
    for k in range(count + 1):
        for r in range(rows.shape[0]):
            table[k, r] = features[k, rows[r]] if k < count else values[rows[r]]
            mean[k] += table[k, r]
        mean[k] /= rows.shape[0]
        for r in range(rows.shape[0]):
            table[k, r] -= mean[k]
    return table, mean
