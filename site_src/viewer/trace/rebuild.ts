/**
 * From whole numbers to numbers a person sees; rebuild.py does the same. Only + - * / and sqrt,
 * in this order, so that both give the same bits. Patches are a codec device: rules fitted to
 * the stored points and normals, which know nothing of rays.
 */
import type { Patch } from "./header";
import { VISIBILITY, type Trace, type Vec3 } from "./types";

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
const FLAT = 0, BALL = 1, FREE = 2; // how a patch's points are kept
const FRAME = 13; // numbers of a patch: step, origin, three axes

/** Writes the world points of the rays from row `first` on to `end`, from their stored coordinates. */
export function pointsOn(patches: readonly Patch[], patchOf: Int32Array, first: number, end: number, number: readonly Float64Array[], out: Float64Array) {
  const form = Uint8Array.from(patches, ({ points }) => (points === "flat" ? FLAT : points === "ball" ? BALL : FREE));
  const frame = new Float64Array(FRAME * patches.length);
  patches.forEach(({ step = NaN, origin = [], axes = [] }, k) => [step, ...origin, ...axes].forEach((part, at) => (frame[FRAME * k + at] = part)));
  const [across, along, third] = number;
  for (let row = first; row < end; row++) {
    const patch = patchOf[row], f = FRAME * patch, to = 3 * row;
    const step = frame[f];
    const a = across[row] * step, b = along[row] * step;
    if (form[patch] === FLAT) {
      out[to] = frame[f + 1] + frame[f + 4] * a + frame[f + 7] * b;
      out[to + 1] = frame[f + 2] + frame[f + 5] * a + frame[f + 8] * b;
      out[to + 2] = frame[f + 3] + frame[f + 6] * a + frame[f + 9] * b;
    } else if (form[patch] === BALL) {
      onOctahedron(a, b, sphere, 0);
      const x = sphere[0], y = sphere[1], z = sphere[2];
      out[to] = frame[f + 1] + frame[f + 4] * x + frame[f + 7] * y + frame[f + 10] * z;
      out[to + 1] = frame[f + 2] + frame[f + 5] * x + frame[f + 8] * y + frame[f + 11] * z;
      out[to + 2] = frame[f + 3] + frame[f + 6] * x + frame[f + 9] * y + frame[f + 12] * z;
    } else {
      out[to] = a;
      out[to + 1] = b;
      out[to + 2] = third[row] * step;
    }
  }
}

const NONE = 0, ONE = 1, GRADIENT = 2, STORED = 3; // how a patch's normals are kept
const RULE = 12; // numbers of a gradient

/** Writes normals: from two stored numbers, or as they follow from the patch; the surface's sign,
 *  1 or -1, turns them to the incoming ray. */
export function normalsOn(
  patches: readonly Patch[], patchOf: Int32Array, surface: Int32Array, surfaces: readonly (readonly number[])[], step: number, number: readonly Float64Array[], point: Float64Array, out: Float64Array,
) {
  const form = Uint8Array.from(patches, ({ normals }) => (normals === "one" ? ONE : normals === "gradient" ? GRADIENT : normals === "stored" ? STORED : NONE));
  const rules = new Float64Array(RULE * patches.length);
  patches.forEach(({ gradient = [] }, k) => gradient.forEach((part, at) => (rules[RULE * k + at] = part)));
  const signs = Float64Array.from(surfaces, (each) => each[3]);
  const [u, v] = number;
  for (let row = 0, count = out.length / 3; row < count; row++) {
    const patch = patchOf[row], g = RULE * patch, at = 3 * row;
    if (form[patch] === STORED) onOctahedron(u[row] * step, v[row] * step, out, at);
    else if (form[patch] === ONE) {
      const sign = signs[surface[row]];
      out[at] = rules[g] * sign;
      out[at + 1] = rules[g + 1] * sign;
      out[at + 2] = rules[g + 2] * sign;
    } else if (form[patch] === GRADIENT) {
      const sign = signs[surface[row]];
      const px = point[at], py = point[at + 1], pz = point[at + 2];
      const x = rules[g] * px + rules[g + 1] * py + rules[g + 2] * pz + rules[g + 9];
      const y = rules[g + 3] * px + rules[g + 4] * py + rules[g + 5] * pz + rules[g + 10];
      const z = rules[g + 6] * px + rules[g + 7] * py + rules[g + 8] * pz + rules[g + 11];
      const size = Math.sqrt(x * x + y * y + z * z);
      out[at] = (x / size) * sign;
      out[at + 1] = (y / size) * sign;
      out[at + 2] = (z / size) * sign;
    }
  }
}

export type Terms = Pick<Trace, "count" | "parent" | "material" | "weight" | "localWeight" | "visibility" | "diffuse" | "specular" | "base">;

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
  const { parent, weight, localWeight, visibility, diffuse, specular, base } = ray;
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
    const r = base[to], g = base[to + 1], b = base[to + 2];
    let red = ambients[of] * r, green = ambients[of + 1] * g, blue = ambients[of + 2] * b;
    for (let l = 0; l < lights; l++) {
      const at = row * lights + l, lamp = 3 * l;
      const seen = visibility[at];
      if (seen !== VISIBILITY.reached && seen !== VISIBILITY.untested) continue;
      const d = diffuse[at], s = specular[at];
      red = red + (d * (diffuses[of] * r) + s * speculars[of]) * lamps[lamp];
      green = green + (d * (diffuses[of + 1] * g) + s * speculars[of + 1]) * lamps[lamp + 1];
      blue = blue + (d * (diffuses[of + 2] * b) + s * speculars[of + 2]) * lamps[lamp + 2];
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
