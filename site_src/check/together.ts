/**
 * What two mistakes make together, out of what each makes alone. Some act on a whole picture, whatever is in it: which pixel shows
 * what, which byte a colour becomes. Others change what they change: that adds up, or the one hides the other.
 */
import { agreement, counted, deviationOf, index, type Deviation, type Layer } from "./layer";

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

/** A mistake's deviation on the layer at hand, and its name. */
export interface Alone {
  name: string;
  deviation: Deviation;
}

/** How far what both make together agrees with what is seen, in the best of the ways in which they may act together. */
export function agreementOfPair(layer: Layer, seen: Deviation, a: Alone, b: Alone): number {
  const onB = ON_WHOLE_PICTURES[a.name] ? afterAll(layer, seen, a, b) : 0;
  const onA = ON_WHOLE_PICTURES[b.name] ? afterAll(layer, seen, b, a) : 0;
  return onA || onB ? Math.max(onA, onB) : sideBySide(layer, seen, a.deviation, b.deviation);
}

function afterAll(layer: Layer, seen: Deviation, last: Alone, { deviation }: Alone): number {
  const picture = layer.right.slice();
  for (let i = 0; i < picture.length; i++) picture[i] += deviation.colours[i];
  return agreement(layer, seen, deviationOf(layer, ON_WHOLE_PICTURES[last.name](picture, layer.size)));
}

/** Added up; the first over the second; the second over the first. Where one changes nothing, all are the same. */
function sideBySide({ weights, right, most }: Layer, seen: Deviation, a: Deviation, b: Deviation): number {
  const [p, q, s] = [a.colours, b.colours, seen.colours];
  let [apart, apartFirst, apartSecond, all, allFirst, allSecond] = [0, 0, 0, 0, 0, 0];
  for (let i = 0, j = 0; i < weights.length; i++, j += 3) {
    const [ofA, ofB, own, weight] = [a.sizes[i], b.sizes[i], seen.sizes[i], weights[i]];
    if (ofA === 0 && ofB === 0 && own === 0) continue;
    const r = sum(right[j], p[j], q[j]);
    const g = sum(right[j + 1], p[j + 1], q[j + 1]);
    const d = sum(right[j + 2], p[j + 2], q[j + 2]);
    const added = weight * counted(s[j] - r, s[j + 1] - g, s[j + 2] - d, most);
    const most1 = weight * Math.max(own, counted(r, g, d, most));
    apart += added;
    all += most1;
    if (ofA === 0 || ofB === 0) {
      [apartFirst, apartSecond, allFirst, allSecond] = [apartFirst + added, apartSecond + added, allFirst + most1, allSecond + most1];
      continue;
    }
    apartFirst += weight * counted(s[j] - p[j], s[j + 1] - p[j + 1], s[j + 2] - p[j + 2], most);
    allFirst += weight * Math.max(own, ofA);
    apartSecond += weight * counted(s[j] - q[j], s[j + 1] - q[j + 1], s[j + 2] - q[j + 2], most);
    allSecond += weight * Math.max(own, ofB);
  }
  return Math.max(index(apart, all), index(apartFirst, allFirst), index(apartSecond, allSecond));
}

/** Two deviations of a colour, cut where bytes end. */
function sum(right: number, p: number, q: number): number {
  const both = p + q;
  return both < -right ? -right : both > 255 - right ? 255 - right : both;
}
