/**
 * How a picture deviates from the right one, and how far two deviations agree. A layer is a small picture of a scene's: its pixels,
 * or means of blocks. Half of an agreement is told by pixels, half by blocks: speckles fall elsewhere in each program, but as densely.
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

/** wrong - right on a layer, what counts of it a pixel, and in all. */
export interface Deviation {
  colours: Float32Array;
  sizes: Float32Array;
  amount: number;
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
  const isOfPixels = most === MOST_OF_PIXEL;
  const weights = Float32Array.from({ length: size * size }, (_, pixel) => (isOfPixels && contrastAt(right, size, pixel) > EDGE ? WEIGHT_OF_EDGES : 1));
  return { size, right, weights, most };
}

/** The largest difference of a colour among a pixel and its neighbours. */
function contrastAt(right: Float32Array, size: number, pixel: number): number {
  const [x, y] = [pixel % size, Math.floor(pixel / size)];
  let largest = 0;
  for (let c = 0; c < 3; c++) {
    let [low, high] = [255, 0];
    for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, size - 1); v++) {
      for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, size - 1); u++) {
        const value = right[3 * (v * size + u) + c];
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    largest = Math.max(largest, high - low);
  }
  return largest;
}

/** What counts of a difference of colours. */
export function counted(r: number, g: number, b: number, most: number): number {
  if (r < 0) r = -r;
  if (g < 0) g = -g;
  if (b < 0) b = -b;
  const size = (r > g ? (r > b ? r : b) : g > b ? g : b) - NOISE;
  return size < 0 ? 0 : size > most ? most : size;
}

export function deviationOf({ right, most, weights }: Layer, wrong: ArrayLike<number>): Deviation {
  const colours = new Float32Array(wrong.length);
  const sizes = new Float32Array(wrong.length / 3);
  let amount = 0;
  for (let i = 0, j = 0; i < sizes.length; i++, j += 3) {
    const [r, g, b] = [wrong[j] - right[j], wrong[j + 1] - right[j + 1], wrong[j + 2] - right[j + 2]];
    colours[j] = r;
    colours[j + 1] = g;
    colours[j + 2] = b;
    sizes[i] = counted(r, g, b, most);
    amount += weights[i] * sizes[i];
  }
  return { colours, sizes, amount };
}

/** 1: the same; 0: nothing of it. A Jaccard index (shared over all) of amounts in place of sets. */
export function agreement({ weights, most }: Layer, a: Deviation, b: Deviation): number {
  let [apart, all] = [0, 0];
  const [p, q] = [a.colours, b.colours];
  for (let i = 0, j = 0; i < weights.length; i++, j += 3) {
    const [own, other] = [a.sizes[i], b.sizes[i]];
    if (own === 0 && other === 0) continue;
    all += weights[i] * (own > other ? own : other);
    apart += weights[i] * counted(p[j] - q[j], p[j + 1] - q[j + 1], p[j + 2] - q[j + 2], most);
  }
  return index(apart, all);
}

export const index = (apart: number, all: number) => (all > 0 ? Math.max(1 - apart / all, 0) : 0);
