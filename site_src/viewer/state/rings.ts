/** What a lesson's step points at: rings round objects and lamps. */
import type { SceneData, View } from "../trace/types";
import { outlineOf, type Outline } from "./outlines";
import type { Projection } from "./projection";
import { lampsOf } from "./switches";

export interface Ring extends Outline {
  name: string;
  isLamp: boolean;
}

const ROOM = 5; // between a thing and its ring, CSS pixels
const LAMP = 13; // a lamp's ring

/** near: world units before the observer from which on things are seen. What is not all before the observer has none. */
export function ringsOf({ highlight = [] }: View, scene: SceneData, projection: Projection, near: number): Ring[] {
  const lamps = lampsOf(scene);
  return highlight.flatMap((name): Ring[] => {
    const object = scene.objects.find((each) => each.name === name);
    if (object) {
      const outline = outlineOf(object, scene, projection, near);
      return outline ? [{ ...around(outline, ROOM), isRound: outline.isRound, name, isLamp: false }] : [];
    }
    const points = (lamps.find((lamp) => lamp.name === name)?.lights ?? []).map((light) => projection.project(scene.lights[light].position));
    if (!points.length || points.some(({ depth }) => depth < near)) return [];
    const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
    const box = { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
    return [{ ...around(box, LAMP), isRound: points.length === 1, name, isLamp: true }];
  });
}

const around = ({ left, right, top, bottom }: Omit<Outline, "isRound">, by: number) => ({ left: left - by, right: right + by, top: top - by, bottom: bottom + by });
