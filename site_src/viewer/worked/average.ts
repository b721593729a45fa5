/** The rays of finer grids in the selected tile, enlarged, and their mean; and all tiles with so many rays each. */
import { element, named, swatch } from "../element";
import type { View, WorkedAverage } from "../trace/types";
import { list, say } from "../words";
import { createChoice, drawSquare } from "./choice";
import type { Worked, WorkedPanel } from "./types";

type Rays = NonNullable<View["rays_a_tile"]>;
const SIDES = { inside: 180, whole: 180 }; // CSS pixels

const bytesOf = (base64: string): Uint8Array => Uint8Array.from(atob(base64), (each) => each.charCodeAt(0));
const rgb = (bytes: ArrayLike<number>, at: number): readonly number[] => [bytes[3 * at], bytes[3 * at + 1], bytes[3 * at + 2]];

/** Unpacked once. */
function unpack({ n, across, samples, means }: WorkedAverage) {
  return { n, grids: new Map(across.map((k, at) => [k, { samples: bytesOf(samples[at]), means: bytesOf(means[at]) }])) };
}

export function createAverage(changed: () => void): WorkedPanel {
  let across = 1;
  let from: WorkedAverage | null = null;
  let grids: ReturnType<typeof unpack> | null = null;
  const choice = createChoice(say("worked.average.rays"), (["1", "3", "5", "7"] as const).map((k) => [k, String(Number(k) ** 2), say("worked.average.help", { count: Number(k) ** 2 })] as const), (to) => ((across = Number(to)), changed()));
  const inside = named(element("canvas", "worked-tiles"), say("worked.average.inside"), "img");
  const whole = named(element("canvas", "worked-tiles"), say("worked.average.whole"), "img");
  const mean = element("p", "worked-title numbers");
  const note = element("p", "worked-note", say("worked.average.inside"));
  const under = element("p", "worked-note", say("worked.average.whole"));
  return {
    element: element("div", "", choice.element, mean, inside, note, whole, under),
    show({ drawn, data, view, isAsking, isNew }: Worked) {
      const { state } = drawn.view;
      const { average } = data;
      if (!average || state.n !== average.n) return false;
      if (average !== from) [from, grids] = [average, unpack(average)];
      if (isNew) across = Math.sqrt(view.rays_a_tile ?? (1 satisfies Rays));
      const { n } = average;
      const { samples, means } = grids!.grids.get(across)!;
      const [column, row] = state.pixel;
      const colour = rgb(means, row * n + column);
      choice.show(String(across) as "1");
      mean.replaceChildren(...(isAsking ? ["?"] : [swatch(`rgb(${colour.join()})`), ` ${list(colour.map(String))}`]));
      drawSquare(inside, across, (k) => `rgb(${rgb(samples, (row * across + Math.floor(k / across)) * n * across + column * across + (k % across)).join()})`, null, SIDES.inside * 2);
      inside.hidden = note.hidden = isAsking;
      drawSquare(whole, n, (k) => `rgb(${rgb(means, k).join()})`, [column, row], SIDES.whole * 2);
      whole.hidden = under.hidden = isAsking;
      return true;
    },
  };
}
