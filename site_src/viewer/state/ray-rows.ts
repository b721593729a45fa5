/** A pixel's rays as the rows of a table, numbered in the order in which they are walked. Stored numbers only,
 *  and products of them: a share times a colour. */
import { RAY_KINDS, type RayKind, type SentKind } from "../trace/kinds";
import type { MaterialData, SceneData, Trace, Vec3 } from "../trace/types";
import type { LightShare, Passing } from "./event-types";
import { baseAt, given, hitsOf, lightShares, localColour, materialAt } from "./events";
import { treeOf } from "./lines";
import { triple } from "./vectors";

export interface LightRow extends LightShare {
  light: number; // index into SceneData.lights
  by: string; // what blocks it, or ""
  at: number; // share of the way to the light where it is blocked
  gives: Vec3; // what it adds to the surface's own colour
}

export interface RayRow {
  number: number; // from 1
  ray: number; // index into the trace
  of: number; // the number of the ray that led to it; 0: the pixel
  kind: RayKind;
  depth: number;
  object: string; // "" if the ray leaves the scene
  material: string;
  way: readonly Passing[]; // the surfaces that led to it
  point: Vec3;
  normal: Vec3;
  t: number;
  tests: number;
  weight: number; // share in the colour of the ray that led to it
  share: number; // in the pixel's
  keeps: number; // share of the surface's own colour in this ray's
  base: Vec3 | null; // what ambient and diffuse are multiplied by; null: nothing, on all of the object
  ambient: Vec3;
  local: Vec3; // the surface's own colour: ambient, and what each light gives
  colour: Vec3; // what the ray brings back
  hits: readonly { name: string; t: number }[]; // all along a camera ray, the nearest first
  lights: readonly LightRow[]; // asked here; none at a surface without a colour of its own
}

const BLACK: Vec3 = [0, 0, 0];

function lightRows(trace: Trace, scene: SceneData, ray: number, material: MaterialData): LightRow[] {
  return lightShares(trace, scene, ray).map((light, k) => {
    const at = ray * trace.lights + k;
    return { ...light, light: k, by: scene.objects[trace.blocker[at]]?.name ?? "", at: trace.blockedAt[at], gives: given(material, light) };
  });
}

/** In walking order: each ray before all it leads to. */
export function rayRows(trace: Trace, scene: SceneData, pixel: number): RayRow[] {
  const numbers = new Map<number, RayRow>();
  return treeOf(trace, pixel).map((ray, k) => {
    const above = numbers.get(trace.parent[ray]);
    const isHit = trace.object[ray] >= 0;
    const material = materialAt(trace, scene, ray);
    const keeps = trace.localWeight[ray];
    const lights = isHit && keeps > 0 ? lightRows(trace, scene, ray, material!) : [];
    const row: RayRow = {
      number: k + 1,
      ray,
      of: above?.number ?? 0,
      kind: RAY_KINDS[trace.kind[ray]],
      depth: trace.depth[ray],
      object: scene.objects[trace.object[ray]]?.name ?? "",
      material: material?.name ?? "",
      way: above ? [...above.way, { what: RAY_KINDS[trace.kind[ray]] as SentKind, name: above.object, enters: trace.inside[above.ray] === 0 }] : [],
      point: triple(trace.point, ray),
      normal: triple(trace.normal, ray),
      t: trace.t[ray],
      tests: trace.tests[ray],
      weight: above ? trace.weight[ray] : 1,
      share: above ? above.share * trace.weight[ray] : 1,
      keeps,
      base: baseAt(trace, scene, ray),
      ambient: material?.ambient ?? BLACK,
      local: isHit ? localColour(material!, lights) : scene.background,
      colour: triple(trace.colour, ray),
      hits: hitsOf(trace, scene, ray),
      lights,
    };
    numbers.set(ray, row);
    return row;
  });
}
