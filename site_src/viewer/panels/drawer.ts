/** The tools beside the stage: looks, slices, what the tiles show, what if, and buttons that do what dragging does. */
import type { Actions } from "../actions";
import { group } from "../element";
import type { Moves } from "../state/observer";
import type { ViewState } from "../state/view-state";
import type { SceneData } from "../trace/types";
import { say } from "../words";
import { createTileMenu } from "./tile-menu";
import { createViewPad } from "./view-pad";
import { createViewSwitch } from "./view-switch";

export type DrawerActs = Moves & Pick<Actions, "camera" | "look" | "slice" | "colours"> & { start: () => void };

/** whatIf: the button that opens the switches. */
export function createDrawer(acts: DrawerActs, whatIf: HTMLElement) {
  const view = createViewSwitch(acts);
  const tiles = createTileMenu(acts);
  const pad = createViewPad(acts);
  return {
    parts: [view.element, view.note, tiles.element, whatIf, group(say("pad.name"), "", pad.element)],
    show(state: ViewState, scene: SceneData) {
      view.show(state, scene);
      tiles.show(state);
      pad.element.parentElement!.hidden = state.slice !== "none";
    },
  };
}
