/** The tools beside the stage: looks, slices, what the tiles show, what if, and buttons that do what dragging does. */
import type { Actions } from "../actions";
import { button, group } from "../element";
import type { Moves } from "../state/observer";
import type { ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { createTileMenu } from "./tile-menu";
import { createViewPad } from "./view-pad";
import { createViewSwitch } from "./view-switch";

export type DrawerActs = Moves & Pick<Actions, "camera" | "look" | "slice" | "colours"> & { start: () => void; whatIf: () => void };

/** The button that opens the switches, whose panel comes with it or was opened before. */
function createOpener(open: () => void) {
  const made = button(say("whatIf.open.word"), say("whatIf.open.help"), open, { className: "open-what-if" });
  made.setAttribute("aria-controls", "what-if");
  made.setAttribute("aria-expanded", String(!!document.querySelector("#what-if:not([hidden])")));
  return made;
}

export function createDrawer(acts: DrawerActs) {
  const view = createViewSwitch(acts);
  const tiles = createTileMenu(acts);
  const pad = createViewPad(acts);
  return {
    parts: [view.element, view.note, tiles.element, createOpener(acts.whatIf), group(say("pad.name"), "", pad.element)],
    show(state: ViewState, scene: SceneData) {
      view.show(state, scene);
      tiles.show(state);
      pad.element.parentElement!.hidden = state.slice !== "none";
    },
  };
}
