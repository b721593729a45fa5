/** Who is whose child; structure.py grows the same tree. */
import { storedRays, type Columns, type Sides } from "./columns";
import { damaged } from "./errors";
import { ints } from "./fill";
import type { Header } from "./header";
import { KIND } from "./types";

const REFLECTED = 1, REFRACTED = 2, TOTAL = 4; // bits of what a hit sends on
const CHILDREN = 8; // symbols they make

export interface Structure {
  count: number;
  pixel: Int32Array;
  parent: Int32Array;
  kind: Uint8Array;
  level: Int32Array; // bounces before the ray
  surface: Int32Array; // row of tables.surface
  patch: Int32Array;
  children: Int32Array;
  way: Int32Array; // equal where two rays met the same patches in the same manner
  sides: Sides;
}

/** The rays of one depth; parents and sides count within the depth before and this one. */
interface Wave {
  pixel: Int32Array;
  parent: Int32Array;
  kind: Uint8Array;
  before: Int32Array; // equal where two rays came by the same way
  sides: Sides;
  paths: number[]; // where each path (RR, RT ...) starts, and the end
}

/** firstObject: what each camera ray meets, -1 if nothing; sides: of the camera rays. */
export function grow(header: Header, columns: Columns, firstObject: Int32Array, sides: Sides): Structure {
  const { n, rays } = header;
  const surfaces = header.tables.surface;
  const tree = empty(rays);
  const base = surfaces.length + 1;
  let wave = cameras(n, firstObject, sides);
  let first = 0, firstBefore = 0, ways = 0;
  for (let level = 0; wave.pixel.length > 0; level++) {
    const size = wave.pixel.length;
    if (first + size > rays) throw damaged(`the tree has more than its ${rays} rays`);
    const surface = columns.symbols("surface", storedRays(wave.before, wave.before, wave.sides), size, surfaces.length);
    const patch = ints(size, (k) => surfaces[surface[k]][0]);
    const way = dense(wave.before, patch, base);
    const group = ints(size, (k) => way[k] * base + surface[k]);
    const children = columns.symbols("children", storedRays(group, surface, wave.sides), size, CHILDREN);
    place(tree, wave, level, first, firstBefore);
    tree.surface.set(surface, first);
    tree.patch.set(patch, first);
    tree.children.set(children, first);
    tree.way.set(ints(size, (k) => way[k] + ways), first);
    wave = nextWave(wave, children, way);
    firstBefore = first;
    first += size;
    ways += size;
  }
  if (first !== rays) throw damaged(`the tree has fewer than its ${rays} rays`);
  return tree;
}

function empty(count: number): Structure {
  const column = () => new Int32Array(count);
  return {
    count,
    pixel: column(), parent: column(), kind: new Uint8Array(count), level: column(),
    surface: column(), patch: column(), children: column(), way: column(),
    sides: { left: column(), up: column(), upLeft: column(), upRight: column() },
  };
}

function cameras(n: number, firstObject: Int32Array, sides: Sides): Wave {
  return {
    pixel: ints(n * n, (k) => k),
    parent: new Int32Array(n * n).fill(-1),
    kind: new Uint8Array(n * n).fill(KIND.camera),
    before: ints(n * n, (k) => firstObject[k] + 1),
    sides,
    paths: [0, n * n],
  };
}

/** Writes a wave's own columns from row `first` on. */
function place(tree: Structure, wave: Wave, level: number, first: number, firstBefore: number) {
  tree.pixel.set(wave.pixel, first);
  tree.kind.set(wave.kind, first);
  tree.level.fill(level, first, first + wave.pixel.length);
  shift(wave.parent, firstBefore, tree.parent, first);
  for (const side of SIDES) shift(wave.sides[side], first, tree.sides[side], first);
}

const SIDES = ["left", "up", "upLeft", "upRight"] as const;

/** Rows counted from `by` on, written at out[at ...]; -1 stays. */
function shift(rows: Int32Array, by: number, out: Int32Array, at: number) {
  for (let k = 0; k < rows.length; k++) out[at + k] = rows[k] < 0 ? -1 : rows[k] + by;
}

/** Small numbers, equal where before and patch are. */
function dense(before: Int32Array, patch: Int32Array, base: number): Int32Array {
  const known = new Map<number, number>();
  return ints(before.length, (k) => {
    const key = before[k] * base + patch[k];
    let number = known.get(key);
    if (number === undefined) known.set(key, (number = known.size));
    return number;
  });
}

/** The children of a wave: path by path, reflected before refracted, in their parents' order. */
function nextWave(wave: Wave, children: Int32Array, way: Int32Array): Wave {
  let count = 0;
  for (let row = 0; row < children.length; row++) count += (children[row] & (REFLECTED | TOTAL) ? 1 : 0) + (children[row] & REFRACTED ? 1 : 0);
  const next: Wave = {
    pixel: new Int32Array(count), parent: new Int32Array(count), kind: new Uint8Array(count), before: new Int32Array(count),
    sides: { left: new Int32Array(count), up: new Int32Array(count), upLeft: new Int32Array(count), upRight: new Int32Array(count) },
    paths: [0],
  };
  const child = [new Int32Array(children.length).fill(-1), new Int32Array(children.length).fill(-1)];
  const down = new Uint8Array(count); // 1: refracted
  let k = 0;
  for (let path = 0; path + 1 < wave.paths.length; path++) {
    for (const bits of [REFLECTED | TOTAL, REFRACTED]) {
      const branch = bits === REFRACTED ? 1 : 0;
      for (let row = wave.paths[path]; row < wave.paths[path + 1]; row++) {
        if (!(children[row] & bits)) continue;
        child[branch][row] = k;
        down[k] = branch;
        next.parent[k] = row;
        next.pixel[k] = wave.pixel[row];
        next.kind[k] = branch ? KIND.refracted : children[row] & TOTAL ? KIND.total : KIND.reflected;
        next.before[k] = 2 * way[row] + branch;
        k++;
      }
      if (k > next.paths[next.paths.length - 1]) next.paths.push(k);
    }
  }
  for (const name of SIDES) {
    const [of, out] = [wave.sides[name], next.sides[name]];
    for (let row = 0; row < count; row++) {
      const beside = of[next.parent[row]];
      out[row] = beside < 0 ? -1 : child[down[row]][beside];
    }
  }
  return next;
}
