/**
 * What acts on a whole picture can be undone: what is left then deviates by a second mistake alone, if there is one. Beside a gamma,
 * which changes every pixel, a missing highlight would drown.
 */
import type { Factors } from "./atlas";
import { darkened, ON_WHOLE_PICTURES } from "./together";

export type Undo = (picture: Float32Array, size: number) => Float32Array;

/** What belongs at a pixel's place is found nearer to the middle by these factors, across and down. */
const drawnOut = (across: number, down: number): Undo => (picture, size) => {
  const result = new Float32Array(picture.length);
  const places = (by: number) => Int32Array.from({ length: size }, (_, i) => Math.floor(size / 2 + by * (i + 0.5 - size / 2)));
  const [columns, rows] = [places(across), places(down)];
  for (let to = 0, v = 0; v < size; v++) for (const u of columns) for (let c = 0; c < 3; c++) result[to++] = picture[3 * (size * rows[v] + u) + c];
  return result;
};

/** A flip or a swap that is done twice is undone. */
export const UNDONE: Record<string, Undo> = { ...ON_WHOLE_PICTURES, "gamma-applied": darkened };

/** Of what is smaller too little is left to tell; what is larger has lost its rim. */
const [SMALLEST, LARGEST] = [0.3, 0.96];
/** The right picture comes back, but for its edges: less is left than this share of what deviated. */
const BACK = 0.3;

/** What undoes a mistake, or null. right: of a scene on its grid. */
export function undoOf({ name, picture, drawnIn }: { name: string; picture: Uint8Array; drawnIn?: Factors }, right: Uint8Array, size: number): Undo | null {
  if (!drawnIn) return UNDONE[name] ?? null;
  if (drawnIn.some((factor) => factor !== 1 && (Math.abs(factor) < SMALLEST || Math.abs(factor) > LARGEST))) return null;
  return apartAt(right, picture, size, drawnIn) < BACK * apartAt(right, picture, size, [1, 1]) ? drawnOut(...drawnIn) : null;
}

/** Of every so-maniest pixel: how far the right one is from that of the wrong picture drawn out. */
function apartAt(right: Uint8Array, wrong: Uint8Array, size: number, [across, down]: Factors): number {
  const EVERY = 3;
  let sum = 0;
  for (let y = 1; y < size; y += EVERY) {
    const v = Math.floor(size / 2 + down * (y + 0.5 - size / 2));
    for (let x = 1; x < size; x += EVERY) {
      const [at, from] = [3 * (size * y + x), 3 * (size * v + Math.floor(size / 2 + across * (x + 0.5 - size / 2)))];
      for (let c = 0; c < 3; c++) sum += Math.abs(right[at + c] - wrong[from + c]);
    }
  }
  return sum;
}
