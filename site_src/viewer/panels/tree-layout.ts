/** Where the nodes of a drawn ray tree stand: a node a ray, rays of little weight in large trees folded into one. */
import type { RayRow } from "../state/ray-rows";

export const NODE = { width: 114, height: 46 };
const SLOT = 126; // pixels across, for a leaf
const LEVEL = 98; // pixels down
const MANY = 20; // rays: in a larger tree
const SMALL = 0.01; // those with a smaller share of the pixel are folded

export interface Placed {
  row: RayRow | null; // null: folded rays
  folded: readonly RayRow[];
  x: number; // leaf slots
  depth: number;
  below: Placed[];
}

export const left = (node: Placed) => node.x * SLOT + (SLOT - NODE.width) / 2;
export const top = (node: Placed) => node.depth * LEVEL + 8;

/** The nodes, the root first, each before what is below it; size in pixels. Leaves stand side by side, each parent over
 *  the middle of what it led to. */
export function layOut(rows: readonly RayRow[], isOpen: boolean) {
  let [across, down] = [0, 0];
  const childrenOf = (row: RayRow) => rows.filter(({ of }) => of === row.number);
  const under = (row: RayRow): RayRow[] => [row, ...childrenOf(row).flatMap(under)];
  function leaf(row: RayRow | null, folded: readonly RayRow[], depth: number): Placed {
    down = Math.max(down, depth + 1);
    return { row, folded, x: across++, depth, below: [] };
  }
  function put(row: RayRow, depth: number): Placed {
    const all = childrenOf(row);
    const small = isOpen || rows.length <= MANY ? [] : all.filter(({ share }) => share < SMALL);
    const below = all.filter((each) => !small.includes(each)).map((each) => put(each, depth + 1));
    if (small.length) below.push(leaf(null, small.flatMap(under), depth + 1));
    if (!below.length) return leaf(row, [], depth);
    return { row, folded: [], x: (below[0].x + below[below.length - 1].x) / 2, depth, below };
  }
  const nodesOf = (node: Placed): Placed[] => [node, ...node.below.flatMap(nodesOf)];
  const nodes = nodesOf(put(rows[0], 0));
  return { nodes, width: across * SLOT, height: (down - 1) * LEVEL + NODE.height + 30 };
}
