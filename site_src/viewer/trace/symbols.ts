/** Whole numbers out of a column's text; symbols.py writes them and says how. */
import { damaged } from "./errors";

const BASE = 93; // printable ASCII without " and \
const ONE = 79; // numbers below it take one character
const LONG: Readonly<Record<number, number>> = { 91: 3, 92: 8 }; // first digit -> digits that follow
const FOREIGN = 255;

const DIGITS = new Uint8Array(128).fill(FOREIGN);
for (let code = 32, digit = 0; code < 127; code++) {
  if (code !== 34 && code !== 92) DIGITS[code] = digit++;
}

export class Reader {
  private at = 0;

  constructor(
    private readonly name: string,
    private readonly text: string,
  ) {}

  get isEmpty(): boolean {
    return this.text.length === 0;
  }

  /** The next number, >= 0. */
  next(): number {
    const first = this.digit();
    if (first < ONE) return first;
    const length = LONG[first];
    if (length === undefined) return ONE + (first - ONE) * BASE + this.digit();
    let number = 0;
    for (let k = 0; k < length; k++) number = number * BASE + this.digit();
    return number;
  }

  /** The next number of any sign. */
  signed(): number {
    const number = this.next();
    return number % 2 === 0 ? number / 2 : -(number + 1) / 2;
  }

  finish() {
    if (this.at !== this.text.length) throw damaged(`column ${this.name} is too long`);
  }

  private digit(): number {
    const code = this.text.charCodeAt(this.at++); // NaN past the end
    const digit = DIGITS[code] ?? FOREIGN;
    if (digit === FOREIGN) throw damaged(`column ${this.name} ends too early or holds a foreign character`);
    return digit;
  }
}
