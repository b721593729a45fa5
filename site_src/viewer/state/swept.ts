/** A scene at a stop of one of its sweeps. A stop is to the page what a scene is: `of` tells them apart. */
import type { SceneData, StopsData } from "../trace/types";

/** Sweep and stop of "lamp-height:7"; null where the scene has no such stop. */
export function stopIn(scene: SceneData, text: string) {
  const [id, number] = text.split(":");
  const sweep = scene.sweeps?.find((each) => each.id === id);
  const stop = Number(number);
  return sweep && Number.isInteger(stop) && stop >= 1 && stop <= sweep.values.length ? { sweep, stop } : null;
}

/** Grids whose rays a sweep's stops have. */
export const levelsOf = (scene: SceneData, id: string): number[] => scene.levels.filter((n) => `${id}/${n}` in scene.files);

type Things = readonly { readonly name: string }[];
const laidOver = <T extends Things>(things: T, others: readonly object[] | undefined): T => (others ? (things.map((thing, k) => ({ ...thing, ...others[k] })) as unknown as T) : things);

/** The scene as it is at a stop, from 1. */
export function sceneAt(scene: SceneData, { stops }: StopsData, id: string, stop: number): SceneData {
  const { objects, lights, materials, ...other } = stops[stop - 1];
  return {
    ...scene,
    ...other,
    of: `${scene.of}/${id}/${stop}`,
    levels: levelsOf(scene, id),
    objects: laidOver(scene.objects, objects),
    lights: laidOver(scene.lights, lights),
    materials: laidOver(scene.materials, materials),
  };
}
