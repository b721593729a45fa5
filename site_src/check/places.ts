/** Where a picture is wrong: on which objects, in shadow, in what mirrors show. What is where was traced: check/places.py. */
import type { Picture } from "./formats/picture";
import { NOISE } from "./layer";

const [IN_SHADOW, LIT, MIRROR, GLASS] = [1, 2, 4, 8];
export const EDGE = 16;
/** A kind of place is told that holds at least this share of the wrong pixels, and is so much less of the picture. */
const [MOST, TELLING] = [0.8, 0.25];
const TOLD = 2;

export type Kind = "shadow" | "lit" | "turned" | "mirror" | "glass" | "edge" | "background" | "object";

export interface Told {
  kind: Kind;
  object: number; // of kind "object": its place in the scene; else -1
  ofWrong: number; // share of the wrong pixels that lie there
  ofPicture: number;
}

export interface OnObject {
  object: number; // its place in the scene, -1: the background
  wrong: number; // share of its pixels
  ofWrong: number; // share of all wrong ones
}

export interface Where {
  told: Told[]; // the most telling first
  objects: OnObject[]; // all that is seen, the most wrong pixels first
}

const KINDS: [Kind, (object: number, bits: number) => boolean][] = [
  ["mirror", (_, bits) => (bits & MIRROR) > 0],
  ["glass", (_, bits) => (bits & GLASS) > 0],
  ["shadow", (_, bits) => (bits & IN_SHADOW) > 0],
  ["turned", (object, bits) => object >= 0 && !(bits & (IN_SHADOW | LIT))],
  ["edge", (_, bits) => (bits & EDGE) > 0],
  ["lit", (_, bits) => (bits & LIT) > 0],
  ["background", (object) => object < 0],
];

/** Whether a place is of the kind that is told. */
export function liesIn({ kind, object: told }: Told, object: number, bits: number): boolean {
  return kind === "object" ? object === told : KINDS.some(([each, holds]) => each === kind && holds(object, bits));
}

/** The place of a pixel of an n x n picture on the grid of places: its object, -1 for none, and bits. */
export function placeAt(places: Picture, n: number, x: number, y: number): { object: number; bits: number } {
  const along = (at: number) => Math.floor(((at + 0.5) * places.width) / n);
  const at = 3 * (along(y) * places.width + along(x));
  return { object: places.values[at] - 1, bits: places.values[at + 1] };
}

/** The worst of a pixel's three colours, steps of 255. i: of its red. */
export function worstAt(a: Picture, b: Picture, i: number): number {
  const [p, q] = [a.values, b.values];
  return Math.max(Math.abs(p[i] - q[i]), Math.abs(p[i + 1] - q[i + 1]), Math.abs(p[i + 2] - q[i + 2]));
}

/** Pixels, and wrong ones, for each pixel of the grid of places. */
function countsOf(student: Picture, right: Picture, size: number): { all: Int32Array; wrong: Int32Array } {
  const n = right.width;
  const along = Int32Array.from({ length: n }, (_, at) => Math.floor(((at + 0.5) * size) / n));
  const [all, wrong] = [new Int32Array(size * size), new Int32Array(size * size)];
  for (let y = 0, i = 0; y < n; y++) {
    for (let x = 0; x < n; x++, i += 3) {
      const place = along[y] * size + along[x];
      all[place]++;
      if (worstAt(student, right, i) > NOISE) wrong[place]++;
    }
  }
  return { all, wrong };
}

export function whereWrong(student: Picture, right: Picture, places: Picture): Where {
  const n = right.width;
  const counts = countsOf(student, right, places.width);
  const kinds = KINDS.map(() => ({ all: 0, wrong: 0 }));
  const objects = new Map<number, { all: number; wrong: number }>();
  let wrong = 0;
  counts.all.forEach((all, place) => {
    if (!all) return;
    const [object, bits] = [places.values[3 * place] - 1, places.values[3 * place + 1]];
    const own = objects.get(object) ?? { all: 0, wrong: 0 };
    objects.set(object, own);
    wrong += counts.wrong[place];
    for (const count of [own, ...kinds.filter((_, k) => KINDS[k][1](object, bits))]) {
      count.all += all;
      count.wrong += counts.wrong[place];
    }
  });
  if (!wrong) return { told: [], objects: [] };
  const share = (count: { all: number; wrong: number }) => ({ ofWrong: count.wrong / wrong, ofPicture: count.all / (n * n) });
  const ofKinds = kinds.map((count, k): Told => ({ kind: KINDS[k][0], object: -1, ...share(count) }));
  const ofObjects = [...objects].filter(([object]) => object >= 0).map(([object, count]): Told => ({ kind: "object", object, ...share(count) }));
  const told = [...ofKinds, ...ofObjects].filter(({ ofWrong, ofPicture }) => ofWrong >= MOST && ofWrong - ofPicture >= TELLING);
  return {
    told: told.sort((a, b) => b.ofWrong - b.ofPicture - (a.ofWrong - a.ofPicture)).slice(0, TOLD),
    objects: [...objects].map(([object, { all, wrong: own }]) => ({ object, wrong: own / all, ofWrong: own / wrong })).sort((a, b) => b.ofWrong - a.ofWrong),
  };
}
