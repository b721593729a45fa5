/** Rasterised against ray traced: the stage plain, with tricks, and the traced picture in its place. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { PNG } from "pngjs";
import { launch, follow, newPage, ON_DISK, open, press, richScene, settled, state, tileOnPage } from "./browser.mjs";

const rich = richScene();
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
  await open(page, ON_DISK, rich.path, "still=1&n=5&p=2,2");
});
after(() => browser.close());
const button = (name) => page.getByRole("button", { name });
const pressedNames = () => page.locator(".view-switch [aria-pressed=true]").allInnerTexts();
const stageShot = async () => PNG.sync.read(await page.locator(".stage-view").screenshot());
const different = (a, b) => a.data.reduce((count, value, k) => count + (Math.abs(value - b.data[k]) > 8), 0) / a.data.length;

test("T goes round: approximate, traced, plain; each names itself in a sentence", async () => {
  assert.equal((await state(page)).look, "approximate");
  for (const [look, word, note] of [["traced", "Traced", /Ray traced/], ["plain", "Plain", /no shadows/], ["approximate", "Approximate", /painted/]]) {
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

test("turning away from the camera shows the rasterised scene again", async () => {
  await follow(page, "still=1&n=5&p=2,2&look=traced");
  await button("Observer back to the start view").click();
  await settled(page);
  assert.equal((await state(page)).look, "approximate");
  assert.equal(await page.locator(".traced-picture").isVisible(), false);
});

test("nothing was said on the console", () => assert.deepEqual(page.faults, []));
