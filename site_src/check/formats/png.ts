/**
 * PNG, decoded by fast-png. Before that the chunks are walked: a picture that unpacks to more than it claims is given up while
 * it does, and chunks that hold no pixels (colour profiles, texts, which may be bombs too) are left out. No gamma is applied.
 */
import { convertIndexedToRgb, decode } from "fast-png";
import { Unzlib } from "fflate";
import { checkSize, PictureFault } from "./fault";
import { pictureOf, type Picture } from "./picture";

const FORMAT = "PNG";
const SIGNATURE = 8;
const KEPT = new Set(["IHDR", "PLTE", "tRNS", "IDAT", "IEND"]);
const CHANNELS: Record<number, number> = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };
const PASSES = [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]]; // of Adam7: x, y, steps
/** Compressed bytes that are unpacked at a time: a deflated byte holds at most 1032. */
const PORTION = 4096;

interface Chunk {
  type: string;
  whole: Uint8Array;
  data: Uint8Array;
}

interface Header {
  width: number;
  height: number;
  depth: number;
  channels: number;
  isIndexed: boolean;
  isInterlaced: boolean;
}

export function readPng(bytes: Uint8Array): Picture {
  const chunks = chunksOf(bytes);
  const header = headerOf(chunks[0]);
  checkUnpacked(header, chunks);
  let decoded: ReturnType<typeof decode>;
  try {
    decoded = decode(joined([bytes.subarray(0, SIGNATURE), ...chunks.map(({ whole }) => whole)]), { checkCrc: true });
    if (header.isIndexed) return coloursOf(header, convertIndexedToRgb(decoded), decoded.palette![0].length);
  } catch (error) {
    throw new PictureFault("damaged", { format: FORMAT, what: said(error) });
  }
  return coloursOf(header, header.depth < 8 ? spread(header, decoded.data as Uint8Array) : decoded.data as Uint8Array | Uint16Array, header.channels);
}

const said = (error: unknown) => (error instanceof Error ? error.message : String(error)).replace(/[.:\s]+$/, "");

function* walked(bytes: Uint8Array): Generator<Chunk> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  let at = SIGNATURE;
  for (let type = ""; type !== "IEND";) {
    if (at + 12 > bytes.length) throw new PictureFault("truncated", { format: FORMAT, has: bytes.length, needed: at + 12 });
    const end = at + 12 + view.getUint32(at);
    if (end > bytes.length) throw new PictureFault("truncated", { format: FORMAT, has: bytes.length, needed: end });
    type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    yield { type, whole: bytes.subarray(at, end), data: bytes.subarray(at + 8, end - 4) };
    at = end;
  }
}

const chunksOf = (bytes: Uint8Array) => [...walked(bytes)].filter(({ type }) => KEPT.has(type));

function headerOf({ type, data }: Chunk): Header {
  if (type !== "IHDR" || data.length !== 13) throw new PictureFault("header", { format: FORMAT, what: "it does not begin with IHDR" });
  const view = new DataView(data.buffer, data.byteOffset, data.length);
  const [width, height, depth, kind] = [view.getUint32(0), view.getUint32(4), data[8], data[9]];
  checkSize(FORMAT, width, height);
  const channels = CHANNELS[kind];
  if (!channels || ![1, 2, 4, 8, 16].includes(depth)) throw new PictureFault("header", { format: FORMAT, what: `there is no colour type ${kind} with ${depth} bits` });
  const header = { width, height, depth, channels, isIndexed: kind === 3, isInterlaced: data[12] === 1 };
  if (header.isInterlaced && depth < 8) throw new PictureFault("variant", { format: FORMAT, what: `interlaced with ${depth} bits a pixel`, instead: "a PNG that is not interlaced" });
  return header;
}

/** Bytes of all rows, each with its filter's number before it. */
function unpackedLength({ width, height, depth, channels, isInterlaced }: Header): number {
  const rows = (w: number, h: number) => (w > 0 && h > 0 ? h * (1 + Math.ceil((w * depth * channels) / 8)) : 0);
  if (!isInterlaced) return rows(width, height);
  return PASSES.reduce((sum, [x, y, dx, dy]) => sum + rows(Math.ceil((width - x) / dx), Math.ceil((height - y) / dy)), 0);
}

/** Unpacks portion by portion, keeping nothing, until more comes out than is claimed. */
function checkUnpacked(header: Header, chunks: Chunk[]): void {
  const expected = unpackedLength(header);
  let found = 0;
  const inflate = new Unzlib((part) => (found += part.length));
  try {
    for (const { data } of chunks.filter(({ type }) => type === "IDAT")) {
      for (let at = 0; at < data.length && found <= expected; at += PORTION) inflate.push(data.subarray(at, at + PORTION));
    }
    if (found <= expected) inflate.push(new Uint8Array(0), true);
  } catch (error) {
    if (found >= expected) return; // all pixels are there; what follows them is fast-png's to judge
    throw new PictureFault("damaged", { format: FORMAT, what: `its pixels do not unpack (${said(error)})` });
  }
  if (found > expected) throw new PictureFault("tooMuch", { format: FORMAT, width: header.width, height: header.height });
  if (found < expected) throw new PictureFault("damaged", { format: FORMAT, what: `it holds ${found} of ${expected} bytes of pixels` });
}

function joined(parts: Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** Greys of 1, 2 or 4 bits, several in a byte, each row from a new one: as bytes. */
function spread({ width, height, depth }: Header, data: Uint8Array): Uint8Array {
  const [rowBytes, most] = [Math.ceil((width * depth) / 8), 2 ** depth - 1];
  return Uint8Array.from({ length: width * height }, (_, i) => {
    const bit = (i % width) * depth;
    const byte = data[Math.floor(i / width) * rowBytes + (bit >> 3)];
    return (255 * ((byte >> (8 - depth - (bit & 7))) & most)) / most;
  });
}

function coloursOf({ width, height, depth, isIndexed }: Header, data: Uint8Array | Uint16Array, channels: number): Picture {
  const isDeep = depth === 16 && !isIndexed;
  if (channels === 3 && !isDeep) return pictureOf(width, height, data as Uint8Array); // as all of ours are: nothing is copied
  const count = width * height;
  const values = isDeep ? new Float32Array(3 * count) : new Uint8Array(3 * count);
  const step = isDeep ? 257 : 1; // 65535 / 255
  const isGrey = channels < 3;
  let hadAlpha = false;
  for (let i = 0; i < count; i++) {
    for (let c = 0; c < 3; c++) values[3 * i + c] = data[i * channels + (isGrey ? 0 : c)] / step;
    if (channels % 2 === 0 && data[(i + 1) * channels - 1] !== 255 * step) hadAlpha = true;
  }
  return { ...pictureOf(width, height, values), hadAlpha };
}
