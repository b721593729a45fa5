/** The plane that a row's or a column's camera rays lie in, drawn flat. The outlines in it come with the scene. */
import type { SceneData, SectionsData, Trace } from "../trace/types";
import { onPlane, type PicturePlane } from "./frustum";
import { add, dot, scale, sub, triple, unit, type Vec3 } from "./vectors";
import type { ViewState } from "./types";

/** To the right and down; of a row: ahead of the eye and to its right. Of a column: ahead and below. */
export type Flat = readonly [number, number];

export const CURVE = { closed: 0, open: 1, ellipse: 2 } as const;

export interface Curve {
  object: number;
  kind: number; // CURVE
  points: readonly Flat[]; // of an ellipse: its centre and two conjugate half axes
}

export interface CameraRay {
  ray: number; // index into the trace
  end: Flat;
  leaves: boolean;
  tile: readonly [Flat, Flat]; // where it crosses the picture plane
}

export interface Section {
  direction: "row" | "column";
  curves: readonly Curve[];
  rays: readonly CameraRay[];
  eye: Flat;
  flat: (point: Vec3) => Flat;
  /** Which of the section's pixels a place belongs to: its ray is the nearest. */
  pixelAt: (place: Flat) => number;
}

function curveOf([object, kind, ...steps]: readonly number[], step: number, side: number): Curve {
  const points: Flat[] = [];
  let [x, y] = [0, 0];
  for (let k = 0; k < steps.length; k += 2) {
    // Chains are stored as differences; an ellipse's three pairs are not a chain.
    [x, y] = kind === CURVE.ellipse ? [steps[k], steps[k + 1]] : [x + steps[k], y + steps[k + 1]];
    points.push([x * step, side * y * step]);
  }
  return { object, kind, points };
}

/** The picture's pixel in the middle of a tile. */
const middleOf = (tile: number, { size }: SceneData, n: number) => tile * (size / n) + (size / n - 1) / 2;

export function sectionOf(data: SectionsData, state: ViewState, scene: SceneData, trace: Trace, plane: PicturePlane): Section | null {
  if (state.slice === "none" || data.scene !== (scene.bodies ?? scene.of)) return null;
  const isRow = state.slice === "row";
  const { n } = state;
  const record = (isRow ? data.rows : data.columns)[middleOf(state.pixel[isRow ? 1 : 0], scene, n)];
  if (!record) return null;
  const [slope, curves] = record;
  const [right, up, forward] = data.frame;
  const ahead = unit(add(forward, scale(isRow ? up : right, slope)));
  const along = isRow ? right : up;
  const side = isRow ? 1 : -1; // a column's up is up on the drawing, where y counts downwards
  const flat = (point: Vec3): Flat => {
    const from = sub(point, data.eye);
    return [dot(from, ahead), side * dot(from, along)];
  };
  const rays = Array.from({ length: n }, (_, pixel) => {
    const [column, row] = isRow ? [pixel, state.pixel[1]] : [state.pixel[0], pixel];
    const ray = row * n + column;
    const ends = isRow ? [onPlane(plane, column, row + 0.5, n), onPlane(plane, column + 1, row + 0.5, n)] : [onPlane(plane, column + 0.5, row, n), onPlane(plane, column + 0.5, row + 1, n)];
    return { ray, end: flat(triple(trace.point, ray)), leaves: trace.object[ray] < 0, tile: [flat(ends[0]), flat(ends[1])] as const };
  });
  // A place ahead of the eye by x and aside by y is seen at y / x; the outermost tiles' edges bound the pixels.
  const edges = [rays[0].tile[0], rays[n - 1].tile[1]].map(([x, y]) => y / x);
  const pixelAt = ([x, y]: Flat) => Math.max(0, Math.min(n - 1, Math.floor((n * (y / Math.max(x, 1e-9) - edges[0])) / (edges[1] - edges[0]))));
  return { direction: isRow ? "row" : "column", curves: curves.map((curve) => curveOf(curve, data.step, side)), rays, eye: [0, 0], flat, pixelAt };
}

const REACH = 1.6; // of the farthest hit: how far a lamp or an outline may widen the drawing

/** Left, top, right, bottom of what is worth drawing. */
export function frameOf({ curves, rays, flat }: Section, scene: SceneData): readonly [number, number, number, number] {
  const infinite = (object: number) => scene.objects[object].type === "plane";
  const hits = rays.filter((ray) => !ray.leaves).map((ray) => ray.end);
  const finite = curves.filter((curve) => !infinite(curve.object) && curve.kind !== CURVE.ellipse).flatMap((curve) => curve.points);
  const round = curves.filter((curve) => curve.kind === CURVE.ellipse).flatMap(({ points: [centre, u, v] }) => {
    const [wide, high] = [Math.hypot(u[0], v[0]), Math.hypot(u[1], v[1])];
    return [[centre[0] - wide, centre[1] - high], [centre[0] + wide, centre[1] + high]] as Flat[];
  });
  const sure: Flat[] = [[0, 0], ...rays.flatMap((ray) => ray.tile), ...finite, ...round];
  const far = Math.max(...sure.map(([x, y]) => Math.hypot(x, y)), scene.bounds.radius) * REACH;
  const near = [...hits, ...scene.lights.map((light) => flat(light.position))].filter(([x, y]) => Math.hypot(x, y) <= far);
  const points = [...sure, ...near];
  const [xs, ys] = [points.map((p) => p[0]), points.map((p) => p[1])];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}
