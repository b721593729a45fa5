/**
 * What the viewer knows of a scene and its rays. Units: world units, right-handed,
 * +y up; colours linear 0..1 unless said to be 8-bit. Nothing here computes light:
 * the pipeline did, these are its results.
 */

// What a scene's scripts hold and how a lesson step or an address gives a view (what is absent keeps its start
// value): made from the pipeline's own types.
export type { BoxesData, Brightest, ChoiceData, FlatMirror, LessonStop, LightData, MaterialData, MeshData, ObjectData, SceneWords, SectionsData, StopsData, Surroundings, SurroundingsData, SwitchesView, Vec3, View, WorkedAverage, WorkedData, WorkedRay, WorkedTree } from "./pipeline-types";
import type { SceneData as Published, Visibility } from "./pipeline-types";

/** bodies: of a stop at which neither bodies nor camera have moved, the scene: its sections and boxes are the stop's too.
 *  asked: of a scene that is drawn with more points of its lamps than rays ask, those that they do. */
export type SceneData = Published & { readonly bodies?: string; readonly asked?: Published["lights"] };

export const VISIBILITY = { blocked: 0, reached: 1, behind: 2, untested: 3, off: 4 } as const satisfies Visibility & { off: number }; // off: only by a switch, in no file

/** One scene at one frustum resolution: n x n camera rays and everything they led to.
 *  Rays are path-major: ray k < n * n is the camera ray of pixel k = row * n + column. */
export interface Trace {
  scene: string; // id, e.g. "05-many-bounces"
  n: number; // tiles across and down
  lights: number; // columns per ray in the per-light arrays
  count: number; // rays in all
  /** (count) */
  kind: Uint8Array; // KIND of kinds.ts
  parent: Int32Array; // -1 for camera rays
  pixel: Int32Array; // row * n + column
  depth: Uint8Array; // bounces before this ray
  object: Int32Array; // index into SceneData.objects, -1 if the ray leaves the scene
  material: Int32Array; // index into SceneData.materials, -1 likewise
  inside: Uint8Array; // 1: met the surface from its inner side
  t: Float64Array; // length of the ray; Infinity if it leaves the scene
  weight: Float64Array; // share of this ray's colour in its parent's
  localWeight: Float64Array; // share of the local colour in this ray's
  tests: Int32Array; // intersection tests made for this ray
  /** (3 * count), xyz or rgb */
  point: Float64Array; // the hit, or where the drawn line of a leaving ray ends
  normal: Float64Array; // unit, facing the incoming ray; 0 0 0 if none
  base: Float64Array; // what the material's ambient and diffuse are multiplied by; 1 1 1 where nothing is
  readonly colour: Float64Array; // what the ray brings back, linear, unclamped
  /** (count * lights) */
  visibility: Uint8Array; // VISIBILITY
  blocker: Int32Array; // object that stopped the shadow ray, else -1
  blockedAt: Float64Array; // share of the way to the light where it was stopped, else 1
  passed: Float64Array; // share of the light that glass on the way lets pass; counted in below
  diffuse: Float64Array; // to be multiplied by MaterialData.diffuse x light colour
  specular: Float64Array; // to be multiplied by MaterialData.specular x light colour
  /** (3 * n * n) exact 8-bit tile colours, equal to the picture's pixels */
  tiles: Uint8Array;
  /** All hits along camera ray k: hitsStart[k] .. hitsStart[k + 1], nearest first. */
  hitsStart: Int32Array;
  hitsT: Float64Array;
  hitsObject: Int32Array;
}
