/** What paper needs to draw a scene as the stage's approximate look does, where shadow maps are all that it takes. */
import { drawsShadows } from "../state/look";
import { BACK, BOTH, facesOf, FRONT, isLamp, lampsApart, shadowMapOf, type Faces } from "../state/shadow-map";
import type { ObjectData, SceneData } from "../trace/types";

export interface ShadowMaps extends ReturnType<typeof shadowMapOf> {
  lamps: readonly number[]; // the lights that have one
  apart: number; // of so many lights one has
  casts: readonly (Faces | null)[]; // by object: which faces are drawn into the map; null: it casts no shadow
}

const OTHER: Readonly<Record<Faces, Faces>> = { [FRONT]: BACK, [BACK]: FRONT, [BOTH]: BOTH }; // three's rule: no surface shades itself

function castBy(object: ObjectData, scene: SceneData): Faces | null {
  return object.type === "plane" ? null : OTHER[facesOf(object, scene)];
}

/** null where the stage draws no shadows, or mirrors and glass too: what these look up is not on paper. */
export function mapsFor(scene: SceneData): ShadowMaps | null {
  const sendsOn = scene.objects.some(({ material, checker }) => [material, checker?.material ?? material].some((k) => scene.materials[k].reflect > 0 || scene.materials[k].transmit > 0));
  if (sendsOn || !drawsShadows(scene)) return null;
  const apart = lampsApart(scene);
  const lamps = scene.lights.flatMap((_, k) => (isLamp(k, apart) ? [k] : []));
  return { ...shadowMapOf(scene), lamps, apart, casts: scene.objects.map((object) => castBy(object, scene)) };
}
