/** What a lesson's step works out for the selected ray: a panel beside the stage, and what of it is drawn on the stage. The
 *  numbers are the pipeline's; here they are only shown, and a point moves along its ray. */
import { element, named } from "../element";
import { svg } from "../panels/svg";
import type { Drawn } from "../stage/renderer";
import { isAsking, stopOf } from "../state/view-state";
import { damaged } from "../trace/errors";
import type { WorkedData } from "../trace/types";
import { say } from "../words";
import { createAverage } from "./average";
import { createEquation } from "./equation";
import { createTree } from "./tree";
import type { WorkedPanel } from "./types";

const MAKERS = { equation: createEquation, tree: createTree, average: createAverage };

const KEPT = 4; // scenes

function workedFrom(json: unknown): WorkedData {
  if ((json as WorkedData | null)?.format !== 1) throw damaged("not what a lesson works out");
  return json as WorkedData;
}

export interface WorkedPlace {
  stage: HTMLElement;
  side: Element;
  /** The loader's: reads files, and keeps as many. */
  kept: <T>(size: number, read: (json: unknown) => T) => (name: string) => Promise<T>;
  /** Something was moved, or has come. */
  changed: () => void;
}

export function createWorked({ stage, side, kept, changed }: WorkedPlace) {
  const lines = svg("svg", { class: "worked-lines", "aria-hidden": "true" });
  const elsewhere = element("p", "worked-none", say("worked.elsewhere"));
  const root = named(element("section", "worked"), say("worked.region"));
  stage.append(lines);
  side.querySelector(".card")!.after(root);
  const panels = new Map<string, WorkedPanel>();
  const load = kept(KEPT, workedFrom);
  const come = new Map<string, WorkedData | null>(); // null: on its way, or not to be had
  let shown = ""; // the step

  function dataOf(scene: string): WorkedData | null {
    if (!come.has(scene)) {
      come.set(scene, null);
      load(`${scene}/worked`).then((data) => (come.set(scene, data), changed()), () => come.delete(scene));
    }
    return come.get(scene)!;
  }

  return {
    show(drawn: Drawn) {
      const { scene, state } = drawn.view;
      const view = stopOf(scene, state)?.view ?? {};
      const data = view.works ? dataOf(scene.id) : null;
      root.hidden = !data;
      side.parentElement!.classList.toggle("working", !!data);
      lines.replaceChildren();
      if (!data || !view.works) return void (shown = "");
      const step = `${scene.id} ${state.step} ${state.revealed}`;
      const panel = panels.get(view.works) ?? MAKERS[view.works](changed);
      panels.set(view.works, panel);
      const has = panel.show({ drawn, data, view, isAsking: isAsking(state, scene), isNew: step !== shown }, lines);
      shown = step;
      if (root.firstChild !== (has ? panel.element : elsewhere)) root.replaceChildren(has ? panel.element : elsewhere);
    },
  };
}
