/** Whatever is pressed, dragged, resized or linked: no error, a state that makes sense, and a way back to the start. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { DIST, launch, newPage, open, richScene, scenesOfSite, state } from "./browser.mjs";
import { monkey, reset, tame } from "./monkey.mjs";
import { serve } from "./server.mjs";

// `make stress` asks for 20,000 and takes another seed each time.
const INPUTS = Number(process.env.RAYWALK_MONKEY_INPUTS ?? 500);
const SEED = Number(process.env.RAYWALK_SEED ?? 20_260);
const scenes = scenesOfSite().map(({ id }) => id);
const { path } = richScene();
let browser, server;
before(async () => {
  // Without the flag Chromium drops links that follow one another this fast, and says so in the console.
  [browser, server] = await Promise.all([launch(["--disable-ipc-flooding-protection"]), serve(DIST)]);
});
after(async () => {
  await browser.close();
  server.close();
});

for (const [stage, share] of [["gl=none", 0.75], ["", 0.25]])
  test(`${INPUTS * share} random inputs, seed ${SEED}, ${stage || "WebGL"}: no error, every state sound, and the start comes back`, async () => {
    const page = await newPage(browser);
    await page.addInitScript(tame);
    await open(page, server.url, `${path}${stage && `?${stage}`}`);
    const start = await state(page);
    await monkey(page, { seed: SEED, inputs: INPUTS * share, scenes });
    await reset(page, `${server.url}${path}${stage && `?${stage}`}`);
    assert.deepEqual(await state(page), start);
    assert.deepEqual(page.faults, []);
    await page.close();
  });
