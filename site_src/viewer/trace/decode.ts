/**
 * A trace file's JSON as a Trace. Reads columns in the order of walk.py, which is the place to
 * learn what they are; the numbers come out bit by bit as there.
 */
import { ABSENT, Columns, NO_FEATURES, inRaster, storedRays, type Stored } from "./columns";
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
  const cameras = storedRays(zeros, zeros, sides);
  const signature = columns.symbols("signature", cameras, n * n, tables.signature.length);
  const hits = readHits(header, columns, signature, sides);
  const tree = grow(header, columns, ints(n * n, (k) => tables.signature[signature[k]][0] ?? ABSENT), sides);
  const count = tree.count;
  const surface = (column: 1 | 2 | 3) => looked(tree.surface, tables.surface.map((each) => each[column]));
  const material = surface(1);
  const point = readPoints(header, columns, tree, hits);
  const normal = readNormals(header, columns, tree, point, surface(3));
  const object = looked(tree.patch, header.patches.map((patch) => patch.object));
  const t = lengths(tree, point, hits, object);
  const weight = readWeights(header, columns, tree, material);
  const tests = new Int32Array(columns.numbers("tests", storedRays(tree.way, tree.patch, tree.sides), NO_FEATURES, new Float64Array(count)));
  const lit = readLights(header, columns, tree, { object, material, point, normal });
  const localWeight = floats(count, (row) => header.materials[material[row]]?.local ?? 0);
  const colour = recombine(header, { count, parent: tree.parent, material, weight, localWeight, ...lit });
  return {
    scene: header.scene, n, lights: header.lights.length, count,
    kind: tree.kind, parent: tree.parent, pixel: tree.pixel,
    depth: new Uint8Array(ints(count, (row) => Math.min(tree.level[row], 255))),
    object, material, inside: new Uint8Array(surface(2)), t, weight, localWeight, tests, point, normal, colour,
    ...lit, tiles: readTiles(columns, n, colour, cameras),
    hitsStart: hits.start, hitsT: hits.hitsT, hitsObject: hits.hitsObject,
  };
}

/** table[row[k]] for every k. */
function looked(row: Int32Array, table: readonly number[]): Int16Array {
  const out = new Int16Array(row.length);
  for (let k = 0; k < row.length; k++) out[k] = table[row[k]];
  return out;
}

/** The rays for which `stored` holds, told by the row's `by`. */
function raysWith(tree: Structure, kind: Int32Array, stored: (row: number) => boolean): Stored {
  const [groups, kinds] = [new Int32Array(tree.count).fill(ABSENT), new Int32Array(tree.count).fill(ABSENT)];
  for (let row = 0; row < tree.count; row++) {
    if (!stored(row)) continue;
    groups[row] = tree.way[row];
    kinds[row] = kind[row];
  }
  return storedRays(groups, kinds, tree.sides);
}

/** Where rays end. Those of camera rays are known from the hits along them. */
function readPoints(header: Header, columns: Columns, tree: Structure, hits: CameraHits): Float64Array {
  const { n, patches } = header;
  const isFree = patches.map((patch) => patch.points === "free");
  const sent = raysWith(tree, tree.patch, (row) => row >= n * n);
  const free = raysWith(tree, tree.patch, (row) => row >= n * n && isFree[tree.patch[row]]);
  const numbers = [sent, sent, free].map((stored, k) => columns.numbers(`point${k}`, stored, NO_FEATURES, new Float64Array(tree.count)));
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
  const isStored = patches.map((patch) => patch.normals === "stored");
  const kind = new Int32Array(tree.count);
  for (let row = 0; row < tree.count; row++) kind[row] = 2 * tree.patch[row] + (tree.level[row] > 0 ? 1 : 0);
  const stored = raysWith(tree, kind, (row) => isStored[tree.patch[row]]);
  const u = columns.numbers("normal0", stored, NO_FEATURES, new Float64Array(tree.count));
  const v = columns.numbers("normal1", stored, NO_FEATURES, new Float64Array(tree.count));
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
  const number = columns.numbers("split", raysWith(tree, tree.surface, isParted), NO_FEATURES, new Float64Array(tree.count));
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
function readTiles(columns: Columns, n: number, colour: Float64Array, cameras: Stored): Uint8Array {
  const tiles = new Uint8Array(3 * n * n);
  for (let c = 0; c < 3; c++) {
    const off = columns.numbers(`tile${c}`, cameras, NO_FEATURES, new Float64Array(n * n));
    for (let k = 0; k < n * n; k++) tiles[3 * k + c] = eightBit(colour[3 * k + c]) + off[k];
  }
  return tiles;
}
