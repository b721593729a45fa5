/** A phone's page scrolls under the stage: what a finger asks for comes into sight, and a swipe is the page's. */
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { keyedScenes, launch, newPage, ON_DISK, open, settled, state, until } from "./browser.mjs";
import { handOf } from "./hand.mjs";

const { path } = keyedScenes()[1];
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
let browser, page;
before(async () => (browser = await launch()));
after(() => browser.close());
afterEach(async () => {
  assert.deepEqual(page.faults, []);
  await page.close();
});

async function phone(hash, options = {}) {
  page = await newPage(browser, { ...PHONE, ...options });
  await open(page, ON_DISK, path, `gl=none${hash}`);
}
const scrolled = () => page.evaluate(() => scrollY);
const scrollTo = async (y) => {
  await page.evaluate((y) => scrollTo(0, y), y);
  await settled(page);
};
/** Its upper edge below the stage's lower one, CSS pixels. */
const underStage = (part) => page.evaluate((part) => document.querySelector(part).getBoundingClientRect().top - document.querySelector(".stage").getBoundingClientRect().bottom, part);

test("a lesson begun from further down the page has its text in sight, and so has each of its steps", async () => {
  await phone("");
  await scrollTo(400);
  await page.keyboard.press("PageDown");
  for (const step of [0, 1]) {
    await until(page, (state, _, step) => state.step === step, step);
    await page.waitForFunction(() => document.querySelector(".lesson").getBoundingClientRect().top >= document.querySelector(".stage").getBoundingClientRect().bottom - 1);
    await scrollTo(400);
    await page.keyboard.press("PageDown");
  }
  await settled(page);
});

test("a step whose text is in sight leaves the page where it is", async () => {
  await phone("");
  await page.keyboard.press("PageDown");
  await until(page, (state) => state.step === 0);
  await settled(page);
  assert.equal(await scrolled(), 0);
});

test("a tab that is opened by a finger comes up under the stage, without a glide where motion is reduced", async () => {
  await phone("", { reducedMotion: "reduce" });
  for (const tab of ["rays", "tree"]) {
    await page.locator(`#tab-card-${tab}`).tap();
    await until(page, (state, _, tab) => state.tab === tab, tab);
    await settled(page);
    const away = await underStage(".tabs");
    const isAtEnd = await page.evaluate(() => scrollY >= document.documentElement.scrollHeight - innerHeight - 1); // a short panel is seen whole
    assert.ok(away >= -1 && (away <= 2 || isAtEnd), `${tab}: ${away} px below the stage`);
    await scrollTo(100);
  }
  await page.locator("#tab-card-tree").evaluate((tab) => tab.click()); // closes it; a tap would scroll there first
  await until(page, (state) => state.tab === "none");
  await settled(page);
  assert.equal(await scrolled(), 100);
});

test("a tab that a link opens leaves the page at its top", async () => {
  await phone("&tab=rays");
  assert.equal(await scrolled(), 0);
});

test("a swipe up that begins on the time slider scrolls the page; along the slider and a tap move it", async () => {
  await phone("&e=2");
  const glass = await handOf(page);
  const box = await page.locator(".scrub").boundingBox();
  const [x, y] = [box.x + 0.9 * box.width, box.y + box.height / 2];
  const swipe = async (across, down) => {
    await glass("touchStart", [[x, y]]);
    for (let k = 1; k <= 10; k++) await glass("touchMove", [[x + (across * k) / 10, y + (down * k) / 10]]);
    await glass("touchEnd");
    await settled(page);
  };
  const { event } = await state(page);
  await swipe(3, -200);
  await page.waitForFunction(() => scrollY > 0);
  assert.equal((await state(page)).event, event);
  await scrollTo(0);
  await settled(page);
  await swipe(-0.6 * box.width, 4);
  assert.ok((await state(page)).event < 3, "it has followed the finger");
  await glass("touchStart", [[x, y]]);
  assert.ok((await state(page)).event < 3, "a finger that has just come down may yet mean the page");
  await glass("touchEnd");
  await until(page, (state) => state.event >= 3);
});
