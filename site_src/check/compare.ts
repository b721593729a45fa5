/** How right a picture is: shares, means, a heat map, and which simple change would make it fit much better. */
import type { Picture } from "./formats/picture";
import { FITS, type Fit } from "./fits";
import { sampled } from "./layer";

/** Steps of 255: what rounding makes, what is hardly seen, what is seen. */
export const WITHIN = [1, 8, 32] as const;
/** A change is told if what is left of the mean deviation is at most this share of it: of the scenes' own pictures so changed
 *  0.06 is left, and of any other mistake that makes one darker or emptier 0.17 and more. */
const MUCH_BETTER = 0.1;
/** Below this mean deviation, steps of 255, there is nothing to be mended. */
const MENDED = 0.5;

export interface Comparison {
  pixels: number;
  within: [number, number, number]; // shares of the pixels whose worst colour is within 1, 8, 32 of 255
  mean: number; // of all colours' deviations, steps of 255
  largest: number;
  heat: Uint8ClampedArray; // red, green, blue, alpha a pixel
  /** What the picture seems to be instead of the right one, and the mean deviation from that. */
  fits: { as: Fit; mean: number } | null;
  /** Right, but each byte cut off where it should be rounded. */
  isTruncated: boolean;
}

/** Both of one size. */
export function compare(student: Picture, right: Picture): Comparison {
  const pixels = student.width * student.height;
  const heat = new Uint8ClampedArray(4 * pixels);
  const counts = WITHIN.map(() => 0);
  let [sum, largest] = [0, 0];
  for (let i = 0; i < pixels; i++) {
    let worst = 0;
    for (let c = 3 * i; c < 3 * i + 3; c++) {
      const deviation = Math.abs(student.values[c] - right.values[c]);
      sum += deviation;
      worst = Math.max(worst, deviation);
    }
    largest = Math.max(largest, worst);
    WITHIN.forEach((limit, k) => (counts[k] += worst <= limit ? 1 : 0));
    heat.set(HEAT[heatOf(worst)], 4 * i);
  }
  const mean = sum / (3 * pixels);
  const within = counts.map((count) => count / pixels) as [number, number, number];
  return { pixels, within, mean, largest, heat, fits: betterFit(student, right, mean), isTruncated: isTruncated(student, right) };
}

/** From black by violet and orange to pale yellow, even in lightness, along the logarithm: 1 of 255 is seen beside 100. */
const STOPS = [[8, 6, 22], [86, 16, 110], [188, 55, 84], [249, 142, 9], [252, 255, 164]];
const STEPS_OF_HEAT = 256;
const HEAT = Array.from({ length: STEPS_OF_HEAT }, (_, step) => {
  const at = (step / (STEPS_OF_HEAT - 1)) * (STOPS.length - 1);
  const from = Math.min(Math.floor(at), STOPS.length - 2);
  return Uint8Array.of(...STOPS[from].map((value, c) => Math.round(value + (at - from) * (STOPS[from + 1][c] - value))), 255);
});
const heatOf = (deviation: number) => (deviation ? Math.min(Math.round(((STEPS_OF_HEAT - 1) * Math.log2(1 + deviation)) / 8), STEPS_OF_HEAT - 1) : 0);

/** That of FITS which leaves least of the deviation, the earlier of equals, if that is little. */
function betterFit(student: Picture, right: Picture, mean: number): Comparison["fits"] {
  if (mean < MENDED) return null;
  const [own, expected] = [small(student), small(right)];
  let best = { as: FITS[0][0], mean: Infinity };
  for (const [as, changed] of FITS) {
    const left = meanDeviation(own, changed(expected));
    if (left < best.mean) best = { as, mean: left };
  }
  return best.mean <= MUCH_BETTER * mean ? best : null;
}

/** A fine picture tells no more of its flips and curves than every so-maniest pixel of it. */
const FINE_ENOUGH = 231;
function small(picture: Picture): Picture {
  if (picture.width <= FINE_ENOUGH) return picture;
  return { ...picture, width: FINE_ENOUGH, height: FINE_ENOUGH, values: sampled(picture.values, picture.width, FINE_ENOUGH) };
}

function meanDeviation(a: Picture, values: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.values.length; i++) sum += Math.abs(a.values[i] - values[i]);
  return sum / a.values.length;
}

/** Bytes between black and white are the right ones or one less, about as often: 99 in 100 at least, a fifth of them less. */
const [CUT_OFF_ALL, CUT_OFF_LESS] = [0.99, 0.2];

function isTruncated(student: Picture, right: Picture): boolean {
  let [between, same, less] = [0, 0, 0];
  for (let i = 0; i < right.values.length; i++) {
    if (right.values[i] < 1 || right.values[i] > 254) continue;
    between++;
    if (student.values[i] === right.values[i]) same++;
    else if (student.values[i] === right.values[i] - 1) less++;
  }
  return between > 0 && same + less >= CUT_OFF_ALL * between && less >= CUT_OFF_LESS * between;
}
