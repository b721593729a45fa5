/**
 * A trace file's JSON as a Trace. Reads columns in the order of walk.py, which is the place to
 * learn what they are; the numbers come out bit by bit as there.
 */
import { ABSENT, Columns, inRaster, type Sides } from "./columns";
import { TraceError, damaged } from "./errors";
import { floats, ints } from "./fill";
import { checkedHeader, type Expected, type Header } from "./header";
import { readLights } from "./lights";
import { readHits, type CameraHits } from "./hits";
import { SHARE, eightBit, normalOn, onOctahedron, pointOn, recombine } from "./rebuild";
import { grow, type Structure } from "./structure";
import { KIND, type Trace } from "./types";

/** Throws TraceError if the file is damaged, or not of the expected scene and resolution. */
export function decode(json: unknown, expected: Expected = {}): Trace {
  const header = checkedHeader(json, expected);
  try {
    const columns = new Columns(header);
    const trace = read(header, columns);
    columns.finish();
    return trace;
  } catch (error) {
    if (error instanceof TraceError) throw error;
    throw damaged(`the header lacks something: ${error}`);
  }
}

function read(header: Header, columns: Columns): Trace {
  const { n, tables } = header;
  const sides = inRaster(n);
  const zeros = new Int32Array(n * n);
  const signature = columns.symbols("signature", zeros, zeros, sides, tables.signature.length);
  const hits = readHits(header, columns, signature, sides);
  const tree = grow(header, columns, ints(n * n, (k) => tables.signature[signature[k]][0] ?? ABSENT), sides);
  const count = tree.count;
  const surface = (column: 1 | 2 | 3) => new Int16Array(ints(count, (row) => tables.surface[tree.surface[row]][column]));
  const material = surface(1);
  const point = readPoints(header, columns, tree, hits);
  const normal = readNormals(header, columns, tree, point, surface(3));
  const object = new Int16Array(ints(count, (row) => header.patches[tree.patch[row]].object));
  const t = lengths(tree, point, hits, object);
  const weight = readWeights(header, columns, tree, material);
  const tests = new Int32Array(columns.numbers("tests", tree.way, tree.patch, tree.sides, []));
  const lit = readLights(header, columns, tree, { object, material, point, normal });
  const localWeight = floats(count, (row) => header.materials[material[row]]?.local ?? 0);
  const colour = recombine(header, { count, parent: tree.parent, material, weight, localWeight, ...lit });
  return {
    scene: header.scene, n, lights: header.lights.length, count,
    kind: tree.kind, parent: tree.parent, pixel: tree.pixel,
    depth: new Uint8Array(ints(count, (row) => Math.min(tree.level[row], 255))),
    object, material, inside: new Uint8Array(surface(2)), t, weight, localWeight, tests, point, normal, colour,
    ...lit, tiles: readTiles(columns, n, colour, sides),
    hitsStart: hits.start, hitsT: hits.hitsT, hitsObject: hits.hitsObject,
  };
}

const where = (of: Int32Array, stored: (row: number) => boolean) =>
  ints(of.length, (row) => (stored(row) ? of[row] : ABSENT));

/** Where rays end. Those of camera rays are known from the hits along them. */
function readPoints(header: Header, columns: Columns, tree: Structure, hits: CameraHits): Float64Array {
  const { n, patches } = header;
  const numbers = [0, 1, 2].map((k) => {
    const stored = (row: number) => row >= n * n && (k < 2 || patches[tree.patch[row]].points === "free");
    return columns.numbers(`point${k}`, where(tree.way, stored), where(tree.patch, stored), tree.sides, []);
  });
  const point = new Float64Array(3 * tree.count);
  point.set(hits.point);
  for (let row = n * n; row < tree.count; row++) {
    pointOn(patches[tree.patch[row]], numbers[0][row], numbers[1][row], numbers[2][row], point, 3 * row);
  }
  return point;
}

function lengths(tree: Structure, point: Float64Array, hits: CameraHits, object: Int16Array): Float64Array {
  const t = new Float64Array(tree.count).fill(Infinity);
  for (let row = 0; row < hits.t.length; row++) if (object[row] >= 0) t[row] = hits.t[row];
  for (let row = hits.t.length; row < tree.count; row++) {
    if (object[row] < 0) continue;
    const a = 3 * row, b = 3 * tree.parent[row];
    const x = point[a] - point[b], y = point[a + 1] - point[b + 1], z = point[a + 2] - point[b + 2];
    t[row] = Math.sqrt(x * x + y * y + z * z);
  }
  return t;
}

function readNormals(
  header: Header, columns: Columns, tree: Structure, point: Float64Array, sign: Int16Array,
): Float64Array {
  const { patches, steps } = header;
  const stored = (row: number) => patches[tree.patch[row]].normals === "stored";
  const kind = ints(tree.count, (row) =>
    stored(row) ? 2 * tree.patch[row] + (tree.level[row] > 0 ? 1 : 0) : ABSENT,
  );
  const group = where(tree.way, stored);
  const u = columns.numbers("normal0", group, kind, tree.sides, []);
  const v = columns.numbers("normal1", group, kind, tree.sides, []);
  const normal = new Float64Array(3 * tree.count);
  for (let row = 0; row < tree.count; row++) {
    const patch = patches[tree.patch[row]];
    if (patch.normals === "stored") onOctahedron(u[row] * steps.normal, v[row] * steps.normal, normal, 3 * row);
    else if (patch.normals !== "none") normalOn(patch, sign[row], point, normal, 3 * row);
  }
  return normal;
}

/** Shares: constants of the parent's material, or split between reflected and refracted. */
function readWeights(header: Header, columns: Columns, tree: Structure, material: Int16Array): Float64Array {
  const { materials, steps } = header;
  const isParted = (row: number) =>
    material[row] >= 0 && materials[material[row]].split > 0 &&
    (tree.children[row] & 3) > 0 && (tree.children[row] & 4) === 0;
  const number = columns.numbers("split", where(tree.way, isParted), where(tree.surface, isParted), tree.sides, []);
  const weight = new Float64Array(tree.count).fill(1);
  for (let row = 0; row < tree.count; row++) {
    const kind = tree.kind[row], parent = tree.parent[row];
    if (kind === KIND.camera) continue;
    const of = materials[material[parent]];
    if (!isParted(parent)) weight[row] = of[SHARE[kind as 1 | 2 | 3]];
    else {
      const share = number[parent] * steps.split;
      weight[row] = kind === KIND.reflected ? share : of.split - share;
    }
  }
  return weight;
}

/** Exact 8-bit colours: stored is by how much the rounded sum of the tree is off. */
function readTiles(columns: Columns, n: number, colour: Float64Array, sides: Sides): Uint8Array {
  const zeros = new Int32Array(n * n);
  const tiles = new Uint8Array(3 * n * n);
  for (let c = 0; c < 3; c++) {
    const off = columns.numbers(`tile${c}`, zeros, zeros, sides, []);
    for (let k = 0; k < n * n; k++) tiles[3 * k + c] = eightBit(colour[3 * k + c]) + off[k];
  }
  return tiles;
}
