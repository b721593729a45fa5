/**
 * What the viewer knows of a scene and its rays. Units: world units, right-handed,
 * +y up; colours linear 0..1 unless said to be 8-bit. Nothing here computes light:
 * the pipeline did, these are its results.
 */

export type Vec3 = readonly [number, number, number];

export const VISIBILITY = { blocked: 0, reached: 1, behind: 2, untested: 3, off: 4 } as const; // off: only by a switch, in no file

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
  object: Int16Array; // index into SceneData.objects, -1 if the ray leaves the scene
  material: Int16Array; // index into SceneData.materials, -1 likewise
  inside: Uint8Array; // 1: met the surface from its inner side
  t: Float64Array; // length of the ray; Infinity if it leaves the scene
  weight: Float64Array; // share of this ray's colour in its parent's
  localWeight: Float64Array; // share of the local colour in this ray's
  tests: Int32Array; // intersection tests made for this ray
  /** (3 * count), xyz or rgb */
  point: Float64Array; // the hit, or where the drawn line of a leaving ray ends
  normal: Float64Array; // unit, facing the incoming ray; 0 0 0 if none
  readonly colour: Float64Array; // what the ray brings back, linear, unclamped
  /** (count * lights) */
  visibility: Uint8Array; // VISIBILITY
  blocker: Int16Array; // object that stopped the shadow ray, else -1
  blockedAt: Float64Array; // share of the way to the light where it was stopped, else 1
  passed: Float64Array; // share of the light that glass on the way lets pass; counted in below
  diffuse: Float64Array; // to be multiplied by MaterialData.diffuse x light colour
  specular: Float64Array; // to be multiplied by MaterialData.specular x light colour
  /** (3 * n * n) exact 8-bit tile colours, equal to the picture's pixels */
  tiles: Uint8Array;
  /** All hits along camera ray k: hitsStart[k] .. hitsStart[k + 1], nearest first. */
  hitsStart: Int32Array;
  hitsT: Float64Array;
  hitsObject: Int16Array;
}

export interface MaterialData {
  name: string;
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  shininess: number;
  reflect: number;
  transmit: number;
  ior: number;
  fresnel: boolean;
}

/** Canonical shapes, placed by `transform`: sphere of radius 1; plane y = 0 facing +y;
 *  cylinder x^2 + y^2 = 1, |z| <= 1; box |x|,|y|,|z| <= 1; disc z = 0 of radius 1 facing +z;
 *  triangle (0,0,0) (1,0,0) (0,1,0); a mesh in its own coordinates. An ellipsoid is a
 *  sphere with a transform. */
export interface ObjectData {
  name: string;
  type: "sphere" | "plane" | "cylinder" | "box" | "disc" | "triangle" | "mesh";
  label: string; // the word a person reads: "ellipsoid", "mesh", ...
  material: number;
  /** 16 numbers, column-major (as three's Matrix4.fromArray): canonical -> world. */
  transform: readonly number[];
  open?: boolean; // a cylinder without caps
  mesh?: string; // key into SceneData.meshes
  checker?: { size: number; material: number; axes: readonly [Vec3, Vec3]; origin: Vec3 };
}

/** Base64 of byte planes: all low bytes, then all next ones. Positions: 2 planes of steps of
 *  65535 over box[0]..box[1], normals (absent when flat): 1 plane, / 127; both axis by axis,
 *  each the difference to the vertex before, modulo the planes' range. Indices: 4 planes, how
 *  far behind the next new vertex; 0 is that new one. */
export interface MeshData {
  box: readonly [Vec3, Vec3];
  positions: string;
  normals?: string;
  indices: string;
}

export interface LightData {
  name: string;
  position: Vec3;
  colour: Vec3;
  intensity: number;
}

/** What-if switches as a lesson step names them; what is absent is as traced. */
export interface SwitchesView {
  bounces?: number;
  lights?: Readonly<Record<string, number>>; // factor on a lamp's brightness, by its name
  shadows?: boolean;
  without?: readonly ("ambient" | "diffuse" | "specular" | "reflected" | "refracted")[];
}

/** A view as a lesson step or an address gives it; what is absent keeps its start value. */
export interface View {
  resolution?: number; // n
  pixel?: readonly [number, number]; // column, row from the top left
  rays?: readonly ("pixel" | "row" | "column" | "all")[]; // [] shows none
  tiles?: "empty" | "filled";
  look?: "plain" | "approximate" | "traced"; // of the stage
  slice?: "none" | "row" | "column"; // drawn flat instead of the stage
  observer?: "start" | "camera" | { eye: Vec3; target: Vec3 };
  switches?: SwitchesView;
  colours?: "picture" | "rays" | "depth" | "tests" | "distance" | "normal"; // of the tiles
}

interface LessonStop {
  html: string; // rendered and sanitised by the pipeline
  view: View;
}

/** With an answer, the step is a question. */
export interface LessonStepData extends LessonStop {
  answer?: LessonStop;
}

/** scenes/<id>/scene.js */
/** What tracing a scene did not have to do. Keys are those of words/<language>.json, below "savings". */
export interface Savings {
  notRun: readonly ("meshes" | "shadows" | "highlights" | "reflection" | "refraction")[];
  /** whole: of how many; 0 if that is not to be told. */
  counts: readonly (readonly [key: "shadow" | "turned" | "colourless" | "dark" | "unshadowed" | "faint" | "tests" | "mesh" | "kept", part: number, whole: number])[];
}

export interface SceneData {
  format: 1;
  id: string;
  key: string; // "1".."9", "0" or ""
  title: string;
  teaches: string;
  picture: string; // file name beside scene.js
  size: number; // the picture is size x size
  camera: { eye: Vec3; target: Vec3; up: Vec3; fov: number }; // fov vertical, degrees
  background: Vec3;
  shadows: boolean;
  depth: number;
  levels: readonly number[]; // frustum resolutions, ascending; <n>.js beside scene.js
  start: { resolution: number; pixel: readonly [number, number] };
  /** A sphere round everything finite: objects, lights, eye. */
  bounds: { center: Vec3; radius: number };
  materials: readonly MaterialData[];
  objects: readonly ObjectData[];
  meshes: Readonly<Record<string, MeshData>>;
  lights: readonly LightData[];
  lesson: readonly LessonStepData[];
  savings: Savings;
}
