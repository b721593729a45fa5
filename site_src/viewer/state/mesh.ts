/** A mesh's numbers as the pipeline packs them (see MeshData). */
import type { MeshData } from "../trace/types";
import { onceFor } from "./memo";

export interface Mesh {
  positions: Float32Array; // three a vertex, the mesh's own coordinates
  normals: Float32Array | null; // null: flat faces
  colours: Uint8Array | null; // base colours, three a vertex, of 255
  indices: Uint32Array;
}

/** Whole numbers from `planes` byte planes, lowest first. */
function fromPlanes(base64: string, planes: number): Uint32Array {
  const bytes = atob(base64);
  const count = bytes.length / planes;
  const values = new Uint32Array(count);
  for (let plane = 0; plane < planes; plane++) {
    for (let k = 0; k < count; k++) values[k] += bytes.charCodeAt(plane * count + k) * 2 ** (8 * plane);
  }
  return values;
}

/** Sums the differences of each axis and puts the axes side by side: xyz xyz ... */
function summed(base64: string, planes: number): Uint32Array {
  const steps = fromPlanes(base64, planes);
  const vertices = steps.length / 3;
  const range = 2 ** (8 * planes);
  const rows = new Uint32Array(steps.length);
  for (let axis = 0; axis < 3; axis++) {
    let value = 0;
    for (let k = 0; k < vertices; k++) {
      value = (value + steps[axis * vertices + k]) % range;
      rows[3 * k + axis] = value;
    }
  }
  return rows;
}

function indicesOf(base64: string): Uint32Array {
  let next = 0;
  return fromPlanes(base64, 4).map((behind) => (behind === 0 ? next++ : next - behind));
}

export const meshOf = onceFor((data: MeshData): Mesh => {
  const [low, high] = data.box;
  const place = (step: number, k: number) => low[k % 3] + (step / 65535) * (high[k % 3] - low[k % 3]);
  const signed = (byte: number) => (byte > 127 ? byte - 256 : byte) / 127;
  return {
    positions: Float32Array.from(summed(data.positions, 2), place),
    normals: data.normals ? Float32Array.from(summed(data.normals, 1), signed) : null,
    colours: data.colours ? Uint8Array.from(summed(data.colours, 1)) : null,
    indices: indicesOf(data.indices),
  };
});
