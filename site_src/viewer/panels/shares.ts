/** What the selected pixel's colour is made of: a bar as long as each share of it, and beside it which rays brought it. */
import type { RayRow } from "../state/ray-rows";
import { clickable, element, swatch } from "../element";
import { hexOf, percent, say } from "../words";
import { wayWords } from "../way-words";
import { lightsUp } from "./lights-up";
import type { LineActs, RaysView } from "./card-types";
import { markRow } from "./lit-row";

const MOST = 4; // shares with words of their own
const LEAST = 5e-4; // of the pixel: less is not worth a word, and "0 %" would be none

/** What a ray brings of its own: a surface's part of its colour, or all of the background's. */
const ownShare = ({ share, keeps, object }: RayRow) => (object ? share * keeps : share);

export function createShares(acts: LineActs): RaysView {
  const bar = element("div", "shares-bar");
  const list = element("ul", "shares");
  bar.setAttribute("aria-hidden", "true"); // the list says it in words
  const root = element("div", "made-of", bar, list);
  // One stop for the Tab key, however many shares there are.
  list.addEventListener("keydown", (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const items = [...list.querySelectorAll<HTMLElement>(".share")];
    const next = by && items[items.indexOf(document.activeElement as HTMLElement) + by];
    if (!by) return;
    event.preventDefault();
    if (!next) return;
    for (const each of items) each.tabIndex = each === next ? 0 : -1;
    next.focus();
  });

  function piece(row: RayRow): HTMLElement {
    const made = element("span");
    made.style.flexGrow = String(ownShare(row));
    made.style.backgroundColor = hexOf(row.local);
    lightsUp(made, (on) => acts.light(on ? { ray: row.ray, light: -1 } : null));
    return made;
  }

  function item(row: RayRow): HTMLElement {
    const object = row.object || say("card.background");
    const words = row.of ? say("card.sharedBy", { way: wayWords(row.way), object }) : object;
    const made = element("li", "share", swatch(hexOf(row.local)), element("b", "numbers", percent(ownShare(row))), element("span", "", words));
    made.dataset.ray = String(row.ray);
    lightsUp(made, (on) => acts.light(on ? { ray: row.ray, light: -1 } : null));
    return clickable(made, () => acts.goToEvent(row.ray, -1));
  }

  return {
    element: root,
    show({ rows }) {
      const parts = rows.filter((row) => ownShare(row) >= LEAST).sort((a, b) => ownShare(b) - ownShare(a));
      const [told, untold] = [parts.slice(0, MOST), parts.slice(MOST)];
      const sum = (of: readonly RayRow[]) => of.reduce((sum, row) => sum + ownShare(row), 0);
      const [more, none] = [sum(untold), 1 - sum(rows)]; // none: no bounce was left, or a switch has left them out
      bar.replaceChildren(...parts.map(piece));
      const line = (words: string) => element("li", "share-rest numbers", words);
      const rest = [...(untold.length ? [line(say("card.moreShares", { count: untold.length, share: percent(more) }))] : []), ...(none >= LEAST ? [line(say("card.noShare", { share: percent(none) }))] : [])];
      const items = told.map(item);
      for (const each of items.slice(1)) each.tabIndex = -1;
      list.replaceChildren(...items, ...rest);
    },
    light(line, event) {
      const ray = String((line ?? event)?.ray);
      const items = [...list.querySelectorAll<HTMLElement>(".share")];
      markRow(list, items, items.find(({ dataset }) => dataset.ray === ray) ?? null, !line);
    },
  };
}
