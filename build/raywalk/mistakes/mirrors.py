"""Where a mirror sends a ray."""

from __future__ import annotations

import numpy as np

from raywalk.mistakes.rays import Hits
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import dot, unit


def mirror_direction(d: np.ndarray, hits: Hits, mistakes: Mistakes) -> np.ndarray:
    """(3, n) r = d - 2 (d.n) n: the angle out is the angle in (Whitted, "An improved illumination
    model for shaded display", CACM 23(6), 1980)."""
    n = hits.normal
    if "mirror-wrong-normal" in mistakes:
        n = unit(hits.point)  # right on a ball about the origin only
    r = d - 2 * dot(d, n) * n
    if "mirror-reversed" in mistakes:
        r = -r
    return np.asarray(r)
