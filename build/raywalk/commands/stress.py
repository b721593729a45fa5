"""raywalk stress: the tracer's hardest cases, each with its bound."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

RAYS = 1_000_000
SEED = 20_260


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("stress", help="measure the hardest cases against their bounds")
    parser.add_argument("--rays", type=int, default=RAYS, help="rays a case (default %(default)s)")
    parser.add_argument("--seed", type=int, default=SEED, help="of all random rays")
    parser.add_argument("--only", nargs="*", help="subjects to run; all if none is named")
    parser.add_argument("--work", type=Path, default=Path(".work"), help="where reports are kept")
    parser.add_argument("--out", type=Path, default=Path("dist"), help="the site the page goes to")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """A line a case as it is measured. Raises BrokenBounds at the end if any is broken."""
    from raywalk.bench.cases import Case, refuse_broken
    from raywalk.bench.report import keep_stress, publish_page
    from raywalk.bench.stress import SUBJECTS, stress
    from raywalk.errors import SourceError, SourceErrors

    unknown = set(chosen.only or ()) - set(SUBJECTS)
    if unknown:
        problem = f"no subject is named {', '.join(sorted(unknown))}"
        known = SourceError(Path("stress"), "--only", problem, "known: " + ", ".join(SUBJECTS))
        raise SourceErrors([known])
    yield f"seed {chosen.seed}, {chosen.rays:,} rays a case"
    cases: list[Case] = []
    for case in stress(chosen.rays, chosen.seed, chosen.only):
        if not cases or cases[-1].subject != case.subject:
            yield case.subject
        cases.append(case)
        yield case.as_line()
    if not chosen.only:
        keep_stress(chosen.work, cases, chosen.rays, chosen.seed)
        yield from publish_page(chosen.work, chosen.out)
    yield f"{sum(case.holds for case in cases)} of {len(cases)} bounds hold"
    refuse_broken(cases)
