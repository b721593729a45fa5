"""LICENSES.txt: all that the site holds besides our own work, by whom it is, and on what terms."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

from raywalk.home import HOME
from raywalk.scene.credits import named_models
from raywalk.scene.model import Scene
from raywalk.work.snapshot import text_of

FILE = "LICENSES.txt"
FONT = "@expo-google-fonts/arimo"
RULE = "=" * 78


@dataclass(frozen=True)
class Part:
    """Something that ships: its name, where it is, its terms in a word and in full."""

    name: str
    where: str
    licence: str
    text: str = ""

    def __str__(self) -> str:
        head = f"{self.name}\nWhere: {self.where}\nLicence: {self.licence}"
        return f"{RULE}\n{head}\n" + (f"\n{self.text.strip()}\n" if self.text else "")


def write_licences(out: Path, scenes: Iterable[Scene], bundled: Path, has_slides: bool) -> None:
    """bundled: the folder of the viewer's script, with packages.json, the names of npm's packages
    that are in it."""
    names = json.loads((bundled / "packages.json").read_text(encoding="utf-8"))
    parts = [own(), *(npm_package(name, "the pages' scripts") for name in names)]
    parts += models(scenes)
    if has_slides:
        parts += [font(), powerpoint_template()]
    (out / FILE).write_text("\n".join(map(str, parts)), encoding="utf-8")


def own() -> Part:
    """Raywalk itself."""
    text = text_of(HOME / "LICENSE")
    return Part(
        "Raywalk: pages, viewer, scenes, lessons, pictures, slides", "everywhere", "MIT", text
    )


def npm_package(name: str, where: str, files: tuple[str, ...] = ("LICENSE",)) -> Part:
    """One of package-lock.json, with its licence as it was installed."""
    locked = json.loads(text_of(HOME / "package-lock.json"))["packages"]
    found = locked[f"node_modules/{name}"]
    folder = HOME / "node_modules" / name
    text = "\n\n".join((folder / file).read_text(encoding="utf-8") for file in files)
    return Part(f"{name} {found['version']} (npm)", where, found["license"], text)


def models(scenes: Iterable[Scene]) -> list[Part]:
    """The named models that scenes show: once each, as models.toml has them."""
    used: dict[str, tuple[Part, list[str]]] = {}
    for scene in scenes:
        for model in named_models(scene):
            about = f"{model.credit}\nSource: {model.source}"
            part = Part(model.title, "", model.licence, about)
            used.setdefault(model.title, (part, []))[1].append(scene.id)
    return [
        Part(part.name, "scenes " + ", ".join(at), part.licence, part.text)
        for part, at in used.values()
    ]


def font() -> Part:
    """The slides' typeface, embedded in PDF; also in the preview pictures."""
    where = (
        "embedded in the PDF files of slides, handouts and worksheets; drawn in preview pictures"
    )
    return npm_package(FONT, where, ("LICENSE", "LICENSE_FONT"))


def powerpoint_template() -> Part:
    """What python-pptx puts into every new file."""
    licence = next(
        file
        for file in metadata.files("python-pptx") or ()
        if file.name.upper().startswith("LICENSE")
    )
    text = Path(str(licence.locate())).read_text(encoding="utf-8")
    where = "the empty master and theme in the PowerPoint files"
    return Part(f"python-pptx {metadata.version('python-pptx')}", where, "MIT", text)
