/**
 * Columns of symbols and of numbers, each entry predicted from rays that came earlier.
 * The arithmetic is residuals.py's, operation by operation. One loop reads all columns of
 * numbers and one all symbols, always with arrays of the same types: a page decodes with them
 * after the first few columns at full speed.
 */
import { damaged } from "./errors";
import { columnBytes, type ColumnBytes, type Header } from "./header";
import { ABSENT, type Sides } from "./neighbours";
import { BASE, DIGITS, FOUR, LONG, MORE } from "./symbols";

const UNIT = 256; // of taps
const TAPS = 6;

// Residuals stand in a text for each class of sizes that a ray's neighbours lead to expect; see expected.py.
const KEPT = 5; // binary digits that a class's own text keeps; those below are noise
const MOST = 2 ** 14 - 1; // sizes are no larger here
const BITS = 6; // in a character of noise

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

export class Columns {
  private readonly texts: ColumnBytes;
  private readonly at: Int32Array; // how far each text is read
  private readonly noise: DataView;
  private bit = 0; // of the noise

  /** By row, scratch: off for number - affine part, and by row + 1 size for how large residuals are. */
  constructor(private readonly header: Header, private readonly off: Float64Array, private readonly size: Int32Array) {
    const { bytes, starts, ends } = (this.texts = columnBytes(header));
    this.at = starts.slice();
    const noise = this.named("noise");
    this.noise = bitsOf(bytes.subarray(starts[noise], ends[noise]));
  }

  /** Which text it is. */
  private named(name: string): number {
    const text = this.texts.names.indexOf(name);
    if (text < 0) throw damaged(`column ${name}`);
    return text;
  }

  /** Each text must be read to its end, and no further. */
  finish() {
    this.at[this.named("noise")] += Math.ceil(this.bit / BITS);
    if (this.texts.ends.some((end, text) => this.at[text] !== end)) throw damaged("a column");
  }

  /** A number whose first digit, which is read, says that there are more. */
  private long(text: number, first: number): number {
    let value = first < FOUR ? first - MORE : 0;
    for (let more = first < FOUR ? 1 : first < LONG ? 3 : 8; more > 0; more--) {
      const digit = DIGITS[this.texts.bytes[this.at[text]++]];
      value = digit < BASE ? value * BASE + digit : NaN;
    }
    if (first > LONG || !(value >= 0)) throw damaged("a column");
    return first < FOUR ? MORE + value : value;
  }

  /** Writes symbols below `most` of the rays from row `first` on to `end` whose kind is not ABSENT.
   *  Neighbours count within a group; kinds are below `kinds`. */
  symbols(
    name: string, first: number, end: number, group: Int32Array, kind: Int32Array, kinds: number, sides: Sides, most: number, out: Int32Array,
  ) {
    const { left, up, upLeft } = sides;
    const { at, texts: { bytes } } = this;
    const text = this.named(name);
    const last = new Int32Array(kinds);
    for (let row = first; row < end; row++) {
      const of = kind[row];
      if (of === ABSENT) continue;
      let value = DIGITS[bytes[at[text]++]];
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
        if (value >= MORE) value = this.long(text, value) | 0;
        value--;
        if (value >= most || value < 0) throw damaged(`column ${name}`);
      }
      out[row] = last[of] = value;
    }
  }

  /** Writes whole numbers at `rows`; what else stands in `out` stays. kind: by row, below `kinds`;
   *  near: by row, within the column's groups (see alike). */
  numbers(name: string, rows: Int32Array, kind: Int32Array, kinds: number, near: Sides, features: Features, out: Float64Array) {
    const same = this.header.same[name];
    if (same !== undefined) for (let k = 0; k < rows.length; k++) out[rows[k]] = same;
    else this.predicted(rows, kind, kinds, near, this.prediction(name, kinds, features.width), features, out);
  }

  private predicted(rows: Int32Array, kind: Int32Array, kinds: number, near: Sides, { affine, taps, has }: Prediction, features: Features, out: Float64Array) {
    const { at, noise, off, size, texts: { bytes } } = this;
    const texts = this.named("numbersa");
    const { left, up, upLeft, upRight } = near;
    const { width, first, second } = features;
    const last = new Int32Array(kinds).fill(-1);
    let { bit } = this;
    size[0] = 0;
    for (let k = 0; k < rows.length; k++) {
      const row = rows[k], of = kind[row], flags = has[of];
      const l = left[row], u = up[row], ul = upLeft[row], ur = upRight[row];

      // Which text the residual stands in; missing neighbours (-1) have size[0], which is 0.
      let sizes = 2 * size[u + 1] + size[ul + 1] + size[ur + 1];
      if ((u | ul | ur) < 0) {
        const count = 4 + 2 * (u >> 31) + (ul >> 31) + (ur >> 31);
        sizes = count > 0 ? (sizes * ((256 / count) | 0)) >> 6 : 4 * size[(l < 0 ? last[of] : l) + 1];
      }
      const length = 32 - Math.clz32(sizes), text = texts + length;
      let code = DIGITS[bytes[at[text]++]], low = 0, extra = 0, residual = 0;
      if (length > KEPT) {
        low = length - KEPT;
        extra = (noise.getUint32(bit >> 3) << (bit & 7)) >>> (32 - low);
        bit += low;
      }
      if (code < MORE) {
        code = (code << low) | extra;
        residual = (code >> 1) ^ -(code & 1); // 0, -1, 1, -2, 2 ...
        size[row + 1] = Math.min((code + 1) >> 1, MOST);
      } else {
        const number = this.long(text, code) * (1 << low) + extra;
        residual = number % 2 === 0 ? number / 2 : -(number + 1) / 2;
        size[row + 1] = Math.min(Math.abs(residual), MOST);
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
        if ((l | u | ul) >= 0) {
          beside = off[l] + off[u] - off[ul];
          if (flags & OWN_TAPS) {
            const ll = left[l], uu = up[u];
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
          const one = l >= 0 ? l : u >= 0 ? u : ul >= 0 ? ul : ur >= 0 ? ur : last[of];
          if (one >= 0) beside = off[one];
        }
      }

      const value = Math.floor(base + beside + 0.5) + residual;
      out[row] = value;
      off[row] = value - base;
      last[of] = row;
    }
    this.bit = bit;
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
        for (let k = 0; k <= features; k++) affine[of * (features + 1) + k] = predictor.affine[k];
        has[of] |= AFFINE;
      }
      if (predictor.taps) has[of] |= predictor.taps.length ? OWN_TAPS : NO_TAPS;
      if (predictor.taps?.length) for (let k = 0; k < TAPS; k++) taps[of * TAPS + k] = predictor.taps[k];
    }
    return { affine, taps, has };
  }
}

/** Four characters of six bits each as three bytes; four more, so that four can be read at any. */
function bitsOf(text: Uint8Array): DataView {
  const bits = new Uint8Array(text.length + 4);
  for (let k = 0, to = 0; k < text.length; k += 4, to += 3) {
    const four = (DIGITS[text[k]] << 18) | (DIGITS[text[k + 1]] << 12) | (DIGITS[text[k + 2]] << 6) | DIGITS[text[k + 3]];
    bits[to] = four >> 16;
    bits[to + 1] = four >> 8;
    bits[to + 2] = four;
  }
  return new DataView(bits.buffer);
}
