/** A saved picture: once, twice, four times as large as on the page, with or without ground, in the page's typeface. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { PNG } from "pngjs";
import { DIST, launch, newPage, ON_DISK, open, openMenu, richScene, show, stats } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { serve } from "./server.mjs";

const rich = richScene();
const CAPTION = 34; // CSS pixels under a picture with its ground
const ALIKE = 12; // of 255, on average: what is drawn anew at another size has other edges
let browser, page, server;
before(async () => {
  [browser, server] = await Promise.all([launch(), serve(DIST)]);
  page = await newPage(browser, { sharp: true, viewport: { width: 820, height: 560 } }); // what is drawn costs by its pixels
  await page.addInitScript(() => {
    window.fonts = new Set();
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (...of) {
      window.fonts.add(this.font.replace(/^[^"a-z]*[\d.]+px /, ""));
      return fillText.apply(this, of);
    };
  });
});
after(async () => {
  await browser.close();
  server.close();
});

const button = (name) => page.getByRole("button", { name });
const choose = async (scale, clear) => {
  await openMenu(page);
  await button(`${scale}\u00d7`).click();
  const bare = button("No background");
  if (((await bare.getAttribute("aria-pressed")) === "true") !== clear) await bare.click();
};
async function saved() {
  await openMenu(page);
  const [download] = await Promise.all([page.waitForEvent("download"), button("Save this view").click()]);
  return PNG.sync.read(readFileSync(await download.path()));
}
const viewBox = () => page.locator(".stage-view:visible, .slice:visible").boundingBox();
/** Mean difference between the pixels of the small one and those of the large one, of which so many go into one. */
function difference(small, large, scale, height) {
  let sum = 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < small.width; x++)
      for (let c = 0; c < 3; c++) {
        let mean = 0;
        for (let k = 0; k < scale * scale; k++) mean += large.data[4 * ((scale * y + Math.floor(k / scale)) * large.width + scale * x + (k % scale)) + c];
        sum += Math.abs(mean / scale ** 2 - small.data[4 * (y * small.width + x) + c]);
      }
  return sum / (3 * height * small.width);
}

for (const how of cases(["", "&gl=none", "&slice=row"], [""]))
  test(`twice and four times as large it is the same picture, only sharper, and the page stays as it was (${how || "WebGL"})`, async () => {
    await open(page, ON_DISK, rich.path, `still=1&n=15&p=5,8&look=plain${how}`);
    if (how.includes("slice")) await page.locator(".slice canvas").waitFor();
    const box = await viewBox();
    const canvas = () => page.locator("canvas:visible").first().evaluate(({ width, height }) => [width, height]);
    const before = await canvas();
    const pictures = {};
    for (const scale of [1, 2, 4]) {
      await choose(scale, false);
      const picture = (pictures[scale] = await saved());
      assert.ok(Math.abs(picture.width - scale * box.width) <= scale && Math.abs(picture.height - scale * (box.height + CAPTION)) <= scale, `${scale}: ${picture.width} x ${picture.height}`);
    }
    for (const scale of [2, 4]) {
      const away = difference(pictures[1], pictures[scale], scale, Math.floor(box.height));
      assert.ok(away < ALIKE, `${scale} times: ${away.toFixed(1)} of 255`);
    }
    assert.deepEqual(await canvas(), before, "what is on the page is drawn as before");
  });

test("its words are set in the page's typeface, all of them", async () => {
  await show(page, ON_DISK, rich.path, "still=1&n=15&p=5,8&look=plain");
  await page.evaluate(() => window.fonts.clear());
  await choose(1, false);
  await saved();
  const { used, asked } = await page.evaluate(() => ({ used: [...window.fonts], asked: getComputedStyle(document.body).fontFamily }));
  assert.deepEqual(used.map((font) => font.replaceAll(" ", "")), [asked.replaceAll(" ", "")]);
});

test("a picture that the graphics card cannot draw so large is as large as it can", async () => {
  await show(page, ON_DISK, rich.path, "still=1&n=15&p=5,8&look=plain");
  const { width } = await stats(page);
  await page.evaluate((most) => {
    const { get } = Object.getOwnPropertyDescriptor(WebGL2RenderingContext.prototype, "drawingBufferWidth");
    Object.defineProperty(WebGL2RenderingContext.prototype, "drawingBufferWidth", { get() { return Math.min(most, get.call(this)); } });
  }, 3 * width);
  await choose(4, false);
  assert.equal((await saved()).width, 2 * width);
});

for (const how of ["", "&gl=none"])
  test(`without ground it is clear where nothing is drawn, and has no caption (${how || "WebGL"})`, async () => {
    await open(page, ON_DISK, "scenes/01-shading/index.html", `still=1&n=15&p=5,8${how}`);
    await choose(1, true);
    const [box, bare] = [await viewBox(), await saved()];
    assert.ok(Math.abs(bare.height - box.height) <= 1);
    const alphas = Array.from({ length: bare.width * bare.height }, (_, k) => bare.data[4 * k + 3]);
    const share = (is) => alphas.filter(is).length / alphas.length;
    assert.equal(alphas[0], 0);
    assert.ok(share((alpha) => alpha === 0) > 0.5, "three balls before nothing");
    assert.ok(share((alpha) => alpha === 255) > 0.05);
    await choose(1, false);
    const whole = await saved();
    assert.ok(whole.data.every((value, k) => k % 4 < 3 || value === 255));
  });

test("in the traced look the traced picture is in it", async () => {
  page.home = server.url; // from a disk browsers do not give a picture's pixels away
  await open(page, server.url, rich.path, "still=1&n=15&p=5,8&look=traced");
  await page.locator(".traced-picture img").evaluate((image) => image.decode());
  await choose(1, false);
  const [picture, view] = [await saved(), await viewBox()];
  const traced = PNG.sync.read(readFileSync(`${DIST}/scenes/${rich.id}/picture.png`));
  const box = await page.locator(".traced-picture").boundingBox();
  let sum = 0;
  for (let k = 0; k < 400; k++) {
    const [u, v] = [(k % 20) + 0.5, Math.floor(k / 20) + 0.5].map((of) => of / 20);
    const [x, y] = [box.x - view.x + u * box.width, box.y - view.y + v * box.height].map(Math.floor);
    const at = 4 * (Math.floor(v * traced.height) * traced.width + Math.floor(u * traced.width));
    for (let c = 0; c < 3; c++) sum += Math.abs(picture.data[4 * (y * picture.width + x) + c] - traced.data[at + c]) / 1200;
  }
  assert.ok(sum < ALIKE, `${sum.toFixed(1)} of 255 away from the traced picture`);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
