/** What the tiles show: a menu; what their colours mean comes when they show something else than the picture. */
import type { Actions } from "../actions";
import type { OnDemand } from "../on-demand";
import type { Shown } from "../state/shown";
import { TILE_VIEWS, type TileView } from "../state/tile-views";
import type { ViewState } from "../state/view-state";
import type { Trace } from "../trace/types";
import { say } from "../words";
import { element } from "../element";
import type { Pointed } from "./tile-legend";

export function createTileColours(acts: Pick<Actions, "colours"> & { draw: () => void }, onDemand: OnDemand) {
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
  const legend = element("div", "tile-legend");
  const meaning = onDemand.one("tile-legend", ({ createTileLegend }) => createTileLegend(legend));

  return {
    element: label,
    legend,
    show(state: ViewState, shown: Shown, trace: Trace | null, pointed: Pointed) {
      const { colours } = state;
      if (menu.value !== colours) menu.value = colours;
      const costs = colours === "picture" || !trace ? null : shown.costs;
      const meant = costs && meaning.nowOr(acts.draw);
      legend.hidden = !meant;
      if (meant) meant.show(state, costs, shown, trace!, pointed);
    },
  };
}
