/**
 * Columns of symbols and of numbers, each entry predicted from rays that came earlier.
 * Kind and group are ABSENT where a ray stores nothing; neighbours count within a group.
 * The arithmetic is number_column.py's, operation by operation.
 */
import { damaged } from "./errors";
import { ints } from "./fill";
import { columnBytes, type Header } from "./header";
import { Reader } from "./symbols";

export const ABSENT = -1;
const UNIT = 256; // of taps
const TAPS = 6;

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

/** The rays that store something in a column, in order, and for each the rows of its neighbours
 *  of the same group, -1 where there is none. Worked out once for all columns of the same rays. */
export interface Stored {
  rows: Int32Array;
  kind: Int32Array; // of each of these rows
  left: Int32Array;
  up: Int32Array;
  upLeft: Int32Array;
  upRight: Int32Array;
  farLeft: Int32Array;
  farUp: Int32Array;
}

/** kind and group count all rays and are ABSENT where a ray stores nothing. */
export function storedRays(group: Int32Array, kind: Int32Array, sides: Sides): Stored {
  const { left, up, upLeft, upRight } = sides;
  let count = 0;
  for (let row = 0; row < kind.length; row++) if (kind[row] !== ABSENT) count++;
  const column = () => new Int32Array(count);
  const stored: Stored = {
    rows: column(), kind: column(),
    left: column(), up: column(), upLeft: column(), upRight: column(), farLeft: column(), farUp: column(),
  };
  for (let row = 0, k = 0; row < kind.length; row++) {
    if (kind[row] === ABSENT) continue;
    const mine = group[row];
    const l = left[row], u = up[row], ul = upLeft[row], ur = upRight[row];
    const ll = l >= 0 ? left[l] : -1;
    const uu = u >= 0 ? up[u] : -1;
    stored.rows[k] = row;
    stored.kind[k] = kind[row];
    stored.left[k] = l >= 0 && group[l] === mine ? l : -1;
    stored.up[k] = u >= 0 && group[u] === mine ? u : -1;
    stored.upLeft[k] = ul >= 0 && group[ul] === mine ? ul : -1;
    stored.upRight[k] = ur >= 0 && group[ur] === mine ? ur : -1;
    stored.farLeft[k] = ll >= 0 && group[ll] === mine ? ll : -1;
    stored.farUp[k] = uu >= 0 && group[uu] === mine ? uu : -1;
    k++;
  }
  return stored;
}

/** What an affine part is a function of: `width` values for each ray. */
export interface Features {
  width: number;
  values: Float64Array;
}
export const NO_FEATURES: Features = { width: 0, values: new Float64Array(0) };

/** What a column predicts with, by kind: has[kind] tells which of the two stand in the others. */
interface Prediction {
  affine: Float64Array; // (kinds, features + 1)
  taps: Float64Array; // (kinds, 6)
  has: Uint8Array; // bit 1: affine; 2: taps of its own; 4: no taps at all
}

const AFFINE = 1, OWN_TAPS = 2, NO_TAPS = 4;

export class Columns {
  private readonly readers = new Map<string, Reader>();

  // Scratch, used anew by each column: allocating them cost more than the arithmetic.
  private readonly read: Float64Array; // what stands in the file
  private readonly off: Float64Array; // number - affine part

  constructor(private readonly header: Header) {
    this.read = new Float64Array(header.rays);
    this.off = new Float64Array(header.rays);
    for (const [name, bytes] of columnBytes(header)) this.readers.set(name, new Reader(name, bytes));
  }

  private reader(name: string): Reader {
    const reader = this.readers.get(name);
    if (!reader) throw damaged(`column ${name} is missing`);
    this.asked.add(reader);
    return reader;
  }
  private readonly asked = new Set<Reader>();

  /** Every column asked for must be read to its end. */
  finish() {
    for (const reader of this.asked) reader.finish();
  }

  /** Symbols below `most`, of `count` rays; 0 where nothing is stored. */
  symbols(name: string, stored: Stored, count: number, most: number): Int32Array {
    const { rows, kind, left, up, upLeft } = stored;
    const { read } = this;
    this.reader(name).take(rows.length, read);
    const symbol = new Int32Array(count);
    const last = new Int32Array(highest(kind) + 1);
    for (let k = 0; k < rows.length; k++) {
      const row = rows[k], code = read[k];
      let value = code - 1;
      if (code === 0) {
        // Continues the edge that two neighbours show: if up-left equals left, take up; else left.
        const l = left[k], u = up[k], ul = upLeft[k];
        if (l < 0) value = u < 0 ? last[kind[k]] : symbol[u];
        else value = u >= 0 && ul >= 0 && symbol[ul] === symbol[l] ? symbol[u] : symbol[l];
      }
      if (value >= most) throw damaged(`column ${name} names a row that is not there`);
      symbol[row] = last[kind[k]] = value;
    }
    return symbol;
  }

  /** Writes whole numbers at the rows that store one; what else stands in `out` stays. */
  numbers(name: string, stored: Stored, features: Features, out: Float64Array): Float64Array {
    const reader = this.reader(name);
    const { rows, kind, left, up, upLeft, upRight, farLeft, farUp } = stored;
    if (reader.isEmpty && rows.length > 0) throw damaged(`column ${name} is empty`);
    const { read, off } = this;
    reader.takeSigned(rows.length, read);
    const most = highest(kind) + 1;
    const { affine, taps, has } = this.prediction(name, most, features.width);
    const last = new Int32Array(most).fill(-1);
    const { width, values } = features;
    for (let k = 0; k < rows.length; k++) {
      const row = rows[k], of = kind[k], flags = has[of];
      let base = 0;
      if (flags & AFFINE) {
        const a = of * (width + 1), v = row * width; // constant, then product by product: the order decides the last bit
        base = affine[a];
        if (width === 6) {
          base = base + affine[a + 1] * values[v] + affine[a + 2] * values[v + 1] + affine[a + 3] * values[v + 2];
          base = base + affine[a + 4] * values[v + 3] + affine[a + 5] * values[v + 4] + affine[a + 6] * values[v + 5];
        } else for (let f = 0; f < width; f++) base = base + affine[a + 1 + f] * values[v + f];
      }
      let value = base;
      if (!(flags & NO_TAPS)) {
        const l = left[k], u = up[k], ul = upLeft[k];
        let near = 0;
        if (l >= 0 && u >= 0 && ul >= 0) {
          const ur = upRight[k], ll = farLeft[k], uu = farUp[k];
          if (flags & OWN_TAPS && ur >= 0 && ll >= 0 && uu >= 0) {
            const t = of * TAPS;
            let whole = off[l] * taps[t] + off[u] * taps[t + 1] + off[ul] * taps[t + 2];
            whole = whole + off[ur] * taps[t + 3] + off[ll] * taps[t + 4];
            near = (whole + off[uu] * taps[t + 5]) / UNIT;
          } else near = off[l] + off[u] - off[ul];
        } else if (l >= 0 && farLeft[k] >= 0) near = 2 * off[l] - off[farLeft[k]];
        else if (u >= 0 && farUp[k] >= 0) near = 2 * off[u] - off[farUp[k]];
        else {
          const ur = upRight[k];
          const one = l >= 0 ? l : u >= 0 ? u : ul >= 0 ? ul : ur >= 0 ? ur : last[of];
          if (one >= 0) near = off[one];
        }
        value = base + near;
      }
      value = Math.floor(value + 0.5) + read[k];
      out[row] = value;
      off[row] = value - base;
      last[of] = row;
    }
    return out;
  }

  private prediction(name: string, kinds: number, features: number): Prediction {
    const affine = new Float64Array(kinds * (features + 1));
    const taps = new Float64Array(kinds * TAPS);
    const has = new Uint8Array(kinds);
    for (const [text, predictor] of Object.entries(this.header.predictors[name] ?? {})) {
      const of = Number(text);
      if (!(of < kinds)) continue; // no ray here is of that kind
      if (predictor.affine) {
        if (predictor.affine.length !== features + 1) throw damaged("a predictor has too few coefficients");
        affine.set(predictor.affine, of * (features + 1));
        has[of] |= AFFINE;
      }
      if (predictor.taps) has[of] |= predictor.taps.length ? OWN_TAPS : NO_TAPS;
      if (predictor.taps?.length) taps.set(predictor.taps, of * TAPS);
    }
    return { affine, taps, has };
  }
}

function highest(kind: Int32Array): number {
  let most = -1;
  for (let k = 0; k < kind.length; k++) if (kind[k] > most) most = kind[k];
  return most;
}
