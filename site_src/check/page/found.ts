/** All that was found about a picture, in the order of its questions: how right, where, what it looks like, walk it. */
import { element, button } from "../../viewer/element";
import { percent, say } from "../../viewer/words";
import type { About } from "../atlas";
import type { Checked } from "../check";
import type { Picture } from "../formats/picture";
import type { Source, Square } from "../square";
import type { Chosen } from "./asked";
import { looksLike } from "./looks";
import { howRight, tilesToWalk, whereItIs } from "./numbers";
import { picturesOf } from "./pictures";

export interface Found {
  file: { name: string; width: number; height: number };
  chosen: Chosen;
  square: Square;
  right: Picture; // of the square's size
  source: Source;
  checked: Checked;
  about: About;
  nearest: number; // size that can be checked exactly
  again: () => void;
}

/** Fewer wrong pixels are nearly none. */
const CLOSE = 0.02;

export function showFound(place: HTMLElement, found: Found) {
  const { checked, square, right } = found;
  const verdict = element("h2", "check-verdict", headline(found));
  verdict.id = "verdict";
  const sections = [howRight(found), whereItIs(found), looksLike(found)].filter((each) => each !== null);
  place.replaceChildren(
    verdict,
    element("ul", "check-notes", ...notes(found).map((note) => element("li", "", note))),
    element("div", "check-columns", picturesOf(square.picture, right, checked.comparison.heat), element("div", "check-findings", ...sections)),
    tilesToWalk(found) ?? "",
    acts(place, found),
  );
  place.hidden = false;
  place.focus({ preventScroll: true });
  place.scrollIntoView({ block: "start" });
}

function headline({ checked: { isRight, comparison }, source }: Found): string {
  if (isRight) return say(source.isExact ? "check.verdict.right" : "check.verdict.nearly");
  const wrong = 1 - comparison.within[0];
  return say(wrong < CLOSE ? "check.verdict.close" : "check.verdict.wrong", { share: percent(wrong) });
}

function notes({ file, checked, square: { picture, isCut }, source, nearest }: Found): string[] {
  const size = picture.width;
  const all: [unknown, string][] = [
    [true, say("check.verdict.file", file)],
    [checked.isRight && source.isExact, say("check.verdict.rightSays")],
    [isCut, say("check.verdict.cut", { size })],
    [!source.isExact, say("check.verdict.sampled", { size, from: source.from, nearest })],
    [picture.isLossy, say("check.verdict.lossy")],
    [picture.hadAlpha, say("check.verdict.alpha")],
    [checked.comparison.isTruncated, say("check.how.truncated")],
  ];
  return all.flatMap(([holds, note]) => (holds ? [note] : []));
}

function acts(place: HTMLElement, { again, file, chosen }: Found): HTMLElement {
  const text = () => `${say("check.report.saved", { name: file.name, scene: chosen.title })}\n${reported(place)}\n`;
  const copy = button(say("check.report.copy"), say("check.report.copy"), () => void copied(text(), copy));
  const print = button(say("check.report.print"), say("check.report.print"), () => window.print());
  return element("p", "check-again", button(say("check.again"), say("check.again"), again), copy, print);
}

/** What stands in the page, line by line. */
const reported = (place: HTMLElement) => [...place.querySelectorAll("h2, h3, li, tr")].map((each) => [...each.querySelectorAll("td, th")].map((cell) => cell.textContent).join(": ") || each.textContent!).join("\n");

async function copied(text: string, by: HTMLElement) {
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
  by.querySelector(".word")!.textContent = say("check.report.copied");
}
