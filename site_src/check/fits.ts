/** What a student's picture may be in place of the right one: changes of the right picture; of two that fit alike the first is told. */
import type { Picture } from "./formats/picture";

export type Fit =
  | "upsideDown" | "mirrored" | "turned" | "transposed" // turned: by half a turn
  | "bgr" | "gbr" | "brg" | "rbg" | "grb" // its first channel is blue, ...
  | "gammaApplied" | "gammaTaken" // brightened or darkened by the exponent 2.2
  | "halfSize" // the whole picture stands in its upper left quarter
  | "doubleSize"; // all of it is the upper left quarter

/** What stands at (x, y) of the changed picture, of its channel c. */
export type Change = (right: Picture, x: number, y: number, c: number) => number;

const GAMMA = 2.2;
const OF_THE_BACK = 0; // where a picture at half size leaves its page

const at = ({ width, values }: Picture, x: number, y: number, c: number) => values[3 * (y * width + x) + c];
const channels = (order: [number, number, number]): Change => (right, x, y, c) => at(right, x, y, order[c]);
const curved = (exponent: number): Change => (right, x, y, c) => 255 * (at(right, x, y, c) / 255) ** exponent;

export const FITS: [Fit, Change][] = [
  ["upsideDown", (right, x, y, c) => at(right, x, right.height - 1 - y, c)],
  ["mirrored", (right, x, y, c) => at(right, right.width - 1 - x, y, c)],
  ["turned", (right, x, y, c) => at(right, right.width - 1 - x, right.height - 1 - y, c)],
  ["transposed", (right, x, y, c) => at(right, y, x, c)], // pictures are square
  ["bgr", channels([2, 1, 0])], ["gbr", channels([1, 2, 0])], ["brg", channels([2, 0, 1])], ["rbg", channels([0, 2, 1])], ["grb", channels([1, 0, 2])],
  ["gammaApplied", curved(1 / GAMMA)], ["gammaTaken", curved(GAMMA)],
  ["halfSize", (right, x, y, c) => (2 * x < right.width - 1 && 2 * y < right.height - 1 ? at(right, 2 * x, 2 * y, c) : OF_THE_BACK)],
  ["doubleSize", (right, x, y, c) => at(right, x >> 1, y >> 1, c)],
];
