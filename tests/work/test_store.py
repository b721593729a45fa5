"""The store of finished work."""

from __future__ import annotations

import pytest

from raywalk.work.store import Store


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
    assert not Store(tmp_path).entry("key", make).was_found
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
