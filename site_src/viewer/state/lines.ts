/** Rays as straight lines: which belong to which pixel, where each begins and ends. */
import { RAY_KINDS, type LineKind } from "../trace/kinds";
import { VISIBILITY, type SceneData, type Trace } from "../trace/types";
import { onceFor } from "./memo";
import { along, triple, type Vec3 } from "./vectors";
import type { ViewState } from "./types";

export interface Line {
  kind: LineKind;
  from: Vec3;
  to: Vec3;
  ray: number; // index into the trace; of a shadow ray: the ray whose hit it leaves
  light: number; // of a shadow ray, else -1
  leaves: boolean; // a ray that leaves the scene ends nowhere: no dot at its end
  share: number; // of the pixel's colour that came along it; of a shadow ray: of its hit's own colour
  growing?: true; // `to` is only as far as it has come: no dot either
}

const LEAST_WORTH = 0.42; // of width and opacity: no ray of the selected pixel vanishes

/** How wide and how opaque a line is drawn: by the square root of its share, so that a tenth of the light is still half as wide. */
export const worthOf = ({ share }: Pick<Line, "share">): number => LEAST_WORTH + (1 - LEAST_WORTH) * Math.sqrt(Math.min(1, Math.max(0, share)));

/** Opacity of thin lines, [up to so many, opacity]: the more there are, the fainter is each, or they would bury the scene. */
const FAINTNESS = [[60, 0.5], [400, 0.28], [1500, 0.16], [15000, 0.09], [Infinity, 0.06]] as const;
export const faintness = (lines: number): number => FAINTNESS.find(([most]) => lines <= most)![1];

/** Counting sort by pixel, without what a switch leaves out: keeps the trace's order, so a parent comes before its children.
 *  Rays of pixel p: order[start[p]] .. order[start[p + 1]]. By Trace.pixel, which some switches leave as it is. */
const sortedByPixel = onceFor((pixel: Int32Array) => {
  const pixels = pixel.reduce((most, each) => Math.max(most, each), -1) + 1;
  const start = new Int32Array(pixels + 1);
  for (const each of pixel) if (each >= 0) start[each + 1]++;
  for (let p = 0; p < pixels; p++) start[p + 1] += start[p];
  const next = start.slice();
  const order = new Int32Array(start[pixels]);
  for (let ray = 0; ray < pixel.length; ray++) if (pixel[ray] >= 0) order[next[pixel[ray]]++] = ray;
  return { start, order };
});

function raysOf(trace: Trace, pixel: number): Int32Array {
  const { start, order } = sortedByPixel(trace.pixel);
  return order.subarray(start[pixel], start[pixel + 1]);
}

/** By parent, -1 for the camera rays. */
export function childrenIn(trace: Trace, rays: Iterable<number>): Map<number, number[]> {
  const children = new Map<number, number[]>();
  for (const ray of rays) children.set(trace.parent[ray], [...(children.get(trace.parent[ray]) ?? []), ray]);
  return children;
}

/** The rays of a pixel, each followed by what it led to (depth first). */
export function treeOf(trace: Trace, pixel: number): number[] {
  const children = childrenIn(trace, raysOf(trace, pixel));
  const walk = (ray: number): number[] => [ray, ...(children.get(ray) ?? []).flatMap(walk)];
  return (children.get(-1) ?? []).flatMap(walk);
}

export function originOf(trace: Trace, scene: SceneData, ray: number): Vec3 {
  return trace.parent[ray] < 0 ? scene.camera.eye : triple(trace.point, trace.parent[ray]);
}

function shadowLine(trace: Trace, scene: SceneData, ray: number, light: number, share: number): Line | null {
  const at = ray * trace.lights + light;
  const seen = trace.visibility[at];
  if (seen !== VISIBILITY.reached && seen !== VISIBILITY.blocked) return null;
  const from = triple(trace.point, ray);
  const position = scene.lights[light].position;
  const to = seen === VISIBILITY.blocked ? along(from, position, trace.blockedAt[at]) : position;
  return { kind: seen === VISIBILITY.blocked ? "blocked" : "reached", from, to, ray, light, leaves: false, share };
}

/** Every line of a pixel: its rays, and the shadow rays from their hits. */
export function linesOf(trace: Trace, scene: SceneData, pixel: number): Line[] {
  const lines: Line[] = [];
  const shares = new Map<number, number>(); // a parent comes before its children
  for (const ray of raysOf(trace, pixel)) {
    const share = (shares.get(trace.parent[ray]) ?? 1) * (trace.parent[ray] < 0 ? 1 : trace.weight[ray]);
    shares.set(ray, share);
    lines.push({
      kind: RAY_KINDS[trace.kind[ray]],
      from: originOf(trace, scene, ray),
      to: triple(trace.point, ray),
      ray,
      light: -1,
      leaves: trace.object[ray] < 0,
      share,
    });
    for (let light = 0; light < trace.lights; light++) {
      const line = shadowLine(trace, scene, ray, light, share * trace.localWeight[ray]);
      if (line) lines.push(line);
    }
  }
  return lines;
}

/** Every kind of line that any pixel has. */
export function kindsIn(trace: Trace): Set<LineKind> {
  const kinds = new Set<LineKind>();
  for (let ray = 0; ray < trace.count; ray++) {
    if (trace.pixel[ray] < 0) continue;
    kinds.add(RAY_KINDS[trace.kind[ray]]);
    for (let at = ray * trace.lights; at < (ray + 1) * trace.lights; at++) {
      if (trace.visibility[at] === VISIBILITY.reached) kinds.add("reached");
      else if (trace.visibility[at] === VISIBILITY.blocked) kinds.add("blocked");
    }
  }
  return kinds;
}

/** Pixels of the selected row, of the column, or of all: the ones drawn thin. */
export function thinPixels({ rays, n, pixel }: Pick<ViewState, "rays" | "n" | "pixel">): number[] {
  if (rays.includes("all")) return Array.from({ length: n * n }, (_, k) => k);
  const wanted = new Set<number>();
  if (rays.includes("row")) for (let k = 0; k < n; k++) wanted.add(pixel[1] * n + k);
  if (rays.includes("column")) for (let k = 0; k < n; k++) wanted.add(k * n + pixel[0]);
  return [...wanted];
}
