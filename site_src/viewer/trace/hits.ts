/** Every hit along each camera ray, kept as one image of 1 / z per key: an object and how often
 *  the ray met it before. A ray that leaves the scene has its end in an image of its own. */
import type { Columns } from "./columns";
import { damaged } from "./errors";
import type { Header } from "./header";
import { ABSENT, alike, type Sides } from "./neighbours";
import type { Scratch } from "./scratch";
import type { Trace } from "./types";

export type CameraHits = Pick<Trace, "hitsStart" | "hitsT" | "hitsObject">;

/** Which image each end stands in; a ray that leaves has one end, others as many as hits. */
interface Ends {
  start: Int32Array; // (n * n + 1)
  ray: Int32Array; // image by image
  place: Int32Array; // likewise: which of all ends
  first: Int32Array; // of each image, and the end
}

/** signature[k]: row of the table of objects along camera ray k, nearest first. Writes points and
 *  lengths of the camera rays, which are the first. */
export function readHits(header: Header, columns: Columns, signature: Int32Array, sides: Sides, scratch: Scratch, point: Float64Array, t: Float64Array): CameraHits {
  const { n } = header;
  const met = header.tables.signature;
  const ends = sortedByImage(header, signature);
  const z = readImages(header, columns, ends, sides, scratch);
  const counts = Int32Array.from(met, (objects) => objects.length);
  const start = new Int32Array(n * n + 1);
  for (let ray = 0; ray < n * n; ray++) start[ray + 1] = start[ray] + counts[signature[ray]];
  const hits: CameraHits = { hitsStart: start, hitsT: new Float64Array(start[n * n]), hitsObject: new Int32Array(start[n * n]) };
  alongRays(header, ends.start, z, hits, point, t);
  for (let ray = 0; ray < n * n; ray++) {
    const objects = met[signature[ray]];
    for (let k = 0; k < objects.length; k++) hits.hitsObject[start[ray] + k] = objects[k];
  }
  return hits;
}

function alongRays({ n, camera }: Header, endStart: Int32Array, z: Float64Array, { hitsStart: start, hitsT }: CameraHits, point: Float64Array, t: Float64Array) {
  const [eyeX, eyeY, eyeZ] = camera.eye, [forwardX, forwardY, forwardZ] = camera.forward;
  const [rightX, rightY, rightZ] = camera.right, [downX, downY, downZ] = camera.down;
  for (let ray = 0, row = 0; row < n; row++) {
    const y = (2 * (row + 0.5)) / n - 1;
    for (let column = 0; column < n; column++, ray++) {
      const x = (2 * (column + 0.5)) / n - 1;
      const stepX = forwardX + rightX * x + downX * y, stepY = forwardY + rightY * x + downY * y, stepZ = forwardZ + rightZ * x + downZ * y;
      const size = Math.sqrt(stepX * stepX + stepY * stepY + stepZ * stepZ);
      const nearest = z[endStart[ray]];
      point[3 * ray] = eyeX + stepX * nearest;
      point[3 * ray + 1] = eyeY + stepY * nearest;
      point[3 * ray + 2] = eyeZ + stepZ * nearest;
      t[ray] = nearest * size;
      let before = -Infinity;
      for (let at = start[ray], end = endStart[ray]; at < start[ray + 1]; at++, end++) {
        const far = z[end] * size;
        if (!(far < before)) before = far; // else closer than the step
        hitsT[at] = before;
      }
    }
  }
}

function sortedByImage(header: Header, signature: Int32Array): Ends {
  const { n, images } = header;
  // A number a key: an object's may be -1, and the highest is one below how many there are.
  const keyOf = (object: number, turn: number) => turn * (header.objects.length + 1) + object;
  const imageOf = new Map(images.map(({ object, turn }, k) => [keyOf(object, turn), k]));
  const keys = header.tables.signature.map((objects) => imageKeys(imageOf, keyOf, objects));
  const counts = Int32Array.from(keys, (own) => own.length);
  const start = new Int32Array(n * n + 1);
  const rays = new Int32Array(keys.length); // of each signature
  for (let ray = 0; ray < n * n; ray++) {
    rays[signature[ray]]++;
    start[ray + 1] = start[ray] + counts[signature[ray]];
  }
  const first = new Int32Array(images.length + 1);
  keys.forEach((own, k) => own.forEach((image) => (first[image + 1] += rays[k])));
  for (let k = 0; k < images.length; k++) first[k + 1] += first[k];
  const next = first.slice();
  const ray = new Int32Array(start[n * n]), place = new Int32Array(start[n * n]);
  for (let k = 0; k < n * n; k++) {
    const own = keys[signature[k]];
    for (let turn = 0; turn < own.length; turn++) {
      const at = next[own[turn]]++;
      ray[at] = k;
      place[at] = start[k] + turn;
    }
  }
  return { start, ray, place, first };
}

/** z of every end, in the rays' order. */
function readImages(header: Header, columns: Columns, ends: Ends, sides: Sides, { near, group: image, zeros, number: [number] }: Scratch): Float64Array {
  const { n, images } = header;
  const cell = new Float64Array(3 * n * n); // column, row, unused
  for (let k = 0; k < n * n; k++) {
    cell[3 * k] = k % n;
    cell[3 * k + 1] = Math.floor(k / n);
  }
  const features = { width: 2, first: cell, second: cell } as const;
  image.fill(ABSENT, 0, n * n); // the last that each ray was of
  const z = new Float64Array(ends.ray.length);
  for (let k = 0; k < images.length; k++) {
    const rays = ends.ray.subarray(ends.first[k], ends.first[k + 1]);
    for (let at = 0; at < rays.length; at++) image[rays[at]] = k;
    alike(rays, image, sides, near);
    columns.numbers(`depth${k}`, rays, zeros, 1, near, features, number);
    const { step } = images[k], from = ends.first[k], { place } = ends;
    for (let at = 0; at < rays.length; at++) {
      const depth = number[rays[at]];
      if (depth < 1) throw damaged(`column depth${k}`);
      z[place[from + at]] = 1 / (depth * step);
    }
  }
  return z;
}

/** The images of a ray that meets these objects, or none. */
function imageKeys(imageOf: Map<number, number>, keyOf: (object: number, turn: number) => number, objects: readonly number[]): number[] {
  const turns = new Map<number, number>();
  return (objects.length ? objects : [ABSENT]).map((object) => {
    const turn = turns.get(object) ?? 0;
    turns.set(object, turn + 1);
    const key = imageOf.get(keyOf(object, turn));
    if (key === undefined) throw damaged("a depth image");
    return key;
  });
}
