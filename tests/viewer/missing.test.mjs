/** Without WebGL the same state is drawn flat. What else can be missing: faults.test.mjs. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { launch, newPage, ON_DISK, open, pictureOf, press, richScene, stats } from "./browser.mjs";

const { path } = richScene();

test("a browser that refuses WebGL gets the flat drawing, every tile in its colour, and one sentence", async () => {
  const refusing = await launch(["--disable-gpu", "--disable-3d-apis"]);
  try {
    const page = await newPage(refusing, { sharp: true });
    await open(page, ON_DISK, path, "still=1&n=5&tiles=filled&cam=camera&rays=none");
    assert.equal((await stats(page)).renderer, "flat");
    assert.match(await page.locator("#notice .notice-text").innerText(), /no WebGL/);
    const image = await pictureOf(page);
    const box = await page.locator(".stage-view").boundingBox();
    const { tiles } = await stats(page);
    for (const k of [0, 6, 12, 18, 24]) {
      const at = await page.evaluate((k) => window.raywalk.stats().tile(k % 5, Math.floor(k / 5)), k);
      const pixel = 4 * (Math.round(box.y + at.y) * image.width + Math.round(box.x + at.x));
      assert.deepEqual([...image.data.subarray(pixel, pixel + 3)], tiles.slice(3 * k, 3 * k + 3));
    }
    await press(page, "a", "r", "ArrowLeft");
    assert.ok((await stats(page)).thin >= 25);
    await open(page, ON_DISK, `${path}?gl=none`, "still=1");
    assert.equal((await stats(page)).renderer, "flat", "asked for in the query too");
    assert.deepEqual(page.faults, []);
  } finally {
    await refusing.close();
  }
});
