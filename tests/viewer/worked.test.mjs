/** Lessons on a scene that is there: they load its rays, and work out beside the stage what the pipeline found. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, press, settled, state, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(async () => {
  await browser.close();
});

const show = (id, step, more = "") => open(page, ON_DISK, `scenes/${id}/index.html`, `step=${step}&gl=none${more}`);
const text = (selector) => page.locator(selector).innerText();
const cells = (row) => page.locator(".worked-table tr").nth(row).locator("td").allInnerTexts();

test("a lesson on a scene loads that scene's rays and nothing is there twice", async () => {
  const asked = [];
  const note = (request) => asked.push(request.url().replace(/^.*\/scenes\//, "").replace(/\?.*$/, ""));
  page.on("request", note);
  await show("20-rasterised-shadows", 2);
  page.off("request", note);
  const own = asked.filter((each) => each.startsWith("20-rasterised-shadows/"));
  assert.deepEqual(own.sort(), ["20-rasterised-shadows/index.html", "20-rasterised-shadows/scene.js"]);
  for (const file of ["scene.js", "15.js"]) assert.ok(asked.includes(`02-shadows/${file}`), file);
  assert.equal((await state(page)).scene, "20-rasterised-shadows");
  assert.equal(await text("#title"), readScene("20-rasterised-shadows").title);
  assert.deepEqual(page.faults, []);
});

test("from the last step of a scene's lesson one goes on to the next of its chapter, and back", async () => {
  await show("12-soft-shadows-1", 5, "&answer=1");
  await press(page, "PageDown");
  await until(page, ({ scene, step }) => scene === "13-soft-shadows-4" && step === 0);
});

test("a point slides along its ray by slider and keys, and the equation stands beside it", async () => {
  await show("11-what-is-a-ray", 4);
  await page.locator(".worked-table").waitFor();
  const blue = await cells(3);
  assert.equal(blue[2], "0.33");
  assert.deepEqual(blue.slice(3), ["4.461", "5.604"]);
  const slider = page.locator(".worked input");
  await slider.focus();
  const before = await page.locator(".worked-lines .point").getAttribute("cx");
  await press(page, "ArrowRight", "ArrowRight");
  assert.notEqual(await page.locator(".worked-lines .point").getAttribute("cx"), before);
  assert.deepEqual((await state(page)).pixel, [4, 3], "the arrows moved the point, not the pixel");
  await slider.fill("625"); // t = 5: in the sphere
  await settled(page);
  assert.match(await text(".worked-note >> nth=1"), /inside/);
  assert.equal(await page.locator(".worked-lines .root").count(), 2);
});

test("a ray that misses has a discriminant below 0 and no roots", async () => {
  await show("11-what-is-a-ray", 5);
  await page.locator(".worked-table").waitFor();
  assert.deepEqual((await cells(3)).slice(2), ["\u22122.66", "\u2013", "\u2013"]);
});

test("the curve of a sphere that the ray misses is seen down to its lowest point, above the line", async () => {
  await show("11-what-is-a-ray", 5);
  await page.locator(".worked-curves").waitFor();
  const [axis, lowest] = await page.evaluate(() => {
    const curves = document.querySelector(".worked-curves");
    const ys = [...curves.querySelectorAll("polyline")].map((line) => Math.max(...line.getAttribute("points").split(" ").map((point) => Number(point.split(",")[1]))));
    return [Number(curves.querySelector(".axis").getAttribute("y1")), Math.max(...ys)]; // y goes down
  });
  assert.ok(lowest > 20 && lowest < axis - 20, `its lowest point is at ${lowest}, the line at ${axis}`);
});

test("another pixel than the step's has no numbers, and it says so", async () => {
  await page.evaluate(() => document.activeElement.blur());
  await press(page, "ArrowDown");
  assert.match(await text(".worked"), /step.s own pixel/);
  await press(page, "ArrowUp");
  await page.locator(".worked-table").waitFor();
});

test("a question keeps what would answer it", async () => {
  await show("11-what-is-a-ray", 9);
  await page.locator(".worked-table").waitFor();
  assert.deepEqual((await cells(3)).slice(2), ["?", "?", "?"]);
  assert.equal(await page.locator(".worked-curves").count(), 0);
  await show("11-what-is-a-ray", 9, "&answer=1");
  await page.locator(".worked-curves").waitFor();
});

const SIZES = [[1280, 800], [1000, 700], [390, 844]];
for (const [width, height] of cases(SIZES, SIZES.slice(1)))
  test(`choices stand above what is worked out and not over it, at ${width} x ${height}`, async () => {
    const sized = await newPage(browser, { viewport: { width, height } });
    for (const [id, step] of [["11-what-is-a-ray", 9], ["17-boxes-in-boxes", 8], ["18-jagged-edges", 7]])
      for (const answer of ["", "&answer=1"]) {
        const hash = `step=${step}&gl=none${answer}`;
        await (answer ? follow(sized, hash) : open(sized, ON_DISK, `scenes/${id}/index.html`, hash));
        await sized.locator(".worked").waitFor();
        await settled(sized);
        const [choices, worked] = await Promise.all([".prediction", ".worked"].map((part) => sized.locator(part).boundingBox()));
        const apart = choices.y + choices.height <= worked.y + 0.5 || worked.y + worked.height <= choices.y + 0.5;
        assert.ok(apart, `${id}: ${JSON.stringify([choices, worked])}`);
        assert.ok(choices.width > 250, "a choice has the whole width");
      }
    await sized.close();
  });

test("a ray's boxes are gone through one by one, and a tree that is cut off costs what it says", async () => {
  await show("17-boxes-in-boxes", 6);
  await page.locator(".worked-steps").waitFor();
  assert.match(await text(".worked-title"), /^49 tests/);
  const next = page.locator(".worked-steps button").nth(1);
  await next.click();
  await settled(page);
  assert.match(await text(".worked-note >> nth=0"), /Level 1: entered/);
  const of = Number((await text(".worked-steps span.numbers")).match(/of (\d+)/)[1]);
  for (let k = 1; k < of - 1; k++) await next.click();
  await next.focus();
  await press(page, "ArrowRight"); // the last one by key
  assert.deepEqual((await state(page)).pixel, [6, 3], "the arrows went on to the next box, not to the next pixel");
  assert.match(await text(".worked-title"), /^49 of 49/);
  assert.equal(await next.getAttribute("aria-disabled"), "true");
  assert.ok((await page.locator(".worked-lines .cutOff").first().getAttribute("d")).length > 0);
  await page.locator(".worked-choice button").first().click();
  await settled(page);
  assert.match(await text(".worked-title"), /^14.696 tests/);
});

test("a tile's mean follows the number of rays", async () => {
  await show("18-jagged-edges", 2);
  await page.locator(".worked-choice").waitFor();
  const choose = async (k) => (await page.locator(".worked-choice button").nth(k).click(), settled(page));
  const means = [];
  for (let k = 0; k < 4; k++) {
    await choose(k);
    means.push(Number((await text(".worked-title")).split(",")[0]));
  }
  assert.deepEqual(means, [242, 151, 134, 121]);
});

test("when the lesson ends the panel goes", async () => {
  assert.equal(await page.locator(".viewer.working").count(), 1);
  await page.locator(".lesson-steps button").last().click();
  await settled(page);
  assert.equal(await page.locator(".viewer.working").count(), 0);
  assert.equal(await page.locator(".worked").isVisible(), false);
  assert.equal(await page.locator(".worked-lines > *").count(), 0);
  assert.deepEqual(page.faults, []);
});
