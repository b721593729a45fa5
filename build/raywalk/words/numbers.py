"""Numbers as people of a language write them; character by character what words.ts writes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal

MINUS = "\u2212"  # as wide as a plus


@dataclass(frozen=True)
class Numbers:
    """How one language writes numbers."""

    decimal: str
    group: str  # between groups of three digits
    between: str  # between numbers of a list: with a decimal comma a comma would be misread

    def fixed(self, value: float, digits: int) -> str:
        """So many decimals, halves away from 0 as JavaScript's toFixed; no minus before zeros."""
        exact = Decimal(float(value)).quantize(Decimal(1).scaleb(-digits), ROUND_HALF_UP)
        sign = MINUS if exact < 0 else ""
        return sign + f"{abs(exact):f}".replace(".", self.decimal)

    def number(self, value: float) -> str:
        """Three decimals."""
        return self.fixed(value, 3)

    def vector(self, values: Iterable[float]) -> str:
        """(x, y, z), three decimals each."""
        return f"({self.listed(map(self.number, values))})"

    def tone(self, colour: Sequence[float]) -> str:
        """A grey as one number, a colour as three."""
        written = [self.number(value) for value in colour]
        return written[0] if len(set(written)) == 1 else self.vector(colour)

    def listed(self, values: Iterable[str]) -> str:
        """Joined, so that decimals are not misread."""
        return self.between.join(values)

    def percent(self, share: float) -> str:
        """At most one decimal."""
        return re.sub(r"\D0$", "", self.fixed(100 * share, 1)) + "\u202f%"

    def grouped(self, value: int) -> str:
        """Whole numbers as people write them: 11 025."""
        return f"{value:,}".replace(",", self.group)
