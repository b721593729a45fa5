/** The bounding volumes that a camera ray tested, also as line segments to draw. */
import { boxesOf, checkedBoxes, type BoxTested, type RayBoxes } from "../trace/boxes";
import type { Vec3 } from "../trace/types";

export interface BoxLines {
  entered: readonly (readonly [Vec3, Vec3])[];
  missed: readonly (readonly [Vec3, Vec3])[];
}

/** Of a scene's meshes. */
export interface Boxes {
  scene: string;
  of: (n: number, ray: number) => RayBoxes & { lines: BoxLines };
}

const ROUND = 48; // segments of a circle

export function boxEdges({ low, high }: Pick<BoxTested, "low" | "high">): [Vec3, Vec3][] {
  const corner = (k: number): Vec3 => [k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]];
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) => [1, 2, 4].filter((bit) => !(k & bit)).map((bit): [Vec3, Vec3] => [corner(k), corner(k | bit)]));
}

/** Three great circles. */
export function sphereCircles({ centre, radius }: { centre: Vec3; radius: number }): [Vec3, Vec3][] {
  const on = (axis: number, k: number): Vec3 => {
    const turn = (2 * Math.PI * k) / ROUND;
    const at: [number, number, number] = [...centre];
    at[(axis + 1) % 3] += radius * Math.cos(turn);
    at[(axis + 2) % 3] += radius * Math.sin(turn);
    return at;
  };
  return [0, 1, 2].flatMap((axis) => Array.from({ length: ROUND }, (_, k): [Vec3, Vec3] => [on(axis, k), on(axis, k + 1)]));
}

/** json: of scenes/<id>/boxes.js. Throws TraceError. */
export function boxesFrom(json: unknown, scene: string): Boxes {
  const data = checkedBoxes(json, scene);
  const of = (n: number, ray: number) => {
    const tested = boxesOf(data, n, ray);
    return { ...tested, lines: boxLines(tested) };
  };
  return { scene, of };
}

function boxLines({ spheres, boxes }: RayBoxes): BoxLines {
  const of = (entered: boolean) => [...spheres.filter((each) => each.entered === entered).flatMap(sphereCircles), ...boxes.filter((each) => each.entered === entered).flatMap(boxEdges)];
  return { entered: of(true), missed: of(false) };
}
