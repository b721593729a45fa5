/** What the tiles show: a menu. */
import type { Actions } from "../actions";
import { element } from "../element";
import { TILE_VIEWS, type TileView } from "../state/tile-views";
import type { ViewState } from "../state/view-state";
import { say } from "../words";

export function createTileMenu(acts: Pick<Actions, "colours">) {
  const menu = element("select", "tile-menu");
  for (const view of TILE_VIEWS) menu.append(new Option(say(`tileView.view.${view}`), view));
  let byPointer = false;
  menu.addEventListener("pointerdown", () => (byPointer = true));
  menu.addEventListener("keydown", () => (byPointer = false));
  menu.addEventListener("change", () => {
    acts.colours(menu.value as TileView);
    if (byPointer) menu.blur(); // the keys go on to the tiles
  });
  const label = element("label", "tile-choice", element("span", "group-name", say("tileView.name")), menu);
  label.title = say("tileView.help");
  return {
    element: label,
    show({ colours }: ViewState) {
      if (menu.value !== colours) menu.value = colours;
    },
  };
}
