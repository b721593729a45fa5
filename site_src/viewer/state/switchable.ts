/** What of a scene can be switched. */
import type { SceneData } from "../trace/types";
import { PARTS, type Part } from "./switches";

/** Parts that some material of the scene has: switching the others would change nothing. */
export function partsOf(scene: SceneData): Part[] {
  const has = (part: Part) =>
    scene.materials.some((material) => (part === "reflected" ? material.reflect > 0 || material.fresnel : part === "refracted" ? material.transmit > 0 : material[part].some((v) => v > 0)));
  return PARTS.filter(has);
}
