/** Whole numbers as text; symbols.py writes them and says how. */
export const BASE = 93; // printable ASCII without " and \
export const MORE = 79; // from this first digit on a number has more, below it is the number
export const FOUR = 91; // has three more, and says only that
export const LONG = 92; // likewise eight

/** By byte, which of the 93 it is. */
export const DIGITS = new Uint8Array(256).fill(255);
for (let code = 32, digit = 0; code < 127; code++) {
  if (code !== 34 && code !== 92) DIGITS[code] = digit++;
}
