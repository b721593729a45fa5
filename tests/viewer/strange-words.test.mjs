/** Words twice as long, 40 % longer, from right to left, and hostile ones: nothing breaks, nothing runs. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { DIST, follow, launch, newPage, open, press, richScene, stats } from "./browser.mjs";
import { cases } from "./cases.mjs";

const rich = richScene();
const QUICK = "still=1&gl=none"; // words are on no stage that WebGL draws otherwise
const folder = mkdtempSync(join(tmpdir(), "strange-words-"));
const site = pathToFileURL(`${folder}/site/`).href;
execFileSync(".venv/bin/python", ["tests/words/pseudo.py", DIST, `${folder}/site`]);
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** What sticks out of the page, of its button, or lies on another control. */
const broken = () =>
  page.evaluate(() => {
    const shown = [...document.querySelectorAll("button, nav a, .top a, .scene-title, .lesson-text, .event-count, .pixel, .legend li, .grid-size")].filter((e) => e.checkVisibility({ visibilityProperty: true }) && e.offsetWidth);
    const name = (e) => `${e.className || e.tagName}: ${e.textContent.trim().slice(0, 40)}`;
    const boxes = shown.map((e) => [e, e.getBoundingClientRect()]);
    const overlap = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 2 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 2;
    const pairs = boxes.flatMap(([a, boxA], k) => boxes.slice(k + 1).filter(([b, boxB]) => !a.contains(b) && !b.contains(a) && overlap(boxA, boxB)).map(([b]) => `${name(a)} lies on ${name(b)}`));
    return {
      wide: document.documentElement.scrollWidth - innerWidth,
      outside: boxes.filter(([, box]) => box.right > innerWidth + 1 || box.left < -1).map(([e]) => name(e)),
      cut: shown.filter((e) => e.tagName === "BUTTON" && e.scrollWidth > e.offsetWidth + 1).map(name),
      pairs,
    };
  });
const SOUND = { wide: 0, outside: [], cut: [], pairs: [] };

const SIZES = [[1280, 800], [390, 844]];
for (const code of ["en-x-doubled", "en-x-long", "ar-x-rtl"])
  for (const [width, height] of cases(SIZES, { "en-x-doubled": SIZES, "ar-x-rtl": SIZES.slice(1) }[code] ?? []))
    test(`${code} at ${width} x ${height}: nothing sticks out, is cut off or lies on something else`, async () => {
      await page.setViewportSize({ width, height });
      await open(page, site, `${code}/${rich.path}`, QUICK);
      for (const more of ["", "&step=1", "&n=15&p=5,8&e=7"]) {
        await follow(page, QUICK + more);
        assert.ok((await stats(page)).shown.lines >= 0);
        assert.deepEqual(await broken(), SOUND, more);
      }
      for (const path of ["index.html", "model/index.html"]) {
        await page.goto(`${site}${code}/${path}`);
        assert.deepEqual(await broken(), SOUND, path);
      }
    });

test("hostile words are shown as they are, and run nothing", async () => {
  await page.setViewportSize({ width: 1280, height: 800 });
  for (const path of ["index.html", "model/index.html"]) {
    await page.goto(`${site}en-x-hostile/${path}`);
    assert.equal(await page.evaluate(() => window.hacked), undefined);
    assert.equal(await page.locator("img[onerror], script:not([src])").count(), 0);
  }
  await open(page, site, `en-x-hostile/${rich.path}`, `${QUICK}&n=15&p=5,8`);
  const { events } = await stats(page);
  for (let k = 0; k < events.length; k++) await press(page, ".");
  await press(page, "Escape");
  await page.getByRole("button", { name: /^Start the lesson/ }).click();
  for (let k = 0; k < 12; k++) await press(page, "PageDown");
  assert.match(await page.locator("body").innerText(), /<img src=x onerror="hacked=1">/);
  assert.match(await page.locator("body").innerText(), /\{\{ 7\*7 \}\}/, "no template is made of a template's words");
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.equal(await page.locator("img[onerror], img[src=x], script:not([src])").count(), 0);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
