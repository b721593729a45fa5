/** What happens beside edges only: surfaces that tie, of which a program may show either; a picture of half a pixel further. */
import type { Picture } from "./formats/picture";
import { centresOf, NOISE } from "./layer";

/** Ties lie on lines, a pixel wide: of the n x n pixels this over n at most. A picture that is shifted has five times as many. */
const TIES_ALONG = 1.2;

const differs = (a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number) =>
  Math.abs(a[i] - b[j]) > NOISE || Math.abs(a[i + 1] - b[j + 1]) > NOISE || Math.abs(a[i + 2] - b[j + 2]) > NOISE;

/** Pixels with a colour further than NOISE from the right one, as places in values. */
export function wrongPixels({ values: own }: Picture, { values }: Picture): Int32Array {
  const found = new Int32Array(values.length / 3);
  let count = 0;
  for (let i = 0; i < values.length; i += 3) if (differs(own, i, values, i)) found[count++] = i;
  return found.subarray(0, count);
}

/** The student's picture with the right colour where it shows a neighbour's, if these pixels are so few that they may be ties. */
export function withoutTies(student: Picture, right: Picture, wrong: Int32Array): Picture {
  const { width, height, values } = right;
  const most = (TIES_ALONG * width * height) / Math.max(width, height);
  const ties: number[] = [];
  for (let k = 0; k < wrong.length && ties.length <= most; k++) if (showsNeighbour(student.values, right, wrong[k])) ties.push(wrong[k]);
  if (!ties.length || ties.length > most) return student;
  const settled = student.values.slice();
  for (const i of ties) for (let c = i; c < i + 3; c++) settled[c] = values[c];
  return { ...student, values: settled };
}

/** i: where a pixel of the student's stands in values. */
function showsNeighbour(own: Picture["values"], { width, height, values }: Picture, i: number): boolean {
  const x = (i / 3) % width;
  const y = (i / 3 - x) / width;
  const [left, end] = [Math.max(x - 1, 0), Math.min(x + 1, width - 1)];
  for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1); v++) {
    for (let j = 3 * (v * width + left), last = 3 * (v * width + end); j <= last; j += 3) if (!differs(own, i, values, j)) return true;
  }
  return false;
}

/**
 * The student's picture with the right colour where its own lies among those of the right pixel and its eight neighbours. For a
 * size that there is no right picture of: what stands in for it is up to a part of a pixel off.
 */
export function withoutEdges(student: Picture, right: Picture, wrong: Int32Array): Picture {
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

/** What half a pixel further up and left shows at a layer's pixels, in two readings. */
interface Shifted {
  nearest: Float32Array; // as near to the student's as four neighbours allow: beside an edge either side may be met
  halfWay: Float32Array; // means of four neighbours
}

/**
 * The right picture as it is seen half a pixel further up and left. A shift is the one mistake whose deviation depends on the
 * picture's own size, so no atlas has it. Of size x size pixels, at centresOf.
 */
export function shifted(student: Picture, { width, values }: Picture, size: number): Shifted {
  const places = centresOf(width, size);
  const [nearest, halfWay] = [new Float32Array(3 * size * size), new Float32Array(3 * size * size)];
  for (let v = 0, to = 0; v < size; v++) {
    const [row, above] = [3 * width * places[v], 3 * width * Math.max(places[v] - 1, 0)];
    for (let u = 0; u < size; u++) {
      const [here, left] = [3 * places[u], 3 * Math.max(places[u] - 1, 0)];
      for (let c = 0; c < 3; c++, to++) {
        const [p, q, r, s] = [values[row + here + c], values[row + left + c], values[above + here + c], values[above + left + c]];
        nearest[to] = Math.min(Math.max(student.values[row + here + c], Math.min(p, q, r, s)), Math.max(p, q, r, s));
        halfWay[to] = (p + q + r + s) / 4;
      }
    }
  }
  return { nearest, halfWay };
}
