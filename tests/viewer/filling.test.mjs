/** Filling takes three seconds at speed 1, whatever the grid and however slowly a machine draws. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, pass, richScene, state } from "./browser.mjs";
import { cases } from "./cases.mjs";

const SECONDS = 3;
const MOST = 1.2 * SECONDS;
const QUICK = 50; // ms a frame; that 60 and 120 a second show the same is rendering.test.mjs's
const SLOW = 500;
const STEP = 50; // ms between two looks
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** Seconds of the page's clock that filling takes. each: ms a frame. */
async function timeToFill(n, each) {
  const page = await newPage(browser, { held: true, viewport: { width: 480, height: 360 } });
  await open(page, ON_DISK, richScene().path, `gl=none&n=${n}`);
  await page.evaluate((each) => (window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), each)), each);
  await page.keyboard.press(" ");
  let ms = 0;
  for (; (await state(page)).tiles === "filling" && ms < 10_000; ms += STEP) await pass(page, STEP);
  assert.equal((await state(page)).tiles, "filled");
  assert.deepEqual(page.faults, []);
  await page.close();
  return ms / 1000;
}

for (const n of cases([5, 35], [35]))
  test(`${n} x ${n} tiles fill in ${SECONDS} s`, async () => {
    const took = await timeToFill(n, QUICK);
    assert.ok(Math.abs(took - SECONDS) <= (2 * STEP) / 1000, `${took} s`);
  });

for (const n of cases([5, 105], [105]))
  test(`with two frames a second ${n} x ${n} tiles fill in at most ${MOST} s`, async () => {
    const took = await timeToFill(n, SLOW);
    assert.ok(took >= SECONDS && took <= MOST, `${took} s`);
  });
