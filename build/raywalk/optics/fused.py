"""a b + c rounded once, as processors have it: numba gives kernels no other way to it."""

from __future__ import annotations

from typing import Any

from numba import types
from numba.extending import intrinsic


def _typed(context: Any, a: Any, b: Any, c: Any) -> Any:
    """LLVM's fma: one instruction, or the C library's function where a processor has none."""

    def written(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        return builder.fma(*values)

    return types.float64(types.float64, types.float64, types.float64), written


fused: Any = intrinsic(_typed)
