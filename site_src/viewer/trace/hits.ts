/** Every hit along each camera ray, kept as one image of 1 / z per key: an object and how often
 *  the ray met it before. A ray that leaves the scene has its end in an image of its own. */
import { ABSENT, storedRays, type Columns, type Sides } from "./columns";
import { damaged } from "./errors";
import { floats, ints } from "./fill";
import type { Header } from "./header";

export interface CameraHits {
  point: Float64Array; // (3 * n * n) where each camera ray ends
  t: Float64Array; // (n * n) length of each camera ray
  start: Int32Array;
  hitsT: Float64Array;
  hitsObject: Int16Array;
}

/** met[signature[k]]: objects along camera ray k, nearest first. */
export function readHits(header: Header, columns: Columns, signature: Int32Array, sides: Sides): CameraHits {
  const { n, camera } = header;
  const met = header.tables.signature;
  const keys = met.map((hits) => imageKeys(header, hits));
  const depth = readImages(header, columns, signature, keys, sides);
  const start = new Int32Array(n * n + 1);
  for (let ray = 0; ray < n * n; ray++) start[ray + 1] = start[ray] + met[signature[ray]].length;
  const hitsT = new Float64Array(start[n * n]);
  const hitsObject = new Int16Array(start[n * n]);
  const point = new Float64Array(3 * n * n);
  const t = new Float64Array(n * n);
  const step = new Float64Array(3);
  for (let ray = 0; ray < n * n; ray++) {
    const x = (2 * ((ray % n) + 0.5)) / n - 1;
    const y = (2 * (Math.floor(ray / n) + 0.5)) / n - 1;
    for (let k = 0; k < 3; k++) step[k] = camera.forward[k] + camera.right[k] * x + camera.down[k] * y;
    const size = Math.sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
    const own = keys[signature[ray]], objects = met[signature[ray]];
    const nearest = depth[own[0]][ray];
    for (let k = 0; k < 3; k++) point[3 * ray + k] = camera.eye[k] + step[k] * nearest;
    t[ray] = nearest * size;
    for (let k = 0; k < objects.length; k++) {
      const at = start[ray] + k;
      hitsT[at] = depth[own[k]][ray] * size;
      if (k > 0 && hitsT[at] < hitsT[at - 1]) hitsT[at] = hitsT[at - 1]; // closer than the step
      hitsObject[at] = objects[k];
    }
  }
  return { point, t, start, hitsT, hitsObject };
}

/** z of every camera ray in every image. */
function readImages(
  header: Header, columns: Columns, signature: Int32Array, keys: number[][], sides: Sides,
): Float64Array[] {
  const { n, images } = header;
  const place = { width: 2, values: floats(2 * n * n, (k) => (k % 2 ? Math.floor((k >> 1) / n) : (k >> 1) % n)) };
  return images.map((image, k) => {
    const groupOf = keys.map((own) => (own.includes(k) ? 0 : ABSENT));
    const group = ints(n * n, (ray) => groupOf[signature[ray]]);
    const z = columns.numbers(`depth${k}`, storedRays(group, group, sides), place, new Float64Array(n * n));
    for (let ray = 0; ray < z.length; ray++) {
      if (group[ray] === ABSENT) continue;
      if (z[ray] < 1) throw damaged(`column depth${k} leads behind the camera`);
      z[ray] = 1 / (z[ray] * image.step);
    }
    return z;
  });
}

/** The images of a ray that meets these objects, or none. */
function imageKeys(header: Header, objects: readonly number[]): number[] {
  const turns = new Map<number, number>();
  return (objects.length ? objects : [ABSENT]).map((object) => {
    const turn = turns.get(object) ?? 0;
    turns.set(object, turn + 1);
    const key = header.images.findIndex((image) => image.object === object && image.turn === turn);
    if (key < 0) throw damaged("a depth image is missing");
    return key;
  });
}
