/** node same-numbers.mjs OLD-CHECKOUT OLD-DIST NEW-DIST: after a change of the trace format, whether every file of
 *  the new site decodes to the numbers that its forerunner decodes to with the old decoder, bit by bit. */
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { gunzipSync } from "node:zlib";
import { loadDecoder } from "./bundle.mjs";

const [checkout, ...sites] = process.argv.slice(2).map((path) => resolve(path));
const old = await import(pathToFileURL(`${checkout}/tests/viewer/trace/bundle.mjs`));
const decoders = [await old.loadDecoder(), await loadDecoder()];
/** As float64, whatever holds the column. */
const bits = (column) => (ArrayBuffer.isView(column) ? Buffer.from(Float64Array.from(column).buffer).toString("base64") : String(column));

let files = 0, columns = 0;
for (const scene of readdirSync(`${sites[1]}/scenes`)) {
  for (const file of readdirSync(`${sites[1]}/scenes/${scene}`)) {
    if (!file.endsWith(".json.gz") || !existsSync(`${sites[0]}/scenes/${scene}/${file}`)) continue;
    const [before, after] = decoders.map(({ decode }, k) => decode(JSON.parse(gunzipSync(readFileSync(`${sites[k]}/scenes/${scene}/${file}`)).toString())));
    for (const name of new Set([...Object.keys(before), ...Object.keys(after)])) {
      columns++;
      if (bits(before[name]) === bits(after[name])) continue;
      console.log(`${scene}/${file}: column ${name} differs`);
      process.exitCode = 1;
    }
    files++;
  }
}
console.log(`${files} files, ${columns} columns compared`);
if (files === 0) process.exitCode = 1;
