/** A mesh's numbers as the pipeline packs them (see MeshData). */
import type { MeshData } from "../trace/types";

export interface Mesh {
  positions: Float32Array; // three a vertex, the mesh's own coordinates
  normals: Float32Array | null; // null: flat faces
  indices: Uint32Array;
}

const bytes = (base64: string): ArrayBuffer => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer;

const unpacked = new WeakMap<MeshData, Mesh>();

export function meshOf(data: MeshData): Mesh {
  const known = unpacked.get(data);
  if (known) return known;
  const steps = new Uint16Array(bytes(data.positions));
  const [low, high] = data.box;
  const positions = Float32Array.from(steps, (step, k) => low[k % 3] + (step / 65535) * (high[k % 3] - low[k % 3]));
  const normals = data.normals ? Float32Array.from(new Int8Array(bytes(data.normals)), (v) => v / 127) : null;
  const mesh = { positions, normals, indices: new Uint32Array(bytes(data.indices)) };
  unpacked.set(data, mesh);
  return mesh;
}
