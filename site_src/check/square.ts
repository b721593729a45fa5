/** Which part of a student's picture is held against which right picture. */
import type { About } from "./atlas";
import type { Picture } from "./formats/picture";
import { sampled } from "./layer";

const LEAST = 5; // pixels along

/** A word of check.verdict, with its figures, where a picture cannot be compared. */
export type Refusal = { word: "tall" | "tiny"; figures: { width: number; height: number; least: number } };

export interface Square {
  picture: Picture; // as many pixels along as upwards
  isCut: boolean; // what a wider picture shows at its sides is left out
}

/** Where the field of view is measured from top to bottom, the middle of a wider picture is the scene's. */
export function squareOf(picture: Picture): Square | Refusal {
  const { width, height, values } = picture;
  const figures = { width, height, least: LEAST };
  if (width < height) return { word: "tall", figures };
  if (height < LEAST) return { word: "tiny", figures };
  if (width === height) return { picture, isCut: false };
  const cut = values.slice(0, 3 * height * height);
  const from = Math.floor((width - height) / 2);
  for (let y = 0; y < height; y++) cut.set(values.subarray(3 * (y * width + from), 3 * (y * width + from + height)), 3 * y * height);
  return { picture: { ...picture, width: height, values: cut }, isCut: true };
}

export const isRefusal = (of: Square | Refusal): of is Refusal => "word" in of;

export interface Source {
  from: number; // size of the picture that is there
  isExact: boolean; // its pixels are those of the size that is asked for
}

/** Out of which right picture one of n x n is taken: its own, one that it is part of, else the finest. */
export function sourceFor(n: number, { own, others }: Pick<About, "own" | "others">): Source {
  const whole = own[own.length - 1];
  if (own.includes(n)) return { from: whole, isExact: true };
  return others.includes(n) ? { from: n, isExact: true } : { from: Math.max(whole, ...others), isExact: false };
}

export function taken(from: Picture, n: number): Picture {
  return from.width === n ? from : { ...from, width: n, height: n, values: new Uint8Array(sampled(from.values, from.width, n)) };
}

/** The size next to n that can be checked exactly. */
export const nearestSize = (n: number, { own, others }: Pick<About, "own" | "others">) => [...own, ...others].reduce((best, each) => (Math.abs(each - n) < Math.abs(best - n) ? each : best));
