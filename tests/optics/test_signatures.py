"""A kernel is compiled once, not anew for what its callers hand it by chance.

Looks at what is kept of the kernels that `make` compiled; tests may hand them other things.
"""

from __future__ import annotations

import pickle
from collections import defaultdict
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import numba
import numpy as np
import pytest
from numba.core import types

from raywalk.geometry.compiled import rays_from
from raywalk.optics.compiled import inlined, kernel, lean
from raywalk.optics.compiling import alike

BUILT = Path(__file__).parents[2] / "dist" / "index.html"


def kept() -> Iterator[tuple[str, list[tuple[Any, ...]]]]:
    """Each kernel's name in its module's file, and the signatures it was compiled for."""
    until = BUILT.stat().st_mtime
    for index in Path(str(numba.config.CACHE_DIR)).rglob("*.nbi"):  # type: ignore[attr-defined]
        with index.open("rb") as file:
            pickle.load(file)  # numba's version
            _, found = pickle.loads(file.read())
        code = {index.parent / name: signature for (signature, *_), name in found.items()}
        signatures = [each for path, each in code.items() if path.stat().st_mtime <= until]
        yield index.name.partition("-")[0], signatures


def in_kind(kind: Any) -> Any:
    """Without what a caller may have otherwise: layout, width, whole numbers or not, constants."""
    kind = types.unliteral(kind)
    if isinstance(kind, types.Array):
        return "array", kind.ndim, kind.dtype if isinstance(kind.dtype, types.Record) else "numbers"
    if isinstance(kind, types.BaseTuple):
        return tuple(in_kind(each) for each in kind.types)
    return "number" if isinstance(kind, types.Number) else kind


def is_inlined(name: str) -> bool:
    """Of one of ours, whether it is copied into its callers, for each constant of theirs."""
    module, _, function = name.rpartition(".")
    for room in ("geometry", "trace", "trace_file", "optics"):
        try:
            found = getattr(import_module(f"raywalk.{room}.{module}"), function)
        except (ImportError, AttributeError):
            continue
        return bool(found.targetoptions.get("forceinline"))
    return False


def test_no_kernel_was_compiled_twice_for_what_makes_no_code_faster() -> None:
    """A scene's eye in whole numbers once had everything that meets rays compiled anew: a tenth of
    a first build. Of what is copied into its callers, constants may differ."""
    kernels = {name: signatures for name, signatures in kept() if signatures}
    if not kernels:
        pytest.skip("the site was built before the kernels' sources were last changed: make")
    assert len(kernels) > 20, "what make compiled is kept"
    for name, signatures in kernels.items():
        alike_but_for_chance = defaultdict(list)
        for signature in signatures:
            alike_but_for_chance[tuple(map(in_kind, signature))].append(signature)
        for group in alike_but_for_chance.values():
            arrays = {tuple(kind for kind in each if not is_number(kind)) for each in group}
            assert len(arrays) == 1, (name, arrays)
            assert len(group) == 1 or is_inlined(name), (name, group)


def is_number(kind: Any) -> bool:
    return isinstance(types.unliteral(kind), types.Number | types.Boolean)


@pytest.mark.parametrize("made", [kernel, lean])
def test_a_constant_and_the_width_of_an_index_make_no_other_code(made: Any) -> None:
    @made
    def inner(values, k):  # type: ignore[no-untyped-def]
        return values[k]

    @kernel
    def outer(values, k):  # type: ignore[no-untyped-def]
        return inner(values, 0) + inner(values, 1) + inner(values, k)

    values = np.arange(5.0)
    assert [outer(values, np.int32(2)), outer(values, 3), inner(values, 4)] == [3.0, 4.0, 4.0]
    assert len(inner.signatures) == len(outer.signatures) == 1


def test_what_is_copied_into_its_callers_knows_their_constants() -> None:
    @inlined
    def inner(values, k):  # type: ignore[no-untyped-def]
        return values[k]

    @kernel
    def outer(values):  # type: ignore[no-untyped-def]
        return inner(values, 0) + inner(values, 1)

    assert outer(np.arange(3.0)) == 1.0
    assert len(inner.signatures) == 2


def test_a_signature_keeps_what_it_is_to_give_back() -> None:
    asked = types.float64(types.int32, types.literal(3), types.float64[:])
    assert alike(asked) == types.float64(types.int64, types.int64, types.float64[:])
    assert alike(asked.args) == (types.int64, types.int64, types.float64[:])


def test_rays_in_whole_numbers_and_in_another_layout_are_as_all_others() -> None:
    frame = np.arange(12).reshape(3, 4).T
    rays = rays_from(np.tile([0, 0, 5], (4, 1)), frame)
    for column in (rays.origin, rays.direction):
        assert column.dtype == float
        assert column.flags.c_contiguous
    assert np.array_equal(rays.direction, frame)
