/** Fingers: one turns or scrubs, two move and pinch, and the page still scrolls elsewhere. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, pass, reach, richScene, settled, state, stats, tileOnPage } from "./browser.mjs";
import { handOf } from "./hand.mjs";

const rich = richScene();
const FLAT = "still=1&gl=none"; // fingers are the same on both stages
const SAID_FOR = 3500; // ms
let browser, page, glass;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, held: true });
  glass = await handOf(page);
});
after(() => browser.close());

/** fingers: for each moment a list of [x, y]. */
async function touch(...moments) {
  for (const [k, points] of moments.entries()) await glass(k ? "touchMove" : "touchStart", points);
  await glass("touchEnd");
  await settled(page);
}

async function stageBox() {
  await page.locator(".stage-view").scrollIntoViewIfNeeded();
  return page.locator(".stage-view").boundingBox();
}

test("one finger beside the tiles turns the view", async () => {
  await open(page, ON_DISK, rich.path, FLAT);
  const box = await stageBox();
  const before = await stats(page);
  await touch([[box.x + 40, box.y + 30]], [[box.x + 90, box.y + 40]], [[box.x + 140, box.y + 50]]);
  const now = await stats(page);
  assert.notDeepEqual(now.eye, before.eye);
  assert.ok(Math.abs(reach(now) - reach(before)) < 1e-9);
});

test("two fingers move the view, and pinching zooms", async () => {
  const box = await stageBox();
  const before = await stats(page);
  const [x, y] = [box.x + 190, box.y + 60];
  await touch([[x - 20, y], [x + 20, y]], [[x - 60, y + 20], [x + 60, y + 20]]);
  const now = await stats(page);
  assert.ok(reach(now) < 0.7 * reach(before), "spreading comes nearer");
  assert.notDeepEqual(now.target, before.target);
});

test("one finger on a tile selects it, and on the picture too", async () => {
  await open(page, ON_DISK, rich.path, `${FLAT}&n=5&cam=camera`);
  await stageBox();
  const tile = await tileOnPage(page, 3, 1);
  await touch([[tile.x, tile.y]]);
  assert.deepEqual((await state(page)).pixel, [3, 1]);
  await page.locator(".marks").scrollIntoViewIfNeeded();
  const picture = await page.locator(".marks").boundingBox();
  await touch([[picture.x + 0.1 * picture.width, picture.y + 0.9 * picture.height]]);
  assert.deepEqual((await state(page)).pixel, [0, 4]);
});

const scrolled = () => page.evaluate(() => scrollY);
/** A finger that moves on the stage in small steps, after it has rested so long. */
async function swipe([x, y], [dx, dy], rest = 0) {
  await glass("touchStart", [[x, y]]);
  await pass(page, rest);
  for (let k = 1; k <= 10; k++) await glass("touchMove", [[x + (k / 10) * dx, y + (k / 10) * dy]]);
  await glass("touchEnd");
  await settled(page);
}

test("a swipe up the stage scrolls the page, turns nothing, picks nothing, and that is said once", async () => {
  await open(page, ON_DISK, rich.path, `${FLAT}&n=5&cam=camera`);
  await page.evaluate(() => (localStorage.clear(), scrollTo(0, 0)));
  const before = await state(page);
  const tile = await tileOnPage(page, 3, 3);
  const said = () => page.locator(".done-sentence").innerText();
  await swipe([tile.x, tile.y], [0, -150]);
  await page.waitForFunction(() => scrollY > 60);
  await page.waitForFunction(() => /swipe scrolls the page/.test(document.querySelector(".done-sentence").textContent));
  assert.deepEqual(await state(page), before);
  await pass(page, SAID_FOR);
  assert.equal(await said(), "");
  const at = await scrolled();
  await swipe([tile.x, tile.y - 100], [0, 150]);
  await page.waitForFunction((at) => scrollY < at, at);
  assert.equal(await said(), "", "not a second time");
});

test("a finger that has rested turns the view wherever it goes, and so does one that goes sideways; the page keeps still", async () => {
  for (const [way, rest] of [[[0, -120], 600], [[120, 0], 0]]) {
    await open(page, ON_DISK, rich.path, FLAT);
    await page.evaluate(() => scrollTo(0, 0));
    const box = await stageBox();
    const before = await stats(page);
    await swipe([box.x + 40, box.y + 200], way, rest);
    assert.notDeepEqual((await stats(page)).eye, before.eye, way.join());
    assert.ok(Math.abs(reach(await stats(page)) - reach(before)) < 1e-9);
    assert.equal(await scrolled(), 0);
  }
});

test("two fingers that go up together move the view and not the page", async () => {
  await open(page, ON_DISK, rich.path, FLAT);
  await page.evaluate(() => scrollTo(0, 0));
  const before = await stats(page);
  await touch(...Array.from({ length: 10 }, (_, k) => [[60, 330 - 12 * k], [120, 330 - 12 * k]]));
  assert.notDeepEqual((await stats(page)).target, before.target);
  assert.equal(await scrolled(), 0);
});

test("the page scrolls when the finger is on the card", async () => {
  const head = await page.locator(".card").boundingBox();
  assert.equal(await page.locator(".card").evaluate((e) => getComputedStyle(e).touchAction), "auto");
  assert.ok(head.height >= 44);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
