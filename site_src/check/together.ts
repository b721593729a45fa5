/**
 * What two mistakes make together, out of what each makes alone. Some act on a whole picture, whatever is in it: which pixel shows
 * what, which byte a colour becomes. Others change what they change: that adds up, or the one hides the other.
 */
import { agreement, counted, deviationOf, index, NOISE, type Deviation, type Layer } from "./layer";

type Whole = (picture: Float32Array, size: number) => Float32Array;

const GAMMA = 1 / 2.2;

/** source: the pixel where (x, y) takes its colour. */
const moved = (source: (x: number, y: number, size: number) => number): Whole => (picture, size) => {
  const result = new Float32Array(picture.length);
  for (let to = 0, y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const from = 3 * source(x, y, size);
      for (let c = 0; c < 3; c++) result[to++] = picture[from + c];
    }
  }
  return result;
};

function brightened(picture: Float32Array): Float32Array {
  const result = new Float32Array(picture.length);
  for (let i = 0; i < result.length; i++) result[i] = 255 * (picture[i] / 255) ** GAMMA;
  return result;
}

function swapped(picture: Float32Array): Float32Array {
  const result = new Float32Array(picture.length);
  for (let i = 0; i < result.length; i++) result[i] = picture[i + 2 - 2 * (i % 3)];
  return result;
}

/** By the names of mistakes.json. */
export const ON_WHOLE_PICTURES: Record<string, Whole> = {
  "upside-down": moved((x, y, size) => (size - 1 - y) * size + x),
  mirrored: moved((x, y, size) => y * size + size - 1 - x),
  "rows-and-columns-swapped": moved((x, y, size) => x * size + y),
  "red-and-blue-swapped": swapped,
  "gamma-applied": brightened,
};

/** A mistake's name, its deviation on the layer at hand, and how it alone agrees there with what is seen. */
export interface Alone {
  name: string;
  deviation: Deviation;
  apart: Float64Array; // of each pixel what of both is apart, and what there is in all
  all: Float64Array;
}

export function aloneOf({ weights, most }: Layer, seen: Deviation, name: string, deviation: Deviation): Alone {
  const [apart, all] = [new Float64Array(weights.length), new Float64Array(weights.length)];
  const [p, s] = [deviation.colours, seen.colours];
  for (let i = 0, j = 0; i < weights.length; i++, j += 3) {
    apart[i] = weights[i] * counted(s[j] - p[j], s[j + 1] - p[j + 1], s[j + 2] - p[j + 2], most);
    all[i] = weights[i] * Math.max(seen.sizes[i], deviation.sizes[i]);
  }
  return { name, deviation, apart, all };
}

/** How far what both make together agrees with what is seen, in the best of the ways in which they may act together; any figure
 *  below `least` if it is less than that. */
export function agreementOfPair(layer: Layer, seen: Deviation, a: Alone, b: Alone, least: number): number {
  const onB = ON_WHOLE_PICTURES[a.name] ? afterAll(layer, seen, a, b) : 0;
  const onA = ON_WHOLE_PICTURES[b.name] ? afterAll(layer, seen, b, a) : 0;
  return onA || onB ? Math.max(onA, onB) : sideBySide(layer, seen, a, b, least);
}

function afterAll(layer: Layer, seen: Deviation, last: Alone, { deviation }: Alone): number {
  const picture = layer.right.slice();
  for (let i = 0; i < picture.length; i++) picture[i] += deviation.colours[i];
  return agreement(layer, seen, deviationOf(layer, ON_WHOLE_PICTURES[last.name](picture, layer.size)));
}

/** Added up; the first over the second; the second over the first. Where one changes nothing, all are the same. */
function sideBySide({ weights, right, most, size }: Layer, seen: Deviation, a: Alone, b: Alone, least: number): number {
  const [p, q, s] = [a.deviation.colours, b.deviation.colours, seen.colours];
  const [sizesA, sizesB, sizes] = [a.deviation.sizes, b.deviation.sizes, seen.sizes];
  // What both make is no more than what each makes, and what noise of both makes together.
  const mostOfAll = seen.amount + a.deviation.amount + b.deviation.amount + NOISE * weights.length;
  const tooFar = (1 - least) * mostOfAll;
  let [apart, apartFirst, apartSecond, all, allFirst, allSecond] = [0, 0, 0, 0, 0, 0];
  for (let i = 0, j = 0; i < weights.length; i++, j += 3) {
    if (i % size === 0 && apart > tooFar && apartFirst > tooFar && apartSecond > tooFar) return 0;
    const [hasA, hasB, own, weight] = [sizesA[i] !== 0, sizesB[i] !== 0, sizes[i], weights[i]];
    if (!hasA && !hasB && own === 0) continue;
    const r = sum(right[j], p[j], q[j]);
    const g = sum(right[j + 1], p[j + 1], q[j + 1]);
    const d = sum(right[j + 2], p[j + 2], q[j + 2]);
    const addedApart = weight * counted(s[j] - r, s[j + 1] - g, s[j + 2] - d, most);
    const both = counted(r, g, d, most);
    const addedAll = weight * (own > both ? own : both);
    apart += addedApart;
    all += addedAll;
    apartFirst += hasA && hasB ? a.apart[i] : addedApart;
    apartSecond += hasA && hasB ? b.apart[i] : addedApart;
    allFirst += hasA && hasB ? a.all[i] : addedAll;
    allSecond += hasA && hasB ? b.all[i] : addedAll;
  }
  return Math.max(index(apart, all), index(apartFirst, allFirst), index(apartSecond, allSecond));
}

/** Two deviations of a colour, cut where bytes end. */
function sum(right: number, p: number, q: number): number {
  const both = p + q;
  return both < -right ? -right : both > 255 - right ? 255 - right : both;
}
