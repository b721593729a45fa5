/**
 * What acts on a whole picture can be undone: what is left then deviates by a second mistake alone, if there is one. Beside a gamma,
 * which changes every pixel, a missing highlight would drown.
 */
import { ON_WHOLE_PICTURES } from "./together";

export type Undo = (picture: Float32Array, size: number) => Float32Array;

const GAMMA = 2.2;

const darkened: Undo = (picture) => picture.map((value) => 255 * (value / 255) ** GAMMA);

/** What belongs at a pixel's place is found nearer to the middle by these factors, across and down. */
const drawnOut = (across: number, down: number): Undo => (picture, size) => {
  const result = new Float32Array(picture.length);
  const places = (by: number) => Int32Array.from({ length: size }, (_, i) => Math.floor(size / 2 + by * (i + 0.5 - size / 2)));
  const [columns, rows] = [places(across), places(down)];
  for (let to = 0, v = 0; v < size; v++) for (const u of columns) for (let c = 0; c < 3; c++) result[to++] = picture[3 * (size * rows[v] + u) + c];
  return result;
};

/** Rays that fan out by 4 to 3 across. */
const ACROSS = 3 / 4;

/** A flip or a swap that is done twice is undone. */
export const UNDONE: Record<string, Undo> = { ...ON_WHOLE_PICTURES, "gamma-applied": darkened, aspect: drawnOut(ACROSS, 1) };

/** By how much depends on the scene's field of view; turned round, if negative. */
const SCALED = ["fov-not-halved", "fov-in-radians"];
/** Of what is smaller too little is left to tell; what is larger has lost its rim. Steps as fine as half a pixel at the rim. */
const [SMALLEST, LARGEST, STEP] = [0.3, 0.96, 0.004];
/** The right picture comes back, but for its edges: less is left than this share of what deviated. */
const BACK = 0.3;

/** What takes its colours from between pixels deviates beside edges by itself. */
export const isRough = (name: string) => name === "aspect" || SCALED.includes(name);

/** right, wrong: of a scene on its grid. What undoes a mistake there, or null. */
export function undoOf(name: string, right: ArrayLike<number>, wrong: ArrayLike<number>, size: number): Undo | null {
  if (!SCALED.includes(name)) return UNDONE[name] ?? null;
  let [least, scale] = [BACK * apartAt(right, wrong, size, 1), 0];
  for (let by = SMALLEST; by < LARGEST; by += STEP) {
    for (const signed of [by, -by]) {
      const apart = apartAt(right, wrong, size, signed);
      if (apart < least) [least, scale] = [apart, signed];
    }
  }
  return scale ? drawnOut(scale, scale) : null;
}

/** Of every so-maniest pixel: how far the right one is from that of the wrong picture drawn out. */
function apartAt(right: ArrayLike<number>, wrong: ArrayLike<number>, size: number, by: number): number {
  const EVERY = 3;
  let sum = 0;
  for (let y = 1; y < size; y += EVERY) {
    const v = Math.floor(size / 2 + by * (y + 0.5 - size / 2));
    for (let x = 1; x < size; x += EVERY) {
      const [at, from] = [3 * (size * y + x), 3 * (size * v + Math.floor(size / 2 + by * (x + 0.5 - size / 2)))];
      for (let c = 0; c < 3; c++) sum += Math.abs(right[at + c] - wrong[from + c]);
    }
  }
  return sum;
}
