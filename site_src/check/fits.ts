/** What a student's picture may be in place of the right one: changes of the right picture; of two that fit alike the first is told. */
import type { Picture } from "./formats/picture";

export type Fit =
  | "upsideDown" | "mirrored" | "turned" | "transposed" // turned: by half a turn
  | "bgr" | "gbr" | "brg" | "rbg" | "grb" // its first channel is blue, ...
  | "gammaApplied" | "gammaTaken" // brightened or darkened by the exponent 2.2
  | "halfSize" // the whole picture stands in its upper left quarter
  | "doubleSize"; // all of it is the upper left quarter

type Change = (right: Picture) => ArrayLike<number>;
type Place = (x: number, y: number, width: number, height: number) => [number, number] | null;

const GAMMA = 2.2;
const OF_THE_BACK = 0; // where a picture at half size leaves its page

/** source: the pixel of the right picture that stands at (x, y), null where nothing does. */
const moved = (source: Place): Change => ({ width, height, values }) => {
  const result = new Float32Array(values.length);
  for (let to = 0, y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = source(x, y, width, height);
      for (let c = 0; c < 3; c++) result[to++] = from ? values[3 * (from[1] * width + from[0]) + c] : OF_THE_BACK;
    }
  }
  return result;
};

const channels = (order: [number, number, number]): Change => ({ values }) => Float32Array.from(values, (_, i) => values[i - (i % 3) + order[i % 3]]);
const curved = (exponent: number): Change => ({ values }) => Float32Array.from(values, (value) => 255 * (value / 255) ** exponent);

export const FITS: [Fit, Change][] = [
  ["upsideDown", moved((x, y, _, height) => [x, height - 1 - y])],
  ["mirrored", moved((x, y, width) => [width - 1 - x, y])],
  ["turned", moved((x, y, width, height) => [width - 1 - x, height - 1 - y])],
  ["transposed", moved((x, y) => [y, x])], // pictures are square
  ["bgr", channels([2, 1, 0])], ["gbr", channels([1, 2, 0])], ["brg", channels([2, 0, 1])], ["rbg", channels([0, 2, 1])], ["grb", channels([1, 0, 2])],
  ["gammaApplied", curved(1 / GAMMA)], ["gammaTaken", curved(GAMMA)],
  ["halfSize", moved((x, y, width, height) => (2 * x < width - 1 && 2 * y < height - 1 ? [2 * x, 2 * y] : null))],
  ["doubleSize", moved((x, y) => [x >> 1, y >> 1])],
];
