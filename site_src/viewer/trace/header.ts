/** What stands in a trace file beside its columns. FORMAT.md in build/raywalk/trace_file explains
 *  it; trace.schema.json there is its schema. */
import { TraceError, damaged } from "./errors";
import type { SentKind } from "./kinds";
import type { Header as Written } from "./pipeline-types";

/** A material has a share for each kind of ray too. */
type Material = Written["materials"][number] & Readonly<Record<SentKind, number>>;
export type Header = Omit<Written, "materials"> & { readonly materials: readonly Material[] };
export type Patch = Header["patches"][number];

export interface Expected {
  scene?: string;
  n?: number;
}

const FORMAT = "raywalk-trace";
const VERSION = 3;

/** The header, if this is an undamaged trace file of this version (and scene, and resolution). */
export function checkedHeader(json: unknown, expected: Expected): Header {
  const header = json as Header;
  if (header?.format !== FORMAT) throw new TraceError("not-a-trace", `"format" is not "${FORMAT}"`);
  if (header.version !== VERSION) throw new TraceError("version", `written as version ${header.version}, this reads ${VERSION}`);
  for (const key of ["scene", "n"] as const) {
    if (expected[key] !== undefined && header[key] !== expected[key]) throw new TraceError("scene", `holds ${key} ${header[key]}, not ${expected[key]}`);
  }
  if (checksum(columnBytes(header)) !== header.crc32) throw damaged("checksum");
  return header;
}

/** The columns' texts as bytes, in the order of their names, and where each stands. */
export interface ColumnBytes {
  bytes: Uint8Array;
  names: string[];
  starts: Int32Array; // by name
  ends: Int32Array;
}

const asBytes = new WeakMap<object, ColumnBytes>();

/** Reading bytes is several times as fast as reading texts. */
export function columnBytes({ columns }: Header): ColumnBytes {
  const known = asBytes.get(columns);
  if (known) return known;
  const names = Object.keys(columns).sort();
  let at = 0;
  const ends = Int32Array.from(names, (name) => (at += columns[name]?.length));
  const starts = Int32Array.of(0, ...ends);
  const bytes = new Uint8Array(at), encoder = new TextEncoder();
  for (const [k, name] of names.entries())
    if (encoder.encodeInto(columns[name], bytes.subarray(starts[k])).read !== columns[name].length) throw damaged(`column ${name}`);
  const all: ColumnBytes = { bytes, names, starts, ends };
  asBytes.set(columns, all);
  return all;
}

/** CRC-32, eight bytes at a time ("slicing by eight", Kounavis and Berry 2005). */
function checksum({ bytes }: ColumnBytes): number {
  const words = new Int32Array(bytes.buffer, 0, bytes.length >> 2); // little-endian, as every browser's machine
  let crc = -1;
  for (let k = 0; k + 1 < words.length; k += 2) {
    const low = crc ^ words[k], high = words[k + 1];
    crc =
      CRC_TABLE[1792 + (low & 255)] ^ CRC_TABLE[1536 + ((low >>> 8) & 255)] ^ CRC_TABLE[1280 + ((low >>> 16) & 255)] ^ CRC_TABLE[1024 + (low >>> 24)] ^
      CRC_TABLE[768 + (high & 255)] ^ CRC_TABLE[512 + ((high >>> 8) & 255)] ^ CRC_TABLE[256 + ((high >>> 16) & 255)] ^ CRC_TABLE[high >>> 24];
  }
  for (let k = bytes.length & ~7; k < bytes.length; k++) crc = CRC_TABLE[(crc ^ bytes[k]) & 255] ^ (crc >>> 8);
  return (crc ^ -1) >>> 0;
}

/** What a byte does to the remainder, and what it does one to seven bytes later. */
const CRC_TABLE = new Int32Array(2048);
for (let byte = 0; byte < 256; byte++) {
  let rest = byte;
  for (let bit = 0; bit < 8; bit++) rest = rest & 1 ? (rest >>> 1) ^ 0xedb88320 : rest >>> 1;
  CRC_TABLE[byte] = rest;
}
for (let at = 256; at < 2048; at++) CRC_TABLE[at] = (CRC_TABLE[at - 256] >>> 8) ^ CRC_TABLE[CRC_TABLE[at - 256] & 255];
