/** Tiles of a scene's frustum where a picture is far off, for a walk through their rays. */
import type { Picture } from "./formats/picture";
import { NOISE } from "./layer";
import { placeAt, worstAt } from "./places";

const MOST = 6;
/** Two tiles are at least this share of the picture apart. */
const APART = 1 / 9;

export interface Tile {
  n: number; // of the grid
  x: number;
  y: number;
  object: number; // what its ray meets first, -1: nothing
  own: [number, number, number]; // bytes of the student's picture
  right: [number, number, number];
}

/** The finest grid that the picture has a pixel for each tile of; the coarsest for a smaller picture. */
export function gridFor(n: number, grids: number[]): number {
  const fitting = grids.filter((grid) => grid <= n);
  return fitting.length ? Math.max(...fitting) : Math.min(...grids);
}

/** The worst first, of each place the worst: other objects, light, mirrors before more of the same. */
export function worstTiles(student: Picture, right: Picture, places: Picture, grid: number): Tile[] {
  const n = right.width;
  const at = (tile: number) => Math.floor(((tile + 0.5) * n) / grid);
  const found = [];
  for (let y = 0; y < grid; y++) {
    for (let x = 0; x < grid; x++) {
      const i = 3 * (at(y) * n + at(x));
      const worst = worstAt(student, right, i);
      if (worst <= NOISE) continue;
      const { object, bits } = placeAt(places, grid, x, y);
      found.push({ x, y, i, object, bits, amount: worst / (1 + amongEdges(bits)) });
    }
  }
  found.sort((a, b) => b.amount - a.amount);
  const colour = (picture: Picture, i: number) => [0, 1, 2].map((c) => Math.round(picture.values[i + c])) as Tile["own"];
  return spread(found, grid).map(({ x, y, i, object }) => ({ n: grid, x, y, object, own: colour(student, i), right: colour(right, i) }));
}

/** Beside an edge a pixel may be wrong for the least of reasons. */
const amongEdges = (bits: number) => (bits >> 4) & 1;

function spread<T extends { x: number; y: number; object: number; bits: number }>(found: T[], grid: number): T[] {
  const chosen: T[] = [];
  for (const isNew of [true, false]) {
    for (const each of found) {
      if (chosen.length === MOST) return chosen;
      const isSame = chosen.some(({ object, bits }) => object === each.object && bits === each.bits);
      const isFar = chosen.every(({ x, y }) => Math.hypot(x - each.x, y - each.y) >= APART * grid);
      if (isFar && isSame !== isNew) chosen.push(each);
    }
  }
  return chosen;
}
