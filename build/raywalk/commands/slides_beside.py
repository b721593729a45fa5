"""The whole site, slides too, built in a process of its own while `raywalk serve` waits for saves:
it can be stopped at any moment, so that what is saved never waits for slides."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import traceback
from argparse import Namespace
from collections.abc import Iterator
from dataclasses import dataclass
from queue import SimpleQueue
from threading import Thread
from typing import IO, Any

from raywalk.commands import build_site
from raywalk.errors import UserError, disk_trouble
from raywalk.work.progress import Message

PROGRAM = "from raywalk.commands.slides_beside import build_here; build_here()"


@dataclass(frozen=True)
class Ended:
    """The site is built, or why it is not."""

    trouble: str = ""


class SlidesBeside:
    """At most one such build at a time."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._heard: SimpleQueue[Any] = SimpleQueue()

    def start(self, chosen: Namespace) -> None:
        """Begins; one that is under way is stopped."""
        self.stop()
        # What is wrong it says in its messages; what those that are stopped complain of is nothing.
        self._process = process = subprocess.Popen(
            [sys.executable, "-c", PROGRAM],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        assert process.stdin and process.stdout
        pickle.dump(chosen, process.stdin)
        process.stdin.flush()  # and it stays open: where it ends, we do, and the process with us
        self._heard = SimpleQueue()
        Thread(target=_listen, args=(process.stdout, self._heard), daemon=True).start()

    def tell_to_stop(self) -> None:
        """Ends it, done or not, and does not wait until it has gone: its memory takes a moment."""
        if self._process:
            self._process.terminate()

    def stop(self) -> None:
        """Ends it, done or not. The site is whole at any moment, and what is finished is kept."""
        self.tell_to_stop()
        if self._process:
            self._forget(self._process)

    def messages(self) -> Iterator[str | Message | Ended]:
        """What it said since it was asked last; an Ended once."""
        while self._process and not self._heard.empty():
            message = self._heard.get()
            if isinstance(message, Ended):
                self._forget(self._process)
            yield message

    def _forget(self, process: subprocess.Popen[bytes]) -> None:
        assert process.stdin
        process.stdin.close()
        process.wait()
        self._process = None


def _listen(says: IO[bytes], heard: SimpleQueue[Any]) -> None:
    """Until it ends; if nothing else was the last that it said, something went wrong."""
    with says:
        try:
            while True:
                heard.put(pickle.load(says))
        except (EOFError, OSError, ValueError, pickle.UnpicklingError):
            heard.put(Ended("slides: the process that builds them has ended"))


def build_here() -> None:
    """In that process. Ctrl+C reaches it too, but is its parent's, which stops it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    says = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what anybody prints is no message
    chosen: Namespace = pickle.load(sys.stdin.buffer)
    Thread(target=_end_with_parent, daemon=True).start()
    for message in _messages(chosen):
        pickle.dump(message, says)
        says.flush()


def _end_with_parent() -> None:
    sys.stdin.buffer.read()
    os._exit(1)


def _messages(chosen: Namespace) -> Iterator[str | Message | Ended]:
    try:
        yield from build_site.run(chosen)
        yield Ended()
    except (UserError, OSError) as problems:
        yield Ended(trouble_of(problems))
    except Exception:  # a fault of ours: seen where the author looks, and the next save may do
        yield Ended(traceback.format_exc())


def trouble_of(problem: UserError | OSError) -> str:
    return disk_trouble(problem) if isinstance(problem, OSError) else str(problem)
