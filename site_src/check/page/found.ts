/** All that was found about a picture: the report's lines beside both pictures, and what can be done with them. */
import { button, element, setWord } from "../../viewer/element";
import { say } from "../../viewer/words";
import type { Picture } from "../formats/picture";
import { reportOf, written, type Found as Told, type Named } from "../report";
import { addressOf } from "./address";
import { titles, type Chosen } from "./asked";
import { picturesOf } from "./pictures";
import { sectionOf, type Links } from "./sections";

export interface Found extends Told {
  chosen: Chosen;
  right: Picture; // of the square's size
  looked: (mistake: string) => Uint8Array | null; // what it makes of the scene
  other: { title: string; compare: () => void } | null; // a scene that the picture shows rather than this one
  again: () => void;
}

const mistakes: Record<string, Named & { url: string }> = JSON.parse(document.getElementById("found")!.dataset.mistakes!);

export function showFound(place: HTMLElement, found: Found) {
  const { checked, chosen, square, right } = found;
  const lines = reportOf(found, { scene: chosen.title, objects: chosen.objects, mistakes, scenes: titles() });
  const [{ words }, ...others] = lines;
  const verdict = element("h2", "check-verdict", words);
  verdict.id = "verdict";
  const links = linksOf(found);
  const findings = (["how", "where", "looks"] as const).map((part) => sectionOf(lines, part, links)).filter((each) => each !== null);
  place.replaceChildren(
    verdict,
    otherScene(found) ?? "",
    element("ul", "check-notes", ...others.filter(({ part }) => part === "verdict").map((note, k) => element("li", !k && checked.answers.length ? "check-like" : "", note.words))),
    element("div", "check-columns", picturesOf(square.picture, right, checked.comparison.heat), element("div", "check-findings", ...findings)),
    sectionOf(lines, "walk", links) ?? "",
    acts([say("check.report.saved", { name: found.file.name, scene: chosen.title }), ...written(lines), ""].join("\n"), found.again),
  );
  place.hidden = false;
  place.focus({ preventScroll: true });
  place.scrollIntoView({ block: "start" });
}

/** null: it is this one. */
function otherScene({ other }: Found): HTMLElement | null {
  if (!other) return null;
  const words = say("check.anotherScene.compare", { title: other.title });
  return element("p", "notice check-other", say("check.anotherScene.says", { title: other.title }), button(words, words, other.compare));
}

function linksOf({ chosen: { id, url }, looked }: Found): Links {
  const { root } = document.body.dataset;
  return {
    looked,
    tile: ({ n, x, y, own }) => `${root}${url}?yours=${[n, x, y, ...own].join()}#n=${n}&p=${x},${y}`,
    mistake: (name) => mistakes[name].url && `${root}${mistakes[name].url}${addressOf(id, false)}`,
  };
}

function acts(report: string, again: () => void): HTMLElement {
  const copy = button(say("check.report.copy"), say("check.report.copy"), () => void copied(report, copy));
  const print = button(say("check.report.print"), say("check.report.print"), () => window.print());
  return element("p", "check-again", button(say("check.again"), say("check.again"), again), copy, print);
}

async function copied(text: string, by: HTMLButtonElement) {
  const area = element("textarea", "unseen");
  area.value = text;
  // From file:// and in a plain http page there is no clipboard to write to: a selected text can be copied there too.
  const isDone = await navigator.clipboard?.writeText(text).then(() => true, () => false);
  if (!isDone) {
    by.after(area);
    area.select();
    document.execCommand("copy");
    area.remove();
    by.focus();
  }
  setWord(by, say("check.report.copied"), say("check.report.copied"));
}
