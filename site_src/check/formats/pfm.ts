/** PFM, floats of colours (PF) or greys (Pf), rows from the bottom; the sign of the header's third number tells the byte order. */
import { checkLength, checkSize, PictureFault } from "./fault";
import { pictureOf, type Picture } from "./picture";
import { scaleOf, toShown } from "./scale";

const FORMAT = "PFM";
const LONGEST_HEADER = 200; // bytes

export function readPfm(bytes: Uint8Array): Picture {
  const head = String.fromCharCode(...bytes.subarray(0, LONGEST_HEADER));
  const found = /^P[Ff]\s+(\d{1,10})\s+(\d{1,10})\s+([-+]?[\d.]+(?:[eE][-+]?\d+)?)(?:\r\n|\s)/.exec(head);
  if (!found) throw new PictureFault("header", { format: FORMAT, what: "expected are width, height and a scale" });
  const [width, height, scale] = found.slice(1).map(Number);
  checkSize(FORMAT, width, height);
  if (!scale) throw new PictureFault("header", { format: FORMAT, what: "its scale is 0, whose sign would tell the order of bytes" });
  const channels = head[1] === "F" ? 3 : 1;
  checkLength(FORMAT, bytes.length, found[0].length + 4 * width * height * channels);
  const view = new DataView(bytes.buffer, bytes.byteOffset + found[0].length);
  const values = new Float32Array(3 * width * height);
  for (let i = 0; i < values.length; i++) {
    const [x, y, c] = [Math.floor(i / 3) % width, Math.floor(i / 3 / width), channels === 3 ? i % 3 : 0];
    const value = view.getFloat32(4 * (((height - 1 - y) * width + x) * channels + c), scale < 0);
    if (!Number.isFinite(value)) throw new PictureFault("notFinite", { x, y, value });
    values[i] = value;
  }
  return pictureOf(width, height, toShown(values, scaleOf(values, true)));
}
