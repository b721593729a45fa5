/** A slide's figure is wide and low: from where a lesson's observer stands, it shows what it can as large as it goes. */
import { landmarks } from "../state/observer";
import type { PicturePlane } from "../state/frustum";
import { createProjection } from "../state/projection";
import type { Observer } from "../state/types";
import type { SceneData } from "../trace/types";

const FILL = 0.92; // of the figure's half, across or down
const LARGEST = 1.6;

/** The same place with a smaller field of view, as small as keeps in the frame what is there: eye, picture plane, lamps,
 *  objects. It depends on nothing else, so that stops with one observer share a view. */
export function closeUp(observer: Observer, scene: SceneData, plane: PicturePlane, { width, height }: { width: number; height: number }): Observer {
  const { project } = createProjection(observer, width, height);
  const reaches = landmarks(scene, plane)
    .map(project)
    .filter(({ depth }) => depth > 0)
    .map(({ x, y }) => Math.max(Math.abs((2 * x) / width - 1), Math.abs((2 * y) / height - 1)))
    .filter((reach) => reach <= 1);
  const factor = Math.max(1, Math.min(LARGEST, FILL / Math.max(...reaches, FILL / LARGEST)));
  return { ...observer, fov: (360 / Math.PI) * Math.atan(Math.tan((observer.fov * Math.PI) / 360) / factor) };
}
