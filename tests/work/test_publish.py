"""A site takes the place of the one before, whole, and takes nothing of anybody else's."""

from __future__ import annotations

import errno
import os
import random
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from raywalk.__main__ import main
from raywalk.bench import stress_kills
from raywalk.errors import SourceErrors, disk_trouble
from raywalk.work import publish
from raywalk.work.leftovers import abandoned
from raywalk.work.ownership import MARKER
from raywalk.work.store import Store


def write_site(out, text="new"):
    with publish.staged(out) as fresh:
        (fresh / "index.html").write_text(text)


@pytest.fixture(params=["exchange", "renames"])
def way(request, monkeypatch):
    """In one step; or in two renames, where the system has no such step."""
    if request.param == "renames":
        monkeypatch.setattr(publish, "exchange", lambda one, other: False)


def names(folder):
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*"))


def test_a_site_replaces_the_one_before_and_leaves_nothing_beside(tmp_path, way):
    write_site(tmp_path / "dist", "old")
    write_site(tmp_path / "dist")
    assert (tmp_path / "dist" / "index.html").read_text() == "new"
    assert names(tmp_path) == ["dist", f"dist/{MARKER}", "dist/index.html"]


def test_a_folder_that_holds_something_else_is_refused_untouched(tmp_path):
    (tmp_path / "thesis.txt").write_text("years of work")
    with pytest.raises(SourceErrors, match=r"was not made by Raywalk .*thesis.txt"):
        write_site(tmp_path)
    assert names(tmp_path) == ["thesis.txt"]


@pytest.mark.parametrize("said", ["settings\nindex.html\n", "", "\xff"])
def test_another_programs_file_of_our_markers_name_is_no_leave(tmp_path, said):
    """It could even list the files beside it."""
    (tmp_path / MARKER).write_bytes(said.encode("latin-1"))
    (tmp_path / "index.html").write_text("mine")
    with pytest.raises(SourceErrors, match="which is no list of ours"):
        write_site(tmp_path)
    assert (tmp_path / "index.html").read_text() == "mine"


def test_links_in_a_circle_and_names_too_long_are_refused(tmp_path):
    (tmp_path / "one").symlink_to("two")
    (tmp_path / "two").symlink_to("one")
    for name in ("one", "x" * 300):
        with pytest.raises(SourceErrors, match="is no place for a site"):
            write_site(tmp_path / name)


@pytest.mark.parametrize("out", ["scenes/dist", "scenes/01/dist", "work/dist", "."])
def test_a_site_lies_in_nothing_that_builds_read(tmp_path, monkeypatch, capsys, out):
    """Nor do they lie in it: `serve` would build for ever, and each site hold the one before."""
    (tmp_path / "all" / "scenes" / "01").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "all")
    write_site(Path("other"))
    Path("other", MARKER).rename(MARKER)  # so that "." is a site's folder
    for command in ("site", "serve"):
        assert main([command, "--out", out, "--work", "work"]) == 1
        said = capsys.readouterr().err
        assert "which builds read" in said and "choose another --out" in said


@pytest.mark.parametrize("place", ["dist", "dist/site"])
def test_a_file_in_the_sites_place_is_refused_untouched(tmp_path, place):
    (tmp_path / "dist").write_text("notes")
    with pytest.raises(SourceErrors, match="dist: is a file; a site needs a folder"):
        write_site(tmp_path / place)
    assert (tmp_path / "dist").read_text() == "notes"


@pytest.mark.parametrize("out", [".", "scenes", "course"])
def test_the_command_refuses_before_it_traces_anything(tmp_path, monkeypatch, capsys, out):
    """All that `raywalk site` says is where, why and the way out; the exit code is 1."""
    monkeypatch.chdir(tmp_path)
    for folder in ("scenes", "course"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "mine.toml").write_text("mine")
    before = names(tmp_path)
    assert main(["site", "--out", out]) == 1
    said = capsys.readouterr()
    assert "was not made by Raywalk" in said.err and "choose another --out" in said.err
    assert not said.out and names(tmp_path) == before


def test_an_empty_folder_is_taken(tmp_path):
    (tmp_path / "dist").mkdir()
    write_site(tmp_path / "dist")
    assert (tmp_path / "dist" / "index.html").is_file()


def test_a_site_from_before_there_were_marks_is_ours(tmp_path):
    out = tmp_path / "dist"
    out.mkdir()
    for name in ("LICENSES.txt", "sizes.json", "sw.js", "index.html"):
        (out / name).write_text("old")
    write_site(out)
    assert names(out) == [MARKER, "index.html"]


def test_of_a_site_without_a_list_all_that_may_be_anybody_elses_stays(tmp_path):
    for name in ("LICENSES.txt", "sizes.json", "sw.js", "index.html", "thesis.txt"):
        (tmp_path / name).write_text("old")
    write_site(tmp_path)
    assert names(tmp_path) == [MARKER, "index.html", "thesis.txt"]


def test_an_empty_folder_of_a_repository_stays(tmp_path, way):
    """After `git gc` refs/heads is empty, and without it git finds no repository."""
    out = tmp_path / "dist"
    with publish.staged(out) as fresh:
        (fresh / "slides").mkdir()
        (fresh / "slides" / "deck.pdf").write_text("old")
    (out / ".git" / "refs" / "heads").mkdir(parents=True)
    write_site(out)
    assert names(out) == sorted([".git", ".git/refs", ".git/refs/heads", MARKER, "index.html"])


def test_a_file_that_is_not_ours_is_never_written_over(tmp_path, way):
    """Put there before a site had one of its name; the site before stays, and so does the file."""
    out = tmp_path / "dist"
    with publish.staged(out) as fresh:
        (fresh / "index.html").write_text("old")
    (out / "robots.txt").write_text("mine")
    with (
        pytest.raises(SourceErrors, match=r"robots\.txt: is not ours, and a new file of the site"),
        publish.staged(out) as fresh,
    ):
        (fresh / "index.html").write_text("new")
        (fresh / "robots.txt").write_text("theirs")
    assert (out / "index.html").read_text() == "old"
    assert (out / "robots.txt").read_text() == "mine"
    assert [path.name for path in tmp_path.iterdir()] == ["dist"]


def test_what_somebody_put_beside_our_files_stays_and_our_old_files_go(tmp_path, way):
    """A host's CNAME; the .git of a worktree; a link, as a link."""
    out = tmp_path / "dist"
    with publish.staged(out) as fresh:
        (fresh / "old.html").write_text("old")
    (out / "CNAME").write_text("rays.example")
    (out / ".git").mkdir()
    (out / ".git" / "HEAD").write_text("ref")
    (out / "link").symlink_to("nowhere")
    for text in ("new", "newer"):
        write_site(out, text)
        expected = [".git", ".git/HEAD", MARKER, "CNAME", "index.html", "link"]
        assert names(out) == sorted(expected)
        assert (out / "CNAME").read_text() == "rays.example"
        assert os.readlink(out / "link") == "nowhere"


def test_through_a_link_the_site_goes_where_it_leads(tmp_path, way):
    (tmp_path / "www").mkdir()
    (tmp_path / "dist").symlink_to("www")
    for text in ("old", "new"):
        write_site(tmp_path / "dist", text)
    assert (tmp_path / "dist").is_symlink()
    assert (tmp_path / "www" / "index.html").read_text() == "new"


def test_a_site_that_fails_leaves_the_one_before(tmp_path, way):
    write_site(tmp_path / "dist", "old")
    with pytest.raises(ZeroDivisionError), publish.staged(tmp_path / "dist") as fresh:
        (fresh / "index.html").write_text("half")
        raise ZeroDivisionError
    assert names(tmp_path) == ["dist", f"dist/{MARKER}", "dist/index.html"]
    assert (tmp_path / "dist" / "index.html").read_text() == "old"


def test_a_rename_that_fails_puts_the_old_site_back(tmp_path, monkeypatch):
    write_site(tmp_path / "dist", "old")
    monkeypatch.setattr(publish, "exchange", lambda one, other: False)
    move = publish._move

    def refused(folder, place):
        if folder.name == publish.REPLACED:
            raise OSError(errno.EACCES, "Permission denied")
        return move(folder, place)

    monkeypatch.setattr(publish, "_move", refused)
    with pytest.raises(OSError, match="denied"):
        write_site(tmp_path / "dist")
    assert (tmp_path / "dist" / "index.html").read_text() == "old"
    assert names(tmp_path) == ["dist", f"dist/{MARKER}", "dist/index.html"]


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("way", ["exchange", "renames"])
def test_killed_at_any_instant_a_whole_site_stands_or_is_put_back(way, seed):
    """`make stress` kills five hundred of each."""
    assert not stress_kills.killed(way, way == "renames", random.Random(seed))


def test_only_half_made_folders_of_ours_are_cleared_away(tmp_path):
    """Another program's may be called .partial as well."""
    ended = os.spawnlp(os.P_NOWAIT, "true", "true")
    os.waitpid(ended, 0)
    (tmp_path / f"dist.{ended}-abc.partial").mkdir()
    for name in ("dist.backup.partial", "dist.partial", f"other.{ended}-abc.partial"):
        (tmp_path / name).mkdir()
        os.utime(tmp_path / name, (0, 0))
    assert [path.name for path in abandoned(tmp_path, "dist.")] == [f"dist.{ended}-abc.partial"]


def test_the_store_clears_away_its_own_entries_only(tmp_path):
    """A web application has a manifest.json too."""
    (tmp_path / "app").mkdir()
    (tmp_path / "app" / "manifest.json").write_text('{"name": "app", "files": []}')
    os.utime(tmp_path / "app" / "manifest.json", (0, 0))
    Store(tmp_path).prune(keep=set())
    assert names(tmp_path) == ["app", "app/manifest.json"]


@pytest.mark.parametrize(
    ("number", "hint"),
    [
        (errno.ENOSPC, "make room"), (errno.EDQUOT, "make room"), (errno.EFBIG, "make room"),
        (errno.EROFS, "allow this user"), (errno.EACCES, "allow this user"),
    ],
)  # fmt: skip
def test_what_a_disk_refuses_is_a_sentence_with_the_place_and_a_hint(tmp_path, number, hint):
    said = disk_trouble(OSError(number, os.strerror(number), str(tmp_path / "dist")))
    assert said.startswith(f"{tmp_path}/dist: {os.strerror(number)}\n  hint: {hint}")
    assert disk_trouble(OSError(number, os.strerror(number))).startswith(os.strerror(number))


def test_a_disk_that_is_full_ends_a_build_with_a_sentence_and_the_old_site(tmp_path, with_viewer):
    """A limit on what a file may hold stands for the full disk: the same call fails."""
    text = Path("scenes/01-shading/scene.toml").read_text(encoding="utf-8")
    small = "[render]\nsize = 315\nresolutions = [5, 15]\n"  # more than the limit
    scene = tmp_path / "scenes" / "01-shading" / "scene.toml"
    scene.parent.mkdir(parents=True)
    text = text.partition("[[lesson]]")[0].replace("[render]\n", small)
    scene.write_text(text, encoding="utf-8")
    with_viewer(tmp_path / "work")
    write_site(tmp_path / "dist", "old")
    command = [sys.executable, "-m", "raywalk", "site", "--scenes", str(tmp_path / "scenes")]
    command += ["--out", str(tmp_path / "dist"), "--work", str(tmp_path / "work")]
    done = subprocess.run(
        command, capture_output=True, text=True, check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000)),
    )  # fmt: skip
    assert done.returncode == 1
    assert "File too large\n  hint: make room" in done.stderr and "Traceback" not in done.stderr
    assert names(tmp_path / "dist") == [MARKER, "index.html"]
    assert not [path.name for path in tmp_path.rglob("*.partial")]
