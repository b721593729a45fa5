"""Changes the sources in one place at a time and asks the tests: does any of them notice?

`make mutants SAMPLE=200 SEED=1` draws that many such changes ("mutants") of each folder; without
SAMPLE all of them are run, which takes a night. A mutant is killed (a test failed), stopped at its
time limit, or survives: a survivor is printed as file:line and difference. cosmic-ray makes the
mutants (mutations.py), in copies of the checkout (checkout_copy.py), and each is judged by the
tests that concern its file (judges.py).
"""

from __future__ import annotations

import argparse
import queue
import random
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from checkout_copy import CheckoutCopy, TestsFail
from cosmic_ray.work_item import MutationSpec, TestOutcome, WorkerOutcome, WorkResult
from judges import FILES, FOLDERS, UNJUDGED, is_judged, judges_of
from mutations import mutations_of

ROOT = Path(__file__).parents[2]
PACKAGE = Path("build/raywalk")


def main() -> int:
    """0 if every mutant was noticed, 1 if one survived, 2 if nothing was proved."""
    arguments = read_arguments()
    if gone := [name for name in (*FILES, *UNJUDGED) if not (ROOT / PACKAGE / name).exists()]:
        sys.exit(f"judges.py names files that are not there: {', '.join(gone)}")
    mutants = drawn(arguments)
    groups = sorted({judges_of(mutant.module_path) for mutant in mutants})
    with tempfile.TemporaryDirectory(prefix="raywalk-mutants-") as folder:
        copies = [CheckoutCopy(ROOT, Path(folder) / str(job)) for job in range(arguments.jobs)]
        try:
            for group in groups:
                print(f"without a mutant: {' '.join(group.compiled)}", flush=True)
                with ThreadPoolExecutor(len(copies)) as threads:
                    list(threads.map(CheckoutCopy.appoint, copies, [group] * len(copies)))
        except TestsFail as failure:
            print(failure)
            return 2
        counts = run(mutants, copies)
    print(", ".join([f"{len(mutants)} mutants", *(f"{counts[name]} {name}" for name in NAMES)]))
    if counts["not run"] or not counts:
        print("mutants that are not run prove nothing")
        return 2
    return 1 if counts["survived"] else 0


def read_arguments() -> argparse.Namespace:
    """What the command line asks for."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--sample", type=int, help="mutants of each folder (default: all)")
    parser.add_argument("--seed", type=int, default=1, help="which sample (default: 1)")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at a time (default: 1)")
    parser.add_argument("--only", nargs="*", help="folders or files below build/raywalk/")
    return parser.parse_args()


def drawn(arguments: argparse.Namespace) -> list[MutationSpec]:
    """The mutants to run; a folder's sample is the same whichever others are asked for."""
    mutants = []
    for name in arguments.only or FOLDERS:
        place = ROOT / PACKAGE / name
        if not place.exists() or Path(name).parts[0] not in FOLDERS:
            sys.exit(f"{name} is no file or folder of {', '.join(FOLDERS)} below {PACKAGE}/")
        files = sorted(place.glob("*.py")) if place.is_dir() else [place]
        judged = [file.relative_to(ROOT) for file in files if is_judged(file)]
        found = [mutation for file in judged for mutation in mutations_of(file)]
        print(f"{name}: {len(found)} mutants", flush=True)
        if arguments.sample is not None and arguments.sample < len(found):
            found = random.Random(arguments.seed).sample(found, arguments.sample)
        mutants += sorted(found, key=lambda m: (m.module_path, m.start_pos))
    return mutants


NAMES = ("killed", "timeout", "survived", "not run")


def run(mutants: list[MutationSpec], copies: list[CheckoutCopy]) -> Counter[str]:
    """Judges every mutant in the next copy that is free, and prints those that survive."""
    free: queue.SimpleQueue[CheckoutCopy] = queue.SimpleQueue()
    for copy in copies:
        free.put(copy)

    def judged(mutant: MutationSpec) -> tuple[MutationSpec, WorkResult]:
        copy = free.get()
        try:
            return mutant, copy.judge(mutant, judges_of(mutant.module_path))
        finally:
            free.put(copy)

    counts: Counter[str] = Counter()
    threads = ThreadPoolExecutor(len(copies))
    try:
        for future in as_completed(threads.submit(judged, mutant) for mutant in mutants):
            mutant, result = future.result()
            name = outcome(result)
            counts[name] += 1
            line = f"{mutant.module_path}:{mutant.start_pos[0]}"
            print(f"{counts.total()}/{len(mutants)} {name} {line}", flush=True)
            if name in ("survived", "not run"):
                print(changed_lines(result), flush=True)
    finally:  # also when a person has seen enough
        threads.shutdown(cancel_futures=True)
    return counts


def outcome(result: WorkResult) -> str:
    """One of NAMES. cosmic-ray counts a run past its limit as killed, and says so as output."""
    if result.worker_outcome != WorkerOutcome.NORMAL:
        return "not run"
    if result.output == "timeout":
        return "timeout"
    return {TestOutcome.KILLED: "killed", TestOutcome.SURVIVED: "survived"}.get(
        result.test_outcome, "not run"
    )


def changed_lines(result: WorkResult) -> str:
    """The line as it was and as it became; what cosmic-ray says where there is no difference."""
    lines = (result.diff or "").splitlines()
    changed = [line for line in lines if line[:1] in ("-", "+") and line[:3] not in ("---", "+++")]
    return "\n".join(changed) or result.output or ""


if __name__ == "__main__":
    sys.exit(main())
