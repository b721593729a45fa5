/** Who is whose child; structure.py grows the same tree. */
import type { Columns } from "./columns";
import { damaged } from "./errors";
import type { Header } from "./header";
import { fillRaster } from "./neighbours";
import type { Scratch } from "./scratch";
import type { Trace } from "./types";
import { BRANCHES, BRANCH_OF, CHILDREN, KIND, SENT } from "./kinds";

/** surface: row of tables.surface; history: equal where two rays met the same patches in the same manner. */
export type Structure = Pick<Trace, "count" | "pixel" | "parent" | "kind" | "depth"> & Pick<Scratch, "surface" | "patch" | "children" | "history" | "sides">;

/** Rays while the tree grows. before: equal where two rays have the same history so far; born: by branch, the child's
 *  row, -1 if there is none. */
type Growing = Structure & Pick<Scratch, "before" | "group" | "born">;

/** firstObject: what each camera ray meets, -1 if nothing. What is no column of a Trace stands in the
 *  scratch arrays, which are longer. */
export function grow(header: Header, columns: Columns, firstObject: Int32Array, scratch: Scratch): Structure {
  const { n, rays } = header;
  const surfaces = header.tables.surface;
  const patchOf = Int32Array.from(surfaces, (surface) => surface[0]);
  const tree = seedling(n, rays, firstObject, scratch);
  const base = surfaces.length + 1;
  let paths = [0, n * n]; // where each path (RR, RT ...) of one depth starts, and the end
  let histories = 0, befores = header.patches.reduce((most, { object }) => Math.max(most, object), 0) + 2;
  for (let depth = 0; paths.length > 1; depth++) {
    const first = paths[0], end = paths.at(-1)!;
    columns.symbols("surface", first, end, tree.before, tree.before, befores, tree.sides, surfaces.length, tree.surface);
    const next = markHistories(tree, first, end, patchOf, histories);
    columns.symbols("children", first, end, tree.group, tree.surface, base, tree.sides, CHILDREN, tree.children);
    paths = branch(tree, paths, Math.min(depth + 1, 255), rays, histories);
    befores = BRANCHES * (next - histories);
    histories = next;
    if (paths.length === 1 && end !== rays) throw damaged(`the tree has fewer than its ${rays} rays`);
  }
  return tree;
}

function seedling(n: number, rays: number, firstObject: Int32Array, scratch: Scratch): Growing {
  if (!(rays >= n * n)) throw damaged(`the tree has more than its ${rays} rays`);
  const { surface, patch, children, history, sides, before, group, born } = scratch;
  const tree: Growing = {
    count: rays,
    pixel: new Int32Array(rays), parent: new Int32Array(rays), kind: new Uint8Array(rays), depth: new Uint8Array(rays),
    surface, patch, children, history, sides, before, group, born,
  };
  fillRaster(n, tree.sides);
  for (let k = 0; k < n * n; k++) {
    tree.pixel[k] = k;
    tree.parent[k] = -1;
    tree.kind[k] = KIND.camera;
    tree.before[k] = firstObject[k] + 1;
  }
  return tree;
}

/** Numbers the histories of these rays from `histories` on, and returns the number after the last. */
function markHistories(tree: Growing, first: number, end: number, patchOf: Int32Array, histories: number): number {
  const { before, surface, patch, history, group } = tree;
  const base = patchOf.length + 1;
  const known = new Map<number, number>();
  let key = -1, number = 0; // neighbours mostly have the same history
  for (let row = first; row < end; row++) {
    const met = patchOf[surface[row]], mine = before[row] * base + met;
    if (mine !== key) {
      key = mine;
      const found = known.get(mine);
      number = found ?? histories + known.size;
      if (found === undefined) known.set(mine, number);
    }
    patch[row] = met;
    history[row] = number;
    group[row] = number * base + surface[row];
  }
  return histories + known.size;
}

/** Adds the children of the rays on these paths: path by path, branch by branch, in their
 *  parents' order. Returns the children's paths. */
function branch(tree: Growing, paths: number[], depth: number, rays: number, histories: number): number[] {
  const { children, pixel, parent, kind, history, before } = tree;
  const end = paths.at(-1)!;
  const starts = [end];
  let k = end;
  for (let path = 0; path + 1 < paths.length; path++) {
    for (let branch = 0; branch < BRANCHES; branch++) {
      const sent = SENT[branch], child = tree.born[branch];
      for (let row = paths[path]; row < paths[path + 1]; row++) {
        if (sent[children[row]] === 0) {
          child[row] = -1;
          continue;
        }
        if (k === rays) throw damaged(`the tree has more than its ${rays} rays`);
        child[row] = k;
        parent[k] = row;
        pixel[k] = pixel[row];
        kind[k] = sent[children[row]];
        before[k] = BRANCHES * (history[row] - histories) + branch;
        k++;
      }
      if (k > starts.at(-1)!) starts.push(k);
    }
  }
  tree.depth.fill(depth, end, k);
  besideParents(tree, end, k);
  return starts;
}

/** A child's neighbours are the like children of its parent's neighbours. */
function besideParents(tree: Growing, first: number, end: number) {
  const { parent, kind, born } = tree;
  const { left, up, upLeft, upRight } = tree.sides;
  for (let row = first; row < end; row++) {
    const child = born[BRANCH_OF[kind[row]]];
    const of = parent[row];
    const l = left[of], u = up[of], ul = upLeft[of], ur = upRight[of];
    left[row] = l < 0 ? -1 : child[l];
    up[row] = u < 0 ? -1 : child[u];
    upLeft[row] = ul < 0 ? -1 : child[ul];
    upRight[row] = ur < 0 ? -1 : child[ur];
  }
}
