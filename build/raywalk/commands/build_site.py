"""raywalk site: scene files in, site out. What it does stands in raywalk/pipeline/site.py."""

from __future__ import annotations

import os
import time
from argparse import ArgumentTypeError, Namespace
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any

from raywalk.home import HOME
from raywalk.work import times
from raywalk.work.last_build import LastBuild, inputs_of
from raywalk.work.ownership import refuse_nested
from raywalk.work.progress import Message
from raywalk.work.publish import ready
from raywalk.work.snapshot import one_build

SITE_SOURCE = HOME / "site_src"
BUDGETS = Path(__file__).parent.parent / "site" / "budgets.toml"
#: Of the site, what it is whole without.
PARTS = {"check": "the page that pictures are checked on", "mistakes": "the pages of mistakes"}


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser(
        "site", aliases=["build"], help="trace all scenes and build the site"
    )
    add_options(parser)
    parser.set_defaults(run=run)


def add_options(parser: Any) -> None:
    """What every build takes, also one by `serve`."""
    parser.add_argument("--out", type=Path, default=Path("dist"), help="where the site goes")
    parser.add_argument("--work", type=Path, default=Path(".work"), help="where traces are kept")
    parser.add_argument("--sizes", action="store_true", help="tell what files weigh, by budget")
    parser.add_argument("--budgets", type=Path, default=BUDGETS, help="what files may weigh")
    parser.add_argument("--explain", action="store_true", help="say why each thing is made again")
    parser.add_argument(
        "--scheduler", metavar="tcp://HOST:PORT", help="trace on this Dask cluster, not here"
    )
    parser.add_argument(
        "--times", type=Path, nargs="?", const=Path(), metavar="FILE",
        help="say where the time goes; FILE: what `make` took before",
    )  # fmt: skip
    parser.add_argument("--stats", action="store_true", help="say what each scene did not need")
    parser.add_argument(
        "--url", default=os.environ.get("RAYWALK_URL", ""), metavar="https://HOST/PATH/",
        help="where the site will be: for its sitemap and shared links (or RAYWALK_URL)",
    )  # fmt: skip
    parser.add_argument(
        "--without", type=parts_left_out, default=os.environ.get("RAYWALK_WITHOUT", ""),
        metavar="PART,PART", help="make the site without these (or RAYWALK_WITHOUT): "
        + "; ".join(f"{name}, {what}" for name, what in PARTS.items()),
    )  # fmt: skip
    parser.set_defaults(slides_later=False)


def parts_left_out(named: str) -> frozenset[str]:
    """Parts of the site by their names. Raises ArgumentTypeError."""
    names = frozenset(name for name in named.replace(",", " ").split())
    if unknown := sorted(names - set(PARTS)):
        allowed = " or ".join(PARTS)
        raise ArgumentTypeError(f"{', '.join(unknown)} cannot be left out: name {allowed}")
    return names


def run(chosen: Namespace) -> Generator[str | Message, None, None]:
    """Builds the site, telling what was traced, kept and written."""
    with one_build():
        yield from _run(chosen)


def _run(chosen: Namespace) -> Iterator[str | Message]:
    started = time.monotonic()
    times.begin()
    refuse_out(chosen)  # before anything is traced
    last = LastBuild(chosen.work, chosen.out)
    with times.phase("look what changed"):
        inputs = inputs_of(chosen.scenes, SITE_SOURCE, chosen.work)
        inputs |= {"url": chosen.url, "without": ",".join(sorted(chosen.without))}
        said = None if chosen.stats else last.said(inputs)
    if said:
        yield from said["remarks"]
        if chosen.explain:
            yield "nothing is made again: no input changed, and the site is as it was left"
        count = said["scenes"]
        traced, size = f"{count} scenes: 0 traced, {count} unchanged", said["size"]
    else:
        # Only here: reading scenes and making pages needs more than looking whether to.
        from raywalk.pipeline.site import build

        done = yield from build(chosen, SITE_SOURCE)
        # The hashes from before the build: what was edited meanwhile is built next time.
        if not chosen.slides_later:
            with times.phase("note what was built"):
                last.keep(inputs, done.also_read, done.said)
        traced, size = done.traced, done.said["size"]
    if chosen.sizes or chosen.budgets != BUDGETS:
        yield from listed_sizes(chosen)
    if chosen.times:
        yield from times.table(chosen.times)
    yield f"{traced}; {size / 1e6:.1f} MB in {chosen.out}/, {time.monotonic() - started:.1f} s"


def refuse_out(chosen: Namespace) -> None:
    """Raises SourceErrors where a site must not go: over what somebody else has there, or into
    what a build reads."""
    ready(chosen.out)
    refuse_nested(
        chosen.out,
        {
            "the folder of scenes": chosen.scenes,
            "the folder of templates": SITE_SOURCE,
            "the folder of kept work": chosen.work,
        },
    )


def listed_sizes(chosen: Namespace) -> Iterator[str]:
    """What the files weigh, if asked; raises OverBudget, also where nothing was built anew."""
    from raywalk.site import sizes

    weights, budgets = sizes.kept(chosen.out), sizes.read_budgets(chosen.budgets)
    if chosen.sizes:
        yield from sizes.table(chosen.out, weights, budgets)
    sizes.check(chosen.out, weights, budgets)
