/** Where objects stand: their transforms, the corners of their boxes. */
import type { ObjectData, SceneData } from "../trace/types";
import { FORMS } from "./shapes";
import { add, cross, dot, scale, sub, triple, type Vec3 } from "./vectors";

/** A point of the object's own space in the world. m: 16 numbers, column-major. */
export function toWorld(m: readonly number[], p: Vec3): Vec3 {
  const [x, y, z] = [m.slice(0, 3), m.slice(4, 7), m.slice(8, 11)] as unknown as [Vec3, Vec3, Vec3];
  return add(add(scale(x, p[0]), scale(y, p[1])), add(scale(z, p[2]), m.slice(12, 15) as unknown as Vec3));
}

/** A point of the world in the object's own space (an affine inverse). */
export function toObject(m: readonly number[], p: Vec3): Vec3 {
  const x = m.slice(0, 3) as unknown as Vec3;
  const y = m.slice(4, 7) as unknown as Vec3;
  const z = m.slice(8, 11) as unknown as Vec3;
  const d = sub(p, m.slice(12, 15) as unknown as Vec3);
  const volume = dot(x, cross(y, z));
  return [dot(d, cross(y, z)) / volume, dot(d, cross(z, x)) / volume, dot(d, cross(x, y)) / volume];
}

/** The eight corners of the object's box in the world; none for a plane. */
export function corners(object: ObjectData, scene: SceneData): Vec3[] {
  const box = FORMS[object.type].box(object, scene);
  if (!box) return [];
  return Array.from({ length: 8 }, (_, k) =>
    toWorld(object.transform, [box[k & 1][0], box[(k >> 1) & 1][1], box[(k >> 2) & 1][2]]),
  );
}

/** A plane's point and its unit normal. */
export function planeOf(object: ObjectData): { point: Vec3; normal: Vec3 } {
  const m = object.transform;
  const n = cross(triple(m.slice(8, 11), 0), triple(m.slice(0, 3), 0)); // z x x = y, also when stretched
  return { point: m.slice(12, 15) as unknown as Vec3, normal: scale(n, 1 / Math.hypot(...n)) };
}

/** Is the point inside of it, as in a room (a box round the eye, say)? */
export function isWithin(object: ObjectData, point: Vec3): boolean {
  return FORMS[object.type].holds?.(toObject(object.transform, point), object) ?? false;
}
