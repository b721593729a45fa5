/** When things are missing the picture and the lesson are still there, with one sentence. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { launch, newPage, ON_DISK, open, press, richScene, scenesOfSite, settled, state, stats, until, DIST } from "./browser.mjs";
import { readScene } from "./scene-files.mjs";
import { serve } from "./server.mjs";

const rich = richScene();
let browser, server;
before(async () => {
  browser = await launch();
  server = await serve(DIST);
});
after(async () => {
  await browser.close();
  server.close();
});

let shared; // one page for all of them: what a test answered differently is taken back after it
async function withPage(task, options) {
  const page = options ? await newPage(browser, options) : (shared ??= await newPage(browser));
  page.home = server.url;
  page.faults.length = 0;
  try {
    await task(page);
  } finally {
    await (options ? page.close() : page.unrouteAll({ behavior: "ignoreErrors" }));
  }
}
const start = readScene(rich.id).start;
const answer = (page, file, reply) => page.route(`**/scenes/${rich.id}/${file}`, reply);
const notice = (page) => page.locator("#notice .notice-text").innerText();
const pictureShows = (page, selector) => page.locator(selector).evaluate((image) => image.complete && image.naturalWidth > 0);

test("without JavaScript the page shows picture, lesson and figures", () =>
  withPage(
    async (page) => {
      await page.goto(ON_DISK + rich.path);
      assert.ok(await page.locator(".plain-picture").isVisible());
      assert.ok((await page.locator(".plain-lesson li").count()) > 0);
      assert.ok((await page.locator(".figures dt").count()) > 0);
      assert.ok(!(await page.locator("#viewer").isVisible()));
      assert.ok((await page.locator("nav.scenes a").count()) > 2);
    },
    { javaScriptEnabled: false },
  ));

test("a missing trace: the scene in space, the picture and the lesson stay, and another grid works", () =>
  withPage(async (page) => {
    const n = start.resolution;
    await answer(page, `${n}.js`, (route) => route.fulfill({ status: 404 }));
    await open(page, server.url, rich.path, "still=1");
    assert.match(await notice(page), /could not be loaded; the picture, the lesson and the scene in space still work/);
    assert.ok(await pictureShows(page, ".picture img"));
    assert.match(await page.locator(".card").innerText(), /not here/);
    await press(page, "+");
    await until(page, (s, t) => t.tiles.length === 3 * s.n * s.n);
    assert.ok(!(await page.locator("#notice").isVisible()));
  }));

const DAMAGES = {
  "not gzip": (name) => `raywalkReceive("${name}", "AAAA")`,
  "not base64": (name) => `raywalkReceive("${name}", "*")`,
  "another shape": (name) => `raywalkReceive("${name}", "${gzipSync("{}").toString("base64")}")`,
  "cut short": () => "",
  "no script": () => "raywalkRec",
};
for (const [how, script] of Object.entries(DAMAGES))
  test(`a damaged trace (${how}) is told, and the rest works`, () =>
    withPage(async (page) => {
      const n = start.resolution;
      await answer(page, `${n}.js`, (route) => route.fulfill({ contentType: "text/javascript", body: script(`${rich.id}/${n}`) }));
      await open(page, server.url, rich.path, "still=1");
      assert.match(await notice(page), /damaged; the picture, the lesson and the scene in space still work/);
      await press(page, " ", "a", "ArrowLeft");
      assert.equal((await stats(page)).tilesShown, 0);
    }));

test("a missing scene: the plain page is there with one sentence", () =>
  withPage(async (page) => {
    await answer(page, "scene.js", (route) => route.fulfill({ status: 404 }));
    await open(page, server.url, rich.path);
    assert.match(await notice(page), /could not be loaded.*complete/);
    assert.ok(await pictureShows(page, ".plain-picture"));
    assert.ok(await page.locator(".plain-lesson").isVisible());
  }));

test("going to a scene whose data is missing ends on that scene's plain page", () =>
  withPage(async (page) => {
    const from = scenesOfSite().find((scene) => scene.id !== rich.id);
    await answer(page, "scene.js", (route) => route.fulfill({ status: 404 }));
    await open(page, server.url, from.path, "still=1");
    await page.locator(`nav.scenes a[data-scene="${rich.id}"]`).click();
    await page.waitForURL(`**/${rich.id}/**`);
    await page.locator(".plain-lesson").waitFor();
    assert.match(await notice(page), /could not be loaded/);
  }));

test("without WebGL (gl=none) the same state is drawn flat", () =>
  withPage(async (page) => {
    await open(page, server.url, rich.path, "still=1&gl=none&n=5&tiles=filled&cam=camera&rays=none");
    assert.equal((await stats(page)).renderer, "flat");
    const { PNG } = await import("pngjs");
    const image = PNG.sync.read(await page.screenshot());
    const box = await page.locator(".stage-view").boundingBox();
    const { tiles } = await stats(page);
    for (const k of [0, 6, 12, 18, 24]) {
      const at = await page.evaluate((k) => window.raywalk.stats().tile(k % 5, Math.floor(k / 5)), k);
      const pixel = 4 * (Math.round(box.y + at.y) * image.width + Math.round(box.x + at.x));
      assert.deepEqual([...image.data.subarray(pixel, pixel + 3)], tiles.slice(3 * k, 3 * k + 3));
    }
    await press(page, "a", "r", "ArrowLeft");
    assert.ok((await stats(page)).thin >= 25);
    assert.deepEqual(page.faults, []);
  }));

test("gl=none works in the query too", () =>
  withPage(async (page) => {
    await open(page, server.url, `${rich.path}?gl=none`, "still=1");
    assert.equal((await stats(page)).renderer, "flat");
  }));

test("a lost drawing context goes on flat, and says so", () =>
  withPage(async (page) => {
    await open(page, server.url, rich.path, "still=1&tiles=filled");
    assert.equal((await stats(page)).renderer, "webgl");
    await page.evaluate(() => window.raywalk.loseContext());
    await until(page, (s, t) => t.renderer === "flat");
    await settled(page);
    assert.match(await notice(page), /simpler way/);
    assert.equal((await state(page)).tiles, "filled");
    assert.deepEqual(page.faults, []);
  }));

test("a browser that refuses WebGL gets the flat drawing and one sentence", async () => {
  const refusing = await launch(["--disable-gpu", "--disable-3d-apis"]);
  try {
    const page = await newPage(refusing);
    await open(page, ON_DISK, rich.path, "still=1");
    assert.equal((await stats(page)).renderer, "flat");
    assert.match(await notice(page), /no WebGL/);
    assert.deepEqual(page.faults, []);
  } finally {
    await refusing.close();
  }
});
