/** Whole numbers as text; symbols.py writes them and says how. */
const BASE = 93; // printable ASCII without " and \
export const MORE = 79; // from this first digit on a number has more, below it is the number
const FOUR = 91; // has three more, and says only that
const LONG = 92; // likewise eight

/** By byte, which of the 93 it is. */
export const DIGITS = new Uint8Array(256).fill(255);
for (let code = 32, digit = 0; code < 127; code++) {
  if (code !== 34 && code !== 92) DIGITS[code] = digit++;
}

/** How many digits follow a first one from MORE on. */
export const following = (first: number) => (first < FOUR ? 1 : first < LONG ? 3 : 8);

/** A number that has more; `at`: after the first. NaN if a digit is foreign. */
export function longNumber(first: number, bytes: Uint8Array, at: number): number {
  const start = first < FOUR ? first - MORE : 0;
  let value = first > LONG ? NaN : start;
  for (let k = 0; k < following(first); k++) {
    const digit = DIGITS[bytes[at + k]];
    value = digit < BASE ? value * BASE + digit : NaN;
  }
  return first < FOUR ? MORE + value : value;
}
