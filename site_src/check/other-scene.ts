/** A picture of another scene than was chosen: told by what all scenes look like from afar. */
import { gunzipSync } from "fflate";
import type { Picture } from "./formats/picture";
import { meansOf, sampled } from "./layer";

/** As build/raywalk/check/all_scenes.py writes it; means by scene. */
export interface AllScenes {
  scenes: string[];
  along: number;
  means: number[][];
}

const BLOCK = 16; // pixels along, of a picture brought to `along` of them
/** A picture is another scene's if it is so much nearer to that, in mean steps of 255, */
const NEARER = 0.4;
/** and as near as its own picture is, sampling aside; or near at all, where no mistake explains what is wrong. */
const [SAME, NEAR] = [1.5, 10];

export const allScenesOf = (bytes: Uint8Array): AllScenes => JSON.parse(new TextDecoder().decode(gunzipSync(bytes)));

/** The id of the scene that a square picture shows rather than the chosen one; null: none. isKnown: a mistake explains it, so that
 *  another scene must be it to the eye. */
export function otherScene({ values, width }: Picture, chosen: string, isKnown: boolean, { scenes, along, means }: AllScenes): string | null {
  const size = along * BLOCK;
  const own = meansOf(sampled(values, width, size), size, BLOCK);
  const away = means.map((of) => of.reduce((sum, value, i) => sum + Math.abs(value - own[i]), 0) / own.length);
  const from = away[scenes.indexOf(chosen)];
  const best = away.indexOf(Math.min(...away));
  const isNearer = away[best] < NEARER * from && away[best] < (isKnown ? SAME : NEAR);
  return isNearer ? scenes[best] : null;
}
