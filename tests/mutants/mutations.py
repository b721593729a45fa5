"""The changes of a source file that are worth a run of its tests."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from cosmic_ray.ast import ast_nodes, get_ast_from_path
from cosmic_ray.plugins import get_operator
from cosmic_ray.work_item import MutationSpec

# Of cosmic-ray's 190 operators those a slip of the pen could make. The others (a sum turned into a
# shift, `<` into `is`) fail in the first test that runs the line and prove no more than that.
BINARY = (
    "Add_Sub Sub_Add Mul_Div Div_Mul FloorDiv_Mul Mod_FloorDiv Pow_Mul"
    " BitOr_BitAnd BitAnd_BitOr BitXor_BitOr LShift_RShift RShift_LShift"
)
COMPARISON = (
    "Eq_NotEq NotEq_Eq Lt_LtE LtE_Lt Gt_GtE GtE_Gt Lt_Gt Gt_Lt LtE_GtE GtE_LtE Is_IsNot IsNot_Is"
)
UNARY = "Delete_USub Delete_Not Delete_Invert"
OTHERS = (
    "AddNot ReplaceTrueWithFalse ReplaceFalseWithTrue ReplaceAndWithOr ReplaceOrWithAnd"
    " ReplaceBreakWithContinue ReplaceContinueWithBreak ExceptionReplacer NumberReplacer"
    " RemoveDecorator ZeroIterationForLoop"
)
OPERATORS = [
    *(f"ReplaceBinaryOperator_{name}" for name in BINARY.split()),
    *(f"ReplaceComparisonOperator_{name}" for name in COMPARISON.split()),
    *(f"ReplaceUnaryOperator_{name}" for name in UNARY.split()),
    *OTHERS.split(),
]
# Without these nothing changes but the time it takes.
SPEED_ONLY = {"@kernel", "@inlined", "@cache", "@lru_cache"}


def mutations_of(file: Path) -> Iterator[MutationSpec]:
    """Every mutation of the file by OPERATORS that could change what it does."""
    tree = get_ast_from_path(file)
    for name in OPERATORS:
        operator = get_operator(f"core/{name}")()
        places = (
            (node, *at) for node in ast_nodes(tree) for at in operator.mutation_positions(node)
        )
        for occurrence, (node, start, end) in enumerate(places):
            if not is_idle(node):
                yield MutationSpec(file, f"core/{name}", occurrence, start, end)


def is_idle(node) -> bool:
    """Whether the parso node says nothing that runs: a type's `|`, a decorator of SPEED_ONLY."""
    if node.type == "decorator":
        return node.get_code(include_prefix=False).strip() in SPEED_ONLY
    around = node.search_ancestor("suite", "param", "annassign", "funcdef")
    in_a_type = around is not None and around.type != "suite"
    return node.type == "operator" and node.value == "|" and in_a_type
