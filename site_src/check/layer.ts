/**
 * A layer is a small picture of a scene's: its pixels, or means of blocks. Half of an agreement is told by pixels, half by blocks:
 * speckles fall elsewhere in each program, but as densely.
 */

/** Steps of 255 that say nothing: rounding, cutting off, float32. */
export const NOISE = 3;
/** Steps of 255 from which on more does not count more: a few very wrong pixels must not drown what all others say. */
export const [MOST_OF_PIXEL, MOST_OF_BLOCK] = [40, 20];
/** Between neighbours: here stands an edge, where sampling at other places deviates by itself. Edges tell little. */
const EDGE = 24;
const WEIGHT_OF_EDGES = 0.2;

export interface Layer {
  size: number; // size x size
  right: Float32Array; // red, green, blue, row by row
  weights: Float32Array; // what each pixel counts
  most: number;
}

/** For each of a layer's rows or columns, of which of an n x n picture's it takes its colours: that at the centre of its pixels. */
export const centresOf = (n: number, size: number): Int32Array => Int32Array.from({ length: size }, (_, i) => Math.min(Math.floor(((i + 0.5) * n) / size), n - 1));

/** Of an n x n picture of any size, its colours at the centres of a layer's pixels. */
export function sampled(values: ArrayLike<number>, n: number, size: number): Float32Array {
  const places = centresOf(n, size);
  const found = new Float32Array(3 * size * size);
  for (let v = 0, to = 0; v < size; v++) {
    const row = places[v] * n;
    for (let u = 0; u < size; u++, to += 3) {
      const from = 3 * (row + places[u]);
      found[to] = values[from];
      found[to + 1] = values[from + 1];
      found[to + 2] = values[from + 2];
    }
  }
  return found;
}

/** Means of blocks, each `by` pixels along; what is over at the right and at the bottom is left out. */
export function meansOf(colours: ArrayLike<number>, n: number, by: number): Float32Array {
  const size = Math.floor(n / by);
  const means = new Float32Array(3 * size * size);
  for (let v = 0, to = 0; v < size; v++) {
    for (let u = 0; u < size; u++, to += 3) {
      let [r, g, b] = [0, 0, 0];
      for (let y = v * by; y < (v + 1) * by; y++) {
        for (let from = 3 * (y * n + u * by), end = from + 3 * by; from < end; from += 3) {
          r += colours[from];
          g += colours[from + 1];
          b += colours[from + 2];
        }
      }
      means[to] = r / (by * by);
      means[to + 1] = g / (by * by);
      means[to + 2] = b / (by * by);
    }
  }
  return means;
}

export function layerOf(right: Float32Array, size: number, most: number): Layer {
  const weights = new Float32Array(size * size).fill(1);
  if (most === MOST_OF_PIXEL) for (let c = 0; c < 3; c++) lessAtEdges(weights, right, size, c);
  return { size, right, weights, most };
}

/** Where a colour differs much among a pixel and its eight neighbours: least and most of each column of three, then of three of these. */
function lessAtEdges(weights: Float32Array, right: Float32Array, size: number, c: number): void {
  const [low, high] = [new Float32Array(size), new Float32Array(size)];
  const last = size - 1;
  for (let y = 0; y < size; y++) {
    const [above, here, below] = [Math.max(y - 1, 0), y, Math.min(y + 1, last)].map((row) => 3 * size * row + c);
    for (let x = 0, at = 0; x < size; x++, at += 3) {
      low[x] = Math.min(right[above + at], right[here + at], right[below + at]);
      high[x] = Math.max(right[above + at], right[here + at], right[below + at]);
    }
    for (let x = 0; x < size; x++) {
      const before = x > 0 ? x - 1 : 0;
      const after = x < last ? x + 1 : last;
      const contrast = Math.max(high[before], high[x], high[after]) - Math.min(low[before], low[x], low[after]);
      if (contrast > EDGE) weights[size * y + x] = WEIGHT_OF_EDGES;
    }
  }
}

/** What counts of a difference of colours. */
export function counted(r: number, g: number, b: number, most: number): number {
  if (r < 0) r = -r;
  if (g < 0) g = -g;
  if (b < 0) b = -b;
  const size = (r > g ? (r > b ? r : b) : g > b ? g : b) - NOISE;
  return size < 0 ? 0 : size > most ? most : size;
}
