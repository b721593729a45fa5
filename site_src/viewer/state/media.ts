/** Which glass a ray travels in: the objects it has gone into and not yet out of, the last one on top.
 *  Outside of all of them the index of refraction is 1. */
import type { SceneData } from "../trace/types";

export type Media = readonly number[]; // indices into SceneData.objects

export const indexIn = (media: Media, scene: SceneData): number =>
  media.length ? scene.materials[scene.objects[media.at(-1)!].material].ior : 1;

export const crossed = (media: Media, object: number, enters: boolean): Media =>
  enters ? [...media, object] : media.filter((each, k) => k !== media.lastIndexOf(object) || each !== object);
