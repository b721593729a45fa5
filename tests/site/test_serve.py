"""make serve: the built site at a local address."""

from __future__ import annotations

import http.client
import threading
import urllib.request
from contextlib import contextmanager

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


def test_nothing_built_is_said(tmp_path, capsys):
    """With what to do about it."""
    assert main(["serve", "--site", str(tmp_path)]) == 1
    assert "run raywalk build, or make" in capsys.readouterr().err


@pytest.mark.parametrize("port", ["-1", "99999"])
def test_a_port_that_cannot_be_is_named(tmp_path, capsys, port):
    """Without a traceback."""
    (tmp_path / "index.html").write_text("hello", encoding="utf-8")
    assert main(["serve", "--site", str(tmp_path), "--port", port]) == 1
    assert f"cannot serve on port {port}" in capsys.readouterr().err


@contextmanager
def served(folder):
    """Asks a server of this folder for an address, with some headers: status and body."""
    with server(folder, 0) as service:
        threading.Thread(target=service.serve_forever, daemon=True).start()

        def ask(address, host=None):
            line = http.client.HTTPConnection("127.0.0.1", service.server_port)
            line.putrequest("GET", address, skip_host=True)
            if host != "":
                line.putheader("Host", host or f"127.0.0.1:{service.server_port}")
            line.endheaders()
            answer = line.getresponse()
            return answer.status, answer.read()

        yield ask
        service.shutdown()


@pytest.mark.parametrize("host", ["127.0.0.1", "localhost", "LOCALHOST:8000", "[::1]:8000"])
def test_a_page_of_this_machine_is_answered(tmp_path, host):
    (tmp_path / "index.html").write_text("hello")
    with served(tmp_path) as ask:
        assert ask("/", host) == (200, b"hello")


@pytest.mark.parametrize(
    "host", ["evil.example", "localhost.evil.example", "127.0.0.1.nip.io:80", ""]
)
def test_a_page_that_calls_this_address_by_another_hosts_name_is_refused(tmp_path, host):
    """Else any page on the web could read the site by DNS rebinding."""
    (tmp_path / "index.html").write_text("hello")
    with served(tmp_path) as ask:
        status, body = ask("/", host)
    assert status == 403 and b"hello" not in body


@pytest.mark.parametrize(
    "address", ["/%00", "/a%00.html", "/%ff", "/%e4.js", "/%c3%28/", "/%ed%a0%80"]
)
def test_an_address_that_no_file_can_have_is_a_bad_request(tmp_path, address):
    """Zero bytes, Latin-1, broken and lone surrogate UTF-8; the next request is served as ever."""
    (tmp_path / "index.html").write_text("hello")
    with served(tmp_path) as ask:
        assert ask(address)[0] == 400
        assert ask("/") == (200, b"hello")
