/**
 * node columns-as-bytes.mjs FILE.json.gz ... : for each file a line of JSON with every column of
 * the decoded Trace as base64 of its bytes, for the Python side to compare with its own.
 */
import { readFileSync } from "node:fs";
import { loadDecoder } from "./bundle.mjs";

const { decode, unpack } = await loadDecoder();
for (const file of process.argv.slice(2)) {
  const trace = decode(await unpack(readFileSync(file).toString("base64")));
  const columns = Object.entries(trace).filter(([, column]) => ArrayBuffer.isView(column));
  const bytes = columns.map(([name, column]) => [
    name,
    { type: column.constructor.name, base64: Buffer.from(column.buffer, column.byteOffset, column.byteLength).toString("base64") },
  ]);
  console.log(JSON.stringify(Object.fromEntries(bytes)));
}
