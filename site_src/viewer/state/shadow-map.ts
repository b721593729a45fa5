/**
 * How the approximate look's lamps cast their shadows: by shadow maps, of six sides each. stage/solids.ts sets three's
 * lights by this, and figures on paper are drawn by it too (trace/shadow_maps.py). Lengths: world units.
 */
import type { ObjectData, SceneData } from "../trace/types";
import { isWithin, toWorld } from "./placing";
import { FORMS } from "./shapes";
import { cross, dot, sub } from "./vectors";

const MOST_LAMPS = 16; // that a graphics card takes, each with its shadow map

/** Which faces of a surface: as three numbers its sides. */
export const [FRONT, BACK, BOTH] = [0, 1, 2] as const;
export type Faces = typeof FRONT | typeof BACK | typeof BOTH;

/** Of an area light's many points one stands for so many. */
export const lampsApart = ({ lights }: SceneData): number => Math.ceil(lights.length / MOST_LAMPS);
export const isLamp = (light: number, apart: number): boolean => light % apart === apart >> 1;

export const shadowMapOf = ({ bounds: { radius } }: SceneData) => ({
  pixels: 512, // across each of a lamp's six sides
  near: radius / 40, // nearer, and depths far away run together
  far: radius * 6,
  bias: -0.0003, // of a depth, from 0 at `near` to 1 at `far`
  normalBias: radius / 400,
});

/** Which faces to draw. A room round the camera shows its inside only, so that an observer outside
 *  looks in; a lone triangle is a piece of wall and turns towards the camera. */
export function facesOf(object: ObjectData, scene: SceneData): Faces {
  const eye = scene.camera.eye;
  if (isWithin(object, eye)) return BACK;
  if (object.type === "triangle") {
    const [a, b, c] = ([[0, 0, 0], [1, 0, 0], [0, 1, 0]] as const).map((p) => toWorld(object.transform, p));
    return dot(cross(sub(b, a), sub(c, a)), sub(eye, a)) < 0 ? BACK : FRONT;
  }
  return FORMS[object.type].isOpen(object) ? BOTH : FRONT;
}
