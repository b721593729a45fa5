/**
 * A trace file's JSON as a Trace. Reads columns in the order of walk.py, which is the place to
 * learn what they are; the numbers come out the same, bit for bit.
 */
import { Columns, NO_FEATURES } from "./columns";
import { TraceError, damaged } from "./errors";
import { checkedHeader, type Expected, type Header } from "./header";
import { darkness, prepareLights } from "./lights";
import { readHits } from "./hits";
import { ABSENT, alike, fillRaster } from "./neighbours";
import { normalsOn, pointsOn, recombine } from "./rebuild";
import { giveBack, takeScratch, type Scratch } from "./scratch";
import { grow, type Structure } from "./structure";
import { bitOf, KIND, RAY_KINDS } from "./kinds";
import type { Trace } from "./types";

/** A level whose tiles can be shown and whose rays are known, but for what the lights give them. */
export interface Level {
  tiles: Uint8Array; // (3 * n * n) exact 8-bit colours
  /** What is left to do, light by light; the trace at the end. */
  light(): Generator<void, Trace>;
}

/** Throws TraceError if the file is damaged, or not of the expected scene and resolution. */
export function decode(json: unknown, expected: Expected = {}): Trace {
  const lights = begin(json, expected).light();
  for (;;) {
    const { done, value } = lights.next();
    if (done) return value;
  }
}

/** The same, with a rest between the parts for what a page does besides. */
export async function decodeWithRests(json: unknown, expected: Expected, rest: () => Promise<void>): Promise<Trace> {
  const lights = begin(json, expected).light();
  for (;;) {
    await rest();
    const { done, value } = lights.next();
    if (done) return value;
  }
}

/** Throws as decode does; `light` as well. */
export function begin(json: unknown, expected: Expected = {}): Level {
  return refusing(() => {
    const header = checkedHeader(json, expected);
    return read(header, takeScratch(Math.max(header.rays, header.n * header.n)));
  });
}

/** What a header lacks shows itself as any error. */
function refusing<T>(run: () => T): T {
  try {
    return run();
  } catch (error) {
    if (error instanceof TraceError) throw error;
    throw damaged(`the header lacks something: ${error}`);
  }
}

function read(header: Header, scratch: Scratch): Level {
  const { n, rays: count, tables, materials, patches, lights } = header;
  const columns = new Columns(header, scratch.off, scratch.size);
  const signature = new Int32Array(n * n);
  const tree = plant(header, columns, signature, scratch);
  const { sides, surface, patch } = tree;
  const { nearAlike: near, number, counting } = scratch;
  const all = counting.subarray(0, count);
  const ofSurface = (column: 1 | 2, out: Int32Array | Uint8Array) => looked(surface, tables.surface.map((each) => each[column]), out);
  const material = ofSurface(1, new Int32Array(count)) as Int32Array, inside = ofSurface(2, new Uint8Array(count)) as Uint8Array;
  const object = looked(patch, patches.map((each) => each.object), new Int32Array(count));
  const point = new Float64Array(3 * count), t = new Float64Array(count);
  const hits = readHits(header, columns, signature, sides, scratch, point, t);
  alike(all, tree.history, sides, near);
  readPoints(header, columns, tree, scratch, point);
  measure(tree, point, object, n * n, t);
  const normal = readNormals(header, columns, tree, scratch, point);
  columns.numbers("tests", all, patch, patches.length, near, NO_FEATURES, number[0]);
  const tests = new Int32Array(count);
  for (let row = 0; row < count; row++) tests[row] = number[0][row];
  const base = readBases(header, columns, tree, scratch);
  const tiles = readTiles(header, columns, tree, scratch);
  const weight = readWeights(header, columns, tree, material, scratch);
  const localWeight = looked(material, materials.map((each) => each.local), new Float64Array(count));
  const unlit = {
    scene: header.scene, n, lights: lights.length, count,
    kind: tree.kind, parent: tree.parent, pixel: tree.pixel, depth: tree.depth,
    object, material, inside, t, weight, localWeight, tests, point, normal, base, tiles, ...hits,
  };
  return {
    tiles,
    *light() {
      const lit = darkness(count * lights.length);
      const shine = refusing(() => prepareLights(header, columns, tree, unlit, scratch, lit));
      for (let l = 0; l < lights.length; l++) {
        refusing(() => shine(l));
        yield;
      }
      columns.finish();
      giveBack(scratch);
      return coloured(header, { ...unlit, ...lit });
    },
  };
}

/** Colours are added up when the first is asked for: the tiles have theirs. Does not hold on to the header's columns. */
function coloured<Terms extends Omit<Trace, "colour">>({ background, materials, lights }: Header, terms: Terms): Trace {
  let sums: Float64Array | undefined;
  return {
    ...terms,
    get colour() {
      return (sums ??= recombine({ background, materials, lights }, terms));
    },
  };
}

/** The tree; writes for each camera ray the row of the table of objects along it. */
function plant(header: Header, columns: Columns, signature: Int32Array, scratch: Scratch): Structure {
  const { n, tables } = header;
  const { sides, zeros, rows } = scratch;
  fillRaster(n, sides);
  columns.symbols("signature", 0, n * n, zeros, zeros, 1, sides, tables.signature.length, signature);
  const nearest = Int32Array.from(tables.signature, (objects) => objects[0] ?? ABSENT);
  const firstObject = rows;
  for (let k = 0; k < n * n; k++) firstObject[k] = nearest[signature[k]];
  return grow(header, columns, firstObject, scratch);
}

/** table[row[k]] for every k, 0 for negative rows. */
function looked<Out extends Int32Array | Uint8Array | Float64Array>(row: Int32Array, table: readonly number[], out: Out): Out {
  for (let k = 0; k < out.length; k++) out[k] = row[k] < 0 ? 0 : table[row[k]];
  return out;
}

/** Rows from `first` on whose value is marked. */
function marked(value: Int32Array, is: Uint8Array, first: number, end: number, rows: Int32Array): Int32Array {
  let k = 0;
  for (let row = first; row < end; row++) if (is[value[row]] === 1) rows[k++] = row;
  return rows.subarray(0, k);
}

/** Where rays end. Those of camera rays are known from the hits along them. */
function readPoints(header: Header, columns: Columns, tree: Structure, { nearAlike: near, number, counting, rows: scratch }: Scratch, point: Float64Array) {
  const { n, patches } = header;
  const sent = counting.subarray(n * n, tree.count);
  const free = marked(tree.patch, Uint8Array.from(patches, (patch) => (patch.points === "free" ? 1 : 0)), n * n, tree.count, scratch);
  for (const [k, rows] of [sent, sent, free].entries()) columns.numbers(`point${k}`, rows, tree.patch, patches.length, near, NO_FEATURES, number[k]);
  pointsOn(patches, tree.patch, n * n, tree.count, number, point);
}

/** Writes lengths of rays: of camera rays known, but Infinity if they leave. */
function measure(tree: Structure, point: Float64Array, object: Int32Array, cameras: number, t: Float64Array) {
  const { parent } = tree;
  for (let row = 0; row < tree.count; row++) {
    if (object[row] < 0) t[row] = Infinity;
    else if (row >= cameras) {
      const a = 3 * row, b = 3 * parent[row];
      const x = point[a] - point[b], y = point[a + 1] - point[b + 1], z = point[a + 2] - point[b + 2];
      t[row] = Math.sqrt(x * x + y * y + z * z);
    }
  }
}

function readNormals(header: Header, columns: Columns, tree: Structure, { nearAlike: near, number, kind, rows: scratch }: Scratch, point: Float64Array): Float64Array {
  const { patches, steps, tables } = header;
  const { count, patch, depth, surface } = tree;
  const rows = marked(patch, Uint8Array.from(patches, ({ normals }) => (normals === "stored" ? 1 : 0)), 0, count, scratch);
  for (let k = 0; k < rows.length; k++) kind[rows[k]] = 2 * patch[rows[k]] + (depth[rows[k]] > 0 ? 1 : 0);
  for (const k of [0, 1] as const) columns.numbers(`normal${k}`, rows, kind, 2 * patches.length, near, NO_FEATURES, number[k]);
  const normal = new Float64Array(3 * count);
  normalsOn(patches, patch, surface, tables.surface, steps.normal, number, point, normal);
  return normal;
}

/** Shares: constants of the parent's material, or split between reflected and refracted. */
function readWeights(header: Header, columns: Columns, tree: Structure, material: Int32Array, scratch: Scratch): Float64Array {
  const { materials, steps } = header;
  const { count, kind, parent, children, surface } = tree;
  const split = Float64Array.from(materials, (of) => of.split);
  const shares = Float64Array.from(materials.flatMap((of) => RAY_KINDS.map((kind) => (kind === "camera" ? 1 : of[kind])))); // by KIND
  const { reflected, refracted } = KIND, either = bitOf("reflected") | bitOf("refracted"), total = bitOf("total");
  const { rows, near, number: [number] } = scratch;
  const group = scratch.group.fill(ABSENT, 0, count);
  let k = 0;
  for (let row = 0; row < count; row++) {
    if (material[row] < 0 || !(split[material[row]] > 0) || (children[row] & either) === 0 || (children[row] & total) !== 0) continue;
    group[row] = tree.history[row];
    rows[k++] = row;
  }
  const parted = rows.subarray(0, k);
  alike(parted, group, tree.sides, near);
  columns.numbers("split", parted, surface, header.tables.surface.length, near, NO_FEATURES, number);
  const weight = new Float64Array(count);
  for (let row = 0; row < count; row++) {
    const of = parent[row];
    if (of < 0) weight[row] = 1;
    else if (group[of] === ABSENT || (kind[row] !== reflected && kind[row] !== refracted)) weight[row] = shares[RAY_KINDS.length * material[of] + kind[row]];
    else {
      const share = number[of] * steps.split;
      weight[row] = kind[row] === reflected ? share : split[material[of]] - share;
    }
  }
  return weight;
}

/** Base colours, each channel predicted from those before it too; of patches that have steps for them. */
function readBases({ patches }: Header, columns: Columns, { count, patch }: Structure, { nearAlike: near, rows: scratch, number: [number] }: Scratch): Float64Array {
  const base = new Float64Array(3 * count).fill(1);
  const steps = patches.map((each) => each.base ?? 0);
  const rows = marked(patch, Uint8Array.from(steps, Math.sign), 0, count, scratch);
  if (rows.length)
    for (const c of [0, 1, 2] as const) {
      columns.numbers(`base${c}`, rows, patch, patches.length, near, { width: c, first: base, second: base }, number);
      for (const row of rows) base[3 * row + c] = number[row] / steps[patch[row]];
    }
  return base;
}

/** 8-bit colours, each channel predicted from those before it too. */
function readTiles({ n, patches }: Header, columns: Columns, { patch }: Structure, { nearAlike: near, counting, number: [number] }: Scratch): Uint8Array {
  const cameras = counting.subarray(0, n * n);
  const tiles = new Uint8Array(3 * n * n), before = new Float64Array(3 * n * n);
  for (const c of [0, 1, 2] as const) {
    columns.numbers(`tile${c}`, cameras, patch, patches.length, near, { width: c, first: before, second: before }, number);
    for (let k = 0; k < cameras.length; k++) tiles[3 * k + c] = before[3 * k + c] = number[k];
  }
  return tiles;
}
