/** Terms of the glossary in a lesson: a card for whoever looks, by pointer, key or finger; links without it. */
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { DIST, launch, newPage, ON_DISK, open, pass, press, scenesOfSite, state } from "./browser.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const { path } = scenesOfSite().find(({ id }) => id === "02-shadows"); // its second step has a camera ray's
const RESTS = 200; // ms: somewhat more than the pointer must rest on a term
const QUICK = "still=1&gl=none&step=2";
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(() => browser.close());
const term = (of = page) => of.locator(".lesson-text a.term").first();
const card = (of = page) => of.locator(".term-card");
const shown = (of = page) => card(of).waitFor({ state: "visible" });
const gone = (of = page) => card(of).waitFor({ state: "hidden" });

test("the pointer on a term shows its card, which stays while the pointer goes to it, and Escape puts it away", async () => {
  const held = await newPage(browser, { held: true });
  await open(held, ON_DISK, path, QUICK);
  await term(held).hover();
  await pass(held, RESTS);
  await shown(held);
  assert.match(await card(held).innerText(), /camera ray/i);
  await card(held).hover();
  await pass(held, 2 * RESTS);
  assert.ok(await card(held).isVisible(), "the pointer is on it");
  await press(held, "Escape");
  await gone(held);
  assert.equal((await state(held)).step, 1, "the lesson goes on");
  await held.close();
});

test("the focus on a term shows it, and names it to who listens; the next Tab puts it away, Enter leads to the glossary", async () => {
  await open(page, ON_DISK, path, QUICK);
  await page.locator(".lesson-steps .next").focus();
  const terms = await page.locator(".lesson-text a.term").count();
  for (let k = 0; k < 8 && !(await page.evaluate(() => document.activeElement.classList.contains("term"))); k++) await page.keyboard.press("Shift+Tab");
  await shown();
  assert.ok(terms >= 2);
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-describedby")), "term-card");
  await page.keyboard.press("Tab");
  await gone();
  await page.keyboard.press("Shift+Tab");
  await shown();
  const to = await page.evaluate(() => document.activeElement.href);
  await page.keyboard.press("Enter");
  await page.waitForURL(to);
  assert.ok(await page.locator(`${new URL(to).hash} dd`).isVisible());
});

test("a finger opens the card and does not leave the lesson; another step puts it away", async () => {
  const phone = await newPage(browser, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await open(phone, ON_DISK, path, QUICK);
  await term(phone).tap();
  await shown(phone);
  const [box, { width, height }] = [await card(phone).boundingBox(), phone.viewportSize()];
  assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height, "it is in the window");
  assert.match(phone.url(), /step=2/);
  await press(phone, "PageDown");
  await gone(phone);
  await phone.close();
});

test("axe finds no fault in a step with its card, in German too", async () => {
  for (const home of ["", "de/"].filter((each) => existsSync(`${DIST}/${each}index.html`))) {
    await open(page, ON_DISK, `${home}${path}`, QUICK);
    await term().hover();
    await shown();
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document, { preload: false, resultTypes: ["violations"], runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"] }));
    assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), []);
    await page.mouse.move(5, 5);
  }
});

test("without what cards say the link leads to the glossary", async () => {
  const without = await newPage(browser);
  await without.route("**/terms.js", (route) => route.abort());
  await open(without, ON_DISK, path, QUICK);
  await term(without).click();
  await without.waitForURL(/glossary\/index\.html#/);
  await without.close();
});

test("every term of every lesson has its entry on the page and in the cards of its language", async () => {
  for (const home of ["", "de/"].filter((each) => existsSync(`${DIST}/${each}glossary/index.html`))) {
    const entries = readFileSync(`${DIST}/${home}glossary/index.html`, "utf8");
    const told = readFileSync(`${DIST}/${home}glossary/terms.js`, "utf8");
    for (const { path } of scenesOfSite()) {
      const ids = [...readFileSync(`${DIST}/${home}${path}`, "utf8").matchAll(/class="term" href="\.\.\/\.\.\/glossary\/index\.html#([\w-]+)"/g)].map(([, id]) => id);
      assert.ok(ids.length >= 3, path);
      for (const id of ids) assert.ok(entries.includes(`id="${id}"`) && told.includes(`"${id}":`), id);
    }
  }
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
