"""The stops of a scene's sweeps, each kept under what it is made from, and what pages load."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from raywalk.pipeline.parts import models_of, shut_for, silent
from raywalk.scene.model import Scene, Sweep
from raywalk.scene.wording import counted, quoted
from raywalk.work.chains import Chain
from raywalk.work.digests import key_of
from raywalk.work.explain import in_runs
from raywalk.work.maker import Maker, Parts
from raywalk.work.making import made, reasons
from raywalk.work.pool import Job, Threads, cores
from raywalk.work.progress import Report, say_nothing
from raywalk.work.store import Entry, Store
from raywalk.work.times import Spent, Stages, note

STOP = Maker("raywalk.sweeps.trace_stop", "write_stop")
SWEEP = Maker("raywalk.sweeps.write", "write_sweep")


def stop_parts(stop: Scene, sweep: Sweep) -> Parts:
    """The scene with the stop's value, and which of its rays are kept."""
    return {
        "what": "stop", "of": stop.id, "scene": silent(stop), "models": models_of(stop),
        "resolutions": list(sweep.resolutions), "picture": sweep.picture,
        **STOP.parts(shut_for(stop)),
    }  # fmt: skip


def sweep_parts(scene: Scene, sweep: Sweep, traced: Entry, stops: list[str]) -> Parts:
    """stops: the keys of its stops' traces."""
    return {
        "what": "sweep", "of": f"{scene.id} {sweep.id}", "scene": silent(scene),
        "trace": traced.folder.name, "stops": stops, **SWEEP.parts(shut_for(scene)),
    }  # fmt: skip


@dataclass
class Tally:
    """Stops of all sweeps of a build, and how many of them were traced by it."""

    stops: int = 0
    traced: int = 0

    def told(self) -> str:
        """For the end of a build; "" where nothing moves."""
        unchanged = self.stops - self.traced
        count = counted(self.stops, "stop")
        return f"{count}: {self.traced} traced, {unchanged} unchanged" if self.stops else ""


def sweeps_chain(
    store: Store, scene: Scene, traced: Entry, tally: Tally | None = None
) -> Chain[dict[str, Entry]]:
    """What is published of each sweep, by its id; only stops that nobody has traced are traced."""
    found, tally = {}, tally or Tally()
    for sweep in scene.sweeps:
        parts = [stop_parts(stop, sweep) for stop in sweep.stops]
        missing = [k for k, each in enumerate(parts) if not store.find(key_of(each))]
        tally.stops += len(parts)
        tally.traced += len(missing)
        if missing:
            count = counted(len(parts), "stop")
            yield f"{scene.id}: {quoted(sweep.name)}: tracing {len(missing)} of {count}"
            yield from _explained(store, scene, sweep, parts, missing)
            wanted = [(sweep.stops[k], parts[k]) for k in missing]
            note((yield Job(scene.id, partial(_make_stops, store, sweep), wanted)))
        whole = sweep_parts(scene, sweep, traced, [key_of(each) for each in parts])
        yield from reasons(store, whole)
        stops = [store.get(key_of(each)).folder for each in parts]
        bare = replace(scene, lesson=(), sweeps=())
        found[sweep.id] = made(store, whole, partial(SWEEP, bare, sweep, traced.folder, stops))
    return found


def _explained(
    store: Store, scene: Scene, sweep: Sweep, parts: list[Parts], missing: list[int]
) -> Iterator[str]:
    """In a build that explains itself, which stops are traced and why, and which are not."""
    for k in missing:
        yield from reasons(store, parts[k], f"stop {k + 1} of {quoted(sweep.name)}")
    if store.explains and (kept := [k + 1 for k in range(len(parts)) if k not in missing]):
        stops = f"{'stop' if len(kept) == 1 else 'stops'} {in_runs(kept)}"
        yield f"{scene.id}: {stops} of {quoted(sweep.name)} unchanged"


def sweeps_here(store: Store, scene: Scene, traced: Entry) -> dict[str, Entry]:
    """The same, made in this process."""
    chain = sweeps_chain(store, scene, traced)
    try:
        said = next(chain)
        while True:
            done = said.work(said.task, cores, say_nothing) if isinstance(said, Job) else None
            said = chain.send(done)
    except StopIteration as end:
        found: dict[str, Entry] = end.value
        return found


def _make_stops(
    store: Store, sweep: Sweep, wanted: list[tuple[Scene, Parts]],
    threads: Threads, report: Report,
) -> Spent:  # fmt: skip
    # Only where something is traced: a change of words imports no compiler.
    from raywalk.optics.compiling import seconds_spent
    from raywalk.trace.relighting import KnownPaths, unlit

    stages = Stages("compiling kernels", seconds_spent)
    of = sweep.resolutions, sweep.picture
    paths = [key_of({"paths": silent(unlit(stop))}) for stop, _ in wanted]
    # Kept only where another stop lights them again.
    known = {each: KnownPaths() for each, count in Counter(paths).items() if count > 1}
    for k, (stop, parts) in enumerate(wanted):
        made(store, parts, partial(STOP, stop, *of, threads=threads, known=known.get(paths[k])))
        report("stops", (k + 1) / len(wanted))
    return stages.spent("stops of sweeps")


def publish_sweeps(folder: Path, sweeps: dict[str, Entry]) -> None:
    """Copies sweeps' files into the folder of their scene, each into one of its own."""
    for id, entry in sweeps.items():
        (folder / id).mkdir()
        for path in entry.files():
            shutil.copyfile(path, folder / id / path.name)
