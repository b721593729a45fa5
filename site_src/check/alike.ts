/** Mistakes whose pictures look the same in a scene are one answer; another scene may tell them apart. */
import type { Atlas } from "./atlas";
import { NOISE } from "./layer";

/** Of the pixels: a mistake that changes fewer is not told, nor is a difference between two. */
const TELLING = 0.005;
/** Of the pixels that one makes wrong: a difference in fewer does not tell either, where both change little. */
const OF_WRONG = 0.4;
const STRIDE = 3 * 19; // of colours

/** Names of all mistakes that may make a picture which looks like this one, in the atlas' order. */
export const namesLike = (picture: Uint8Array, { mistakes, right }: Atlas) => mistakes.filter(({ pictures }) => pictures.some((own) => lookAlike(own, picture, right))).map(({ name }) => name);

/** What cannot be told apart in a scene: groups of two names or more. */
export function alikeIn(atlas: Atlas): string[][] {
  const groups = atlas.mistakes.flatMap(({ pictures }) => pictures.map((picture) => namesLike(picture, atlas))).filter(({ length }) => length > 1);
  return [...new Map(groups.map((group) => [group.join(), group])).values()];
}

const differ = (a: Uint8Array, b: Uint8Array, i: number) => Math.abs(a[i] - b[i]) > NOISE || Math.abs(a[i + 1] - b[i + 1]) > NOISE || Math.abs(a[i + 2] - b[i + 2]) > NOISE;

function lookAlike(a: Uint8Array, b: Uint8Array, right: Uint8Array): boolean {
  const most = (TELLING * a.length) / 3;
  const apart = apartUpTo(most, a, b);
  return apart <= most && apart <= OF_WRONG * apartUpTo(Infinity, a, right);
}

/** Pixels that differ; more than `most` are not counted to the end. */
function apartUpTo(most: number, a: Uint8Array, b: Uint8Array): number {
  let count = 0;
  // In strides: what differs lies together, and is met early.
  for (let from = 0; from < STRIDE && count <= most; from += 3) for (let i = from; i < a.length; i += STRIDE) if (differ(a, b, i)) count++;
  return count;
}

/** What is known of a scene without its pictures. */
export interface Shown {
  scene: string;
  names: string[]; // the mistakes that show there
  groups: string[][]; // of them those that look alike there
}

/** The first scene where two names show, and not as one; null if there is none. */
export function toldApartIn(a: string, b: string, scenes: Shown[]): string | null {
  const found = scenes.find(({ names, groups }) => names.includes(a) && names.includes(b) && !groups.some((group) => group.includes(a) && group.includes(b)));
  return found?.scene ?? null;
}
