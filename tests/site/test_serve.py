"""make serve: the built site at a local address."""

from __future__ import annotations

import threading
import urllib.request

import pytest

from raywalk.__main__ import main
from raywalk.site.serve import server


def test_the_site_is_served_on_this_machine_and_never_cached(tmp_path):
    """A rebuilt page shows at the next reload; nobody else on the network can reach it."""
    (tmp_path / "index.html").write_text("hello", encoding="utf-8")
    with server(tmp_path, 0) as service:
        assert service.server_address[0] == "127.0.0.1"
        threading.Thread(target=service.serve_forever, daemon=True).start()
        with urllib.request.urlopen(f"http://127.0.0.1:{service.server_port}/") as answer:
            assert answer.read() == b"hello"
            assert answer.headers["Cache-Control"] == "no-store"
        service.shutdown()


def test_nothing_built_is_told(tmp_path, capsys):
    """With what to do about it."""
    assert main(["serve", "--site", str(tmp_path)]) == 1
    assert "run make" in capsys.readouterr().err


@pytest.mark.parametrize("port", ["-1", "99999"])
def test_a_port_that_cannot_be_is_told(tmp_path, capsys, port):
    """Without a traceback."""
    (tmp_path / "index.html").write_text("hello", encoding="utf-8")
    assert main(["serve", "--site", str(tmp_path), "--port", port]) == 1
    assert f"cannot serve on port {port}" in capsys.readouterr().err
