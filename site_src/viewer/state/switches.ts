/** What-if switches: what a person has switched. How that changes: switching.ts; what it does: what-if.ts. Nothing is traced anew. */
import type { Brightest, SceneData, SwitchesView } from "../trace/types";

export type Part = "ambient" | "diffuse" | "specular" | "reflected" | "refracted";
export const PARTS: readonly Part[] = ["ambient", "diffuse", "specular", "reflected", "refracted"];
export const BRIGHTEST: Brightest = 2;

export interface Switches {
  bounces: number | null; // rays with more bounces are left out; null: as many as were traced
  lamps: readonly number[]; // factor on each lamp's brightness, 0: off; []: all 1
  shadows: boolean; // false: every light counts as seen
  without: readonly Part[];
}

export const HIDDEN = -1; // pixel of a ray that they leave out
export const AS_TRACED: Switches = { bounces: null, lamps: [], shadows: true, without: [] };

export const isSwitched = (of: Switches): boolean => of.bounces !== null || of.lamps.length > 0 || !of.shadows || of.without.length > 0;

/** A light as a person names it: a point light, or all the point lights that an area light is made of. */
export interface Lamp {
  name: string;
  lights: readonly number[]; // indices into SceneData.lights
}

/** The pipeline names an area light's points "name 1/16", "name 2/16" ... */
export function lampsOf(scene: Pick<SceneData, "lights">): Lamp[] {
  const lamps = new Map<string, number[]>();
  for (const [light, { name }] of scene.lights.entries()) {
    const whole = name.replace(/ \d+\/\d+$/, "");
    lamps.set(whole, [...(lamps.get(whole) ?? []), light]);
  }
  return [...lamps].map(([name, lights]) => ({ name, lights }));
}

export const brightness = (of: Switches, lamp: number): number => of.lamps[lamp] ?? 1;

/** On each light's brightness. */
export function factorsOf(of: Switches, scene: SceneData): number[] {
  const factors = scene.lights.map(() => 1);
  for (const [lamp, { lights }] of lampsOf(scene).entries()) for (const light of lights) factors[light] = brightness(of, lamp);
  return factors;
}

/** Without what is as traced anyway, and within the limits. */
export function tidy(of: Switches, scene: SceneData): Switches {
  const bounces = of.bounces !== null && of.bounces < scene.depth ? Math.max(0, of.bounces) : null;
  const lamps = of.lamps.every((factor) => factor === 1) ? [] : of.lamps;
  return { bounces, lamps, shadows: of.shadows || !scene.shadows, without: PARTS.filter((part) => of.without.includes(part)) };
}

export const bouncesOf = (of: Switches, scene: SceneData): number => Math.min(of.bounces ?? scene.depth, scene.depth);

/** As a lesson step names them. */
export function switchesFrom(view: SwitchesView | undefined, scene: SceneData): Switches {
  if (!view) return AS_TRACED;
  const lamps = lampsOf(scene).map(({ name }) => view.lights?.[name] ?? 1);
  return tidy({ bounces: view.bounces ?? null, lamps, shadows: view.shadows ?? true, without: view.without ?? [] }, scene);
}

/** As the address has them: "b2,l1x0,l2x1.5,-shadows,-ambient". */
export function writeSwitches(of: Switches): string {
  return [
    ...(of.bounces === null ? [] : [`b${of.bounces}`]),
    ...of.lamps.flatMap((factor, lamp) => (factor === 1 ? [] : [`l${lamp + 1}x${Number(factor.toFixed(2))}`])),
    ...(of.shadows ? [] : ["-shadows"]),
    ...of.without.map((part) => `-${part}`),
  ].join(",");
}

/** null where this scene has no such switch. A limit may be one of a stop that goes deeper than the scene. */
export function readSwitches(text: string, of: SceneData): Switches | null {
  const scene = { ...of, depth: of.deepest ?? of.depth };
  const lamps = lampsOf(scene).map(() => 1);
  const without: Part[] = [];
  let bounces: number | null = null;
  let shadows = true;
  for (const word of text.split(",")) {
    const [, limit, lamp, factor, off] = /^(?:b(\d{1,3})|l(\d{1,3})x(\d(?:\.\d{1,2})?)|-([a-z]+))$/.exec(word) ?? [];
    if (limit !== undefined && Number(limit) <= scene.depth) bounces = Number(limit);
    else if (lamp !== undefined && Number(lamp) > 0 && Number(lamp) <= lamps.length && Number(factor) <= BRIGHTEST) lamps[Number(lamp) - 1] = Number(factor);
    else if (off === "shadows") shadows = false;
    else if (PARTS.includes(off as Part)) without.push(off as Part);
    else return null;
  }
  return tidy({ bounces, lamps, shadows, without }, scene);
}
