"""The node process that the pipeline asks: answers in turn, and a sentence for what goes wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.stops import process
from raywalk.stops.process import Stops


def test_one_process_answers_request_after_request(tmp_path: Path):
    """Also after one that could not be followed, which is named."""
    missing = {"do": "events", "scene": str(tmp_path / "scene.js"), "trace": "", "words": {}}
    with Stops() as stops:
        for _ in range(2):
            with pytest.raises(SourceErrors, match=r"no such file.*scene\.js"):
                stops.ask(missing)


def test_without_node_it_says_what_is_missing(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("PATH", "")
    with Stops() as stops, pytest.raises(SourceErrors, match="node is not installed"):
        stops.ask({})


def test_without_its_packages_it_says_so_too(tmp_path: Path):
    """The script where no node_modules are: one sentence, not node's trace."""
    lost = tmp_path / "stops.mjs"
    for name in ("stops.mjs", "modules.mjs"):
        lost.with_name(name).write_bytes(process.SCRIPT.with_name(name).read_bytes())
    with Stops(lost) as stops, pytest.raises(SourceErrors) as raised:
        stops.ask({})
    message = str(raised.value)
    assert "Cannot find package 'esbuild'" in message and "npm ci" in message
    assert len(message.splitlines()) <= 3


def test_a_process_that_is_not_asked_is_not_started():
    with Stops() as stops:
        assert stops._node is None
