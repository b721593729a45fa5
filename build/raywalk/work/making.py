"""Makes a piece of work and keeps it under its key, unless its sources were edited meanwhile."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from raywalk.errors import UserError
from raywalk.work.digests import digest_or_missing, key_of
from raywalk.work.explain import likest, why
from raywalk.work.maker import OURS, Parts
from raywalk.work.store import Entry, Store, damage_of


class Edited(UserError):
    """What was made is not what its key says; str() names the file."""


def made(store: Store, parts: Parts, make: Callable[[Path], object]) -> Entry:
    """The entry of these parts; `make` fills a new folder with its files if there is none.

    Python imports a module, and node reads a script, some time after the key was taken. So their
    hashes are compared again when the work is done, and work of edited sources is not kept: this
    process has run a mixture and cannot make it right. Raises Edited, and what `make` raises.
    """

    def make_unless_edited(folder: Path) -> None:
        make(folder)
        refuse_edited(parts)

    return store.entry(key_of(parts), make_unless_edited, parts)


def reasons(store: Store, parts: Parts, called: str = "") -> Iterator[str]:
    """Why a piece of work will be made, in a build that explains itself; nothing if it is there.

    called: what it is to a person, where a scene has many of its kind.
    """
    key = key_of(parts)
    if store.explains and not store.find(key):
        what, of = parts["what"], parts["of"]
        before = likest(store.all_of(what, of), parts) if called else store.newest(what, of)
        because = why(before, parts, damage_of(store.folder / key) or "")
        yield f"{of}: {called or what} made: {because}"


def refuse_edited(parts: Parts) -> None:
    """Raises Edited if code is no longer what the parts say."""
    now = {name: digest_or_missing(OURS.place(name)) for name in parts["code"]}
    refuse_changed(parts, parts["code"], now)


def refuse_changed(parts: Parts, before: dict[str, str], now: dict[str, str]) -> None:
    """Raises Edited for the first hash that is another now."""
    for name, hash in before.items():
        if now[name] != hash:
            raise Edited(
                f"{name} was edited while {parts['what']} of {parts['of']} was made, which is not "
                "kept\n  build again; of our Python, `raywalk serve` takes note when started anew"
            )
