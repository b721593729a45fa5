/** Time: the selector blinks, except where it must not; nothing is drawn that need not be. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { atRest, launch, newPage, ON_DISK, open, pass, pictureOf, press, richScene, scenesOfSite, stats, until, workOf } from "./browser.mjs";

const rich = richScene();
const FLAT = "gl=none"; // when it is drawn does not depend on what draws it
let browser, page, held;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 800, height: 600 } }); // quickly drawn
  held = await newPage(browser, { held: true });
});
after(() => browser.close());
/** Drawn while so much time passes. */
async function framesIn(ms) {
  const { frames } = await stats(held);
  await pass(held, ms);
  return (await stats(held)).frames - frames;
}

test("the selector blinks: two frames in 1.1 seconds are drawn, no more", async () => {
  await open(held, ON_DISK, rich.path, FLAT);
  await pass(held, 10_000); // parts come while nobody does anything, and are drawn
  await held.evaluate(() => window.raywalk.whole);
  await pass(held, 10_000);
  await press(held, "ArrowRight"); // blinks anew from here on
  assert.equal(await framesIn(1100), 2);
});

test("it stops before five seconds are over, lit, and blinks anew when something changes", async () => {
  assert.equal(await framesIn(3900), 6, "eight changes in all: lit, as it was");
  assert.equal(await framesIn(10_000), 0);
  await press(held, "ArrowRight");
  assert.equal(await framesIn(1100), 2);
});

for (const [name, hash, motion] of [["still=1", `${FLAT}&still=1`, null], ["reduced motion", FLAT, "reduce"]])
  test(`with ${name} nothing is drawn while nothing happens`, async () => {
    await held.emulateMedia({ reducedMotion: motion });
    await open(held, ON_DISK, rich.path, hash);
    await atRest(held);
    assert.equal(await framesIn(60_000), 0);
    await held.emulateMedia({ reducedMotion: null });
  });

test("with still=1 two pictures of the same state are the same, pixel by pixel", async () => {
  const shot = async () => {
    await open(page, ON_DISK, rich.path, "still=1&tiles=filled&rays=pixel,row");
    await page.evaluate(() => window.raywalk.whole);
    return (await pictureOf(page)).data;
  };
  assert.ok((await shot()).equals(await shot()));
});

const AT_ONCE = 6; // frames' work; it was 2.2 to 2.7

test("a scene or grid that is loaded already shows its filled plane after a few frames' work", async (t) => {
  await open(page, ON_DISK, rich.path, "still=1&tiles=filled");
  const other = scenesOfSite().find((scene) => scene.key && scene.id !== rich.id);
  const work = await workOf(page);
  const change = async (key) => {
    const { shown } = await stats(page);
    await page.keyboard.press(key);
    await until(page, (s, t, before) => JSON.stringify(t.shown) !== before && t.shown.scene === s.scene && t.shown.n === s.n && t.shown.tiles === s.n * s.n, JSON.stringify(shown));
  };
  const keys = [other.key, rich.key, "+", "-"];
  for (const key of keys) await change(key); // now they are loaded
  const frame = await workOfFrame(page, work);
  for (const key of keys) {
    await atRest(page);
    const before = await work();
    await change(key);
    const took = (await work()) - before;
    t.diagnostic(`key ${key}: ${(took / frame).toFixed(1)} frames' work`);
    assert.ok(took <= AT_ONCE * frame, `key ${key}: ${took} ms, a frame ${frame} ms`);
  }
});

/** ms of work for a frame in which nothing changed. */
async function workOfFrame(page, work) {
  await atRest(page);
  const before = await work();
  const FRAMES = 10;
  for (let k = 0; k < FRAMES; k++) await press(page, "r"); // draws what is there
  return ((await work()) - before) / FRAMES;
}

test("nothing was said in the console", () => assert.deepEqual([page.faults, held.faults], [[], []]));
