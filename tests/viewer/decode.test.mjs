/** How long a trace takes to decode in the browser, at the finest grid of every scene. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { DIST, launch, newPage, scenesOfSite } from "./browser.mjs";

const TRACE = fileURLToPath(new URL("../../site_src/viewer/trace/", import.meta.url));
const FINEST = 105;
let browser, page;

before(async () => {
  const contents = 'export * from "./decode"; export * from "./unpack";';
  const bundle = await build({ stdin: { contents, resolveDir: TRACE, loader: "ts" }, bundle: true, write: false, format: "iife", globalName: "decoder" });
  browser = await launch();
  page = await newPage(browser);
  await page.goto("about:blank");
  await page.addScriptTag({ content: bundle.outputFiles[0].text });
});
after(() => browser.close());

// An absolute time decides nothing: the floor is the browser's own unpacking and parsing of the
// same text, in the same run. Measured ratios are 5 to 9; a decoder that went quadratic would
// be hundreds.
for (const { id } of scenesOfSite()) {
  test(`${id} at ${FINEST} x ${FINEST} decodes within 20 times the floor of unzipping its text`, async (t) => {
    const base64 = readFileSync(`${DIST}/scenes/${id}/${FINEST}.json.gz`).toString("base64");
    const { count, floor, best, middle } = await page.evaluate(async (text) => {
      const { decode, unpack } = window.decoder;
      const floors = [], times = [];
      let trace;
      for (let k = 0; k < 9; k++) {
        const start = performance.now();
        const json = await unpack(text);
        const unpacked = performance.now();
        trace = decode(json);
        floors.push(unpacked - start);
        times.push(performance.now() - unpacked);
      }
      times.sort((a, b) => a - b);
      return { count: trace.count, floor: Math.min(...floors), best: times[0], middle: times[4] };
    }, base64);
    t.diagnostic(`${id}: ${count} rays, decode best ${best.toFixed(1)} ms, middle ${middle.toFixed(1)} ms, floor ${floor.toFixed(1)} ms`);
    assert.ok(count >= FINEST * FINEST);
    assert.ok(best <= 20 * floor, `${best} ms against a floor of ${floor} ms`);
  });
}
