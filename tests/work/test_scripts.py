"""What a script is made from, beside what its bundler takes in."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

from raywalk.work.closure import PACKAGE
from raywalk.work.scripts import script_closure

SITE = PACKAGE.parents[1] / "site_src"
BUNDLE = """
import { build } from "esbuild";
const { metafile } = await build({ entryPoints: [process.argv[1]], bundle: true, write: false,
  metafile: true, external: ["three"], logLevel: "error" });
console.log(JSON.stringify(Object.keys(metafile.inputs)));
"""


@pytest.mark.parametrize(
    "entry", ["viewer/main.ts", "viewer/kiosk/main.ts", "viewer/stops/main.ts"]
)
def test_a_scripts_files_are_those_that_esbuild_bundles(entry):
    """To the file, tables of the pipeline's too; npm's come with their versions."""
    command = ["node", "--input-type=module", "-e", BUNDLE, str(SITE / entry)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=SITE.parent)
    bundled = {SITE.parent / path for path in json.loads(done.stdout)}
    files, _ = script_closure(SITE / entry)
    assert files == {path for path in bundled if "node_modules" not in path.parts}


def test_a_bundler_is_made_from_its_entries_too():
    """They are texts in it, not imports."""
    files, packages = script_closure(SITE / "bundle.mjs")
    assert {
        SITE / "viewer/main.ts",
        SITE / "viewer/kiosk/main.ts",
        SITE / "strip-rays.mjs",
    } <= files
    assert {"esbuild", "acorn", "three"} <= packages


def test_types_are_no_part_of_a_script(tmp_path: Path):
    """They leave nothing behind; what is imported when it is asked for does."""
    (tmp_path / "main.ts").write_text(
        'import type { A } from "./types";\nimport { b } from "./b";\nexport * from "@x/y/z.js";\n'
        'export type { C } from "./types";\nconst c = () => import("./c.ts");\n'
    )
    for name in ("types", "b", "c"):
        (tmp_path / f"{name}.ts").write_text("")
    files, packages = script_closure(tmp_path / "main.ts")
    assert sorted(path.name for path in files) == ["b.ts", "c.ts", "main.ts"]
    assert packages == {"@x/y"}
