/** The viewer unpacks the meshes that the pipeline packs (tests/site/test_mesh_data.py packs the same one). */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./typescript.mjs";

const { meshOf } = await load("state/mesh.ts");

// Corners (0,0,0) (0,2,0) (1,0,0) (0,0,4) in the order of their first use.
const TETRAHEDRON = {
  box: [[0, 0, 0], [1, 2, 4]],
  positions: "AAD/AQD/AQAAAAD/AAD/AAD/AAAAAAD/",
  normals: "gX9/gQB/gQAAAAB/",
  indices: "AAAAAwEAAgMBBAEDAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA",
};

test("a packed mesh comes back with its corners, normals and faces", () => {
  const mesh = meshOf(TETRAHEDRON);
  assert.deepEqual([...mesh.positions], [0, 0, 0, 0, 2, 0, 1, 0, 0, 0, 0, 4]);
  assert.deepEqual([...mesh.normals], [-1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1]);
  assert.deepEqual([...mesh.indices], [0, 1, 2, 0, 2, 3, 2, 1, 3, 0, 3, 1]);
});

test("a mesh without normals is flat", () => {
  assert.equal(meshOf({ ...TETRAHEDRON, normals: undefined }).normals, null);
});

test("colours of vertices are bytes, as they were packed", () => {
  const colours = Buffer.from([255, 10, 246, 1, 0, 255, 13, 200, 7, 121, 136, 56]).toString("base64"); // differences, axis by axis
  assert.deepEqual([...meshOf({ ...TETRAHEDRON, colours }).colours], [255, 0, 7, 9, 255, 128, 255, 12, 8, 0, 212, 64]);
  assert.equal(meshOf({ ...TETRAHEDRON }).colours, null);
});
