"""The store of finished work."""

from __future__ import annotations

import json
import os
import time

import pytest

from raywalk.work.leftovers import remove_leftovers
from raywalk.work.store import MANIFEST, Store


def write(text):
    """A maker that counts how often it was asked."""
    calls = []

    def make(folder):
        calls.append(folder)
        (folder / "a.txt").write_text(text)

    return make, calls


def test_what_was_made_once_is_found_again(tmp_path):
    """The second time nothing is made."""
    make, calls = write("one")
    assert not Store(tmp_path).has("key")
    assert not Store(tmp_path).entry("key", make).was_found
    assert Store(tmp_path).has("key")
    assert Store(tmp_path).entry("key", make).was_found
    assert len(calls) == 1


def test_an_interrupted_making_leaves_nothing(tmp_path):
    """Neither half an entry nor scraps beside it; the next build makes it again."""

    def fail(folder):
        (folder / "a.txt").write_text("half")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        Store(tmp_path).entry("key", fail)
    assert list(tmp_path.iterdir()) == []
    make, _ = write("whole")
    assert not Store(tmp_path).entry("key", make).was_found


@pytest.mark.parametrize("damage", ["changed", "cut", "missing", "manifest"])
def test_a_damaged_entry_is_noticed_and_made_again(tmp_path, damage):
    """A changed byte, a cut or missing file, a broken manifest."""
    make, calls = write("content")
    place = Store(tmp_path).entry("key", make).folder
    file = place / ("manifest.json" if damage == "manifest" else "a.txt")
    if damage == "missing":
        file.unlink()
    else:
        file.write_text({"changed": "Content", "cut": "cont", "manifest": "{"}[damage])
    entry = Store(tmp_path).entry("key", make)
    assert not entry.was_found
    assert (entry.folder / "a.txt").read_text() == "content"
    assert len(calls) == 2


def test_two_builds_with_the_same_work_do_not_disturb_each_other(tmp_path):
    """The slower one finds the quicker one's entry in its place and is content."""

    def make_slowly(folder):
        make, _ = write("same")
        Store(tmp_path).entry("key", make)  # the other build, meanwhile
        make(folder)

    entry = Store(tmp_path).entry("key", make_slowly)
    assert (entry.folder / "a.txt").read_text() == "same"


def test_what_was_not_used_for_a_month_goes_and_what_is_used_stays(tmp_path):
    """Finding an entry counts as using it; what this build made stays in any case."""
    store = Store(tmp_path)
    make, _ = write("content")
    for key in ("old", "found", "kept"):
        place = store.entry(key, make).folder
        long_ago = time.time() - 40 * 86_400
        os.utime(place / MANIFEST, (long_ago, long_ago))
    assert store.find("found")
    store.prune(keep={"kept"})
    assert sorted(path.name for path in tmp_path.iterdir()) == ["found", "kept"]


def test_beyond_its_room_the_store_drops_what_was_used_longest_ago(tmp_path):
    """It does not grow for ever."""
    store = Store(tmp_path)
    make, _ = write("x" * 1000)
    for age, key in enumerate(["newest", "newer", "oldest"]):
        place = store.entry(key, make).folder
        os.utime(place / MANIFEST, (time.time() - age, time.time() - age))
    room = sum(path.stat().st_size for path in (tmp_path / "newest").iterdir())
    store.prune(keep=set(), most=2 * room)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["newer", "newest"]


def test_what_a_killed_build_left_is_cleared_away_and_a_running_ones_is_not(tmp_path):
    """Half-made folders carry their maker's process number."""
    ended = os.spawnlp(os.P_NOWAIT, "true", "true")
    os.waitpid(ended, 0)
    (tmp_path / f"key.{ended}-abc.partial").mkdir()
    (tmp_path / f"key.{os.getpid()}-abc.partial").mkdir()
    remove_leftovers(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [f"key.{os.getpid()}-abc.partial"]


def test_what_an_entry_was_made_from_is_kept_with_it(tmp_path):
    """So that the next build can say what changed; the newest of a kind and name counts."""
    store = Store(tmp_path)
    make, _ = write("content")
    for age, value in enumerate([3, 2, 1]):
        made_from = {"what": "trace", "of": "ball", "value": value}
        place = store.entry(f"key{value}", make, made_from).folder
        os.utime(place / MANIFEST, (time.time() - age, time.time() - age))
    assert store.newest("trace", "ball") == {"what": "trace", "of": "ball", "value": 3}
    assert store.newest("trace", "box") is None
    assert json.loads((tmp_path / "key1" / MANIFEST).read_text())["made_from"]["value"] == 1
