/** How right a picture is, where it is wrong, and which tiles are worth a walk. */
import { the } from "../../viewer/articles";
import { element, swatch } from "../../viewer/element";
import { fixed, percent, say } from "../../viewer/words";
import { WITHIN } from "../compare";
import type { Told } from "../places";
import type { Tile } from "../tiles";
import type { Chosen } from "./asked";
import type { Found } from "./found";

/** Of the table of objects: rows, and the least share of the wrong pixels. */
const [LINES, LEAST] = [6, 0.005];

const section = (head: string, ...parts: (Node | string)[]) => element("section", "", element("h2", "", head), ...parts);

function table(rows: [string, ...string[]][], head: string[] = []): HTMLTableElement {
  const line = ([name, ...cells]: [string, ...string[]]) => {
    const th = element("th", "", name);
    th.scope = "row";
    return element("tr", "", th, ...cells.map((cell) => element("td", "", cell)));
  };
  const heads = head.map((word) => Object.assign(element("th", "", word), { scope: "col" }));
  return element("table", "check-numbers", ...(head.length ? [element("thead", "", element("tr", "", ...heads))] : []), element("tbody", "", ...rows.map(line)));
}

export function howRight({ checked: { comparison } }: Found): HTMLElement {
  const { within, mean, largest, fits } = comparison;
  const steps = (value: number, digits: number) => say("check.how.steps", { value: fixed(value, digits) });
  const numbers = table([
    ...WITHIN.map((limit, k): [string, string] => [say("check.how.within", { steps: limit }), percent(within[k])]),
    [say("check.how.mean"), steps(mean, 2)],
    [say("check.how.largest"), steps(largest, 0)],
  ]);
  return section(say("check.how.head"), ...(fits ? [element("p", "check-fits", say(`check.fits.${fits.as}`))] : []), numbers);
}

export const nameOf = ({ objects }: Chosen, object: number) => objects[object] ?? say("check.where.backgroundName");

export function whereItIs({ checked: { isRight, where }, chosen }: Found): HTMLElement | null {
  if (isRight) return null;
  const rows = where.objects.filter(({ ofWrong }) => ofWrong >= LEAST).slice(0, LINES);
  const told = where.told.map((each) => element("li", "", sentenceOf(each, chosen)));
  return section(
    say("check.where.head"),
    element("ul", "check-told", ...(told.length ? told : [element("li", "", say("check.where.none"))])),
    table(rows.map(({ object, wrong, ofWrong }) => [nameOf(chosen, object), percent(wrong), percent(ofWrong)]), [say("check.where.tableObject"), say("check.where.tableWrong"), say("check.where.tableOf")]),
  );
}

function sentenceOf({ kind, object, ofWrong, ofPicture }: Told, chosen: Chosen): string {
  const place = kind === "object" ? say("check.where.object", { name: the(nameOf(chosen, object)) }) : say(`check.where.${kind}`);
  return say("check.where.only", { share: percent(ofWrong), place, part: percent(ofPicture) });
}

export function tilesToWalk({ checked: { tiles }, chosen }: Found): HTMLElement | null {
  if (!tiles.length) return null;
  const made = section(say("check.walk.head"), element("p", "check-notes", say("check.walk.says")), element("ul", "check-tiles", ...tiles.map((tile) => element("li", "", linkTo(tile, chosen)))));
  made.className = "check-walk";
  return made;
}

function linkTo({ n, x, y, object, own, right }: Tile, chosen: Chosen): HTMLElement {
  const bytes = (colour: Tile["own"]) => colour.join(", ");
  const colour = (of: Tile["own"]) => swatch(`rgb(${bytes(of)})`);
  const link = element("a", "", colour(own), colour(right), say("check.walk.pixel", { x, y, n, name: nameOf(chosen, object) }), element("span", "check-colours", say("check.walk.colours", { yours: bytes(own), right: bytes(right) })));
  link.href = `${document.body.dataset.root}${chosen.url}#n=${n}&p=${x},${y}`;
  return link;
}
