/** The part of an endless plane that is drawn: a square as far as the scene reaches, seen from the ray-tracing camera's side. */
import { planeOf } from "../state/placing";
import { add, cross, dot, scale, sub, unit, type Vec3 } from "../state/vectors";
import type { ObjectData, SceneData } from "../trace/types";

const REACH = 2.1; // of the scene's radius

export type WallSheet = ReturnType<typeof wallSheet>;

export function wallSheet(object: ObjectData, { camera, bounds }: SceneData) {
  const { point, normal } = planeOf(object);
  const facing = dot(sub(camera.eye, point), normal) < 0 ? scale(normal, -1) : normal;
  const middle = sub(bounds.center, scale(facing, dot(sub(bounds.center, point), facing)));
  const reach = REACH * bounds.radius;
  const across = unit(cross(Math.abs(facing[1]) < 0.9 ? [0, 1, 0] : [0, 0, 1], facing));
  const down = cross(facing, across);
  return {
    point,
    facing, // the unit normal on the camera's side
    /** u across and v down, -1 to 1. */
    at: (u: number, v: number) => add(middle, add(scale(across, u * reach), scale(down, v * reach))),
    /** How far out a point of it is: 1 at the middle of an edge. */
    out: (of: Vec3) => Math.hypot(...sub(of, middle)) / reach,
  };
}

/** The sheets of all endless planes but this one. */
export const otherWalls = (object: ObjectData, scene: SceneData): WallSheet[] =>
  scene.objects.filter((each) => each.type === "plane" && each !== object).map((each) => wallSheet(each, scene));
