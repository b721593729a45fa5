/**
 * Columns of symbols and of numbers, each entry predicted from rays that came earlier.
 * Kind and group are ABSENT where a ray stores nothing; neighbours count within a group.
 * The arithmetic is number_column.py's, operation by operation.
 */
import { damaged } from "./errors";
import { ints } from "./fill";
import type { Header, Predictor } from "./header";
import { Reader } from "./symbols";

export const ABSENT = -1;
const UNIT = 256; // of taps
const FLAT = [UNIT, UNIT, -UNIT, 0, 0, 0];

/** Rows of the neighbours in the picture that came by the same bounces, -1 where there is none. */
export interface Sides {
  left: Int32Array;
  up: Int32Array;
  upLeft: Int32Array;
  upRight: Int32Array;
}

/** The rays beside each of the n x n camera rays. */
export function inRaster(n: number): Sides {
  const side = (right: number, down: number) =>
    ints(n * n, (k) => {
      const column = (k % n) + right;
      const row = Math.floor(k / n) + down;
      return column < 0 || column >= n || row < 0 ? -1 : row * n + column;
    });
  return { left: side(-1, 0), up: side(0, -1), upLeft: side(-1, -1), upRight: side(1, -1) };
}

export class Columns {
  private readonly readers = new Map<string, Reader>();

  // Scratch, used anew by each column: allocating them cost more than the arithmetic.
  private readonly base: Float64Array; // affine part
  private readonly off: Float64Array; // number - base

  constructor(private readonly header: Header) {
    this.base = new Float64Array(header.rays);
    this.off = new Float64Array(header.rays);
  }

  private reader(name: string): Reader {
    let reader = this.readers.get(name);
    if (!reader) {
      const text = this.header.columns[name];
      if (typeof text !== "string") throw damaged(`column ${name} is missing`);
      this.readers.set(name, (reader = new Reader(name, text)));
    }
    return reader;
  }

  /** Every column asked for must be read to its end. */
  finish() {
    for (const reader of this.readers.values()) reader.finish();
  }

  /** Symbols below `most`; 0 where nothing is stored. */
  symbols(name: string, group: Int32Array, kind: Int32Array, sides: Sides, most: number): Int32Array {
    const reader = this.reader(name);
    const symbol = new Int32Array(kind.length);
    const last: number[] = [];
    for (let row = 0; row < kind.length; row++) {
      if (kind[row] === ABSENT) continue;
      const code = reader.next();
      symbol[row] = code ? code - 1 : guess(symbol, group, sides, row, last[kind[row]] ?? 0);
      last[kind[row]] = symbol[row];
      if (symbol[row] >= most) throw damaged(`column ${name} names a row that is not there`);
    }
    return symbol;
  }

  /** Whole numbers; 0 where none is stored. */
  numbers(
    name: string, group: Int32Array, kind: Int32Array, sides: Sides, features: Float64Array[],
  ): Float64Array {
    const reader = this.reader(name);
    const { left, up, upLeft, upRight } = sides;
    const count = kind.length;
    if (reader.isEmpty) return checkedEmpty(name, kind);
    const { base, off } = this;
    base.fill(0);
    const tapsOf: (readonly number[])[] = [];
    for (const [of, predictor] of Object.entries(this.header.predictors[name] ?? {})) {
      addAffine(base, kind, Number(of), predictor, features);
      tapsOf[Number(of)] = predictor.taps ?? FLAT;
    }
    const number = new Float64Array(count);
    const last: number[] = [];
    for (let row = 0; row < count; row++) {
      const of = kind[row];
      if (of === ABSENT) continue;
      const taps = tapsOf[of] ?? FLAT;
      let value = base[row];
      if (taps.length) {
        const mine = group[row];
        let l = left[row], u = up[row], ul = upLeft[row], ur = upRight[row];
        let ll = l >= 0 ? left[l] : -1;
        let uu = u >= 0 ? up[u] : -1;
        if (l >= 0 && group[l] !== mine) l = -1;
        if (u >= 0 && group[u] !== mine) u = -1;
        if (ul >= 0 && group[ul] !== mine) ul = -1;
        if (ur >= 0 && group[ur] !== mine) ur = -1;
        if (ll >= 0 && group[ll] !== mine) ll = -1;
        if (uu >= 0 && group[uu] !== mine) uu = -1;
        let near: number;
        if (l >= 0 && u >= 0 && ul >= 0) {
          if (ur >= 0 && ll >= 0 && uu >= 0) {
            let whole = off[l] * taps[0] + off[u] * taps[1] + off[ul] * taps[2];
            whole = whole + off[ur] * taps[3] + off[ll] * taps[4];
            near = (whole + off[uu] * taps[5]) / UNIT;
          } else near = off[l] + off[u] - off[ul];
        } else if (l >= 0 && ll >= 0) near = 2 * off[l] - off[ll];
        else if (u >= 0 && uu >= 0) near = 2 * off[u] - off[uu];
        else {
          const one = l >= 0 ? l : u >= 0 ? u : ul >= 0 ? ul : ur >= 0 ? ur : (last[of] ?? -1);
          near = one >= 0 ? off[one] : 0;
        }
        value = value + near;
      }
      value = Math.floor(value + 0.5) + reader.signed();
      number[row] = value;
      off[row] = value - base[row];
      last[of] = row;
    }
    return number;
  }
}

function checkedEmpty(name: string, kind: Int32Array): Float64Array {
  for (let row = 0; row < kind.length; row++) if (kind[row] !== ABSENT) throw damaged(`column ${name} is empty`);
  return new Float64Array(kind.length);
}

/** Continues the edge that two neighbours show: if up-left equals left, take up; else left. */
function guess(symbol: Int32Array, group: Int32Array, sides: Sides, row: number, otherwise: number): number {
  const mine = group[row];
  const l = sides.left[row], u = sides.up[row], ul = sides.upLeft[row];
  const hasLeft = l >= 0 && group[l] === mine;
  const hasUp = u >= 0 && group[u] === mine;
  if (!hasLeft) return hasUp ? symbol[u] : otherwise;
  const isEdge = hasUp && ul >= 0 && group[ul] === mine && symbol[ul] === symbol[l];
  return isEdge ? symbol[u] : symbol[l];
}

/** Constant, then product by product: the order decides the last bit. */
function addAffine(
  base: Float64Array, kind: Int32Array, of: number, predictor: Predictor, features: Float64Array[],
) {
  const affine = predictor.affine;
  if (!affine) return;
  if (affine.length !== features.length + 1) throw damaged("a predictor has too few coefficients");
  for (let row = 0; row < kind.length; row++) {
    if (kind[row] !== of) continue;
    let value = affine[0];
    for (let k = 0; k < features.length; k++) value = value + affine[k + 1] * features[k][row];
    base[row] = value;
  }
}
