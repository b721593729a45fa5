/** A kiosk that nobody touches: lesson after lesson, round after round, and what the page holds does not grow. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, scenesOfSite } from "./browser.mjs";
import { countGpu, memoryOf } from "./memory.mjs";

const scenes = scenesOfSite();
// `make stress` asks for 2,000 cycles or half an hour, with tiles that fill and rays that grow. A cycle is a lesson.
const CYCLES = Number(process.env.RAYWALK_SOAK_CYCLES ?? 3 * scenes.length);
const MINUTES = Number(process.env.RAYWALK_SOAK_MINUTES ?? 2);
const MOVING = !!process.env.RAYWALK_SOAK_CYCLES;
/** A round's heap differs by what the engine compiles and the page keeps of its last scenes: bytes. */
const HEAP_SLACK = 1.5e6;
/** Of averages: how long each scene is looked at differs from round to round. */
const GPU_SLACK = 1.1;
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 640, height: 480 } });
  await page.addInitScript(countGpu);
});
after(() => browser.close());

/** Until so many lessons have been shown: what the graphics card held meanwhile, on average, and how many there were. */
const shown = (cycles, end) =>
  page.evaluate(
    async ([cycles, end]) => {
      const sum = {};
      let [at, times] = [0, 0];
      while ((at = window.raywalk.stats().kiosk.cycles) < cycles && Date.now() < end) {
        for (const [kind, held] of Object.entries(window.gpuHeld)) sum[kind] = (sum[kind] ?? 0) + held;
        times++;
        await new Promise((done) => setTimeout(done, 10));
      }
      return { cycles: at, held: Object.fromEntries(Object.entries(sum).map(([kind, all]) => [kind, Math.round((10 * all) / times) / 10])) };
    },
    [cycles, end],
  );

test(`${CYCLES} lessons shown unattended: heap, nodes, listeners, buffers, textures and programs stay as they are`, async () => {
  const start = Date.now();
  const end = start + 60_000 * MINUTES;
  await open(page, ON_DISK, scenes[0].path, `kiosk=1&attract-pace=0.02${MOVING ? "" : "&still=1"}`);
  await page.waitForFunction(() => window.raywalk.stats().kiosk?.attract);
  const measure = await memoryOf(page);
  const rounds = [];
  for (let target = scenes.length; target <= CYCLES && Date.now() < end; target += scenes.length) {
    const { cycles, held } = await shown(target, end);
    if (cycles >= target) rounds.push({ ...(await measure()), gpu: held, cycles });
  }
  const [first, ...later] = rounds.slice(1); // in the first round everything is loaded and compiled
  const last = later.at(-1);
  const told = { cycles: last.cycles, seconds: Math.round((Date.now() - start) / 1000), heap: [first.heap, last.heap], nodes: [first.nodes, last.nodes], listeners: [first.listeners, last.listeners], gpu: [first.gpu, last.gpu], faults: page.faults.length };
  console.log(`soak ${JSON.stringify(told)}`);
  for (const round of later) {
    for (const [kind, held] of Object.entries(round.gpu)) assert.ok(held <= GPU_SLACK * first.gpu[kind] + 2, `${kind}: ${first.gpu[kind]}, after ${round.cycles} lessons ${held}`);
    // A round may end one scene further: its card and lesson hold so many more. The long run sees the trend.
    for (const [what, apart] of Object.entries({ nodes: 800, listeners: 300, documents: 100 })) assert.ok(round[what] <= 1.1 * first[what] + apart, `${what}: ${first[what]}, after ${round.cycles} lessons ${round[what]}`);
    assert.ok(round.heap <= first.heap + HEAP_SLACK, `heap: ${first.heap}, after ${round.cycles} lessons ${round.heap}`);
  }
  assert.deepEqual(page.faults, []);
});
