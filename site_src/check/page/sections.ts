/** A report's lines as parts of the page: lines of a kind stand together, in a list, a table, or a paragraph each. */
import { element, named, swatch } from "../../viewer/element";
import { say } from "../../viewer/words";
import type { Line, Part } from "../report";
import type { Tile } from "../tiles";
import { canvasWith, imageOf } from "./canvas";

type Kind = Line["kind"];
type Of<K extends Kind> = Extract<Line, { kind: K }>;

/** What a line leads to. */
export interface Links {
  tile: (tile: Tile) => string;
  mistake: (name: string) => string; // "": it has no page
  looked: (name: string) => Uint8Array | null; // what it makes of the scene, a square
}

/** null: nothing is said of it. */
export function sectionOf(lines: Line[], part: Part, links: Links): HTMLElement | null {
  const own = lines.filter((line) => line.part === part);
  if (!own.length) return null;
  const all = <K extends Kind>(kind: K) => own.filter((line): line is Of<K> => line.kind === kind);
  const texts = (kind: Kind) => all(kind).map(({ words }) => words);
  const parts = [
    ...texts("head").map((words) => element("h2", "", words)),
    ...texts("fit").map((words) => element("p", "check-fits", words)),
    ...[...texts("says"), ...texts("beside")].map((words) => element("p", "check-notes", words)),
    listOf("ul", "check-told", texts("place").map((words) => element("li", "", words))),
    table([], all("number")),
    table(all("columns"), all("object")),
    listOf("ol", "check-answers", answers(own, links)),
    listOf("ul", "check-tiles", all("tile").map((line) => element("li", "", linkTo(line, links)))),
  ];
  return element("section", part === "walk" ? "check-walk" : "", ...parts.filter((each) => each !== null));
}

const listOf = (tag: "ul" | "ol", name: string, items: HTMLElement[]) => (items.length ? element(tag, name, ...items) : null);

type Row = { words: string; values: string[] };

function table(heads: Row[], rows: Row[]): HTMLElement | null {
  if (!rows.length) return null;
  const cells = ({ words, values }: Row) => [words, ...values];
  const heading = (word: string, scope: string) => Object.assign(element("th", "", word), { scope });
  const head = heads.map((each) => element("thead", "", element("tr", "", ...cells(each).map((word) => heading(word, "col")))));
  const lines = rows.map(({ words, values }) => element("tr", "", heading(words, "row"), ...values.map((value) => element("td", "", value))));
  return element("table", "check-numbers", ...head, element("tbody", "", ...lines));
}

/** What is said of an answer's mistakes together stands below them, the line to look for below each. */
function answers(lines: Line[], { mistake, looked }: Links): HTMLElement[] {
  const items: HTMLElement[] = [];
  const heads = new Map<string, HTMLElement>(); // of the last answer
  for (const line of lines) {
    if (line.kind === "answer") {
      heads.clear();
      line.names.forEach((name, k) => heads.set(name, titled(line.titles[k], mistake(name))));
      items.push(element("li", "", ...shown(looked(line.names[0])), ...heads.values(), element("p", "check-agree", ...line.values)));
    }
    const last = items[items.length - 1];
    if (line.kind === "line") heads.size > 1 ? heads.get(line.name)!.after(lineOf(line)) : last.append(lineOf(line));
    if (line.kind === "alike" || line.kind === "apart") last.append(element("p", `check-${line.kind}`, line.words));
  }
  return items;
}

function lineOf({ words, values: [right, wrong] }: Of<"line">): HTMLElement {
  const row = (side: string, says: string, code: string) => element("div", `is-${side}`, element("dt", "", says), element("dd", "", element("code", "", code)));
  return element("div", "lines", element("p", "", words), element("dl", "", row("right", say("check.view.right"), right), row("wrong", say("check.looks.withMistake"), wrong)));
}

/** What a mistake makes of the scene, to hold beside one's own; nothing where that is not known. */
function shown(picture: Uint8Array | null): HTMLElement[] {
  if (!picture) return [];
  const size = Math.sqrt(picture.length / 3);
  return [named(canvasWith(imageOf(picture, size)), say("check.looks.shown"), "img")];
}

function titled(title: string, url: string): HTMLElement {
  if (!url) return element("h3", "", title);
  const link = element("a", "", title);
  link.href = url;
  return element("h3", "", link);
}

function linkTo({ words, values, tile }: Of<"tile">, links: Links): HTMLElement {
  const colour = (of: Tile["own"]) => swatch(`rgb(${of.join(", ")})`);
  const link = element("a", "", colour(tile.own), colour(tile.right), words, element("span", "check-colours", ...values));
  link.href = links.tile(tile);
  return link;
}
