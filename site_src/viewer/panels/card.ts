/** The selected pixel's card: where it is, its colour, and its rays as a list, as a tree, as a sum and in the algorithm. */
import type { Actions } from "../actions";
import type { OnDemand } from "../on-demand";
import type { RayEvent } from "../state/event-types";
import { rayRows } from "../state/ray-rows";
import { TABS, type LitLine } from "../state/types";
import { isAsking, pixelIndex, tileColour, type ViewState } from "../state/view-state";
import type { SceneData, Trace } from "../trace/types";
import { say } from "../words";
import { createCardHead, type Copy } from "./card-head";
import type { PixelRays, RaysView } from "./card-types";
import { element, named } from "../element";
import { bringUp } from "./scrolls";
import { createShares } from "./shares";
import { createTabs } from "./tabs";

type CardActs = Pick<Actions, "move" | "light" | "goToEvent" | "tab">;

/** The tabs' panels and what is in them, which comes when its tab is first chosen; the shares are seen while none is. */
function createViews(acts: CardActs, onDemand: OnDemand) {
  const none = createShares(acts);
  const panel = (...content: Node[]) => element("div", "tab-panel", ...content);
  const panels = { rays: panel(), tree: panel(), sum: panel(), code: panel() };
  const into = (of: HTMLElement, view: RaysView) => (of.append(view.element), view);
  return {
    panels,
    shares: none.element,
    views: {
      none: { now: () => none, nowOr: () => none },
      rays: onDemand.one("card-rays", ({ createRays }) => into(panels.rays, createRays(acts))),
      tree: onDemand.one("card-tree", ({ createTree }) => into(panels.tree, createTree(acts))),
      sum: onDemand.one("card-sum", ({ createSums }) => into(panels.sum, createSums(acts))),
      code: onDemand.one("code", ({ createCode }) => into(panels.code, createCode())),
    },
  };
}

export function createCard(acts: CardActs, onDemand: OnDemand) {
  const { panels, shares, views } = createViews(acts, onDemand);
  const tabs = createTabs("card", say("card.tabs"), TABS.map((id) => ({ id, word: say(`card.tab.${id}.word`), help: say(`card.tab.${id}.help`), panel: panels[id] })), (id) => ((isOpened = true), acts.tab(id)));
  const head = createCardHead({ move: acts.move, copy: copyRays });
  const note = element("p", "note");
  const body = element("div", "card-body", shares, ...tabs.panels);
  const root = named(element("section", "card", note, body, tabs.bar), say("card.region"));

  let isOpened = false; // by a person: a link and a lesson leave the page where it is
  let heading = "";
  let now: PixelRays | null = null;
  let isCovered = true; // there are no rays yet, or they would give an answer away
  let shown: readonly unknown[] = [];
  let tab: ViewState["tab"] = "none";
  let lit: readonly [LitLine | null, RayEvent | null] = [null, null];

  const atHand = onDemand.one("at-hand", (part) => part);
  function copyRays(what: Copy, done: () => void) {
    if (isCovered) return;
    const [title, { rows }] = [heading, now!];
    atHand.use(({ copyRays }) => copyRays(what, title, rows, done));
  }

  /** Only the visible panel is filled. */
  function draw() {
    body.hidden = isCovered && tab !== "code"; // the algorithm gives no answer away
    note.hidden = !body.hidden;
    if (body.hidden) return;
    const view = views[tab].nowOr(draw);
    if (!view) return;
    if (now) view.show(now);
    view.light(...lit);
    if (isOpened && tab !== "none") bringUp(tabs.bar, "smooth");
    isOpened = false;
  }

  return {
    element: root,
    head: head.element,
    /** missing: this grid's rays could not be loaded. line: what is lit up on the stage. event: the current one. */
    show(state: ViewState, scene: SceneData, trace: Trace | null, missing: boolean, line: LitLine | null, event: RayEvent | null) {
      const [pixel, asking] = [pixelIndex(state), isAsking(state, scene)];
      const next = [trace, pixel, missing, asking, state.tab];
      const isSame = trace && next.every((each, k) => each === shown[k]);
      if (isSame && line === lit[0] && event === lit[1]) return;
      lit = [line, event];
      if (isSame) return body.hidden ? undefined : views[tab].now()?.light(line, event);
      shown = next;
      tab = state.tab;
      tabs.show(tab);
      shares.hidden = tab !== "none";
      isCovered = !trace || asking;
      now = trace && { rows: asking ? [] : rayRows(trace, scene, pixel), scene, trace, pixel };
      heading = `${scene.title}, ${state.n} \u00d7 ${state.n}, ${say("card.pixel", { column: state.pixel[0], row: state.pixel[1] })}`;
      head.show(state.pixel, isCovered ? null : tileColour(trace!, pixel));
      if (isCovered) note.textContent = say(asking ? "card.covered" : missing ? "card.none" : "card.waiting");
      draw();
    },
  };
}
