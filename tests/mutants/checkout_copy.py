"""A copy of the checkout in which one source file at a time is changed and judged by tests."""

from __future__ import annotations

import ast
import os
import shlex
import shutil
import subprocess
import time
from pathlib import Path

import attrs
from cosmic_ray.mutating import mutate_and_test
from cosmic_ray.testing import run_tests
from cosmic_ray.work_item import MutationSpec, TestOutcome, WorkResult
from judges import Judges

# Seconds for kernels that must be compiled anew, and how much slower a busy machine may be than
# it was when the tests ran on the sources as they are: eight neighbours made it ten times slower.
COMPILING, BUSIER = 60, 20


class TestsFail(Exception):
    """The tests fail on the sources as they are: they cannot judge a mutant."""


class CheckoutCopy:
    """The checkout's files in a folder of their own, with its compiled kernels."""

    def __init__(self, checkout: Path, folder: Path) -> None:
        """Files that git knows or would add are copied; installed packages are shared."""
        self.python = checkout / ".venv/bin/python"
        self.folder, self.kernels = folder, folder / "kernels"
        self.limits: dict[Judges, float] = {}
        listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        for name in subprocess.check_output(listed, cwd=checkout, text=True).split("\0"):
            if name and (checkout / name).is_file():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(checkout / name, folder / name)
        (folder / "node_modules").symlink_to(checkout / "node_modules")

    def appoint(self, judges: Judges) -> None:
        """Runs the tests on the sources as they are: keeps their kernels and their time limit.

        Raises TestsFail.
        """
        started = time.monotonic()
        command = f"env -u PYTHONDONTWRITEBYTECODE {self.command(judges, self.kernels)}"
        outcome, output = run_tests(command, timeout=None)
        if outcome != TestOutcome.SURVIVED:
            raise TestsFail(f"{' '.join(judges.compiled)} fail without any mutant:\n{output}")
        self.limits[judges] = COMPILING + BUSIER * (time.monotonic() - started)

    def judge(self, mutation: MutationSpec, judges: Judges) -> WorkResult:
        """Changes the file, runs the tests until one fails, and puts the file back as it was."""
        file, kernels = self.folder / mutation.module_path, self.folder / "kernels-of-mutant"
        stale = importers(self.folder, mutation.module_path)

        def left_out(folder: str, names: list[str]) -> list[str]:
            module = "raywalk." + Path(folder).name.partition("_")[0]  # geometry_5e1f.../
            return [name for name in names if f"{module}.{name.partition('.')[0]}" in stale]

        shutil.rmtree(kernels, ignore_errors=True)
        shutil.copytree(self.kernels, kernels, ignore=left_out, copy_function=os.link)
        before = file.stat()
        there = attrs.evolve(mutation, module_path=file)
        result = mutate_and_test([there], self.command(judges, kernels), self.limits[judges])
        os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))  # numba asks for it
        return result

    def command(self, judges: Judges, kernels: Path) -> str:
        """Runs those tests until one fails, beginning with those that the last mutant failed."""
        settings = ["env", f"PYTHONPATH={self.folder / 'build'}", f"NUMBA_CACHE_DIR={kernels}"]
        run = [str(self.python), "-m", "pytest", "-x", "--failed-first"]
        steps = [["cd", str(self.folder)]]
        if judges.interpreted:
            steps += [[*settings, "NUMBA_DISABLE_JIT=1", *run, *judges.interpreted]]
        steps += [[*settings, *run, *judges.compiled]]
        return shlex.join(["sh", "-c", " && ".join(map(shlex.join, steps))])


def importers(checkout: Path, changed: Path) -> set[str]:
    """The module and all that import it, or import such a one: kernels compiled into others."""
    package = checkout / "build"
    imports = {dotted(file, package): imported(file) for file in package.rglob("*.py")}
    found = {dotted(checkout / changed, package)}
    while more := {name for name, needs in imports.items() if needs & found} - found:
        found |= more
    return found


def dotted(file: Path, package: Path) -> str:
    """build/raywalk/scene/exact.py as raywalk.scene.exact."""
    return ".".join(file.relative_to(package).with_suffix("").parts).removesuffix(".__init__")


def imported(file: Path) -> set[str]:
    """Modules that the file imports anywhere, and the names it imports from them as if modules."""
    froms = [n for n in ast.walk(ast.parse(file.read_bytes())) if isinstance(n, ast.ImportFrom)]
    modules = {node.module for node in froms if node.module}
    return modules | {f"{node.module}.{alias.name}" for node in froms for alias in node.names}
