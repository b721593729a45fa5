/** The panel over the live page with what can be taken away of the scene that is shown; straight from the disk. */
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch, newPage, ON_DISK, open, openMenu, press, scenesOfSite, state, until } from "./browser.mjs";

const scenes = scenesOfSite();
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
  await open(page, ON_DISK, scenes[0].path, "still=1&gl=none");
});
after(() => browser.close());
const isOpen = () => page.evaluate(() => document.querySelector("#take").matches(":popover-open"));
const boxes = () => page.evaluate(() => JSON.stringify([...document.querySelectorAll("#viewer *, header *, nav *")].filter((each) => !each.closest("#take")).map((each) => each.getBoundingClientRect())));
const links = () => page.evaluate(() => [...document.querySelectorAll("#take a")].filter((a) => !a.parentElement.hidden).map((a) => ({ href: a.href, size: a.textContent })));

test("it opens and closes by keyboard, nothing of the page moves, and the keys of the page rest meanwhile", async () => {
  await openMenu(page);
  const [still, pixel] = [await boxes(), (await state(page)).pixel];
  await page.focus(".take-open");
  await press(page, "Enter");
  assert.ok(await isOpen());
  assert.ok((await boxes()) === still, "something moved");
  assert.equal(await page.evaluate(() => document.activeElement.id), "take");
  await press(page, "ArrowRight");
  assert.deepEqual((await state(page)).pixel, pixel);
  await press(page, "Escape");
  assert.ok(!(await isOpen()));
  const focused = () => page.evaluate(() => document.activeElement.classList[0]);
  assert.equal(await focused(), "take-open");
  const { width, height } = await page.locator(".take-open").boundingBox();
  assert.ok(width >= 44 && height >= 44);
  await press(page, "Escape");
  assert.equal(await page.locator("#menu").isVisible(), false, "one Escape a layer");
  assert.equal(await focused(), "menu-open");
});

for (const opener of [".menu-open", ".chooser"])
  test(`Escape closes what ${opener} has opened, and does not leave the player as well`, async () => {
    const opened = page.locator(`#${await page.locator(opener).getAttribute("popovertarget")}`);
    await press(page, ".");
    const { event } = await state(page);
    await page.focus(opener);
    await press(page, "Enter");
    await opened.waitFor();
    await press(page, "Escape");
    assert.equal(await opened.isVisible(), false);
    assert.equal((await state(page)).event, event);
    await press(page, "Escape");
    assert.equal((await state(page)).event, null);
  });

test("every file it names is there, with its size; another scene's after turning to it", async () => {
  for (const { id } of [scenes[0], scenes[scenes.length - 1]]) {
    await page.evaluate((scene) => document.querySelector(`nav.scenes a[data-scene="${scene}"]`).click(), id);
    await until(page, (_state, _stats, scene) => document.querySelector("nav.scenes [aria-current]").dataset.scene === scene, id);
    const files = (await links()).filter(({ href }) => !href.includes("index.html"));
    assert.ok(files.length >= 7, `${id}: ${files.length} files`);
    for (const { href, size } of files) {
      assert.match(href, new RegExp(`/slides/${id}[.-]`));
      assert.ok(existsSync(fileURLToPath(href)), href);
      assert.match(size, /\d (KB|MB)\s*$/);
    }
    assert.ok((await links()).some(({ href }) => href.endsWith(`slides/index.html#${id}`)));
  }
});
