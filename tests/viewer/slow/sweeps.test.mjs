/** Who moves something to and fro for an hour has a page that holds no more than after a minute. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, scenesOfSite } from "../browser.mjs";
import { countGpu, memoryOf } from "../memory.mjs";
import { readScene } from "../scene-files.mjs";

const PASSES = 20; // over all stops
const WARM = 3; // of them: all stops are decoded, and what draws them is compiled
/** Bytes of what is no typed array: a scene left behind at each stop would be 400 of them; what grows is code that the engine compiles. */
const SLACK = 2e6;
/** Bytes of typed arrays: less than one decoded stop at 33 x 33, of which a leak would leave at least one behind in each pass. */
const BUFFER_SLACK = 150_000;
const movers = scenesOfSite().map((scene) => ({ ...scene, ...readScene(scene.id) })).filter(({ id, of, sweeps }) => id === of && sweeps);
const count = ({ values, across }) => values.length * (across?.values.length ?? 1);
const [most] = movers.flatMap((scene) => scene.sweeps.map((sweep) => ({ scene, sweep, stops: count(sweep) }))).sort((a, b) => b.stops - a.stops);
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 640, height: 480 } });
  await page.addInitScript(countGpu);
});
after(() => browser.close());

/** To and fro through all stops, each drawn. */
const passes = (times) =>
  page.evaluate(async ([times, stops]) => {
    const frame = () => new Promise(requestAnimationFrame);
    for (let k = 0; k < times; k++)
      for (let stop = 1; stop < stops; stop++) {
        const before = window.raywalk.state().sweep;
        document.body.dispatchEvent(new KeyboardEvent("keydown", { key: k % 2 ? "<" : ">", bubbles: true }));
        while (window.raywalk.state().sweep === before || window.raywalk.stats().tiles.length === 0) await frame();
        await frame();
      }
    await new Promise((done) => setTimeout(done, 500)); // it has glided there, and is written into the address
    return { ...window.gpuHeld };
  }, [times, most.stops]);

test(`after ${PASSES} passes over all ${most?.stops} stops the page holds what it held after ${WARM}`, async () => {
  await open(page, ON_DISK, most.scene.path, `sweep=${most.sweep.id}:1&tiles=filled&n=33`);
  const memory = await memoryOf(page);
  const gpu = await passes(WARM + 1); // an even number: at the first stop again
  const { heap, buffers, nodes } = await memory.measure();
  const after = await passes(PASSES - WARM - 1);
  const now = await memory.measure();
  console.log(`heap ${heap} + ${now.heap - heap}, buffers ${buffers} + ${now.buffers - buffers}, nodes ${nodes} + ${now.nodes - nodes}`);
  assert.ok(now.heap - heap < SLACK, `${now.heap - heap} bytes more`);
  assert.ok(now.buffers - buffers < BUFFER_SLACK, `${now.buffers - buffers} bytes of typed arrays more`);
  assert.ok(now.nodes - nodes < 20, `${now.nodes - nodes} nodes more`);
  assert.deepEqual(after, gpu);
  assert.deepEqual(page.faults, []);
});
