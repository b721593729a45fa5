"""The whole site, slides too, built in a process of its own while `raywalk serve` waits for saves:
it can be stopped at any moment, so that what is saved never waits for slides."""

from __future__ import annotations

import multiprocessing
import signal
import traceback
from argparse import Namespace
from collections.abc import Iterator
from dataclasses import dataclass
from threading import Thread
from typing import Any

from raywalk.commands import build_site
from raywalk.errors import UserError, disk_trouble
from raywalk.work.pool import end_with_parent
from raywalk.work.progress import Message


@dataclass(frozen=True)
class Ended:
    """The site is built, or why it is not."""

    trouble: str = ""


class SlidesBeside:
    """At most one such build at a time."""

    def __init__(self) -> None:
        self._process: Any = None
        self._heard: Any = None

    def start(self, chosen: Namespace) -> None:
        """Begins; one that is under way is stopped."""
        self.stop()
        context = multiprocessing.get_context("spawn")
        self._heard, says = context.Pipe(duplex=False)
        self._process = context.Process(target=_build, args=(chosen, says))
        self._process.start()
        says.close()  # ours: the end of theirs is then heard

    def stop(self) -> None:
        """Ends it, done or not. The site is whole at any moment, and what is finished is kept."""
        if self._process:
            self._process.terminate()
            self._process.join()
            self._heard.close()
        self._process = None

    def messages(self) -> Iterator[str | Message | Ended]:
        """What it said since it was asked last; an Ended once."""
        while self._process and self._heard.poll():
            try:
                message = self._heard.recv()
            except EOFError:
                message = Ended(f"slides: the process ended with {self._process.exitcode}")
            if isinstance(message, Ended):
                self._process.join()
                self._process = None
            yield message


def _build(chosen: Namespace, says: Any) -> None:
    """In that process. Ctrl+C reaches it too, but is its parent's, which stops it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=end_with_parent, daemon=True).start()
    try:
        for message in build_site.run(chosen):
            says.send(message)
        says.send(Ended())
    except (UserError, OSError) as problems:
        says.send(Ended(trouble_of(problems)))
    except Exception:  # a fault of ours: seen where the author looks, and the next save may do
        says.send(Ended(traceback.format_exc()))


def trouble_of(problem: UserError | OSError) -> str:
    return disk_trouble(problem) if isinstance(problem, OSError) else str(problem)
