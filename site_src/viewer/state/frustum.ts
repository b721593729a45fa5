/** The picture plane in space: n x n tiles in front of the ray-tracing camera. */
import type { SceneData } from "../trace/types";
import { corners, isWithin, planeOf } from "./placing";
import { add, cross, dot, scale, sub, unit, type Vec3 } from "./vectors";

export interface PicturePlane {
  eye: Vec3;
  forward: Vec3;
  up: Vec3;
  /** Top left corner, and the vectors across and down from it, world units. */
  origin: Vec3;
  across: Vec3;
  down: Vec3;
}

const SHARE = 0.46; // of the way to the nearest object: well clear of the eye and of the scene
const CLOSEST = 0.04; // of the scene's radius

function planeAt(scene: SceneData, distance: number): PicturePlane {
  const { eye, target, up, fov } = scene.camera;
  const forward = unit(sub(target, eye));
  const right = unit(cross(forward, up));
  const upright = cross(right, forward);
  const half = distance * Math.tan((fov * Math.PI) / 360);
  const origin = add(add(eye, scale(forward, distance)), add(scale(right, -half), scale(upright, half)));
  return { eye, forward, up: upright, origin, across: scale(right, 2 * half), down: scale(upright, -2 * half) };
}

export const planeCorners = ({ origin, across, down }: PicturePlane): Vec3[] => [
  origin,
  add(origin, across),
  add(add(origin, across), down),
  add(origin, down),
];

/** Do the tiles stay on the eye's side of every wall and floor? */
function isClear(plane: PicturePlane, scene: SceneData): boolean {
  return scene.objects.every((object) => {
    if (object.type === "plane") {
      const { point, normal } = planeOf(object);
      const side = dot(sub(plane.eye, point), normal);
      return planeCorners(plane).every((corner) => dot(sub(corner, point), normal) * side > 0);
    }
    return !isWithin(object, plane.eye) || planeCorners(plane).every((corner) => isWithin(object, corner));
  });
}

/** The plane stands in front of everything the camera sees, at the same place for every resolution. */
export function picturePlane(scene: SceneData): PicturePlane {
  const { eye, target } = scene.camera;
  const forward = unit(sub(target, eye));
  const nearest = scene.objects
    .map((object) => Math.min(...corners(object, scene).map((corner) => dot(sub(corner, eye), forward))))
    .filter((depth) => depth > CLOSEST * scene.bounds.radius);
  let distance = SHARE * Math.min(...nearest, scene.bounds.radius * 2);
  while (distance > CLOSEST * scene.bounds.radius && !isClear(planeAt(scene, distance), scene)) distance *= 0.9;
  return planeAt(scene, distance);
}

/** Corner of tile (column, row), or a point within it for fractions. */
export const onPlane = (plane: PicturePlane, column: number, row: number, n: number): Vec3 =>
  add(plane.origin, add(scale(plane.across, column / n), scale(plane.down, row / n)));
