/** A picture of another scene than was chosen: told by what all scenes look like from afar. */
import { gunzipSync } from "fflate";
import type { Picture } from "./formats/picture";
import { meansOf, sampled } from "./layer";

/** As build/raywalk/check/all_scenes.py writes it; means by scene. */
export interface AllScenes {
  scenes: string[];
  along: number;
  means: number[][];
  wrongAlong: number;
  wrong: Record<string, number[][]>[]; // by mistake, of each of its pictures
}

const BLOCK = 16; // pixels along, of a picture brought to `along` of them
/** A picture is another scene's if it is so much nearer to that, in mean steps of 255, */
const NEARER = 0.4;
/** and as near as its own picture is, sampling aside; or near at all, where no mistake explains what is wrong. */
const [SAME, NEAR] = [1.5, 10];

/** A mistake of another scene explains it if its own wrong picture is so near, and nearer by NEARER than any of the chosen one. */
const EXPLAINED = 1.5;
/** In a square of the wrong pictures' means two mistakes are told apart from this many steps on. */
const TOLD_APART = 6;

export const allScenesOf = (bytes: Uint8Array): AllScenes => JSON.parse(new TextDecoder().decode(gunzipSync(bytes)));

/** The id of the scene that a square picture shows rather than the chosen one, as it is or with a mistake; null: none. isKnown: a
 *  mistake explains it, so that another scene must be it to the eye. */
export function otherScene(picture: Picture, chosen: string, isKnown: boolean, all: AllScenes): string | null {
  const { scenes, along, means } = all;
  const own = fromAfar(picture, along);
  const away = means.map((of) => distance(of, own));
  const from = away[scenes.indexOf(chosen)];
  const best = away.indexOf(Math.min(...away));
  const isNearer = away[best] < NEARER * from && away[best] < (isKnown ? SAME : NEAR);
  return isNearer ? scenes[best] : isKnown ? null : otherWithMistake(picture, chosen, from, all);
}

/** from: how far the picture is from the chosen scene's right one. */
function otherWithMistake(picture: Picture, chosen: string, from: number, { scenes, wrongAlong, wrong }: AllScenes): string | null {
  const own = fromAfar(picture, wrongAlong);
  const away = wrong.map((of) => Math.min(...Object.values(of).flat().map((each) => distance(each, own))));
  const best = away.indexOf(Math.min(...away));
  const ofChosen = Math.min(from, away[scenes.indexOf(chosen)]);
  return away[best] < EXPLAINED && away[best] < NEARER * ofChosen ? scenes[best] : null;
}

function fromAfar({ values, width }: Picture, along: number): Float32Array {
  const size = along * BLOCK;
  return meansOf(sampled(values, width, size), size, BLOCK);
}

const distance = (of: number[], own: Float32Array) => of.reduce((sum, value, i) => sum + Math.abs(value - own[i]), 0) / own.length;

/** The first scene in which two mistakes make pictures that differ even from afar; null if there is none. */
export function toldApartFromAfar(a: string, b: string, { scenes, wrong }: AllScenes): string | null {
  const differ = (one: number[], other: number[]) => one.some((value, i) => Math.abs(value - other[i]) >= TOLD_APART);
  const at = wrong.findIndex(({ [a]: ones, [b]: others }) => ones && others && ones.every((one) => others.every((other) => differ(one, other))));
  return at < 0 ? null : scenes[at];
}
