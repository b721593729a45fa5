/** node decode-time.mjs FILE.json.gz ... : milliseconds to decode each in a process of its own: the first
 *  time, and the best and the middle of 25. JSON.parse counts, unzipping does not. */
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";
import { loadDecoder } from "./bundle.mjs";
import { best, decodingTimes, middle } from "./times.mjs";

const [first, ...others] = process.argv.slice(2);
if (others.length) for (const file of [first, ...others]) spawnSync(process.execPath, [fileURLToPath(import.meta.url), file], { stdio: "inherit" });
else {
  const { count, times } = await decodingTimes(await loadDecoder(), gunzipSync(readFileSync(first)).toString(), 25);
  const written = Object.entries(times).map(([name, each]) => `${name} ${each[0].toFixed(1)} ${best(each).toFixed(1)} ${middle(each).toFixed(1)}`);
  console.log(`${first}: ${count} rays; first, best, middle: ${written.join(", ")} ms`);
}
