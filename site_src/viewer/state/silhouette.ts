/** An object's outline as it is seen straight from above a flat drawing: what lies beside the drawn plane, laid onto it. */
import type { ObjectData, SceneData, Trace, Vec3 } from "../trace/types";
import type { Line } from "./lines";
import { meshOf } from "./mesh";
import { toWorld } from "./placing";
import { FORMS } from "./shapes";
import { CURVE, type Curve, type Flat, type Section } from "./section";

const MOST = 3000; // of a mesh's vertices: the outline of more looks the same

/** Corners of an object in its own frame, whose hull is its outline. */
function corners(object: ObjectData, scene: SceneData): Vec3[] {
  const data = object.mesh ? scene.meshes[object.mesh] : undefined;
  if (!data) return FORMS[object.type].faces(object, scene).flat();
  const { positions } = meshOf(data);
  const step = Math.ceil(positions.length / 3 / MOST);
  return Array.from({ length: Math.floor(positions.length / 3 / step) }, (_, k): Vec3 => [positions[3 * k * step], positions[3 * k * step + 1], positions[3 * k * step + 2]]);
}

/** Convex hull, by A. M. Andrew's monotone chain (1979). */
export function hull(points: readonly Flat[]): Flat[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turn = (a: Flat, b: Flat, c: Flat) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const chain = (of: readonly Flat[]) => {
    const kept: Flat[] = [];
    for (const point of of) {
      while (kept.length > 1 && turn(kept[kept.length - 2], kept.at(-1)!, point) <= 0) kept.pop();
      kept.push(point);
    }
    return kept.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
}

/** flat: of a point in the world; affine. null for a plane, which has no outline. */
export function silhouetteOf(index: number, scene: SceneData, flat: (point: Vec3) => Flat): Curve | null {
  const object = scene.objects[index];
  const at = (p: Vec3) => flat(toWorld(object.transform, p));
  if (object.type === "sphere") {
    // An ellipsoid's shadow is an ellipse: two half axes that span the same as its three do.
    const centre = at([0, 0, 0]);
    const axes = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const).map((axis) => at(axis).map((v, k) => v - centre[k]));
    const sum = (of: (a: number[]) => number) => axes.reduce((total, axis) => total + of(axis), 0);
    const wide = Math.sqrt(sum(([x]) => x * x));
    const slope = sum(([x, y]) => x * y) / wide;
    return { object: index, kind: CURVE.ellipse, points: [centre, [wide, slope], [0, Math.sqrt(Math.max(0, sum(([, y]) => y * y) - slope ** 2))]] };
  }
  const all = corners(object, scene);
  return all.length > 0 ? { object: index, kind: CURVE.closed, points: hull(all.map(at)) } : null;
}

/** Outlines of what blocks a light on the chosen lines and does not reach into the section's plane. */
export function besideOf({ curves, flat }: Section, scene: SceneData, trace: Trace, chosen: readonly Line[]): Curve[] {
  const blockers = new Set(chosen.filter(({ kind }) => kind === "blocked").map(({ ray, light }) => trace.blocker[ray * trace.lights + light]));
  for (const { object } of curves) blockers.delete(object);
  return [...blockers].flatMap((object) => (object < 0 ? [] : (silhouetteOf(object, scene, flat) ?? [])));
}
