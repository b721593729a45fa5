/** BMP with 24 or 32 bits a pixel, of all headers since Windows 2; rows from the bottom, or from the top where the height is negative. */
import { checkLength, checkSize, PictureFault } from "./fault";
import { pictureOf, type Picture } from "./picture";

const FORMAT = "BMP";
const FILE_HEADER = 14;
const CORE = 12; // the length of the oldest header, of 16-bit sizes
const [PLAIN, BY_MASKS] = [0, 3]; // of the field "compression"
const AS_ALWAYS = [0xff0000, 0xff00, 0xff]; // red, green, blue of a pixel as a little-endian number

export function readBmp(bytes: Uint8Array): Picture {
  checkLength(FORMAT, bytes.length, FILE_HEADER + CORE);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const { width, height, isTopDown, bits, masks } = headerOf(view);
  const rowBytes = 4 * Math.ceil((width * bits) / 32);
  const start = view.getUint32(10, true);
  checkLength(FORMAT, bytes.length, start + rowBytes * height);
  const places = masks.map((mask) => Math.log2(mask / 255) / 8); // which byte of a pixel holds which colour
  const values = new Uint8Array(3 * width * height);
  for (let row = 0; row < height; row++) {
    const from = start + rowBytes * (isTopDown ? row : height - 1 - row);
    for (let i = 0; i < 3 * width; i++) values[3 * width * row + i] = bytes[from + Math.floor(i / 3) * (bits / 8) + places[i % 3]];
  }
  return pictureOf(width, height, values);
}

function headerOf(view: DataView) {
  const length = view.getUint32(FILE_HEADER, true);
  const isCore = length === CORE;
  if (!isCore && (length < 40 || length > 256)) throw new PictureFault("header", { format: FORMAT, what: `it says that it has ${length} bytes` });
  checkLength(FORMAT, view.byteLength, FILE_HEADER + length);
  const signed = isCore ? view.getUint16(20, true) : view.getInt32(22, true);
  const width = isCore ? view.getUint16(18, true) : view.getInt32(18, true);
  if (width < 0) throw new PictureFault("header", { format: FORMAT, what: `the width is ${width}` });
  checkSize(FORMAT, width, Math.abs(signed));
  const bits = view.getUint16(isCore ? 24 : 28, true);
  const compression = isCore ? PLAIN : view.getUint32(30, true);
  if ((bits !== 24 && bits !== 32) || (compression !== PLAIN && (compression !== BY_MASKS || bits !== 32))) {
    throw new PictureFault("variant", { format: FORMAT, what: `${bits} bits a pixel, compression ${compression}`, instead: "24 bits, not compressed" });
  }
  return { width, height: Math.abs(signed), isTopDown: signed < 0, bits, masks: compression === BY_MASKS ? masksOf(view) : AS_ALWAYS };
}

/** Behind a header of 40 bytes, or in a longer one: the same place. */
function masksOf(view: DataView): number[] {
  checkLength(FORMAT, view.byteLength, 66);
  const masks = [54, 58, 62].map((at) => view.getUint32(at, true));
  if (masks.some((mask) => ![0xff, 0xff00, 0xff0000, 0xff000000].includes(mask)) || new Set(masks).size < 3) {
    throw new PictureFault("variant", { format: FORMAT, what: "colours that are not a byte each", instead: "24 bits, not compressed" });
  }
  return masks;
}
