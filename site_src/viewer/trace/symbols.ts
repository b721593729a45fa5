/** Whole numbers as text; symbols.py writes them and says how. */
import { damaged } from "./errors";

export const BASE = 93; // printable ASCII without " and \
export const TWO = 79; // from this first digit on a number has two, below it is the number
export const FOUR = 91; // has four, the first of which says only that
export const LONG = 92; // likewise nine
export const LONG_DIGITS = 8;
export const FOREIGN = 128; // a bit that no digit has

/** By byte, which of the 93 it is. */
export const DIGITS = new Uint8Array(256).fill(255);
for (let code = 32, digit = 0; code < 127; code++) {
  if (code !== 34 && code !== 92) DIGITS[code] = digit++;
}

/** One of the rare numbers of nine characters; `at`: after the first. */
export function longNumber(name: string, first: number, bytes: Uint8Array, at: number): number {
  let value = first === LONG ? 0 : NaN;
  for (let k = 0; k < LONG_DIGITS; k++) {
    const digit = DIGITS[bytes[at + k]];
    value = digit < BASE ? value * BASE + digit : NaN;
  }
  if (!Number.isFinite(value)) throw damaged(`column ${name} ends too early or holds a foreign character`);
  return value;
}
