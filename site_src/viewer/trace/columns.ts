/**
 * Columns of symbols and of numbers, each entry predicted from rays that came earlier.
 * The arithmetic is residuals.py's, operation by operation. One loop reads all columns of
 * numbers and one all symbols, always with arrays of the same types: a page decodes with them
 * after the first few columns at full speed.
 */
import { damaged } from "./errors";
import { columnBytes, type Header } from "./header";
import { ABSENT, type Sides } from "./neighbours";
import { BASE, DIGITS, FOREIGN, FOUR, LONG, LONG_DIGITS, TWO, longNumber } from "./symbols";

const UNIT = 256; // of taps
const TAPS = 6;

/** What an affine part is a function of: the first `width` of six values of each ray, three in each array. */
export interface Features {
  width: 0 | 1 | 2 | 3 | 6;
  first: Float64Array; // (3 * rays)
  second: Float64Array;
}
const NOTHING = new Float64Array(0);
export const NO_FEATURES: Features = { width: 0, first: NOTHING, second: NOTHING };

/** What a column predicts with, by kind: has[kind] says which of the two stand in the others. */
interface Prediction {
  affine: Float64Array; // (kinds, features + 1)
  taps: Float64Array; // (kinds, 6)
  has: Uint8Array;
}

const AFFINE = 1, OWN_TAPS = 2, NO_TAPS = 4;

/** Where in the bytes a column stands, and how far it is read. */
interface Span {
  at: number;
  end: number;
  isAsked: boolean;
}

export class Columns {
  private readonly bytes: Uint8Array;
  private readonly spans = new Map<string, Span>();

  /** off: scratch, by row, for number - affine part. */
  constructor(private readonly header: Header, private readonly off: Float64Array) {
    const { bytes, ends } = columnBytes(header);
    this.bytes = bytes;
    let at = 0;
    for (const [name, end] of ends) {
      this.spans.set(name, { at, end, isAsked: false });
      at = end;
    }
  }

  private span(name: string): Span {
    const span = this.spans.get(name);
    if (!span) throw damaged(`column ${name} is missing`);
    span.isAsked = true;
    return span;
  }

  /** Every column asked for must be read to its end. */
  finish() {
    for (const [name, { at, end, isAsked }] of this.spans) if (isAsked && at !== end) throw damaged(`column ${name} is too long`);
  }

  private readTo(name: string, span: Span, at: number) {
    if (at > span.end) throw damaged(`column ${name} ends too early`);
    span.at = at;
  }

  /** Writes symbols below `most` of the rays from row `first` on to `end` whose kind is not ABSENT.
   *  Neighbours count within a group; kinds are below `kinds`. */
  symbols(
    name: string, first: number, end: number, group: Int32Array, kind: Int32Array, kinds: number, sides: Sides, most: number, out: Int32Array,
  ) {
    const { left, up, upLeft } = sides;
    const { bytes } = this;
    const span = this.span(name);
    const last = new Int32Array(kinds);
    let at = span.at;
    for (let row = first; row < end; row++) {
      const of = kind[row];
      if (of === ABSENT) continue;
      let value = DIGITS[bytes[at++]];
      if (value === 0) {
        // Continues the edge that two neighbours show: if up-left equals left, take up; else left.
        const mine = group[row];
        let l = left[row], u = up[row];
        if (l >= 0 && group[l] !== mine) l = -1;
        if (u >= 0 && group[u] !== mine) u = -1;
        if (l < 0) value = u < 0 ? last[of] : out[u];
        else {
          value = out[l];
          if (u >= 0) {
            const ul = upLeft[row];
            if (ul >= 0 && group[ul] === mine && out[ul] === value) value = out[u];
          }
        }
      } else {
        if (value >= TWO) {
          if (value < FOUR) value = TWO + (value - TWO) * BASE + DIGITS[bytes[at++]];
          else if (value < LONG) {
            value = (DIGITS[bytes[at]] * BASE + DIGITS[bytes[at + 1]]) * BASE + DIGITS[bytes[at + 2]];
            at += 3;
          }
        }
        value--; // what is foreign is too large
        if (!(value < most)) throw damaged(`column ${name} names a row that is not there`);
      }
      out[row] = last[of] = value;
    }
    this.readTo(name, span, at);
  }

  /** Writes whole numbers at `rows`; what else stands in `out` stays. kind: by row, below `kinds`;
   *  near: by row, within the column's groups (see alike). */
  numbers(name: string, rows: Int32Array, kind: Int32Array, kinds: number, near: Sides, features: Features, out: Float64Array) {
    const span = this.span(name);
    const { bytes, off } = this;
    const { left, up, upLeft, upRight } = near;
    const { affine, taps, has } = this.prediction(name, kinds, features.width);
    const { width, first, second } = features;
    const last = new Int32Array(kinds).fill(-1);
    let at = span.at, all = 0; // all: bits of the digits, to notice foreign ones
    if (at === span.end && rows.length > 0) throw damaged(`column ${name} is empty`);
    for (let k = 0; k < rows.length; k++) {
      const row = rows[k], of = kind[row], flags = has[of];

      let code = DIGITS[bytes[at++]], residual = 0;
      if (code < LONG) {
        if (code >= FOUR) {
          const high = DIGITS[bytes[at]], middle = DIGITS[bytes[at + 1]], low = DIGITS[bytes[at + 2]];
          at += 3;
          all |= high | middle | low;
          code = (high * BASE + middle) * BASE + low;
        } else if (code >= TWO) {
          const low = DIGITS[bytes[at++]];
          all |= low;
          code = TWO + (code - TWO) * BASE + low;
        }
        residual = (code >> 1) ^ -(code & 1); // 0, -1, 1, -2, 2 ...
      } else {
        const number = longNumber(name, code, bytes, at);
        at += LONG_DIGITS;
        residual = number % 2 === 0 ? number / 2 : -(number + 1) / 2;
      }

      let base = 0;
      if (flags & AFFINE) {
        const a = of * (width + 1), v = 3 * row; // constant, then product by product: the order decides the last bit
        base = affine[a] + affine[a + 1] * first[v];
        if (width > 1) base = base + affine[a + 2] * first[v + 1];
        if (width > 2) base = base + affine[a + 3] * first[v + 2];
        if (width > 3) base = base + affine[a + 4] * second[v] + affine[a + 5] * second[v + 1] + affine[a + 6] * second[v + 2];
      }

      let beside = 0;
      if (!(flags & NO_TAPS)) {
        const l = left[row], u = up[row], ul = upLeft[row];
        if ((l | u | ul) >= 0) {
          beside = off[l] + off[u] - off[ul];
          if (flags & OWN_TAPS) {
            const ur = upRight[row], ll = left[l], uu = up[u];
            if ((ur | ll | uu) >= 0) {
              const t = of * TAPS;
              let whole = off[l] * taps[t] + off[u] * taps[t + 1] + off[ul] * taps[t + 2];
              whole = whole + off[ur] * taps[t + 3] + off[ll] * taps[t + 4];
              beside = (whole + off[uu] * taps[t + 5]) / UNIT;
            }
          }
        } else if (l >= 0 && left[l] >= 0) beside = 2 * off[l] - off[left[l]];
        else if (u >= 0 && up[u] >= 0) beside = 2 * off[u] - off[up[u]];
        else {
          const one = l >= 0 ? l : u >= 0 ? u : ul >= 0 ? ul : upRight[row] >= 0 ? upRight[row] : last[of];
          if (one >= 0) beside = off[one];
        }
      }

      const value = Math.floor(base + beside + 0.5) + residual;
      out[row] = value;
      off[row] = value - base;
      last[of] = row;
    }
    if (all & FOREIGN) throw damaged(`column ${name} holds a foreign character`);
    this.readTo(name, span, at);
  }

  private prediction(name: string, kinds: number, features: number): Prediction {
    const affine = new Float64Array(kinds * (features + 1));
    const taps = new Float64Array(kinds * TAPS);
    const has = new Uint8Array(kinds);
    const predictors = this.header.predictors[name] ?? {};
    for (const text of Object.keys(predictors)) {
      const of = Number(text), predictor = predictors[text];
      if (!(of < kinds)) continue; // no ray here is of that kind
      if (predictor.affine) {
        if (predictor.affine.length !== features + 1) throw damaged("a predictor has too few coefficients");
        for (let k = 0; k <= features; k++) affine[of * (features + 1) + k] = predictor.affine[k];
        has[of] |= AFFINE;
      }
      if (predictor.taps) has[of] |= predictor.taps.length ? OWN_TAPS : NO_TAPS;
      if (predictor.taps?.length) for (let k = 0; k < TAPS; k++) taps[of * TAPS + k] = predictor.taps[k];
    }
    return { affine, taps, has };
  }
}
