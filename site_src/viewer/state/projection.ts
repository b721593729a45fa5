/** From the world to the stage's pixels, as the observer sees it, and from a pixel to a tile. */
import type { PicturePlane } from "./frustum";
import type { Observer } from "./types";
import { along, cross, dot, sub, unit, type Vec3 } from "./vectors";

export interface ScreenPoint {
  x: number; // CSS pixels from the left
  y: number; // from the top
  depth: number; // world units in front of the observer; negative behind
}

export type Projection = ReturnType<typeof createProjection>;

export function createProjection(observer: Observer, width: number, height: number) {
  const forward = unit(sub(observer.target, observer.eye));
  const right = unit(cross(forward, observer.up));
  const up = cross(right, forward);
  const focal = Math.min(width, height) / 2 / Math.tan((observer.fov * Math.PI) / 360);
  const homogeneous = (d: Vec3): Vec3 => {
    const w = dot(d, forward);
    return [(width / 2) * w + focal * dot(d, right), (height / 2) * w - focal * dot(d, up), w];
  };
  return {
    width,
    height,
    /** CSS pixels that one world unit takes at depth 1. */
    focal,
    right,
    up,
    forward,
    /** Homogeneous stage coordinates (x w, y w, w) of a direction from the eye: linear, so also of a plane's axes. */
    homogeneous,
    project(point: Vec3): ScreenPoint {
      const [x, y, w] = homogeneous(sub(point, observer.eye));
      return { x: x / w, y: y / w, depth: w };
    },
    /** Share across and down the picture plane (0..1 when on it) under a stage pixel; null if not seen there. */
    onPicturePlane(plane: PicturePlane, x: number, y: number): readonly [number, number] | null {
      // (x, y, 1) ~ a A + b D + c O; Cramer's rule gives a : b : c.
      const A = homogeneous(plane.across);
      const D = homogeneous(plane.down);
      const O = homogeneous(sub(plane.origin, observer.eye));
      const at: Vec3 = [x, y, 1];
      const c = dot(A, cross(D, at));
      const share = [dot(at, cross(D, O)) / c, dot(A, cross(at, O)) / c] as const;
      const depth = share[0] * A[2] + share[1] * D[2] + O[2];
      return Number.isFinite(share[0]) && Number.isFinite(share[1]) && depth > 0 ? share : null;
    },
  };
}

/** The part of a segment that is at least `near` before the observer, as its two ends on the stage; null if none is. */
export function seenPart({ project }: Projection, from: Vec3, to: Vec3, near: number): readonly [ScreenPoint, ScreenPoint] | null {
  const [a, b] = [project(from), project(to)];
  if (a.depth < near && b.depth < near) return null;
  const cut = () => project(along(from, to, (near - a.depth) / (b.depth - a.depth)));
  return [a.depth < near ? cut() : a, b.depth < near ? cut() : b];
}
