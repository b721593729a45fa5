/** TGA of colours or greys (types 2 and 3), and both packed by runs (10 and 11). It has no mark of its own: its header must make sense. */
import { checkLength, checkSize, PictureFault } from "./fault";
import { pictureOf, type Picture } from "./picture";

const FORMAT = "TGA";
const HEADER = 18;
const TYPES = [1, 2, 3, 9, 10, 11];
const [FROM_RIGHT, FROM_TOP] = [0x10, 0x20]; // of the descriptor

/** Could be the header of one. */
export function looksLikeTga(bytes: Uint8Array): boolean {
  if (bytes.length < HEADER || bytes[1] > 1 || !TYPES.includes(bytes[2])) return false;
  return [8, 15, 16, 24, 32].includes(bytes[16]) && (bytes[17] & 0xc0) === 0 && (bytes[1] === 1) === (bytes[2] === 1 || bytes[2] === 9);
}

export function readTga(bytes: Uint8Array): Picture {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const [type, bits, descriptor] = [bytes[2], bytes[16], bytes[17]];
  const [width, height] = [view.getUint16(12, true), view.getUint16(14, true)];
  checkSize(FORMAT, width, height);
  const isGrey = type === 3 || type === 11;
  if (type === 1 || type === 9 || (isGrey ? bits !== 8 : bits < 24)) {
    throw new PictureFault("variant", { format: FORMAT, what: `type ${type} with ${bits} bits a pixel`, instead: "24 bits without a colour map" });
  }
  const size = bits / 8;
  const start = HEADER + bytes[0];
  const pixels = type >= 9 ? unpacked(bytes, start, width * height, size) : bytes.subarray(start);
  checkLength(FORMAT, pixels.length, width * height * size);
  return placed(pixels, width, height, size, descriptor);
}

/** A packet is a count and either that many pixels or one for all of them. */
function unpacked(bytes: Uint8Array, from: number, count: number, size: number): Uint8Array {
  const pixels = new Uint8Array(count * size);
  let at = from;
  for (let done = 0; done < pixels.length;) {
    const isRun = bytes[at] >= 128;
    const length = Math.min(((bytes[at] & 127) + 1) * size, pixels.length - done);
    checkLength(FORMAT, bytes.length, at + 1 + (isRun ? size : length));
    if (isRun) for (let i = 0; i < length; i++) pixels[done + i] = bytes[at + 1 + (i % size)];
    else pixels.set(bytes.subarray(at + 1, at + 1 + length), done);
    at += 1 + (isRun ? size : length);
    done += length;
  }
  return pixels;
}

function placed(pixels: Uint8Array, width: number, height: number, size: number, descriptor: number): Picture {
  const values = new Uint8Array(3 * width * height);
  let hadAlpha = false;
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    const to = (descriptor & FROM_TOP ? y : height - 1 - y) * width + (descriptor & FROM_RIGHT ? width - 1 - x : x);
    for (let c = 0; c < 3; c++) values[3 * to + c] = pixels[i * size + (size === 1 ? 0 : 2 - c)];
    if (size === 4 && (descriptor & 15) > 0 && pixels[i * size + 3] !== 255) hadAlpha = true;
  }
  return { ...pictureOf(width, height, values), hadAlpha };
}
