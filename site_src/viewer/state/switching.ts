/** The ways in which what-if switches change: each makes the next ones out of these. */
import type { SceneData } from "../trace/types";
import { bouncesOf, BRIGHTEST, brightness, lampsOf, tidy, type Part, type Switches } from "./switches";

const STEP = 0.25; // of a button; the slider's are finer
const ROUNDED = 1e-9; // a slider's 0.75 may be a little less

/** The same switches at either end: what was not traced cannot be shown. */
export function stepBounces(of: Switches, scene: SceneData, by: 1 | -1): Switches {
  const bounces = bouncesOf(of, scene) + by;
  return bounces < 0 || bounces > scene.depth ? of : tidy({ ...of, bounces }, scene);
}

export function setLamp(of: Switches, scene: SceneData, lamp: number, factor: number): Switches {
  const lamps = lampsOf(scene).map((_, k) => (k === lamp ? Math.min(BRIGHTEST, Math.max(0, factor)) : brightness(of, k)));
  return tidy({ ...of, lamps }, scene);
}

/** To the next quarter of its brightness: one up, or one down. */
export function stepLamp(of: Switches, scene: SceneData, lamp: number, by: 1 | -1): Switches {
  const quarters = brightness(of, lamp) / STEP;
  const next = by > 0 ? Math.floor(quarters + ROUNDED) + 1 : Math.ceil(quarters - ROUNDED) - 1;
  return setLamp(of, scene, lamp, STEP * next);
}

export const turnLamp = (of: Switches, scene: SceneData, lamp: number): Switches => setLamp(of, scene, lamp, brightness(of, lamp) > 0 ? 0 : 1);

export const turnShadows = (of: Switches, scene: SceneData): Switches => tidy({ ...of, shadows: !of.shadows }, scene);

export function turnPart(of: Switches, scene: SceneData, part: Part): Switches {
  const without = of.without.includes(part) ? of.without.filter((each) => each !== part) : [...of.without, part];
  return tidy({ ...of, without }, scene);
}
