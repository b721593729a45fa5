/** Rasterised against ray traced: the stage plain, with tricks, and the traced picture in its place. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, follow, newPage, ON_DISK, open, openDrawer, pictureOf, press, richScene, settled, state, tileOnPage } from "./browser.mjs";

const rich = richScene();
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true, viewport: { width: 1000, height: 640 } }); // what is drawn costs by its pixels
  await open(page, ON_DISK, rich.path, "still=1&n=5&p=2,2");
  await openDrawer(page); // looks and views are in it; it stays open
});
after(() => browser.close());
const button = (name) => page.getByRole("button", { name });
const pressedNames = () => page.locator(".view-switch [aria-pressed=true]").allInnerTexts();
const stageShot = () => pictureOf(page, page.locator(".stage-view"));
const different = (a, b) => a.data.reduce((count, value, k) => count + (Math.abs(value - b.data[k]) > 8), 0) / a.data.length;

test("T goes round: approximate, traced, plain; each names itself in a sentence", async () => {
  assert.equal((await state(page)).look, "approximate");
  for (const [look, word, note] of [["traced", "Traced", /Ray traced/], ["plain", "Plain", /no shadows/], ["approximate", "Approximate", /shadow maps, mirrors that look up/]]) {
    await press(page, "t");
    assert.equal((await state(page)).look, look);
    assert.deepEqual(await pressedNames(), [word]);
    assert.match(await page.locator(".view-note").innerText(), note);
  }
});

test("plain and approximate are drawn differently", async () => {
  await follow(page, "still=1&n=5&p=2,2&look=plain");
  const plain = await stageShot();
  await follow(page, "still=1&n=5&p=2,2&look=approximate");
  // Mirrors fill about a tenth of this stage; one per cent is far above noise, which a still stage has not.
  assert.ok(different(plain, await stageShot()) > 0.01);
});

test("traced looks from the ray-tracing camera, and the picture covers the tiles to the pixel", async () => {
  await follow(page, "still=1&n=5&p=2,2&look=traced");
  assert.equal((await state(page)).observer, "camera");
  const picture = page.locator(".traced-picture");
  await picture.waitFor({ state: "visible" });
  const box = await picture.boundingBox();
  for (const [column, row] of [[0, 0], [4, 4], [2, 1]]) {
    const middle = await tileOnPage(page, column, row);
    // Half a CSS pixel: boxes are laid out on device pixels.
    assert.ok(Math.abs(middle.x - (box.x + ((column + 0.5) / 5) * box.width)) < 0.5);
    assert.ok(Math.abs(middle.y - (box.y + ((row + 0.5) / 5) * box.height)) < 0.5);
  }
});

test("the traced look gives the view of before back when it is left, from a link too", async () => {
  const cam = "6,4,6,0,0,0";
  await follow(page, `still=1&n=5&p=2,2&cam=${cam}`);
  const before = (await state(page)).observer;
  await press(page, "t");
  assert.equal((await state(page)).observer, "camera");
  await page.waitForFunction(() => location.hash.includes("look=traced"));
  await follow(page, new URL(page.url()).hash.slice(1));
  await button("Rasterised: every surface by itself").click();
  assert.deepEqual((await state(page)).observer, before);
});

test("the stage follows switches: a light that is off is struck and gives nothing, shadows and terms go, and all come back", async () => {
  await follow(page, "still=1&n=5&p=2,2&rays=none&tiles=filled&if=-shadows"); // its panel opens now and stays
  await follow(page, "still=1&n=5&p=2,2&rays=none&tiles=filled");
  const labels = () => page.locator(".stage-view .labels span:visible").allInnerTexts();
  const asTraced = await stageShot();
  for (const [switches, label] of [["l2x0", "light 2: off"], ["-shadows", "light 2"], ["-diffuse", "light 2"], ["-reflected", "light 2"]]) {
    await follow(page, `still=1&n=5&p=2,2&rays=none&tiles=filled&if=${switches}`);
    // The tiles are about two per cent of the stage; the room, which all of these change, is most of it.
    assert.ok(different(asTraced, await stageShot()) > 0.04, switches);
    assert.ok((await labels()).includes(label), switches);
  }
  await follow(page, "still=1&n=5&p=2,2&rays=none&tiles=filled");
  assert.equal(different(asTraced, await stageShot()), 0);
});

test("a blocked shadow ray ends at what blocks it, which is named there", async () => {
  await follow(page, "still=1&n=15&p=7,12&tab=rays");
  await page.locator("li.ray").first().waitFor();
  const names = await page.locator("li.ray.blocked b:last-child").allInnerTexts();
  assert.ok(names.length > 0);
  const signs = names.slice(0, 3).map((name) => name.replace("by the ", "by ")); // a sign is short
  assert.deepEqual(await page.locator(".labels .stop:visible").allInnerTexts(), signs);
});

test("turning away from the camera shows the rasterised scene again", async () => {
  await follow(page, "still=1&n=5&p=2,2&look=traced");
  await button("Observer back to the start view").click();
  await settled(page);
  assert.equal((await state(page)).look, "approximate");
  assert.equal(await page.locator(".traced-picture").isVisible(), false);
});

test("nothing was said on the console", () => assert.deepEqual(page.faults, []));
