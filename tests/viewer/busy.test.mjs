/** A machine that draws slowly draws fewer pixels while time runs, says so, and draws all again when it can. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, pass, press, richScene, state } from "./browser.mjs";

const SLOW = 250; // ms a frame
const QUICK = 16;
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { held: true, sharp: true, viewport: { width: 640, height: 480 } });
});
after(() => browser.close());

const pixels = () => page.locator(".stage-view > canvas").evaluate((canvas) => canvas.width);
const note = () => page.locator(".busy-note").allInnerTexts();
/** The page's frames come so far apart. */
const frames = (ms) => page.evaluate((ms) => (window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), ms)), ms);

for (const how of ["", "gl=none&"])
  test(`slow frames halve the stage's pixels, quick ones bring them back, and so does the end (${how || "WebGL"})`, async () => {
    await open(page, ON_DISK, richScene().path, `${how}n=33&speed=0.25&look=plain`);
    const full = await pixels();
    await frames(SLOW);
    await press(page, " ");
    await pass(page, 6 * SLOW);
    assert.equal((await state(page)).tiles, "filling");
    assert.equal(await pixels(), full / 2);
    assert.deepEqual(await note(), ["drawn coarser: busy"]);
    assert.equal(await page.locator(".busy-note").getAttribute("role"), "status");
    await frames(QUICK);
    await pass(page, 60 * QUICK + SLOW);
    assert.equal((await state(page)).tiles, "filling");
    assert.equal(await pixels(), full);
    assert.deepEqual(await note(), []);
    await frames(SLOW);
    await pass(page, 6 * SLOW);
    assert.equal(await pixels(), full / 2);
    await press(page, " "); // to the end
    await pass(page, 2 * SLOW);
    assert.equal((await state(page)).tiles, "filled");
    assert.equal(await pixels(), full, "what stands still is drawn in full");
    assert.deepEqual(await note(), []);
  });

test("a single slow frame changes nothing", async () => {
  await open(page, ON_DISK, richScene().path, "gl=none&n=33&speed=0.25");
  const full = await pixels();
  await press(page, " ");
  await frames(SLOW);
  await pass(page, SLOW + 1);
  await frames(QUICK);
  await pass(page, 10 * QUICK + SLOW);
  assert.equal(await pixels(), full);
  assert.deepEqual(await note(), []);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
