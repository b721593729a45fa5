/** Lesson after lesson, scene after scene, for as long as a kiosk runs: what the page holds does not grow. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { DIST, launch, newPage, open, press, scenesOfSite, until } from "./browser.mjs";
import { countGpu, memoryOf } from "./memory.mjs";
import { serve } from "./server.mjs";

// `make stress` asks for 2,000, or as many as half an hour takes.
const CYCLES = Number(process.env.RAYWALK_SOAK_CYCLES ?? 36);
const MINUTES = Number(process.env.RAYWALK_SOAK_MINUTES ?? 30);
const SCENES = scenesOfSite().slice(0, 6); // more than are kept at hand, so that each round drops some
/** A round's heap may differ by what the browser's own caches do (compiled code, fonts, pictures): bytes. */
const HEAP_SLACK = 1.5e6;
let browser, server, page;
before(async () => {
  [browser, server] = await Promise.all([launch(["--js-flags=--expose-gc"]), serve(DIST)]);
  page = await newPage(browser, { viewport: { width: 800, height: 600 } });
  await page.addInitScript(countGpu);
});
after(async () => {
  await browser.close();
  server.close();
});

/** A cycle: a scene's lesson begins, and its first stops are shown. */
async function cycle(k) {
  const { id } = SCENES[k % SCENES.length];
  await page.locator(`nav.scenes a[data-scene="${id}"]`).click();
  await until(page, (s, t, id) => t.shown.scene === id && t.tiles.length > 0, id);
  if (await page.getByRole("button", { name: "Start the lesson" }).isVisible()) await page.getByRole("button", { name: "Start the lesson" }).click();
  await press(page, " ", ".", ".", "+");
  await until(page, (s, t) => t.tiles.length === 3 * s.n * s.n);
}

test(`${CYCLES} cycles over ${SCENES.length} scenes: heap, nodes, listeners, buffers, textures and programs stay as they are`, async () => {
  await open(page, server.url, SCENES[1].path, "still=1");
  const measure = await memoryOf(page);
  const rounds = [];
  const end = Date.now() + 60_000 * MINUTES;
  for (let k = 0; k < CYCLES && Date.now() < end; k++) {
    await cycle(k);
    if (k % SCENES.length === SCENES.length - 1) rounds.push(await measure());
  }
  const settledAt = Math.min(2, rounds.length - 2); // by then everything that is kept is there
  const [first, ...later] = rounds.slice(settledAt);
  console.log(`  ${CYCLES} cycles, ${rounds.length} rounds; heap ${rounds.map(({ heap }) => (heap / 1e6).toFixed(1)).join(" ")} MB; gpu ${JSON.stringify(rounds.at(-1).gpu)}`);
  for (const round of later) {
    assert.deepEqual(round.gpu, first.gpu, "the graphics card keeps as much");
    for (const what of ["nodes", "listeners", "documents"]) assert.ok(round[what] <= 1.02 * first[what], `${what}: ${first[what]}, then ${round[what]}`);
    assert.ok(round.heap <= first.heap + HEAP_SLACK, `heap: ${first.heap}, then ${round.heap}`);
  }
  assert.deepEqual(page.faults, []);
});
