/** How a picture deviates from the right one on a layer, and how far two deviations agree. */
import { counted, type Layer } from "./layer";

/** What is seen: wrong - right at each pixel, what counts of it, and in all. */
export interface Seen {
  colours: Float32Array;
  sizes: Float32Array;
  amount: number;
}

/** What a mistake makes: the same at those pixels alone that deviate at all, as most mistakes change little of a picture. */
export interface Deviation {
  places: Int32Array; // of the layer's pixels, in their order
  colours: Float32Array; // three a place
  sizes: Float32Array;
  amount: number;
}

export function seenOf({ right, most, weights }: Layer, wrong: ArrayLike<number>): Seen {
  const colours = new Float32Array(wrong.length);
  const sizes = new Float32Array(weights.length);
  let amount = 0;
  for (let i = 0, j = 0; i < sizes.length; i++, j += 3) {
    colours[j] = wrong[j] - right[j];
    colours[j + 1] = wrong[j + 1] - right[j + 1];
    colours[j + 2] = wrong[j + 2] - right[j + 2];
    sizes[i] = counted(colours[j], colours[j + 1], colours[j + 2], most);
    amount += weights[i] * sizes[i];
  }
  return { colours, sizes, amount };
}

export function deviationOf({ right, most, weights }: Layer, wrong: ArrayLike<number>): Deviation {
  const all = new Int32Array(weights.length);
  let count = 0;
  for (let i = 0, j = 0; i < all.length; i++, j += 3) {
    if (wrong[j] !== right[j] || wrong[j + 1] !== right[j + 1] || wrong[j + 2] !== right[j + 2]) all[count++] = i;
  }
  const places = all.slice(0, count);
  const [colours, sizes] = [new Float32Array(3 * count), new Float32Array(count)];
  let amount = 0;
  for (let k = 0, to = 0; k < count; k++, to += 3) {
    const j = 3 * places[k];
    colours[to] = wrong[j] - right[j];
    colours[to + 1] = wrong[j + 1] - right[j + 1];
    colours[to + 2] = wrong[j + 2] - right[j + 2];
    sizes[k] = counted(colours[to], colours[to + 1], colours[to + 2], most);
    amount += weights[places[k]] * sizes[k];
  }
  return { places, colours, sizes, amount };
}

/**
 * 1: the same; 0: nothing of it. A Jaccard index (shared over all) of amounts in place of sets. Where a mistake changes nothing, what
 * is seen is apart from it whole, so that only its own places are looked at.
 */
export function agreement({ weights, most }: Layer, seen: Seen, { places, colours, sizes }: Deviation): number {
  let [apart, all] = [seen.amount, seen.amount];
  const of = seen.colours;
  for (let k = 0, from = 0; k < places.length; k++, from += 3) {
    const place = places[k];
    const j = 3 * place;
    const own = seen.sizes[place];
    if (own === 0 && sizes[k] === 0) continue; // noise beside noise
    if (sizes[k] > own) all += weights[place] * (sizes[k] - own);
    apart += weights[place] * (counted(of[j] - colours[from], of[j + 1] - colours[from + 1], of[j + 2] - colours[from + 2], most) - own);
  }
  return index(apart, all);
}

/** The same of any picture, on the layer. */
export function agreementOfPicture({ right, weights, most }: Layer, seen: Seen, wrong: Float32Array): number {
  const of = seen.colours;
  let apart = 0;
  let all = 0;
  for (let i = 0, j = 0; i < weights.length; i++, j += 3) {
    const r = wrong[j] - right[j];
    const g = wrong[j + 1] - right[j + 1];
    const b = wrong[j + 2] - right[j + 2];
    const own = seen.sizes[i];
    const size = counted(r, g, b, most);
    if (own === 0 && size === 0) continue;
    apart += weights[i] * counted(of[j] - r, of[j + 1] - g, of[j + 2] - b, most);
    all += weights[i] * (size > own ? size : own);
  }
  return index(apart, all);
}

export const index = (apart: number, all: number) => (all > 0 ? Math.max(1 - apart / all, 0) : 0);
