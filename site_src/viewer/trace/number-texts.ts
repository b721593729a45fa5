/**
 * Residuals of all columns of numbers, in a text for each class of sizes that a ray's neighbours lead
 * to expect. expected.py writes them and says why.
 */
import { damaged } from "./errors";
import type { ColumnBytes } from "./header";
import { DIGITS, following, longNumber } from "./symbols";

const CLASSES = 17;
export const KEPT = 5; // binary digits that a class's own text keeps; those below are noise
export const MOST = 2 ** 14 - 1; // sizes are no larger here
const BITS = 6; // in a character of noise
export const SHARES = Int32Array.from([0, 256, 128, 85, 64]); // 256 by how many neighbours count

/** Where the reading of the texts stands; its loop is in columns.ts. */
export class NumberTexts {
  readonly at = new Int32Array(CLASSES); // read so far, of each class
  private readonly end = new Int32Array(CLASSES);
  readonly noise: DataView;
  bit = 0; // of the noise
  private readonly bits: number;

  constructor(private readonly bytes: Uint8Array, spans: ColumnBytes["spans"]) {
    for (let of = 0; of < CLASSES; of++) {
      const span = spans.get(`numbers${of}`);
      this.at[of] = span?.at ?? 0;
      this.end[of] = span?.end ?? 0;
    }
    const noise = spans.get("noise");
    const text = bytes.subarray(noise?.at, noise?.end ?? 0);
    this.noise = bitsOf(text);
    this.bits = BITS * text.length;
  }

  /** A number of this class whose first digit says that there are more. */
  long(of: number, first: number): number {
    const value = longNumber(first, this.bytes, this.at[of]);
    if (!(value >= 0)) throw damaged("a number holds a foreign character");
    this.at[of] += following(first);
    return value;
  }

  /** Throws if a text was read past its end. */
  check(name: string) {
    if (this.bit > this.bits || this.at.some((at, of) => at > this.end[of])) throw damaged(`column ${name} has too few numbers`);
  }

  /** Throws if a text was not read to its end. */
  finish() {
    if (this.bit <= this.bits - BITS || this.at.some((at, of) => at < this.end[of])) throw damaged("there are more numbers than columns");
  }
}

/** Four characters of six bits each as three bytes; four more, so that four can be read at any. */
function bitsOf(text: Uint8Array): DataView {
  const bits = new Uint8Array(((text.length * BITS) >> 3) + 8);
  for (let k = 0, to = 0; k < text.length; k += 4, to += 3) {
    const four = (DIGITS[text[k]] << 18) | (DIGITS[text[k + 1]] << 12) | (DIGITS[text[k + 2]] << 6) | DIGITS[text[k + 3]];
    bits[to] = four >> 16;
    bits[to + 1] = four >> 8;
    bits[to + 2] = four;
  }
  return new DataView(bits.buffer);
}
