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

/** wrong - right on a layer, and what counts of it, a pixel. */
export interface Deviation {
  colours: Float32Array;
  sizes: Float32Array;
}

/** Of an n x n picture of any size, its colours at the centres of a layer's pixels. */
export function sampled(values: ArrayLike<number>, n: number, size: number): Float32Array {
  const places = Int32Array.from({ length: size }, (_, i) => Math.min(Math.floor(((i + 0.5) * n) / size), n - 1));
  const found = new Float32Array(3 * size * size);
  let to = 0;
  for (const y of places) for (const x of places) for (let c = 0; c < 3; c++) found[to++] = values[3 * (y * n + x) + c];
  return found;
}

/** Means of blocks, each `by` pixels along; what is over at the right and at the bottom is left out. */
export function meansOf(colours: Float32Array, n: number, by: number): Float32Array {
  const size = Math.floor(n / by);
  const means = new Float32Array(3 * size * size);
  for (let y = 0; y < size * by; y++) {
    for (let x = 0; x < size * by; x++) {
      const to = 3 * (Math.floor(y / by) * size + Math.floor(x / by));
      for (let c = 0; c < 3; c++) means[to + c] += colours[3 * (y * n + x) + c] / (by * by);
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

export function deviationOf(layer: Layer, wrong: Float32Array): Deviation {
  const { right, most } = layer;
  const colours = new Float32Array(wrong.length);
  for (let i = 0; i < wrong.length; i++) colours[i] = wrong[i] - right[i];
  const sizes = new Float32Array(wrong.length / 3);
  for (let i = 0, j = 0; i < sizes.length; i++, j += 3) sizes[i] = counted(colours[j], colours[j + 1], colours[j + 2], most);
  return { colours, sizes };
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
