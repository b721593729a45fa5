"""What a lesson's views may show: what the scene has."""

from __future__ import annotations

from collections.abc import Sequence

from raywalk.scene.model import Render
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema import SwitchesTable, ViewTable
from raywalk.scene.wording import did_you_mean, joined, plain, quoted


def check_view(
    view: ViewTable, render: Render, lights: Sequence[str] | None, at: Location, problems: Problems
) -> None:
    """A view shows a frustum that exists, a ray that is in it, and switches that there are.

    lights: names, of an area light as its file gives it; None if they are not known.
    """
    if view.switches is not None:
        _check_switches(view.switches, render, lights, (*at, "switches"), problems)
    resolutions = render.resolutions
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
