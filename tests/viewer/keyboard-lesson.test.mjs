/** The lesson of scene 2 by keyboard alone: pressed keys, no pointer, and always to be seen where one is. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, keyedScenes, settled, state, until } from "./browser.mjs";
import { readScene } from "./scene-files.mjs";

const { id, path } = keyedScenes()[1];
const { lesson } = readScene(id);
const MOST_TABS = 60; // from one thing to another
const TO_START = 6; // Tabs from the top of the page to the lesson
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
  await page.addInitScript(() => {
    window.pointed = 0;
    for (const kind of ["pointerdown", "touchstart", "mousedown"]) addEventListener(kind, () => window.pointed++, true);
  });
});
after(() => browser.close());

/** What has the focus: its name, and whether one sees that it has. */
const focused = () =>
  page.evaluate(() => {
    const at = document.activeElement;
    const box = at.getBoundingClientRect();
    const { outlineStyle, outlineWidth } = getComputedStyle(at);
    const top = document.elementFromPoint(Math.min(innerWidth - 1, Math.max(0, box.x + box.width / 2)), Math.min(innerHeight - 1, Math.max(0, box.y + box.height / 2)));
    return {
      name: at.getAttribute("aria-label") ?? at.textContent.trim(),
      outlined: outlineStyle !== "none" && parseFloat(outlineWidth) >= 2,
      onTop: !!top && (at.contains(top) || top.contains(at)),
    };
  });

async function tabTo(name, most = MOST_TABS) {
  for (let k = 0; k < most; k++) {
    await page.keyboard.press("Tab");
    const now = await focused();
    if (!now.name.includes(name)) continue;
    assert.ok(now.outlined && now.onTop, `${name}: its focus is seen`);
    return;
  }
  assert.fail(`no Tab leads to ${name}`);
}

// Up to a formula, whose letters browsers change to those of mathematics.
const words = (html) => html.replace(/<math.*/s, "").replace(/<[^>]+>/g, "").replace(/&[^;]+;/g, "").replace(/\s+/g, " ").trim();
const shown = async () => words(await page.locator(".lesson-text").innerText());
const fits = async (step, revealed) => {
  await settled(page);
  await until(page, (s, t) => t.shown.n === s.n); // another grid comes with its rays, and with them the step's text
  const now = await state(page);
  assert.deepEqual([now.step, now.revealed], [step, revealed]);
  const stop = revealed ? lesson[step].answer : lesson[step];
  assert.ok((await shown()).startsWith(words(stop.html).slice(0, 50)), `step ${step + 1} is shown`);
};

test(`${id} by keyboard alone: from the address to the last answer, ${lesson.length} steps, each question revealed`, async () => {
  await open(page, ON_DISK, path, "gl=none"); // the flat stage: keys are the same on both
  await tabTo("Start the lesson", TO_START);
  await page.keyboard.press("Enter");
  await fits(0, false);
  assert.match((await focused()).name, /Next step/, "the focus goes on to the lesson");
  assert.ok((await focused()).outlined, "and is seen there");
  for (const [step, { answer, choices }] of lesson.entries()) {
    await fits(step, false);
    if (choices) {
      // The focus has gone on to the choices: arrows choose, and Enter on what is chosen reveals.
      assert.match((await focused()).name, /^A/);
      for (let k = 0; k <= step % choices.length; k++) await page.keyboard.press("ArrowDown");
      assert.ok((await focused()).outlined, "it is seen which one has the focus");
      await fits(step, false);
      await page.keyboard.press("Enter");
      await fits(step, true);
      assert.match((await focused()).name, step < lesson.length - 1 ? /Next step/ : /On to the next scene's lesson/, "the focus goes on");
    } else if (answer) {
      // The button stands before Next: one goes back to it, and from it on to Next by itself.
      for (let k = 0; k < 5 && !(await focused()).name.includes("Reveal"); k++) await page.keyboard.press("Shift+Tab");
      assert.match((await focused()).name, /Reveal the answer/);
      await page.keyboard.press(step % 2 ? "Enter" : " ");
      await fits(step, true);
      assert.match((await focused()).name, step < lesson.length - 1 ? /Next step/ : /On to the next scene's lesson/, "the focus goes on");
    }
    if (step < lesson.length - 1) await page.keyboard.press("Enter");
  }
  // The steps ask to look: turn the view, pick a neighbour, walk its rays, all without a pointer.
  await tabTo("Tools: ");
  assert.ok(await page.locator(".drawer").isVisible(), "an answer that sets switches has opened it");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await page.locator(".view-pad").waitFor();
  assert.match((await focused()).name, /Plain/, "the focus goes on into the drawer");
  await tabTo("Turn the view left");
  const { observer } = await state(page);
  await page.keyboard.press("Enter");
  await settled(page);
  assert.notDeepEqual((await state(page)).observer, observer);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press(".");
  await settled(page);
  assert.equal((await state(page)).event, 0);
  assert.equal(await page.evaluate(() => window.pointed), 0, "no pointer was used");
  assert.deepEqual(page.faults, []);
});
