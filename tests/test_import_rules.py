"""Who may import whom (ARCHITECTURE.md), asked of the source itself."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "build" / "raywalk"
VIEWER = ROOT / "site_src" / "viewer"

# What each folder may import of the package, besides itself; folders not listed are free:
# __main__ and its commands, pipeline and bench tie the others together.
MAY_IMPORT = {
    "optics": set(),
    "words": {"home", "work.snapshot"},
    "terms": {"home", "work.snapshot"},
    "models": set(),
    "scene": {"errors", "home", "models", "work.snapshot"},
    "geometry": {"scene", "models", "optics", "errors"},
    "trace": {"geometry", "optics", "scene", "errors"},
    "trace_file": {"trace.kinds", "trace.tree", "optics.compiled", "scene", "errors"},
    "stops": {"words", "trace.tree", "home", "node", "errors"},
    "homework": {"trace", "scene", "errors"},
    # An independent check of the tracer: it shares scenes and the names of what is recorded only.
    "mistakes": {"scene", "trace.tree", "trace.kinds", "errors"},
    # It shows what that does, and what the rays of both are is told by others.
    "mistake_pages": {"mistakes", "scene", "trace.tree", "trace.kinds", "errors"},
    "check": {"mistakes", "trace", "trace_file", "geometry.roots", "scene", "words", "errors"},
    # Stops are traced and written as scenes are; what moves on the stage is scene data.
    "sweeps": {"trace", "trace_file", "site", "scene", "errors"},
    "course": {"models", "scene", "home", "errors"},
    "work": {"home", "node", "errors"},
    "slides": {"scene", "trace.kinds", "words", "terms", "home", "errors"},
    "teacher": {"slides", "scene", "words", "terms", "home", "errors"},
    "site": {
        "scene",
        "trace.kinds",
        "trace.tree",
        "trace_file",
        "mistakes.table",
        "mistake_pages.best",
        "mistake_pages.rounds",
        "words",
        "terms",
        "home",
        "node",
        "errors",
        "work.snapshot",
    },
}
VIEWER_MAY_IMPORT = {
    "trace": {"trace"},
    "state": {"state", "trace"},
    # Of actions stage and panels take the types only: what they may do.
    "stage": {"stage", "state", "trace", "actions"},
    # event-words holds the sentences for the state's events, which only panels show; what a panel
    # shows later is asked of on-demand.
    "panels": {"panels", "state", "trace", "event-words", "on-demand", "actions", "light-page"},
    # Files beside the folders: what is listed knows nothing of who ties it together.
    "palette.ts": {"trace"},
    "light-page.ts": {"trace"},
    "event-words.ts": {"state", "trace"},
    "session.ts": {"state", "trace"},
    # Of what sets switches actions know the names only: it comes when one is set.
    "actions.ts": {"doing", "switch-acts", "session", "state", "trace"},
    "switch-acts.ts": {"doing", "session", "state", "trace"},
    "doing.ts": {"session", "state", "trace"},
    "stops": {"stops", "state", "trace", "event-words", "sweep-words"},
    # What a step works out is a panel, and lines on the stage.
    "worked": {"worked", "panels", "stage", "state", "trace"},
    # A panel that acts on the session, and what it brings to it.
    "sweeps": {"sweeps", "sweep-words", "load", "panels", "session", "state", "trace"},
    "sweep-words.ts": {"state", "trace"},
    "kiosk": {"kiosk", "actions", "session", "state", "panels"},
}
FOR_ANYONE = {"words", "articles", "way-words", "word-keys", "element", "palette", "tile-picture"}


def python_files(folder: str) -> list[Path]:
    """A folder's sources; none while the folder is still to be written."""
    return sorted((PACKAGE / folder).rglob("*.py"))


@cache
def imported(file: Path) -> list[str]:
    """Dotted names of all modules a file imports, at its top or inside functions."""
    return list(_imported(file))


def _imported(file: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{file.name}: imports are absolute here"
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                path = PACKAGE.parent.joinpath(*inner.split("."))
                is_module = path.is_dir() or path.with_suffix(".py").exists()
                yield inner if is_module else str(node.module)


@pytest.mark.parametrize("folder", MAY_IMPORT)
def test_a_folder_imports_only_the_folders_below_it(folder: str) -> None:
    """Every import of raywalk modules stays within the folder or goes to one it may know."""
    allowed = {f"raywalk.{name}" for name in MAY_IMPORT[folder] | {folder}}
    for file in python_files(folder):
        for name in imported(file):
            if name.split(".")[0] == "raywalk":
                known = any(name == a or name.startswith(a + ".") for a in allowed)
                assert known, f"{folder}/{file.name} imports {name}"


def test_optics_knows_numpy_and_numba_only() -> None:
    """Pure kernels: beyond the standard library nothing else is imported."""
    outside = {"numpy", "numba", "raywalk", *sys.stdlib_module_names}
    for file in python_files("optics"):
        found = {name.split(".")[0] for name in imported(file)}
        assert found <= outside, f"optics/{file.name} imports {found - outside}"


@pytest.mark.parametrize("engine", ["trimesh", "embreex"])
def test_only_geometry_knows_the_mesh_engines(engine: str) -> None:
    """Float32 and misses end in geometry; bench compares engines, so it knows them too."""
    for file in sorted(PACKAGE.rglob("*.py")):
        if file.relative_to(PACKAGE).parts[0] not in ("geometry", "bench"):
            found = {name.split(".")[0] for name in imported(file)}
            assert engine not in found, f"{file.relative_to(PACKAGE)} imports {engine}"


def test_a_build_knows_nothing_of_the_bench() -> None:
    """What measures the pipeline stands above it: only its two commands import it."""
    allowed = {"bench", "commands/bench.py", "commands/stress.py"}
    for file in sorted(PACKAGE.rglob("*.py")):
        place = file.relative_to(PACKAGE)
        if place.parts[0] not in allowed and place.as_posix() not in allowed:
            found = [name for name in imported(file) if name.startswith("raywalk.bench")]
            assert not found, f"{place} imports {found[0]}"


def test_start_up_needs_no_engine() -> None:
    """A run with nothing to trace does not import numba, trimesh or embreex (0.8 to 1.2 s):
    no module that reads scenes imports them at its top."""
    for folder in (
        "scene",
        "models",
        "trace_file",
        "stops",
        "words",
        "site",
        "slides",
        "teacher",
        "work",
    ):
        for file in python_files(folder):
            found = {name.split(".")[0] for name in imported(file)}
            assert not found & {"numba", "trimesh", "embreex"}, file.name


def typescript_files(part: str) -> list[Path]:
    """A folder's modules, or the one file."""
    at = VIEWER / part
    return [at] if at.is_file() else sorted(at.rglob("*.ts"))


def without_comments_and_strings(source: str) -> str:
    """Code only: a word in a comment or a text is no knowledge of the DOM."""
    token = r"""/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`"""
    return re.sub(token, " ", source, flags=re.DOTALL)


def viewer_imports(file: Path) -> Iterator[str]:
    """What a viewer module imports: packages by name, own modules by path below viewer/."""
    statement = (
        r"""^(?:import|export)\b[^;"'=(]*?\bfrom\s*["']([^"']+)["']"""
        r"""|\bimport\s*\(?\s*["']([^"']+)["']"""
    )
    for named in re.findall(statement, file.read_text("utf-8"), flags=re.MULTILINE):
        name = "".join(named)
        if name.endswith(".json"):
            continue  # a table that the pipeline reads too
        if name.startswith("."):
            yield (file.parent / name).resolve().relative_to(VIEWER.resolve()).as_posix()
        else:
            yield name


@pytest.mark.parametrize("part", VIEWER_MAY_IMPORT)
def test_a_part_of_the_viewer_imports_only_what_it_may(part: str) -> None:
    """main -> stage, panels -> state -> trace; stage and panels do not know each other."""
    files = typescript_files(part)
    assert files, f"viewer/{part} is not there"
    for file in files:
        for name in viewer_imports(file):
            top = name.split("/")[0]
            known = top in VIEWER_MAY_IMPORT[part] or name in FOR_ANYONE
            assert known or (name.startswith("three") and part == "stage"), (
                f"viewer/{file.relative_to(VIEWER)} imports {name}"
            )


def test_no_modules_of_the_viewer_import_one_another_in_a_circle() -> None:
    """Imports of types count too: where types meet, a module of types alone lies below both."""
    graph = {
        file.relative_to(VIEWER).with_suffix("").as_posix(): set(viewer_imports(file))
        for file in typescript_files(".")
    }
    unknown = (
        set().union(*graph.values()) - set(graph) - {"three", "word-keys", "trace/pipeline-types"}
    )
    assert not unknown, f"imports that are no module's path: {unknown}"  # a circle could hide there
    TopologicalSorter(graph).prepare()  # raises CycleError, which names the circle


def test_only_the_stage_knows_three() -> None:
    """Another renderer would be another folder."""
    for file in typescript_files("."):
        if not file.is_relative_to(VIEWER / "stage"):
            assert not [name for name in viewer_imports(file) if name.startswith("three")], file


@pytest.mark.parametrize("folder", ["trace", "state", "stops"])
def test_trace_and_state_know_no_browser(folder: str) -> None:
    """They run in node as they are: no document, no window."""
    for file in typescript_files(folder):
        code = without_comments_and_strings(file.read_text("utf-8"))
        found = re.findall(
            r"(?<![\w.])(?:document|window|navigator|HTMLElement)\b(?!\s*[?]?:)", code
        )
        assert not found, f"viewer/{folder}/{file.name} knows {found[0]}"


def test_checks_of_pictures_know_no_browser_and_no_viewer() -> None:
    """site_src/check runs in pages and in node: it imports itself, what reads PNG and JPEG, and the
    words that all speak with; its page also builds elements as the viewer does. That the rest names
    nothing of the DOM its own tsconfig.json sees to, which does not have it."""
    folder = VIEWER.parent / "check"
    files = sorted(folder.rglob("*.ts"))
    assert files
    for file in files:
        named = re.findall(r"""\bfrom\s*["']([^"']+)["']""", file.read_text("utf-8"))
        outside = {n for n in named if not (file.parent / n).resolve().is_relative_to(folder)}
        packages = {n for n in named if not n.startswith(".")}
        viewers = {name.rpartition("/")[2] for name in outside - packages}
        of_page = file.parent.name == "page"
        assert viewers <= (FOR_ANYONE if of_page else {"words", "word-keys", "articles"}), file
        assert packages <= {"fast-png", "fflate", "jpeg-js/lib/decoder"}, file
    assert "DOM" not in (folder / "tsconfig.json").read_text("utf-8")


def test_who_reads_a_trace_never_imports_numba() -> None:
    """A build with nothing to trace, and what reads its files, never pays for the compiler."""
    command = (
        "import sys, raywalk.trace_file, raywalk.pipeline.site; sys.exit('numba' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", command], check=False).returncode == 0
