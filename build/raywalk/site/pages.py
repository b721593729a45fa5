"""The pages: a gallery, one page a scene that tells its story without JavaScript, and the
page on the model behind the pictures."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import groupby
from pathlib import Path
from traceback import walk_tb
from typing import Any

from jinja2 import (
    BytecodeCache,
    Environment,
    FunctionLoader,
    StrictUndefined,
    TemplateSyntaxError,
    select_autoescape,
)
from jinja2.bccache import Bucket
from markupsafe import Markup, escape

from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.lesson_text import inline_html, lesson_html
from raywalk.scene.model import Choice, Scene
from raywalk.site.downloads import FORMS, sorted_downloads
from raywalk.site.figures import Figures
from raywalk.site.mistake_words import of_terms, read_said
from raywalk.site.preview import NAME as PREVIEW
from raywalk.site.saying import sayings
from raywalk.site.shown_picture import shown_picture
from raywalk.site.sizes import Budget, Size, shown, weighed
from raywalk.site.terms import first_seen, letters_of, marked, terms_script
from raywalk.terms.glossary import Glossary, read_glossary
from raywalk.words import Words, languages, read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.work.snapshot import text_of

# viewer_js, kiosk_js, words_js, page_js and style_css, relative to the site's root; parts
Assets = dict[str, str]
FACE = "5"


def write_pages(
    out: Path, templates: Path, scenes: list[Scene], figures: dict[str, Figures], assets: Assets,
    words: Words | None = None, savings: dict[str, Figures] | None = None,
    downloads: dict[str, dict[str, int]] | None = None, base: str = "", with_mistakes: bool = False,
) -> None:  # fmt: skip
    """index.html, model/, glossary/, slides/, offline/ and scenes/<id>/index.html of one
    language: under `out` for the default one, under out/<code> for another. scenes: in that
    language; downloads: paths and sizes of the files to take away, by scene id or "course"; base:
    where the site will be, if that is known; with_mistakes: whether there are pages of mistakes.

    Links are relative, so that the site works under any sub-path and from a disk.
    """
    words = words or read_words()
    environment = page_environment(templates, words)
    home = home_of(words.code)

    def write(here: str, template: str, **context: Any) -> None:
        page = out / f"{home}{here}"
        page.parent.mkdir(parents=True, exist_ok=True)
        values = shared | {"root": "../" * (home + here).count("/"), "here": here} | context
        page.write_text(rendered(environment, template, values), encoding="utf-8")

    cards = [card_of(scene, home, out) for scene in scenes]
    decks = {id: sorted_downloads(id, sizes, words) for id, sizes in (downloads or {}).items()}
    shared = {
        "home": home, "scenes": cards, "chapters": _chapters(cards), **assets,
        "decks": decks, "forms": {word: ending for ending, word in FORMS.items()},
        "base": base, "preview": _preview(out, [face_of(scenes)] if scenes else []),
        "with_mistakes": with_mistakes,
    }  # fmt: skip
    has_checks = any(has_check(scene, out) for scene in scenes)
    has_which = (out / "mistakes" / "which.js").exists()
    write("index.html", "gallery.html", has_checks=has_checks, has_which=has_which)
    write("offline/index.html", "offline.html")
    write(
        "model/index.html", "model.html",
        glass_scenes=[
            _glass(each, home, out) for each in scenes if each.has_glass and not each.base
        ],
        has_benchmarks=(out / "benchmarks" / "index.html").exists(),
    )  # fmt: skip
    glossary = read_glossary(words.code)
    write(
        "glossary/index.html", "glossary.html", terms=glossary.terms,
        seen=first_seen(glossary, scenes), letters=letters_of(glossary.terms),
        wrong=of_terms(templates.parent) if with_mistakes else {},
        said=read_said(templates.parent, words.code),
    )  # fmt: skip
    (out / home / "glossary" / "terms.js").write_text(terms_script(glossary.terms), "utf-8")
    if decks:
        write("slides/index.html", "slides.html")
    for scene in scenes:
        deck = decks.get(scene.id)
        shown = _scene(scene, figures[scene.id], out) | {
            "lesson": _lesson(scene, deck["figures"] if deck else [], words, glossary),
            "savings": (savings or {}).get(scene.id),
            "downloads": deck, "check": has_check(scene, out),
        }  # fmt: skip
        here = f"scenes/{scene.id}/index.html"
        write(here, "scene.html", scene=shown, preview=_preview(out, [scene]))


def face_of(scenes: Sequence[Scene]) -> Scene:
    """The scene whose picture stands for the whole site: many mirrors, if it is there."""
    return next((scene for scene in scenes if scene.key == FACE), scenes[0])


def _preview(out: Path, scenes: Sequence[Scene]) -> str:
    """The preview picture of the first of these, "" where there is none."""
    names = (f"scenes/{scene.traces}/{PREVIEW}" for scene in scenes)
    return next((name for name in names if (out / name).exists()), "")


def home_of(code: str) -> str:
    """Where a language's pages are, relative to the site's root: "" or "de/"."""
    return "" if code == DEFAULT else f"{code}/"


def write_sizes(
    out: Path, templates: Path, weights: Sequence[Size], budgets: Sequence[Budget], assets: Assets
) -> None:
    """sizes/index.html: what files weigh, budget by budget."""
    tables = []
    for budget in budgets:
        own = sorted((each for each in weights if each.key == budget.key), key=lambda e: -e.value)
        if not own:
            continue
        rows = [
            {"file": each.file, "size": f"{each.size:,}", "value": shown(each.value, budget)}
            for each in own
        ]
        together = [shown(value, budget) for _, value in weighed(own, budget)]
        all_counted = budget.counted == "all"
        tables.append(
            {
                "what": budget.what, "limit": shown(budget.limit, budget), "reason": budget.reason,
                "rows": rows, "together": together[0] if all_counted else "",
            }
        )  # fmt: skip
    page = out / "sizes" / "index.html"
    page.parent.mkdir(parents=True, exist_ok=True)
    values = {"root": "../", "tables": tables, **assets}
    page.write_text(rendered(page_environment(templates), "sizes.html", values), encoding="utf-8")


def rendered(environment: Environment, name: str, values: dict[str, Any]) -> str:
    """A page's text. Raises SourceErrors with the template and line in which a mistake is."""
    try:
        return environment.get_template(name).render(values)
    except TemplateSyntaxError as mistake:
        place, line = mistake.filename or name, mistake.lineno
        said = mistake.message or str(mistake)
    except Exception as mistake:  # of any kind: a template calls what it likes
        frames = [(frame.f_code.co_filename, at) for frame, at in walk_tb(mistake.__traceback__)]
        own = [(file, at) for file, at in frames if file.endswith(".html")]
        if not own:
            raise
        (place, line), said = own[-1], str(mistake)
    raise SourceErrors([SourceError(Path(place), f"line {line}", said)])


def _loaded(templates: Path, name: str) -> tuple[str, str, None] | None:
    """A template's text and file; None for one that is not there."""
    file = templates / name
    return (text_of(file), str(file), None) if file.is_file() else None


class _Compiled(BytecodeCache):
    """Templates compiled in this process, by their text: all languages and builds use the same."""

    def __init__(self) -> None:
        self.kept: dict[str, bytes] = {}

    def load_bytecode(self, bucket: Bucket) -> None:
        """Jinja2 asks for a template by its name and the hash of its text."""
        if (code := self.kept.get(bucket.key + bucket.checksum)) is not None:
            bucket.bytecode_from_string(code)

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Jinja2 has compiled a template."""
        self.kept[bucket.key + bucket.checksum] = bucket.bytecode_to_string()


_COMPILED = _Compiled()


def page_environment(templates: Path, words: Words | None = None) -> Environment:
    """Jinja2 as every page uses it: all values are escaped, `say` and `tell` know the sentences
    of a language, of the default one if none is given."""
    environment = Environment(
        loader=FunctionLoader(partial(_loaded, templates)),
        autoescape=select_autoescape(default=True, default_for_string=True),
        bytecode_cache=_COMPILED,
        undefined=StrictUndefined,  # a misspelt name fails the build, not the page
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.globals.update(sayings(words or read_words()))
    others = [read_words(code) for code in languages()]
    environment.globals["languages"] = [
        {
            "code": each.code, "name": each.name, "home": home_of(each.code),
            "begin": each.say("kiosk.begin"),
        }
        for each in others
    ]  # fmt: skip
    return environment


def _named(scene: Scene) -> dict[str, str]:
    return {key: getattr(scene, key) for key in ("id", "key", "chapter", "title", "teaches")}


def card_of(scene: Scene, home: str, out: Path) -> dict[str, str]:
    """What a picture that leads to a scene's page shows."""
    at = f"scenes/{scene.traces}"
    thumb = f"{at}/{shown_picture(out / at, 'thumb')}"
    return _named(scene) | {"url": f"{home}scenes/{scene.id}/index.html", "thumb": thumb}


def _chapters(cards: Sequence[dict[str, str]]) -> list[dict[str, Any]]:
    """Scenes by chapter, in their order; each with its place among all, from 1."""
    placed = [card | {"place": str(place)} for place, card in enumerate(cards, start=1)]
    return [
        {"name": name, "scenes": list(of)}
        for name, of in groupby(placed, key=lambda card: card["chapter"])
    ]


def _glass(scene: Scene, home: str, out: Path) -> dict[str, str]:
    return card_of(scene, home, out) | {"glass_shadows": scene.render.glass_shadows}


def has_check(scene: Scene, out: Path) -> bool:
    """Whether there are pictures to check a student's against: of the scene itself."""
    return not scene.base and (out / "check" / scene.id).is_dir()


def _scene(scene: Scene, figures: Figures, out: Path) -> dict[str, Any]:
    render, at = scene.render, f"scenes/{scene.traces}"
    return {
        **_named(scene),
        "picture": f"{at}/{shown_picture(out / at, 'picture')}",
        "saved": f"{at}/picture.png",
        "size": render.size, "levels": sorted(render.resolutions), "depth": render.depth,
        "shadows": render.shadows, "figures": figures,
    }  # fmt: skip


def _lesson(
    scene: Scene, figures: Sequence[str], words: Words, glossary: Glossary
) -> list[dict[str, Any]]:
    """The steps with their answers. figures: paths of a figure for each step and each answer, in
    their order, which paper shows beside the words; fewer where slides were not made."""
    left = iter(figures)
    steps = []
    for step in scene.lesson:
        texts = (lesson_html(text, scene.id) for text in (step.text, step.answer))
        html, answer = (marked(text, glossary) for text in texts)
        seen = {"figure": next(left, ""), "answer_figure": next(left, "") if answer else ""}
        choices = [_choice(scene, choice, words) for choice in step.choices]
        steps.append({"html": html, "answer": answer, "choices": choices, **seen})
    return steps


def _choice(scene: Scene, choice: Choice, words: Words) -> dict[str, Any]:
    """Its label and its reason as HTML, and its swatch's colour."""
    if choice.pixel is not None:
        label = escape(words.say("card.pixel", column=choice.pixel[0], row=choice.pixel[1]))
    elif choice.object is not None:
        label = escape(scene.objects[choice.object].name)
    else:
        label = Markup(inline_html(choice.text, scene.id))
    colour = "rgb({} {} {})".format(*(round(255 * c) for c in choice.colour or (0, 0, 0)))
    return {
        "label": label, "because": Markup(inline_html(choice.because, scene.id)),
        "right": choice.right, "swatch": colour if choice.colour else "",
    }  # fmt: skip
