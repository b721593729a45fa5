/** Whole numbers out of a column's text; symbols.py writes them and says how. */
import { damaged } from "./errors";

const BASE = 93; // printable ASCII without " and \
const ONE = 79; // numbers below it take one character
const LONG: Readonly<Record<number, number>> = { 91: 3, 92: 8 }; // first digit -> digits that follow
const FOREIGN = 255;

const DIGITS = new Uint8Array(256).fill(FOREIGN);
for (let code = 32, digit = 0; code < 127; code++) {
  if (code !== 34 && code !== 92) DIGITS[code] = digit++;
}

export class Reader {
  private at = 0;

  constructor(
    private readonly name: string,
    private readonly bytes: Uint8Array,
  ) {}

  get isEmpty(): boolean {
    return this.bytes.length === 0;
  }

  /** The next `count` numbers, >= 0. */
  take(count: number, out: Float64Array) {
    const { bytes } = this;
    let at = this.at;
    for (let k = 0; k < count; k++) {
      const first = DIGITS[bytes[at++]];
      if (first < ONE) out[k] = first;
      else {
        this.at = at;
        out[k] = this.long(first);
        at = this.at;
      }
    }
    this.at = at;
  }

  /** The next `count` numbers of any sign. */
  takeSigned(count: number, out: Float64Array) {
    this.take(count, out);
    for (let k = 0; k < count; k++) {
      const number = out[k];
      out[k] = number % 2 === 0 ? number / 2 : -(number + 1) / 2;
    }
  }

  finish() {
    if (this.at !== this.bytes.length) throw damaged(`column ${this.name} is too long`);
  }

  private long(first: number): number {
    const length = LONG[first];
    if (length === undefined && first < BASE) return ONE + (first - ONE) * BASE + this.digit();
    if (length === undefined) throw this.cut();
    let number = 0;
    for (let k = 0; k < length; k++) number = number * BASE + this.digit();
    return number;
  }

  private digit(): number {
    const digit = DIGITS[this.bytes[this.at++]];
    if (!(digit < BASE)) throw this.cut();
    return digit;
  }

  private cut = () => damaged(`column ${this.name} ends too early or holds a foreign character`);
}
