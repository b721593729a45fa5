/** What the tiles' colours mean, and the numbers of the selected and the pointed tile; for counts a scale. */
import { onScale, scaleOf, type CountedView, type ScaledView } from "../state/costs";
import { triple } from "../state/vectors";
import type { Shown } from "../state/shown";
import type { Costs } from "../state/tile-views";
import { pixelIndex, type ViewState } from "../state/view-state";
import type { RayBoxes } from "../trace/boxes";
import type { Trace } from "../trace/types";
import { grouped, list, number, percent, say, vector } from "../words";
import { element } from "../element";

export { costsOf } from "../state/costs"; // of the same part: what the colours mean, and they

const STOPS = 10;

function ramp(): string {
  const stops = Array.from({ length: STOPS }, (_, k) => `rgb(${onScale(k / (STOPS - 1)).join()})`);
  return `linear-gradient(90deg, ${stops.join(", ")})`;
}

/** At an end of the scale a count needs no noun. */
function written(view: ScaledView, value: number, atEnd: boolean): string {
  const how = scaleOf(view).written;
  if (how !== "count") return how === "share" ? percent(value) : number(value);
  return atEnd ? String(value) : say(`tileView.count.${view as CountedView}`, { count: value });
}

function valueOf({ view, values }: Costs, trace: Trace, tile: readonly [number, number]): string {
  const index = tile[1] * trace.n + tile[0];
  const leaves = trace.object[index] < 0;
  if (view === "normal") return leaves ? say("tileView.leaves") : vector(triple(trace.normal, index));
  const value = values?.[index] ?? 0;
  if (Number.isNaN(value)) return say(leaves ? "tileView.leaves" : "tileView.none");
  return written(view as ScaledView, value, false);
}

/** What the bounding volumes saved the selected camera ray. */
function boxWords({ boxes, spheres, without }: RayBoxes, made: number): string[] {
  const entered = boxes.filter((box) => box.entered).length;
  const saved = percent(Math.max(0, 1 - made / without));
  const shown = spheres.some((each) => each.entered) ? say("tileView.boxes.tested", { count: boxes.length, entered }) : say("tileView.boxes.passesBy");
  return [say("tileView.boxes.saved", { made: grouped(made), without: grouped(without), saved }), shown];
}

type Pointed = readonly [number, number] | null;

/** row: the element that it stands under. */
export function createTileLegend(row: Element) {
  const [least, most] = [element("span"), element("span")];
  const bar = element("span", "ramp");
  bar.style.backgroundImage = ramp();
  const scale = element("div", "scale numbers", least, bar, most);
  const means = element("p", "means");
  const values = element("p", "tile-values numbers");
  const legend = element("div", "tile-legend", means, scale, values);
  row.after(legend);

  return {
    show({ pixel, colours }: ViewState, { costs, boxes }: Shown, trace: Trace | null, pointed: Pointed) {
      legend.hidden = colours === "picture" || !trace || !costs;
      if (legend.hidden || !trace || !costs || costs.view === "picture") return;
      scale.hidden = !costs.values;
      means.textContent = say(`tileView.means.${costs.view}`);
      const end = (value: number) => (costs.values ? written(costs.view as ScaledView, value, true) : "");
      [least.textContent, most.textContent] = [end(costs.least), end(costs.most)];
      const slotsOf = (tile: readonly [number, number]) => ({ pixel: list(tile.map(String)), value: valueOf(costs, trace, tile) });
      const lines = [say("tileView.selected", slotsOf(pixel))];
      if (boxes) lines.push(...boxWords(boxes, trace.tests[pixelIndex({ pixel, n: trace.n })]));
      lines.push(pointed ? say("tileView.pointed", slotsOf(pointed)) : ""); // last: it comes and goes
      values.replaceChildren(...lines.map((line) => element("span", "", line)));
    },
  };
}
