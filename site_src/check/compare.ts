/** How right a picture is: shares, means, a heat map, and which simple change would make it fit much better. */
import type { Picture } from "./formats/picture";
import { FITS, type Change, type Fit } from "./fits";
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
  const heat = new Uint32Array(pixels);
  const [own, expected] = [student.values, right.values];
  const counts = new Uint32Array(256); // of pixels, by their worst colour rounded upwards
  let [sum, largest] = [0, 0];
  for (let i = 0, j = 0; i < pixels; i++, j += 3) {
    const [r, g, b] = [Math.abs(own[j] - expected[j]), Math.abs(own[j + 1] - expected[j + 1]), Math.abs(own[j + 2] - expected[j + 2])];
    const worst = r > g ? (r > b ? r : b) : g > b ? g : b;
    sum += r + g + b;
    if (worst > largest) largest = worst;
    counts[Math.ceil(worst)]++;
    heat[i] = HEAT[Number.isInteger(worst) ? STEP_OF[worst] : stepOf(worst)];
  }
  const mean = sum / (3 * pixels);
  const within = WITHIN.map((limit) => counts.subarray(0, limit + 1).reduce((all, count) => all + count, 0) / pixels) as [number, number, number];
  return { pixels, within, mean, largest, heat: new Uint8ClampedArray(heat.buffer), fits: betterFit(student, right, mean), isTruncated: isTruncated(student, right) };
}

/** From black by violet and orange to pale yellow, even in lightness, along the logarithm: 1 of 255 is seen beside 100. */
const STOPS = [[8, 6, 22], [86, 16, 110], [188, 55, 84], [249, 142, 9], [252, 255, 164]];
const STEPS_OF_HEAT = 256;
const HEAT = new Uint32Array(Uint8Array.from({ length: 4 * STEPS_OF_HEAT }, (_, i) => {
  const [step, c] = [i >> 2, i & 3];
  const at = (step / (STEPS_OF_HEAT - 1)) * (STOPS.length - 1);
  const from = Math.min(Math.floor(at), STOPS.length - 2);
  return c === 3 ? 255 : Math.round(STOPS[from][c] + (at - from) * (STOPS[from + 1][c] - STOPS[from][c]));
}).buffer);
const stepOf = (deviation: number) => Math.min(Math.round(((STEPS_OF_HEAT - 1) * Math.log2(1 + deviation)) / 8), STEPS_OF_HEAT - 1);
/** Of whole deviations, which those of bytes are. */
const STEP_OF = Uint8Array.from({ length: STEPS_OF_HEAT }, (_, deviation) => stepOf(deviation));

/** That of FITS which leaves least of the deviation, the earlier of equals, if that is little. */
function betterFit(student: Picture, right: Picture, mean: number): Comparison["fits"] {
  if (mean < MENDED) return null;
  const [own, expected] = [small(student), small(right)];
  let best: Comparison["fits"] = null;
  let most = MUCH_BETTER * mean;
  for (const [as, change] of FITS) {
    const left = deviationFrom(change, own, expected, most);
    if (left > most || (best && left === most)) continue;
    [best, most] = [{ as, mean: left }, left];
  }
  return best;
}

/** Mean deviation from the right picture so changed; Infinity as soon as it is more than `most`. */
function deviationFrom(change: Change, { values }: Picture, right: Picture, most: number): number {
  let sum = 0;
  for (let y = 0, i = 0; y < right.height; y++) {
    for (let x = 0; x < right.width; x++) for (let c = 0; c < 3; c++, i++) sum += Math.abs(values[i] - change(right, x, y, c));
    if (sum > most * values.length) return Infinity;
  }
  return sum / values.length;
}

/** A fine picture tells no more of its flips and curves than every so-maniest pixel of it. */
const FINE_ENOUGH = 231;
function small(picture: Picture): Picture {
  if (picture.width <= FINE_ENOUGH) return picture;
  return { ...picture, width: FINE_ENOUGH, height: FINE_ENOUGH, values: sampled(picture.values, picture.width, FINE_ENOUGH) };
}

/** Bytes between black and white are the right ones or one less, about as often: 99 in 100 at least, a fifth of them less. */
const [CUT_OFF_ALL, CUT_OFF_LESS] = [0.99, 0.2];

function isTruncated(student: Picture, right: Picture): boolean {
  let [between, same, less] = [0, 0, 0];
  const [own, expected] = [student.values, right.values];
  for (let i = 0; i < expected.length; i++) {
    if (expected[i] < 1 || expected[i] > 254) continue;
    between++;
    if (own[i] === expected[i]) same++;
    else if (own[i] === expected[i] - 1) less++;
  }
  return between > 0 && same + less >= CUT_OFF_ALL * between && less >= CUT_OFF_LESS * between;
}
