/** What happens beside edges only: surfaces that tie, of which a program may show either; a picture of half a pixel further. */
import type { Picture } from "./formats/picture";
import { NOISE } from "./layer";

/** Ties lie on lines, a pixel wide: of the n x n pixels this over n at most. A picture that is shifted has five times as many. */
const TIES_ALONG = 1.2;

const differs = (a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number) =>
  Math.abs(a[i] - b[j]) > NOISE || Math.abs(a[i + 1] - b[j + 1]) > NOISE || Math.abs(a[i + 2] - b[j + 2]) > NOISE;

/** Pixels with a colour further than NOISE from the right one, as places in values. */
export function wrongPixels(student: Picture, right: Picture): number[] {
  const found: number[] = [];
  for (let i = 0; i < right.values.length; i += 3) if (differs(student.values, i, right.values, i)) found.push(i);
  return found;
}

/** The student's picture with the right colour where it shows a neighbour's, if these pixels are so few that they may be ties. */
export function withoutTies(student: Picture, right: Picture, wrong: number[]): Picture {
  const { width, height, values } = right;
  const showsNeighbour = (i: number) => {
    const [x, y] = [(i / 3) % width, Math.floor(i / 3 / width)];
    for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1); v++) {
      for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, width - 1); u++) if (!differs(student.values, i, values, 3 * (v * width + u))) return true;
    }
    return false;
  };
  const ties = wrong.filter(showsNeighbour);
  if (!ties.length || ties.length * Math.max(width, height) > TIES_ALONG * width * height) return student;
  const settled = student.values.slice();
  for (const i of ties) for (let c = i; c < i + 3; c++) settled[c] = values[c];
  return { ...student, values: settled };
}

/**
 * The student's picture with the right colour where its own lies among those of the right pixel and its eight neighbours. For a
 * size that there is no right picture of: what stands in for it is up to a part of a pixel off.
 */
export function withoutEdges(student: Picture, right: Picture, wrong: number[]): Picture {
  const { width, height, values } = right;
  const settled = student.values.slice();
  for (const i of wrong) {
    const [x, y] = [(i / 3) % width, Math.floor(i / 3 / width)];
    const isAmong = (c: number) => {
      let [low, high] = [255, 0];
      for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1); v++) {
        for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, width - 1); u++) {
          const value = values[3 * (v * width + u) + c];
          [low, high] = [Math.min(low, value), Math.max(high, value)];
        }
      }
      return student.values[i + c] >= low - NOISE && student.values[i + c] <= high + NOISE;
    };
    if (isAmong(0) && isAmong(1) && isAmong(2)) for (let c = i; c < i + 3; c++) settled[c] = values[c];
  }
  return { ...student, values: settled };
}

/** For each colour what becomes of it and its three neighbours up and left. */
function withNeighbours({ width, height, values }: Picture, of: (at: number, a: number, b: number, c: number, d: number) => number): Float32Array {
  const result = new Float32Array(values.length);
  for (let y = 0, to = 0; y < height; y++) {
    const [row, above] = [3 * width * y, 3 * width * Math.max(y - 1, 0)];
    for (let x = 0; x < width; x++) {
      const [here, left] = [3 * x, 3 * Math.max(x - 1, 0)];
      for (let c = 0; c < 3; c++, to++) result[to] = of(to, values[row + here + c], values[row + left + c], values[above + here + c], values[above + left + c]);
    }
  }
  return result;
}

/**
 * The right picture as it is seen half a pixel further up and left, as near to the student's as four neighbours allow: beside an
 * edge either side may be met. A shift is the one mistake whose deviation depends on the picture's own size, so no atlas has it.
 */
export const halfAPixelOff = (student: Picture, right: Picture): Picture => ({
  ...right, values: withNeighbours(right, (at, a, b, c, d) => Math.min(Math.max(student.values[at], Math.min(a, b, c, d)), Math.max(a, b, c, d))),
});

/** Means of four neighbours. */
export const shiftedHalfWay = (right: Picture): Picture => ({ ...right, values: withNeighbours(right, (_, a, b, c, d) => (a + b + c + d) / 4) });
