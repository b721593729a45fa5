/** What stands in a trace file beside its columns. FORMAT.md in build/raywalk/trace_file explains
 *  it; trace.schema.json there is its schema. */
import { TraceError, damaged } from "./errors";
import type { Vec3 } from "./types";

export interface Patch {
  object: number; // -1: rays that leave the scene end here
  points: "flat" | "ball" | "free";
  normals: "one" | "gradient" | "stored" | "none";
  step?: number;
  origin?: readonly number[];
  axes?: readonly number[];
  gradient?: readonly number[];
}

export interface Predictor {
  affine?: readonly number[];
  taps?: readonly number[]; // []: the affine part stands alone
}

export interface Header {
  format: string;
  version: number;
  scene: string;
  n: number;
  rays: number;
  crc32: number;
  camera: { eye: Vec3; forward: Vec3; right: Vec3; down: Vec3 };
  background: Vec3;
  lights: readonly { position: Vec3; colour: Vec3 }[];
  materials: readonly {
    ambient: Vec3; diffuse: Vec3; specular: Vec3;
    local: number; split: number; reflected: number; refracted: number; total: number;
    step: number;
  }[];
  patches: readonly Patch[];
  images: readonly { object: number; turn: number; step: number }[];
  tables: {
    signature: readonly (readonly number[])[];
    surface: readonly (readonly [number, number, number, number])[]; // patch, material, inside, sign
    visibility: readonly (readonly [number, number, number?])[]; // visibility, blocker, passed
  };
  steps: { normal: number; split: number; blocked: number };
  predictors: Readonly<Record<string, Readonly<Record<string, Predictor>>>>;
  columns: Readonly<Record<string, string>>;
}

export interface Expected {
  scene?: string;
  n?: number;
}

const FORMAT = "raywalk-trace";
const VERSION = 1;

/** The header, if this is an undamaged trace file of this version (and scene, and resolution). */
export function checkedHeader(json: unknown, expected: Expected): Header {
  const header = json as Header;
  if (typeof header !== "object" || header === null || header.format !== FORMAT) {
    throw new TraceError("not-a-trace", `"format" is not "${FORMAT}"`);
  }
  if (header.version !== VERSION) {
    throw new TraceError("version", `written as version ${header.version}, this reads ${VERSION}`);
  }
  for (const key of ["scene", "n"] as const) {
    if (expected[key] !== undefined && header[key] !== expected[key]) {
      throw new TraceError("scene", `holds ${key} ${header[key]}, not ${expected[key]}`);
    }
  }
  if (typeof header.columns !== "object" || header.columns === null) throw damaged("no columns");
  if (checksum(columnBytes(header)) !== header.crc32) {
    throw damaged("the columns' checksum does not match");
  }
  return header;
}

const asBytes = new WeakMap<object, Map<string, Uint8Array>>();

/** The columns' texts as bytes, in the order of their names: reading these is several times as fast. */
export function columnBytes({ columns }: Header): Map<string, Uint8Array> {
  const known = asBytes.get(columns);
  if (known) return known;
  const bytes = new Map<string, Uint8Array>();
  for (const name of Object.keys(columns).sort()) {
    if (typeof columns[name] !== "string") throw damaged(`column ${name} is no text`);
    bytes.set(name, encoder.encode(columns[name]));
  }
  asBytes.set(columns, bytes);
  return bytes;
}
const encoder = new TextEncoder();

/** One CRC-32 over all of them. */
function checksum(columns: Map<string, Uint8Array>): number {
  let crc = -1;
  for (const bytes of columns.values())
    for (let i = 0; i < bytes.length; i++) crc = CRC_TABLE[(crc ^ bytes[i]) & 255] ^ (crc >>> 8);
  return (crc ^ -1) >>> 0;
}

const CRC_TABLE = Int32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; bit++) rest = rest & 1 ? (rest >>> 1) ^ 0xedb88320 : rest >>> 1;
  return rest;
});
