"""What a lesson's views may show: what the scene has."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from raywalk.scene.model import Render, SceneObject
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema import SwitchesTable, ViewTable
from raywalk.scene.shapes import Mesh, Plane, Sphere
from raywalk.scene.wording import did_you_mean, joined, plain, quoted

Stop = int | tuple[int, int]  # its number, or column and row, from 1


@dataclass(frozen=True)
class Stops:
    """Those of a sweep."""

    columns: int
    rows: int
    resolutions: Sequence[int]  # whose rays each has

    def number(self, stop: Stop) -> int:
        """Of all stops, row by row; as it is given, or by column and row."""
        return stop if isinstance(stop, int) else (stop[1] - 1) * self.columns + stop[0]


Sweeps = Mapping[str, Stops]  # by their names

#: The ray-tracing camera's name in `labels`, in every language.
CAMERA = "camera"


@dataclass(frozen=True)
class Named:
    """What a view may name."""

    lights: Sequence[str]  # of an area light as its file gives it
    objects: Sequence[SceneObject] | None  # None: some are flawed, and left out
    sweeps: Sweeps = field(default_factory=dict)


def check_view(
    view: ViewTable, render: Render, named: Named | None, at: Location, problems: Problems
) -> None:
    """A view shows a frustum that exists, a ray that is in it, and switches and things that there
    are. named: None if they are not known."""
    if view.switches is not None:
        lights = named.lights if named else None
        _check_switches(view.switches, render, lights, (*at, "switches"), problems)
    if named is not None:
        _check_stop(view.sweep or {}, named.sweeps, (*at, "sweep"), problems)
        _check_grid_of_stop(view, named.sweeps, (*at, "resolution"), problems)
    if named is not None and named.objects is not None:
        _check_marks(view, named.lights, named.objects, at, problems)
        _check_works(view, render, named.objects, at, problems)
    resolutions = render.resolutions
    if view.sweep and view.look == "traced":
        problems.add(
            (*at, "look"), "a sweep's stop has no traced look", hint="plain or approximate"
        )
    if view.resolution is not None and view.resolution not in resolutions:
        problems.add(
            (*at, "resolution"),
            f"{view.resolution} is not one of the scene's resolutions",
            allowed=f"known: {joined(map(str, resolutions))}",
        )
        return
    if view.pixel is not None and view.resolution is None:
        problems.add((*at, "pixel"), f"{plain(view.pixel)} needs a resolution to be counted in")
    elif view.pixel is not None and view.resolution and max(view.pixel) >= view.resolution:
        problems.add(
            (*at, "pixel"),
            f"{plain(view.pixel)} is outside the frustum",
            allowed=f"allowed: columns and rows 0 to {view.resolution - 1}",
        )
    if not isinstance(view.observer, str | None) and view.observer.eye == view.observer.target:
        problems.add(
            (*at, "observer", "target"), f"{plain(view.observer.target)} is where the eye is"
        )


def _check_stop(
    asked: Mapping[str, Stop], sweeps: Sweeps, at: Location, problems: Problems
) -> None:
    """The sweep is the scene's, and has that stop."""
    for name, stop in asked.items():
        _check_known(name, list(sweeps), (*at, name), problems)
        if name not in sweeps:
            continue
        columns, rows = sweeps[name].columns, sweeps[name].rows
        if isinstance(stop, int):
            if stop > columns * rows:
                message = f"{stop} is beyond its last stop"
                problems.add((*at, name), message, allowed=f"allowed: 1 to {columns * rows}")
        elif rows == 1:
            hint = f"it has no rows: write the stop's number, 1 to {columns}"
            problems.add((*at, name), f"{plain(stop)} is none of its stops", hint=hint)
        elif stop[0] > columns or stop[1] > rows:
            message = f"{plain(stop)} is beyond its last column or row"
            allowed = f"allowed: columns 1 to {columns}, rows 1 to {rows}"
            problems.add((*at, name), message, allowed=allowed)


def _check_grid_of_stop(view: ViewTable, sweeps: Sweeps, at: Location, problems: Problems) -> None:
    """A step at a stop shows rays that the stop has."""
    for name in view.sweep or {}:
        has = sweeps[name].resolutions if name in sweeps else ()
        if has and view.resolution is not None and view.resolution not in has:
            problems.add(
                at, f"stops of {quoted(name)} have no rays of {view.resolution}",
                allowed=f"known: {joined(map(str, has))}",
                hint="or write it among the sweep's resolutions",
            )  # fmt: skip


def _check_works(
    view: ViewTable, render: Render, objects: Sequence[SceneObject], at: Location,
    problems: Problems,
) -> None:  # fmt: skip
    """What is to be worked out is of a scene that has it."""
    if view.works is None:
        for key in ("tree_depth", "rays_a_tile"):
            if getattr(view, key) is not None:
                problems.add((*at, key), "nothing is worked out here", hint="give works, too")
        return
    shapes = [obj.shape for obj in objects]
    if view.works == "equation" and not any(isinstance(each, Sphere) for each in shapes):
        problems.add((*at, "works"), "this scene has no sphere, so no sphere's equation")
    if view.works == "tree" and not any(isinstance(each, Mesh) for each in shapes):
        problems.add((*at, "works"), "this scene has no mesh, so no tree of boxes")
    n = view.resolution
    if n is None or view.pixel is None:
        problems.add((*at, "works"), "needs a resolution and a pixel")
    elif view.works == "average" and not {3 * n, 5 * n, 7 * n} <= set(render.resolutions):
        problems.add(
            (*at, "works"), f"needs the resolutions {3 * n}, {5 * n} and {7 * n}, too",
            hint="works = \"average\" is for resolution 11 of 11, 33, 55, 77",
        )  # fmt: skip


def _check_switches(
    switches: SwitchesTable, render: Render, lights: Sequence[str] | None, at: Location,
    problems: Problems,
) -> None:  # fmt: skip
    if switches.bounces is not None and switches.bounces > render.depth:
        problems.add(
            (*at, "bounces"),
            f"{switches.bounces} is more than are traced",
            allowed=f"allowed: 0 to {render.depth}, which is render.depth",
        )
    for name in switches.lights or {}:
        if lights is not None and name not in lights:
            problems.add(
                (*at, "lights", name), "there is no such light",
                allowed=f"known: {joined(map(quoted, lights))}" if lights else "",
                hint=did_you_mean(name, lights),
            )  # fmt: skip
    if switches.shadows and not render.shadows:
        problems.add((*at, "shadows"), "this scene is traced without shadows")


def _check_marks(
    view: ViewTable, lights: Sequence[str], objects: Sequence[SceneObject], at: Location,
    problems: Problems,
) -> None:  # fmt: skip
    endless = [obj.name for obj in objects if isinstance(obj.shape, Plane)]
    ringed = [obj.name for obj in objects if obj.name not in endless] + [*lights]
    for i, name in enumerate(view.highlight or ()):
        if name in endless:
            problems.add((*at, "highlight", i), f"{quoted(name)} has no end to draw a ring round")
        else:
            _check_known(name, ringed, (*at, "highlight", i), problems)
    for name in view.labels or {}:
        _check_known(name, [CAMERA, *ringed], (*at, "labels", name), problems)


def _check_known(name: str, known: Sequence[str], at: Location, problems: Problems) -> None:
    if name not in known:
        problems.add(
            at, f"there is no {quoted(name)}",
            allowed=f"known: {joined(map(quoted, known))}" if known else "the scene names nothing",
            hint=did_you_mean(name, known),
        )  # fmt: skip
