/**
 * What acts on a whole picture can be undone: what is left then deviates by a second mistake alone, if there is one. Beside a gamma,
 * which changes every pixel, a missing highlight would drown.
 */
import { sampled } from "./layer";
import { ON_WHOLE_PICTURES } from "./together";

type Undo = (picture: Float32Array, size: number) => Float32Array;

const GAMMA = 2.2;

const darkened: Undo = (picture) => picture.map((value) => 255 * (value / 255) ** GAMMA);

/** Rays that fan out by 4 to 3 across: what belongs at a pixel's place is found three quarters as far from the middle. */
const ACROSS = 3 / 4;
const widened: Undo = (picture, size) => {
  const result = new Float32Array(picture.length);
  const from = Int32Array.from({ length: size }, (_, x) => 3 * Math.floor(size / 2 + ACROSS * (x + 0.5 - size / 2)));
  for (let to = 0, y = 0; y < size; y++) for (const at of from) for (let c = 0; c < 3; c++) result[to++] = picture[3 * size * y + at + c];
  return result;
};

/** A flip or a swap that is done twice is undone. */
export const UNDONE: Record<string, Undo> = { ...ON_WHOLE_PICTURES, "gamma-applied": darkened, aspect: widened };

/** What takes its colours from between pixels deviates beside edges by itself. */
export const isRough = (name: string) => name === "aspect";

/** A student's picture on an atlas' grid with a mistake undone. */
export const without = (name: string, values: ArrayLike<number>, width: number, size: number): Float32Array => UNDONE[name](sampled(values, width, size), size);
