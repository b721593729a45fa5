"""The course's order: by chapter, in it by folder, unless a scene says what it stands before."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from typing import get_args

from raywalk.errors import SourceError
from raywalk.scene.model import Scene
from raywalk.scene.schema import ChapterName
from raywalk.scene.wording import did_you_mean, joined, quoted

CHAPTERS = get_args(ChapterName)


def in_order(scenes: Iterable[Scene]) -> list[Scene]:
    """Scenes as the course goes through them; several before the same one stay in order.

    Those whose `before` leads nowhere (see `misplaced`) come last.
    """
    scenes = sorted(scenes, key=lambda scene: (_chapter(scene), _folder(scene)))
    ahead: dict[str, list[Scene]] = defaultdict(list)
    for scene in scenes:
        ahead[scene.before].append(scene)
    placed = [each for scene in ahead[""] for each in _with_those_ahead(scene, ahead)]
    names = {_folder(scene) for scene in placed}
    return placed + [scene for scene in scenes if _folder(scene) not in names]


def _with_those_ahead(scene: Scene, ahead: dict[str, list[Scene]]) -> list[Scene]:
    others = [each for one in ahead[_folder(scene)] for each in _with_those_ahead(one, ahead)]
    return [*others, scene]


def misplaced(scenes: Iterable[Scene], folders: Iterable[str]) -> list[SourceError]:
    """What is wrong with each `before`. folders: all scenes' names, of those with mistakes too."""
    by_folder, folders = {_folder(scene): scene for scene in scenes}, list(folders)
    wrong = ((scene, _wrong(scene, by_folder, folders)) for scene in by_folder.values())
    return [
        SourceError(scene.path, "before", f"{quoted(scene.before)}: {said[0]}", *said[1:])
        for scene, said in wrong
        if said
    ]


def _wrong(
    scene: Scene, by_folder: dict[str, Scene], folders: list[str]
) -> tuple[str, str, str] | None:
    """What is wrong with a scene's `before`, what is allowed, and a hint; None if it is right."""
    name, other = scene.before, by_folder.get(scene.before)
    if name and name not in folders:
        beside = [
            quoted(folder)
            for folder, each in by_folder.items()
            if each.chapter == scene.chapter and each is not scene
        ]
        known = f"in this chapter: {joined(beside)}" if beside else ""
        return "there is no such scene", known, did_you_mean(name, folders)
    if other is None:
        return None
    if other is scene:
        return "this is the scene itself", "", ""
    if other.chapter != scene.chapter:
        return (
            f"is in another chapter, {quoted(other.chapter)}",
            f"this one is in {quoted(scene.chapter) if scene.chapter else 'none'}",
            "",
        )
    if _leads_back(scene, by_folder):
        return "stands, by its own before, behind this one", "", "leave out one of them"
    return None


def _leads_back(scene: Scene, by_folder: dict[str, Scene]) -> bool:
    """Whether one comes from a scene to itself again."""
    there, left = by_folder.get(scene.before), len(by_folder)
    while there and there is not scene and left:
        there, left = by_folder.get(there.before), left - 1
    return there is scene


def _chapter(scene: Scene) -> int:
    return CHAPTERS.index(scene.chapter) if scene.chapter else len(CHAPTERS)


def _folder(scene: Scene) -> str:
    return scene.path.absolute().parent.name
