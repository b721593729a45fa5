/** node decode-time.mjs FILE.json.gz ... : milliseconds to unpack and to decode, best and middle of 15. */
import { readFileSync } from "node:fs";
import { loadDecoder } from "./bundle.mjs";

const { decode, unpack } = await loadDecoder();
for (const file of process.argv.slice(2)) {
  const text = readFileSync(file).toString("base64");
  const [unpacking, decoding] = [[], []];
  let trace;
  for (let k = 0; k < 15; k++) {
    const start = performance.now();
    const json = await unpack(text);
    const middle = performance.now();
    trace = decode(json);
    unpacking.push(middle - start);
    decoding.push(performance.now() - middle);
  }
  const told = (times) => `first ${times[0].toFixed(1)}, best ${Math.min(...times).toFixed(1)}, middle ${times.sort((a, b) => a - b)[7].toFixed(1)}`;
  console.log(`${file}: ${trace.count} rays, unpack ${told(unpacking)}, decode ${told(decoding)} ms`);
}
