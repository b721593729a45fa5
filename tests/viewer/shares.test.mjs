/** What the colour is made of: shares that are the whole pixel, their sum its colour; and lines as wide as what they are worth. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chooseTab, follow, launch, newPage, ON_DISK, open, press, richScene, sceneCalled, scenesOfSite, settled, state, stats } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { rayRows } = await load("state/ray-rows.ts");
const { worthOf, faintness, linesOf } = await load("state/lines.ts");
const rich = richScene();
const glass = scenesOfSite().find(({ key }) => key === "8") ?? rich;
const own = ({ share, keeps, object }) => (object ? share * keeps : share);
const HALF = 0.0006; // of the pixel: shares are written in per cent with at most one decimal
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
  await open(page, ON_DISK, glass.path, "still=1&gl=none&n=15");
});
after(() => browser.close());

for (const { id } of new Set([sceneCalled("01-shading"), rich, glass]))
  test(`${id}: the shares of every pixel are at most the whole, and times their colours they are its sum`, () => {
    const { scene, trace } = readTrace(id, 15);
    for (let pixel = 0; pixel < 225; pixel++) {
      const rows = rayRows(trace, scene, pixel);
      assert.ok(rows.reduce((sum, row) => sum + own(row), 0) <= 1 + 1e-9); // products in another order
      for (const c of [0, 1, 2]) assert.ok(Math.abs(rows.reduce((sum, row) => sum + own(row) * row.local[c], 0) - rows[0].colour[c]) < 1e-9, `pixel ${pixel}`);
    }
  });

/** Written in per cent: the shares with words, and what is told as a rest. */
const written = () => page.locator(".share b, .share-rest").evaluateAll((all) => all.map((each) => Number(/([\d.]+)\s*%/.exec(each.textContent)[1]) / 100));
const pieces = () => page.locator(".shares-bar span").evaluateAll((all) => all.map((each) => [Number(each.style.flexGrow), each.getBoundingClientRect().width]));

test("on the page they sum to 100 %, the bar's pieces are as long, and the sum tab has the same numbers", async () => {
  const { scene, trace } = readTrace(glass.id, 15);
  for (const [column, row] of [[9, 10], [8, 12], [2, 11], [0, 0], [14, 14]]) {
    await follow(page, `still=1&gl=none&n=15&p=${column},${row}`);
    const rows = rayRows(trace, scene, row * 15 + column);
    const told = await written();
    assert.ok(Math.abs(told.reduce((sum, each) => sum + each, 0) - 1) <= HALF * told.length, `${column},${row}: ${told.join(" + ")}`);
    const drawn = await pieces();
    const expected = rows.map(own).filter((share) => share >= 5e-4).sort((a, b) => b - a);
    assert.equal(drawn.length, expected.length, "the largest first");
    const bar = (await page.locator(".shares-bar").boundingBox()).width;
    for (const [k, [grow, width]] of drawn.entries()) {
      assert.ok(Math.abs(grow - expected[k]) < 1e-6);
      assert.ok(Math.abs(width / bar - expected[k]) < 0.01, `piece ${k}: ${width} of ${bar} px for ${expected[k]}`);
    }
    await chooseTab(page, "sum");
    assert.ok((await page.locator(".sum").first().textContent()).includes(rows[0].colour[0].toFixed(3)));
  }
});

test("a pixel of the background is all background, and one that no ray is followed for says so", async () => {
  await open(page, ON_DISK, sceneCalled("01-shading").path, "still=1&gl=none&n=15&p=0,0");
  assert.match(await page.locator(".share").innerText(), /100\s*%\s+background/i);
  const mirrors = scenesOfSite().find(({ key }) => key === "4"); // one bounce: a mirror in a mirror is black
  await open(page, ON_DISK, mirrors.path, "still=1&gl=none&n=15&p=10,7");
  assert.equal(await page.locator(".share").count(), 0);
  assert.match(await page.locator(".share-rest").innerText(), /100\s*% black/);
});

for (const [language, size, words] of [["", { width: 1280, height: 800 }, "One ray, through its middle."], ["de/", { width: 1280, height: 800 }, "Ein Strahl, durch seine Mitte."], ["", { width: 390, height: 844 }, "One ray, through its middle."]])
  test(`at the swatch it is said that a pixel is one ray: "${words}", at ${size.width} x ${size.height}`, async () => {
    await page.setViewportSize(size);
    await open(page, ON_DISK, language + glass.path, "still=1&gl=none&n=5");
    const said = page.locator(".card-head .pixel-ray");
    assert.equal(await said.innerText(), words);
    const [swatch, sentence] = [await page.locator(".card-head .chip, .card-head > :first-child").first().boundingBox(), await said.boundingBox()];
    assert.ok(sentence.y - swatch.y - swatch.height < 40 && swatch.y < sentence.y + sentence.height, "beside or right below it");
    await page.setViewportSize({ width: 1280, height: 800 });
  });

test("pointing at a share or focusing it lights its ray on the stage; Enter goes to its event, arrows go on", async () => {
  await open(page, ON_DISK, glass.path, "still=1&gl=none&n=15&p=9,10");
  const [one, two] = await page.locator(".share").evaluateAll((all) => all.map((each) => Number(each.dataset.ray)));
  await page.locator(".share").nth(1).hover();
  await settled(page);
  assert.deepEqual((await stats(page)).lit, { ray: two, light: -1 });
  await page.mouse.move(2, 2);
  await page.locator(".share").first().focus();
  await settled(page);
  assert.deepEqual((await stats(page)).lit, { ray: one, light: -1 });
  await press(page, "ArrowDown");
  assert.deepEqual((await stats(page)).lit, { ray: two, light: -1 });
  assert.deepEqual((await state(page)).pixel, [9, 10], "the arrows walk the shares");
  await press(page, "Enter");
  const { events } = await stats(page);
  const { ray, what } = events[(await state(page)).event];
  assert.deepEqual([ray, ["meets", "background"].includes(what)], [two, true]);
});

test("a line is as wide as its share says, never less than a floor; many are fainter than few", () => {
  assert.equal(worthOf({ share: 1 }), 1);
  let before = 0;
  for (const share of [0, 1e-6, 0.01, 0.1, 0.5, 1]) {
    const worth = worthOf({ share });
    assert.ok(worth > before && worth >= 0.3, `${share}: ${worth}`);
    before = worth;
  }
  for (const lines of [50, 225, 1000, 10_000]) assert.ok(faintness(lines) < worthOf({ share: 0 }) + 0.1 && faintness(10 * lines) < faintness(lines));
  const { scene, trace } = readTrace(glass.id, 15);
  for (let pixel = 0; pixel < 225; pixel++)
    for (const row of rayRows(trace, scene, pixel)) {
      const line = linesOf(trace, scene, pixel).find(({ ray, light }) => ray === row.ray && light < 0);
      assert.ok(Math.abs(line.share - row.share) < 1e-12, "the card's share");
    }
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
