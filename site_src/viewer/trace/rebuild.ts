/**
 * From whole numbers to numbers a person sees; rebuild.py does the same. Only + - * / and sqrt,
 * in this order, so that both give the same bits. Patches are a codec device: rules fitted to
 * the stored points and normals, which know nothing of rays.
 */
import type { Header, Patch } from "./header";
import { KIND, VISIBILITY } from "./types";

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

/** Colours of all rays: a hit's own share, then, from the last row to the first, each ray's
 *  weight x colour added to its parent. */
export function recombine(header: Header, ray: Terms): Float64Array {
  const { materials, lights, background } = header;
  const colour = new Float64Array(3 * ray.count);
  for (let row = 0; row < ray.count; row++) {
    const material = materials[ray.material[row]];
    for (let c = 0; c < 3; c++) {
      if (!material) {
        colour[3 * row + c] = background[c];
        continue;
      }
      let local = material.ambient[c];
      for (let l = 0; l < lights.length; l++) {
        const at = row * lights.length + l;
        const seen = ray.visibility[at];
        if (seen !== VISIBILITY.reached && seen !== VISIBILITY.untested) continue;
        const term = ray.diffuse[at] * material.diffuse[c] + ray.specular[at] * material.specular[c];
        local = local + term * lights[l].colour[c];
      }
      colour[3 * row + c] = ray.localWeight[row] * local;
    }
  }
  for (let row = ray.count - 1; row >= 0; row--) {
    const parent = ray.parent[row];
    if (parent < 0) break; // camera rays stand first
    for (let c = 0; c < 3; c++) {
      colour[3 * parent + c] = colour[3 * parent + c] + ray.weight[row] * colour[3 * row + c];
    }
  }
  return colour;
}

/** Linear 0..1, clamped, as 0..255; halves up. */
export const eightBit = (colour: number) => Math.floor(255 * Math.min(Math.max(colour, 0), 1) + 0.5);

/** Which constant of its parent's material a ray's weight is. */
export const SHARE = { [KIND.reflected]: "reflected", [KIND.refracted]: "refracted", [KIND.total]: "total" } as const;
