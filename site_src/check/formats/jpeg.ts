/** JPEG, decoded by jpeg-js; its size is read first, and more of it than is claimed never made. */
import decode from "jpeg-js/lib/decoder";
import { checkSize, PictureFault } from "./fault";
import { pictureOf, type Picture } from "./picture";

const FORMAT = "JPEG";
const MOST_SCANS = 100; // progressive files have about ten; each is gone through for all pixels
const MEMORY = 150; // MB

export function readJpeg(bytes: Uint8Array): Picture {
  const { width, height } = sizeOf(bytes);
  checkSize(FORMAT, width, height);
  try {
    const decoded = decode(bytes, { useTArray: true, formatAsRGBA: false, tolerantDecoding: false, maxMemoryUsageInMB: MEMORY });
    return { ...pictureOf(width, height, decoded.data), isLossy: true };
  } catch (error) {
    throw new PictureFault("damaged", { format: FORMAT, what: error instanceof Error ? error.message : String(error) });
  }
}

/** Of the first frame header (SOF0 to SOF2); what else stands in front is stepped over. */
function sizeOf(bytes: Uint8Array): { width: number; height: number } {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let size: { width: number; height: number } | undefined;
  for (let at = 2; at + 4 <= bytes.length && bytes[at] === 0xff;) {
    const marker = bytes[at + 1];
    if (marker === 0xff) at++;
    else if (marker === 0xda) break;
    else {
      if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker)) size = frame(view, at, marker);
      at += 2 + view.getUint16(at + 2);
    }
  }
  if (!size) throw new PictureFault("header", { format: FORMAT, what: "no frame is described before its data" });
  let scans = 0;
  for (let at = bytes.indexOf(0xff); at >= 0; at = bytes.indexOf(0xff, at + 1)) if (bytes[at + 1] === 0xda) scans++;
  if (scans > MOST_SCANS) throw new PictureFault("damaged", { format: FORMAT, what: `it has ${scans} scans` });
  return size;
}

function frame(view: DataView, at: number, marker: number) {
  if (at + 10 > view.byteLength) throw new PictureFault("truncated", { format: FORMAT, has: view.byteLength, needed: at + 10 });
  const instead = "a PNG";
  if (marker > 0xc2) throw new PictureFault("variant", { format: FORMAT, what: "lossless or arithmetic coding", instead });
  if (![1, 3].includes(view.getUint8(at + 9))) throw new PictureFault("variant", { format: FORMAT, what: `${view.getUint8(at + 9)} components`, instead });
  return { height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
}
