/** The lesson of scene 2 by touch alone, on a phone: fingers on the glass, no key, no mouse. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, keyedScenes, settled, state, stats, until } from "./browser.mjs";
import { handOf } from "./hand.mjs";
import { readScene } from "./scene-files.mjs";

const { id, path } = keyedScenes()[1];
const { lesson } = readScene(id);
let browser, page, glass;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.addInitScript(() => {
    window.others = 0;
    addEventListener("keydown", () => window.others++, true);
    addEventListener("pointerdown", (event) => (window.others += event.pointerType !== "touch"), true);
  });
  glass = await handOf(page);
});
after(() => browser.close());

async function tap(x, y) {
  await glass("touchStart", [[x, y]]);
  await glass("touchEnd");
  await settled(page);
}
async function drag(...points) {
  for (const [k, point] of points.entries()) await glass(k ? "touchMove" : "touchStart", [point]);
  await glass("touchEnd");
  await settled(page);
}
/** Scrolls there as a finger does, on what may be scrolled, and taps its middle. */
async function tapOn(locator) {
  for (let k = 0; k < 30; k++) {
    const box = await locator.boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const isFree = await locator.evaluate((at, [x, y]) => at.contains(document.elementFromPoint(x, y)), [x, y]);
    if (isFree && y > 0 && y < 844) {
      assert.ok(box.width >= 44 && box.height >= 44, `${box.width} x ${box.height} is large enough for a finger`);
      return tap(x, y);
    }
    // To the middle of what the stage leaves free: under it nothing can be touched. On the page's edge, which no part takes for itself.
    const by = Math.max(-300, Math.min(300, 640 - y));
    await drag([4, 422 - by / 2], [4, 422 - by / 4], [4, 422], [4, 422 + by / 4], [4, 422 + by / 2]);
    await page.evaluate(async () => {
      let at;
      do {
        at = scrollY;
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      } while (at !== scrollY);
    });
  }
  assert.fail("never came to the finger");
}
const button = (name) => page.getByRole("button", { name });
// Up to a formula, whose letters browsers change to those of mathematics.
const words = (html) => html.replace(/<math.*/s, "").replace(/<[^>]+>/g, "").replace(/&[^;]+;/g, "").replace(/\s+/g, " ").trim();
const fits = async (step, revealed) => {
  // A tap becomes a click a moment after the finger has left.
  await until(page, (now, _, [step, revealed]) => now.step === step && now.revealed === revealed, [step, revealed]);
  await settled(page);
  const now = await state(page);
  assert.deepEqual([now.step, now.revealed], [step, revealed]);
  const stop = revealed ? lesson[step].answer : lesson[step];
  assert.ok((await page.locator(".lesson-text").innerText()).replace(/\s+/g, " ").trim().startsWith(words(stop.html).slice(0, 50)), `step ${step + 1} is shown`);
};

test(`${id} by touch alone: ${lesson.length} steps, each question revealed, the view turned and a pixel picked`, async () => {
  await open(page, ON_DISK, path, "gl=none"); // the flat stage: fingers are the same on both
  await tapOn(button("Start the lesson"));
  for (const [step, { answer, choices }] of lesson.entries()) {
    await fits(step, false);
    if (answer) {
      if (choices) await tapOn(page.getByRole("radio").nth(step % choices.length));
      await tapOn(button("Reveal the answer"));
      await fits(step, true);
    }
    if (step < lesson.length - 1) await tapOn(button("Next step"));
  }
  await tapOn(button("Previous step"));
  await tapOn(button("End the lesson"));
  await until(page, ({ step }) => step === null);

  const picture = page.locator(".marks");
  await picture.evaluate((at) => at.scrollIntoView({ block: "center" }));
  const box = await picture.boundingBox();
  await tap(box.x + 0.1 * box.width, box.y + 0.9 * box.height);
  const { pixel, n } = await state(page);
  assert.deepEqual(pixel, [Math.floor(0.1 * n), Math.floor(0.9 * n)]);
  const stage = page.locator(".stage-view");
  await stage.evaluate((at) => at.scrollIntoView({ block: "center" }));
  const view = await stage.boundingBox();
  const before = (await stats(page)).eye;
  await drag([view.x + 30, view.y + 30], [view.x + 60, view.y + 35], [view.x + 120, view.y + 40]);
  assert.notDeepEqual((await stats(page)).eye, before);
  assert.equal(await page.evaluate(() => window.others), 0, "no key, no mouse");
  assert.deepEqual(page.faults, []);
});
