/** Tiles of a scene's frustum where a picture is far off, for a walk through their rays. */
import type { Picture } from "./formats/picture";
import { NOISE } from "./layer";
import { EDGE, liesIn, placeAt, worstAt, type Told } from "./places";

const MOST = 6;
/** Two tiles are at least this share of the picture apart. */
const APART = 1 / 9;
/** Of the grid of places to each side: a tile that has the same all round, and hardly changes, is beside no edge. */
const AROUND = 2;
/** Steps of 255 between neighbours in the right picture from which on a place counts as an edge: the rim of a highlight, too. */
const SMOOTH = 24;

export interface Tile {
  n: number; // of the grid
  x: number;
  y: number;
  object: number; // what its ray meets first, -1: nothing
  own: [number, number, number]; // bytes of the student's picture
  right: [number, number, number]; // of the ray through the tile's middle
}

export interface Grid {
  n: number;
  /** A pixel's middle is that of each tile; else of the pixels the nearest is taken. */
  isShared: boolean;
}

/** Whether tiles of the coarser one have a pixel of the finer one in their middle: an odd number of them to each. */
const isPart = (coarse: number, fine: number) => fine % (2 * coarse) === coarse;

/** The finest grid of the scene whose tiles a picture of n x n has pixels for. Where no pixel's middle is a tile's, one whose tiles'
 *  right colours are among those of the finest, which come along (check/in_little.py). */
export function gridFor(n: number, grids: number[]): Grid {
  const shared = grids.filter((grid) => isPart(grid, n));
  if (shared.length) return { n: Math.max(...shared), isShared: true };
  const told = grids.filter((grid) => isPart(grid, Math.max(...grids)));
  const fitting = told.filter((grid) => grid <= n);
  return { n: fitting.length ? Math.max(...fitting) : Math.min(...told), isShared: false };
}

interface Candidate {
  tile: Tile;
  bits: number;
  amount: number;
  isInside: boolean; // beside no edge
}

/**
 * The worst first, of each place the worst: other objects, light, mirrors before more of the same. Where there are any, those in the
 * place that is told of the wrong pixels, and beside no edge: there a pixel may be wrong for the least of reasons.
 * exact: the right colours of tiles, a picture that has a pixel in the middle of each.
 */
export function worstTiles(student: Picture, right: Picture, exact: Picture, places: Picture, grid: number, [told]: Told[]): Tile[] {
  const found = candidates(student, right, exact, places, grid).sort((a, b) => b.amount - a.amount);
  const there = told ? found.filter(({ tile: { object }, bits }) => liesIn(told, object, bits)) : found;
  const inside = (of: Candidate[]) => of.filter(({ isInside }) => isInside);
  const chosen = [inside(there), told?.kind === "edge" ? there : inside(found), found].find(({ length }) => length) ?? [];
  return spread(chosen, grid).map(({ tile }) => tile);
}

function candidates(student: Picture, right: Picture, exact: Picture, places: Picture, grid: number): Candidate[] {
  const found: Candidate[] = [];
  for (let y = 0; y < grid; y++) {
    for (let x = 0; x < grid; x++) {
      const [i, j] = [middleOf(student, grid, x, y), middleOf(exact, grid, x, y)];
      const amount = worstAt(student, right, i);
      if (amount <= NOISE) continue;
      const { object, bits } = placeAt(places, grid, x, y);
      const tile = { n: grid, x, y, object, own: colourAt(student, i), right: colourAt(exact, j) };
      // What the student's pixel must be is what the tile is, or the two colours shown would not belong together.
      const isSame = worst(tile.right, colourAt(right, i)) <= NOISE;
      found.push({ tile, bits, amount, isInside: isSame && isEven(places, grid, x, y) && isSmooth(right, i) });
    }
  }
  return found;
}

/** Where the pixel in the middle of a tile stands in a picture's values, or the one beside it. */
function middleOf({ width }: Picture, grid: number, x: number, y: number): number {
  const along = (tile: number) => Math.floor(((tile + 0.5) * width) / grid);
  return 3 * (along(y) * width + along(x));
}

const colourAt = ({ values }: Picture, i: number) => [0, 1, 2].map((c) => Math.round(values[i + c])) as Tile["own"];
const worst = (a: number[], b: number[]) => Math.max(...a.map((value, c) => Math.abs(value - b[c])));

/** The same object in the same light all round. */
function isEven(places: Picture, grid: number, x: number, y: number): boolean {
  const { width, values } = places;
  const middle = middleOf(places, grid, x, y) / 3;
  const [u, v] = [middle % width, Math.floor(middle / width)];
  const [left, end] = [Math.max(u - AROUND, 0), Math.min(u + AROUND, width - 1)];
  for (let row = Math.max(v - AROUND, 0); row <= Math.min(v + AROUND, width - 1); row++) {
    for (let column = left; column <= end; column++) {
      const at = 3 * (row * width + column);
      if (values[at] !== values[3 * middle] || values[at + 1] !== values[3 * middle + 1]) return false;
    }
  }
  return (values[3 * middle + 1] & EDGE) === 0;
}

/** i: where a pixel of the right picture stands in its values. */
function isSmooth({ width, values }: Picture, i: number): boolean {
  const [x, y] = [(i / 3) % width, Math.floor(i / 3 / width)];
  for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, width - 1); v++) {
    for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, width - 1); u++) {
      const j = 3 * (v * width + u);
      for (let c = 0; c < 3; c++) if (Math.abs(values[j + c] - values[i + c]) > SMOOTH) return false;
    }
  }
  return true;
}

function spread(found: Candidate[], grid: number): Candidate[] {
  const chosen: Candidate[] = [];
  for (const isNew of [true, false]) {
    for (const each of found) {
      if (chosen.length === MOST) return chosen;
      const isSame = chosen.some(({ tile, bits }) => tile.object === each.tile.object && bits === each.bits);
      const isFar = chosen.every(({ tile }) => Math.hypot(tile.x - each.tile.x, tile.y - each.tile.y) >= APART * grid);
      if (isFar && isSame !== isNew) chosen.push(each);
    }
  }
  return chosen;
}
