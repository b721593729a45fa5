/** What the tiles' colours mean, under the stage: it comes when they show something else than the picture. */
import type { OnDemand } from "../on-demand";
import type { Shown } from "../state/shown";
import type { ViewState } from "../state/view-state";
import type { Trace } from "../trace/types";
import { element } from "../element";
import type { Pointed } from "./tile-legend";

export function createTileColours(draw: () => void, onDemand: OnDemand) {
  const legend = element("div", "tile-legend");
  const meaning = onDemand.one("tile-legend", ({ createTileLegend }) => createTileLegend(legend));
  return {
    element: legend,
    show(state: ViewState, shown: Shown, trace: Trace | null, pointed: Pointed) {
      const costs = state.colours === "picture" || !trace ? null : shown.costs;
      const meant = costs && meaning.nowOr(draw);
      legend.hidden = !meant;
      if (meant) meant.show(state, costs, shown, trace!, pointed);
    },
  };
}
