/**
 * From whole numbers to numbers a person sees; rebuild.py does the same. Only + - * / and sqrt,
 * in this order, so that both give the same bits. Patches are a codec device: rules fitted to
 * the stored points and normals, which know nothing of rays.
 */
import type { Patch } from "./header";
import { KIND, VISIBILITY, type Vec3 } from "./types";

/** Writes a unit vector at out[at..at + 2] from coordinates on the unfolded octahedron. */
export function onOctahedron(u: number, v: number, out: Float64Array, at: number) {
  const z = 1 - Math.abs(u) - Math.abs(v);
  const below = z < 0 ? -z : 0;
  const x = u >= 0 ? u - below : u + below;
  const y = v >= 0 ? v - below : v + below;
  const size = Math.sqrt(x * x + y * y + z * z);
  out[at] = x / size;
  out[at + 1] = y / size;
  out[at + 2] = z / size;
}

const sphere = new Float64Array(3);

/** Writes the world point with these stored coordinates on a patch. */
export function pointOn(patch: Patch, a: number, b: number, c: number, out: Float64Array, at: number) {
  const step = patch.step!;
  if (patch.points === "free") {
    out[at] = a * step;
    out[at + 1] = b * step;
    out[at + 2] = c * step;
    return;
  }
  const o = patch.origin!, axes = patch.axes!;
  if (patch.points === "flat") {
    const u = a * step, v = b * step;
    for (let k = 0; k < 3; k++) out[at + k] = o[k] + axes[k] * u + axes[3 + k] * v;
    return;
  }
  onOctahedron(a * step, b * step, sphere, 0);
  for (let k = 0; k < 3; k++) {
    out[at + k] = o[k] + axes[k] * sphere[0] + axes[3 + k] * sphere[1] + axes[6 + k] * sphere[2];
  }
}

/** Writes the normal that follows from the patch; sign 1 or -1 turns it to the incoming ray. */
export function normalOn(patch: Patch, sign: number, point: Float64Array, out: Float64Array, at: number) {
  const g = patch.gradient!;
  if (patch.normals === "one") {
    for (let k = 0; k < 3; k++) out[at + k] = g[k] * sign;
    return;
  }
  const px = point[at], py = point[at + 1], pz = point[at + 2];
  const x = g[0] * px + g[1] * py + g[2] * pz + g[9];
  const y = g[3] * px + g[4] * py + g[5] * pz + g[10];
  const z = g[6] * px + g[7] * py + g[8] * pz + g[11];
  const size = Math.sqrt(x * x + y * y + z * z);
  out[at] = (x / size) * sign;
  out[at + 1] = (y / size) * sign;
  out[at + 2] = (z / size) * sign;
}

export interface Terms {
  count: number;
  parent: Int32Array;
  material: Int16Array;
  weight: Float64Array;
  localWeight: Float64Array;
  visibility: Uint8Array;
  diffuse: Float64Array;
  specular: Float64Array;
}

/** The colours that terms are multiplied by. */
export interface Paints {
  materials: readonly { ambient: Vec3; diffuse: Vec3; specular: Vec3 }[];
  lights: readonly { colour: Vec3 }[];
  background: Vec3;
}

/** Colours of all rays: a hit's own share, then, from the last row to the first, each ray's
 *  weight x colour added to its parent. */
export function recombine(header: Paints, ray: Terms): Float64Array {
  const { background } = header;
  const { parent, weight, localWeight, visibility, diffuse, specular } = ray;
  const colour = new Float64Array(3 * ray.count);
  const flat = (name: "ambient" | "diffuse" | "specular") => Float64Array.from(header.materials.flatMap((each) => [...each[name]]));
  const [ambients, diffuses, speculars] = [flat("ambient"), flat("diffuse"), flat("specular")];
  const lamps = Float64Array.from(header.lights.flatMap((light) => [...light.colour]));
  const lights = header.lights.length;
  for (let row = 0; row < ray.count; row++) {
    const of = 3 * ray.material[row], to = 3 * row;
    if (of < 0) {
      colour[to] = background[0];
      colour[to + 1] = background[1];
      colour[to + 2] = background[2];
      continue;
    }
    let red = ambients[of], green = ambients[of + 1], blue = ambients[of + 2];
    for (let l = 0; l < lights; l++) {
      const at = row * lights + l, lamp = 3 * l;
      const seen = visibility[at];
      if (seen !== VISIBILITY.reached && seen !== VISIBILITY.untested) continue;
      const d = diffuse[at], s = specular[at];
      red = red + (d * diffuses[of] + s * speculars[of]) * lamps[lamp];
      green = green + (d * diffuses[of + 1] + s * speculars[of + 1]) * lamps[lamp + 1];
      blue = blue + (d * diffuses[of + 2] + s * speculars[of + 2]) * lamps[lamp + 2];
    }
    colour[to] = localWeight[row] * red;
    colour[to + 1] = localWeight[row] * green;
    colour[to + 2] = localWeight[row] * blue;
  }
  for (let row = ray.count - 1; row >= 0 && parent[row] >= 0; row--) { // camera rays stand first
    const from = 3 * row, to = 3 * parent[row], share = weight[row];
    colour[to] = colour[to] + share * colour[from];
    colour[to + 1] = colour[to + 1] + share * colour[from + 1];
    colour[to + 2] = colour[to + 2] + share * colour[from + 2];
  }
  return colour;
}

/** Linear 0..1, clamped, as 0..255; halves up. */
export const eightBit = (colour: number) => Math.floor(255 * Math.min(Math.max(colour, 0), 1) + 0.5);

/** Which constant of its parent's material a ray's weight is. */
export const SHARE = { [KIND.reflected]: "reflected", [KIND.refracted]: "refracted", [KIND.total]: "total" } as const;
