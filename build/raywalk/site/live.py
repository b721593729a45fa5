"""What open pages hear while `raywalk serve` runs: a new build, one under way, mistakes."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from pathlib import Path
from threading import Condition

BUSY = "Building …"
TROUBLE = "Not built: this page shows what was there before"


@dataclass(frozen=True)
class News:
    """version: how many builds changed the site; trouble: why there is no newer one."""

    version: int = 0
    busy: bool = False
    trouble: str = ""

    def as_event(self) -> bytes:
        """One server-sent event; JSON escapes line ends, so a text cannot break out of it."""
        message = {
            "version": self.version,
            "busy": self.busy,
            "trouble": self.trouble,
            "title": TROUBLE if self.trouble else BUSY if self.busy else "",
        }
        return f"data: {json.dumps(message)}\n\n".encode()


class Live:
    """The newest news, for any number of waiting pages."""

    def __init__(self) -> None:
        self.news = News()
        # Files that pages get instead of the built site's, until the next build is done.
        self.meanwhile: Path | None = None
        self._changed = Condition()

    def begin(self) -> None:
        """A build is under way."""
        self._tell(replace(self.news, busy=True))

    def first_sight(self, folder: Path) -> None:
        """Some of the site's files are new in a folder; the build goes on."""
        self.meanwhile = folder
        self._tell(replace(self.news, version=self.news.version + 1))

    def done(self) -> None:
        """The site is new."""
        self.meanwhile = None
        self._tell(News(version=self.news.version + 1))

    def slides_too(self) -> None:
        """The pages are as they were; nobody need load them again."""
        self._tell(News(version=self.news.version))

    def failed(self, trouble: str) -> None:
        """The site is as it was, and this is why."""
        self.meanwhile = None
        self._tell(replace(self.news, busy=False, trouble=trouble))

    def after(self, seen: News | None, seconds: float) -> News:
        """The news as soon as they are not what was seen, or after some seconds."""
        with self._changed:
            self._changed.wait_for(lambda: self.news != seen, seconds)
            return self.news

    def _tell(self, news: News) -> None:
        with self._changed:
            self.news = news
            self._changed.notify_all()
