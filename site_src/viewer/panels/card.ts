/** The selected pixel's card: where it is, its colour, and its rays as a list, as a tree and as a sum. */
import type { RayEvent } from "../state/event-types";
import { rayRows, type RayRow } from "../state/ray-rows";
import type { LitLine } from "../state/types";
import { isAsking, pixelIndex, tileColour, type ViewState } from "../state/view-state";
import type { SceneData, Trace } from "../trace/types";
import { say } from "../words";
import { createRays } from "./card-rays";
import { createSums } from "./card-sum";
import { createTree } from "./card-tree";
import { copy, treeTable, treeText } from "./copy";
import { sayDone } from "./done";
import { button, element, swatch } from "./element";
import { createTabs } from "./tabs";

export interface CardActs {
  move: (right: number, down: number) => void;
  light: (line: LitLine | null) => void;
  /** Goes to the event in which that happens to the ray. */
  tell: (ray: number, light: number, ...whats: RayEvent["what"][]) => void;
}

/** code: the algorithm, which has its tab here too. */
export function createCard(acts: CardActs, code: HTMLElement) {
  const chip = swatch("#000");
  const pixel = element("span", "pixel-name");
  const rgb = element("span", "pixel-colour numbers");
  const moves = [["\u2190", "left", -1, 0], ["\u2191", "up", 0, -1], ["\u2193", "down", 0, 1], ["\u2192", "right", 1, 0]] as const;
  const arrows = element("div", "joined arrows", ...moves.map(([sign, name, right, down]) => button(sign, say(`controls.moves.${name}`), () => acts.move(right, down), { className: "sign" })));
  const copies = (["text", "table"] as const).map((what) => {
    const made = button(say(`copy.${what}.word`), say(`copy.${what}.help`), () => {
      if (!rows.length) return;
      void copy(what === "text" ? treeText(heading, rows) : treeTable(rows), () => sayDone(made, say(`copy.${what}.done`)));
    });
    return made;
  });
  const head = element("div", "card-head", chip, element("h2", "pixel", pixel, rgb), arrows, element("div", "copies", ...copies));
  const rays = createRays(acts);
  const tree = createTree(acts);
  const sums = createSums(acts);
  const tabs = createTabs("card", say("card.tabs"), (["rays", "tree", "sum", "code"] as const).map((id) => ({ id, word: say(`card.tab.${id}.word`), help: say(`card.tab.${id}.help`), panel: element("div", "tab-panel", { rays, tree, sum: sums, code: { element: code } }[id].element) })), () => draw());
  const note = element("p", "note");
  const body = element("div", "card-body", ...tabs.panels);
  const root = element("section", "card", tabs.bar, note, body);
  root.setAttribute("aria-label", say("card.region"));

  let rows: readonly RayRow[] = [];
  let heading = "";
  let now: { state: ViewState; scene: SceneData; trace: Trace } | null = null;
  let shown: readonly unknown[] = [];
  let bright: readonly unknown[] = [];

  /** Only the panel that is seen is made. */
  function draw() {
    bright = [];
    body.hidden = !now && tabs.chosen() !== "code"; // the algorithm gives no answer away
    note.hidden = !body.hidden;
    if (!now) return;
    const { state, scene, trace } = now;
    if (tabs.chosen() === "rays") rays.show(rows);
    else if (tabs.chosen() === "tree") tree.show(rows);
    else if (tabs.chosen() === "sum") sums.show(rows, scene, trace, tileColour(trace, pixelIndex(state)));
  }

  /** Scrolls the list alone: the page stays where it is. */
  function showRow(of: HTMLElement, row: HTMLElement) {
    const [box, at] = [of.getBoundingClientRect(), row.getBoundingClientRect()];
    if (at.top < box.top) of.scrollTop += at.top - box.top;
    else if (at.bottom > box.bottom) of.scrollTop += Math.min(at.bottom - box.bottom, at.top - box.top);
  }

  function mark(of: HTMLElement, rows: readonly HTMLElement[], lit: HTMLElement | null, follow: boolean) {
    for (const row of rows) row.classList.toggle("lit", row === lit);
    if (lit && follow) showRow(of, lit);
  }

  return {
    element: root,
    /** Where the pixel is and what colour it has. */
    head,
    /** missing: this grid's rays could not be loaded. */
    show(state: ViewState, scene: SceneData, trace: Trace | null, missing: boolean) {
      const index = pixelIndex(state);
      const asking = isAsking(state, scene);
      const next = [trace, index, missing, asking];
      if (trace && next.every((each, k) => each === shown[k])) return;
      shown = next;
      heading = `${scene.title}, ${state.n} \u00d7 ${state.n}, ${say("card.pixel", { column: state.pixel[0], row: state.pixel[1] })}`;
      pixel.textContent = say("card.pixel", { column: state.pixel[0], row: state.pixel[1] });
      const isOpen = !!trace && !asking;
      const colour = isOpen ? tileColour(trace, index) : null;
      rgb.textContent = colour?.join(", ") ?? "";
      chip.style.backgroundColor = colour ? `rgb(${colour.join()})` : "transparent";
      for (const each of copies) each.setAttribute("aria-disabled", String(!isOpen));
      now = isOpen ? { state, scene, trace } : null;
      rows = isOpen ? rayRows(trace, scene, index) : [];
      if (!isOpen) note.textContent = say(asking ? "card.covered" : missing ? "card.none" : "card.waiting");
      draw();
    },
    /** Marks what belongs to the ray that is lit up on the stage, or to the told event; follow: and brings it into sight. */
    light(line: LitLine | null, told: RayEvent | null) {
      const next = [line, told];
      if (next.every((each, k) => each === bright[k])) return;
      bright = next;
      const lit = line ?? told;
      const follow = !line;
      if (tabs.chosen() === "tree") return tree.light(lit, follow);
      if (tabs.chosen() === "sum") return mark(sums.element, sums.items(), sums.lit(told), true);
      const items = [...rays.element.querySelectorAll<HTMLElement>("li.ray")];
      mark(rays.element, items, items.find(({ dataset }) => dataset.ray === String(lit?.ray) && dataset.light === String(lit?.light)) ?? null, follow);
    },
  };
}
