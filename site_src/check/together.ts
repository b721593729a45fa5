/**
 * What two mistakes make together, out of what each makes alone. Some act on a whole picture, whatever is in it: which pixel shows
 * what, which byte a colour becomes. Others change what they change: that adds up, or the one hides the other.
 */
import { agreementOfPicture, index, type Deviation, type Seen } from "./deviation";
import { counted, type Layer } from "./layer";

type Whole = (picture: Float32Array, size: number) => Float32Array;

const GAMMA = 2.2;

/** Steps to places in a picture: the pixel where the first takes its colour, and from there on across and down. */
type Steps = (size: number) => [first: number, across: number, down: number];

const moved = (stepsOf: Steps): Whole => (picture, size) => {
  const result = new Float32Array(picture.length);
  const [first, across, down] = stepsOf(size);
  for (let to = 0, y = 0; y < size; y++) {
    for (let x = 0; x < size; x++, to += 3) {
      const from = 3 * (first + x * across + y * down);
      result[to] = picture[from];
      result[to + 1] = picture[from + 1];
      result[to + 2] = picture[from + 2];
    }
  }
  return result;
};

/** Powers cost much, a million of them in a check: they are laid out, along a root so as to be dense in the dark, where a gamma is steep. */
const LAID_OUT = 4096;

function curved(power: number): Whole {
  const curve = Float32Array.from({ length: LAID_OUT + 1 }, (_, i) => 255 * (i / LAID_OUT) ** (2 * power));
  return (picture) => {
    const result = new Float32Array(picture.length);
    for (let i = 0; i < result.length; i++) result[i] = curve[Math.round(LAID_OUT * Math.sqrt(picture[i] / 255))];
    return result;
  };
}

const brightened = curved(1 / GAMMA);
export const darkened = curved(GAMMA);

function swapped(picture: Float32Array): Float32Array {
  const result = new Float32Array(picture.length);
  for (let i = 0; i < result.length; i++) result[i] = picture[i + 2 - 2 * (i % 3)];
  return result;
}

/** By the names of mistakes.json. */
export const ON_WHOLE_PICTURES: Record<string, Whole> = {
  "upside-down": moved((size) => [(size - 1) * size, 1, -size]),
  mirrored: moved((size) => [size - 1, -1, size]),
  "rows-and-columns-swapped": moved((size) => [0, size, 1]),
  "red-and-blue-swapped": swapped,
  "gamma-applied": brightened,
};

/** A mistake's name, its deviation on the layer at hand, and what it adds there, alone, to what is apart from what is seen and to all there is. */
export interface Alone {
  name: string;
  deviation: Deviation;
  apart: Float32Array; // at each of its places
  all: Float32Array;
  sums: { apart: number; all: number };
}

export function aloneOf({ weights, most }: Layer, seen: Seen, name: string, deviation: Deviation): Alone {
  const { places, colours, sizes } = deviation;
  const [apart, all] = [new Float32Array(places.length), new Float32Array(places.length)];
  const sums = { apart: 0, all: 0 };
  const s = seen.colours;
  for (let k = 0, from = 0; k < places.length; k++, from += 3) {
    const j = 3 * places[k];
    const weight = weights[places[k]];
    const own = seen.sizes[places[k]];
    if (own === 0 && sizes[k] === 0) continue; // noise beside noise
    apart[k] = weight * (counted(s[j] - colours[from], s[j + 1] - colours[from + 1], s[j + 2] - colours[from + 2], most) - own);
    all[k] = sizes[k] > own ? weight * (sizes[k] - own) : 0;
    sums.apart += apart[k];
    sums.all += all[k];
  }
  return { name, deviation, apart, all, sums };
}

/** How far what `a` and others make together agrees with what is seen, in the best of the ways in which they may act together. */
export function agreementWith(layer: Layer, seen: Seen, a: Alone): (b: Alone) => number {
  const slots = new Int32Array(layer.weights.length); // of a's places, from 1 on
  a.deviation.places.forEach((place, k) => (slots[place] = k + 1));
  return (b) => {
    const onB = ON_WHOLE_PICTURES[a.name] ? afterAll(layer, seen, a, b) : 0;
    const onA = ON_WHOLE_PICTURES[b.name] ? afterAll(layer, seen, b, a) : 0;
    return onA || onB ? Math.max(onA, onB) : sideBySide(layer, seen, a, b, slots);
  };
}

function afterAll(layer: Layer, seen: Seen, last: Alone, { deviation: { places, colours } }: Alone): number {
  const picture = layer.right.slice();
  for (let k = 0, from = 0; k < places.length; k++) for (let j = 3 * places[k], end = j + 3; j < end; j++, from++) picture[j] += colours[from];
  return agreementOfPicture(layer, seen, ON_WHOLE_PICTURES[last.name](picture, layer.size));
}

/** Added up; the first over the second; the second over the first. Where one changes nothing, all are the same. */
function sideBySide({ weights, right, most }: Layer, seen: Seen, a: Alone, b: Alone, slots: Int32Array): number {
  const [p, q, s] = [a.deviation.colours, b.deviation.colours, seen.colours];
  const { places } = b.deviation;
  const each = { apart: seen.amount + a.sums.apart + b.sums.apart, all: seen.amount + a.sums.all + b.sums.all }; // if nothing were changed by both
  let [apart, apartFirst, apartSecond] = [each.apart, each.apart, each.apart];
  let [all, allFirst, allSecond] = [each.all, each.all, each.all];
  for (let k = 0; k < places.length; k++) {
    const slot = slots[places[k]] - 1;
    if (slot < 0) continue;
    const j = 3 * places[k];
    const m = 3 * slot;
    const n = 3 * k;
    const own = seen.sizes[places[k]];
    if (own === 0 && a.deviation.sizes[slot] === 0 && b.deviation.sizes[k] === 0) continue;
    const weight = weights[places[k]];
    const r = sum(right[j], p[m], q[n]);
    const g = sum(right[j + 1], p[m + 1], q[n + 1]);
    const d = sum(right[j + 2], p[m + 2], q[n + 2]);
    const both = counted(r, g, d, most);
    const addedApart = weight * (counted(s[j] - r, s[j + 1] - g, s[j + 2] - d, most) - own) - a.apart[slot] - b.apart[k];
    const addedAll = weight * (both > own ? both - own : 0) - a.all[slot] - b.all[k];
    const doBoth = a.deviation.sizes[slot] !== 0 && b.deviation.sizes[k] !== 0;
    apart += addedApart;
    all += addedAll;
    apartFirst += doBoth ? -b.apart[k] : addedApart;
    allFirst += doBoth ? -b.all[k] : addedAll;
    apartSecond += doBoth ? -a.apart[slot] : addedApart;
    allSecond += doBoth ? -a.all[slot] : addedAll;
  }
  return Math.max(index(apart, all), index(apartFirst, allFirst), index(apartSecond, allSecond));
}

/** Two deviations of a colour, cut where bytes end. */
function sum(right: number, p: number, q: number): number {
  const both = p + q;
  return both < -right ? -right : both > 255 - right ? 255 - right : both;
}
