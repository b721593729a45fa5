"""What `make` asks for before it installs anything, and that installing runs nobody's code."""

from __future__ import annotations

import json
import os
import re
import subprocess
from pathlib import Path

import pytest

MAKEFILE = Path("Makefile").read_text()
SCRIPT = "build/setup/versions.sh"


def versions(tools, **programs):
    """Exit code and words where there are only these programs, each of which says that version."""
    for name, said in programs.items():
        (tools / name).write_text(f"#!/bin/sh\necho {said}\n")
        (tools / name).chmod(0o755)
    shell = subprocess.run(
        ["sh", "-c", "command -v sh"], capture_output=True, text=True, check=True
    )
    done = subprocess.run(
        [shell.stdout.strip(), SCRIPT], env={"PATH": str(tools)}, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    return done.returncode, done.stderr


@pytest.mark.parametrize("python", ["3.11", "3.12", "3.13", "3.14"])
@pytest.mark.parametrize("node", ["20.0.0", "22.11.0", "100.1.2"])
def test_supported_versions_are_silent(tmp_path, python, node):
    assert versions(tmp_path, python3=python, node=node, npm="10") == (0, "")


@pytest.mark.parametrize(
    ("programs", "said"),
    [
        ({"python3": "3.10"}, "needs Python 3.11 to 3.14 as python3; python3 here is 3.10"),
        ({"python3": "3.15"}, "needs Python 3.11 to 3.14 as python3; python3 here is 3.15"),
        ({"python3": None}, "needs Python 3.11 to 3.14 as python3; there is none here"),
        ({"node": "18.20.1"}, "needs Node 20 or newer with npm; node here is 18.20.1"),
        ({"node": None}, "needs Node 20 or newer with npm; node is missing here"),
        ({"npm": None}, "needs Node 20 or newer with npm; npm is missing here"),
    ],
)
def test_anything_else_is_one_sentence_that_names_what_is_needed(tmp_path, programs, said):
    here = {"python3": "3.11", "node": "20.1.0", "npm": "10"} | programs
    code, words = versions(tmp_path, **{name: said for name, said in here.items() if said})
    assert code == 1 and said in words and len(words.splitlines()) == 1


def test_both_are_told_at_once(tmp_path):
    code, words = versions(tmp_path, python3="2.7", node="8.0.0", npm="6")
    assert code == 1 and len(words.splitlines()) == 2


def test_make_asks_before_it_installs():
    for ready in ("PYTHON_READY", "NODE_READY"):
        assert re.search(rf"^\$\({ready}\):.* \| versions$", MAKEFILE, re.MULTILINE)


def test_what_is_supported_is_said_alike_everywhere():
    assert 'requires-python = ">=3.11,<3.15"' in Path("pyproject.toml").read_text()
    assert json.loads(Path("package.json").read_text())["engines"] == {"node": ">=20"}
    assert "Python 3.11 to 3.14" in Path("README.md").read_text()
    assert "Node 20 or newer" in Path("README.md").read_text()


def test_packages_are_installed_as_wheels_and_without_scripts():
    """An sdist runs its setup, an npm package its postinstall."""
    pip = [line for line in MAKEFILE.splitlines() if "-r requirements" in line]
    assert len(pip) == 3 and all("--only-binary=:all:" in line for line in pip)
    [npm] = [line for line in MAKEFILE.splitlines() if "npm ci" in line]
    assert "--ignore-scripts" in npm
    assert os.access("node_modules/.bin/esbuild", os.X_OK)
