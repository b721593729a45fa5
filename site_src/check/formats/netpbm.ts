/** PGM and PPM, as text (P2, P3) or bytes (P5, P6), with 8 or 16 bits and comments. After https://netpbm.sourceforge.net/doc/ppm.html. */
import { checkLength, checkSize, PictureFault } from "./fault";
import { pictureOf, type Picture } from "./picture";

const isSpace = (byte: number) => byte === 32 || (byte >= 9 && byte <= 13);
const isDigit = (byte: number) => byte >= 48 && byte <= 57;

export function readNetpbm(bytes: Uint8Array): Picture {
  const kind = bytes[1] - 48;
  const format = `P${kind}`;
  if (kind === 1 || kind === 4 || kind === 7) throw new PictureFault("variant", { format, what: kind === 7 ? "PAM" : "black and white bits", instead: "P3 or P6" });
  const text = numbersIn(bytes, format);
  const [width, height, most] = [text.next(), text.next(), text.next()];
  checkSize(format, width, height);
  if (most < 1 || most > 65535) throw new PictureFault("header", { format, what: `the largest value is ${most}; allowed are 1 to 65535` });
  const channels = kind === 2 || kind === 5 ? 1 : 3;
  const count = width * height * channels;
  const next = kind < 4 ? textual(text, bytes, format, count) : binary(bytes, text.at() + 1, format, count, most);
  const values = most === 255 ? new Uint8Array(3 * width * height) : new Float32Array(3 * width * height);
  for (let i = 0; i < count; i++) {
    const value = next();
    if (value > most) throw new PictureFault("aboveMost", { format, value, most });
    const shown = most === 255 ? value : (255 * value) / most;
    if (channels === 3) values[i] = shown;
    else values.fill(shown, 3 * i, 3 * i + 3);
  }
  return pictureOf(width, height, values);
}

/** Whole numbers in text, from behind the two letters on; a comment reaches from # to the line's end. */
function numbersIn(bytes: Uint8Array, format: string) {
  let at = 2;
  const next = () => {
    while (isSpace(bytes[at]) || bytes[at] === 35) {
      if (bytes[at] === 35) while (at < bytes.length && bytes[at] !== 10 && bytes[at] !== 13) at++;
      else at++;
    }
    if (at >= bytes.length) throw new PictureFault("damaged", { format, what: "it ends where a number is expected" });
    let value = 0;
    const start = at;
    for (; isDigit(bytes[at]); at++) value = Math.min(10 * value + bytes[at] - 48, 1e9);
    if (at === start) throw new PictureFault("damaged", { format, what: `there is ${JSON.stringify(String.fromCharCode(bytes[at]))} at byte ${at}, where a number is expected` });
    return value;
  };
  return { next, at: () => at };
}

/** The shortest text of a number is a digit and a space. */
function textual(text: ReturnType<typeof numbersIn>, bytes: Uint8Array, format: string, count: number): () => number {
  checkLength(format, bytes.length, text.at() + 2 * count);
  return text.next;
}

function binary(bytes: Uint8Array, from: number, format: string, count: number, most: number): () => number {
  const width = most > 255 ? 2 : 1;
  checkLength(format, bytes.length, from + width * count);
  let at = from;
  return width === 1 ? () => bytes[at++] : () => 256 * bytes[at++] + bytes[at++]; // the high byte first
}
