/** A slider moves what a sweep moves: each stop is a scene that was traced, and the page shows it as it shows any scene. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { gunzipSync } from "node:zlib";
import { DIST, launch, newPage, ON_DISK, open, openDrawer, pass, press, settled, state, stats, until } from "./browser.mjs";
import { readScene, readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { decode, wholeAgain, sceneAt, placeOf, stopIn } = await load("trace/decode.ts", "trace/whole.ts", "state/swept.ts");
const ID = "02-shadows";
const scene = readScene(ID);
const [sweep] = scene.sweeps;
const read = (name) => JSON.parse(gunzipSync(Buffer.from(readFileSync(`${DIST}/scenes/${ID}/${sweep.id}/${name}.js`, "utf8").split('"')[3], "base64")));
const grid = (n) => wholeAgain(read(n).stops).map((json) => decode(json, { scene: ID, n }));

test("the stop that is the scene itself has the rays of the scene, at both grids", () => {
  for (const n of [15, 33]) {
    const [own, there] = [readTrace(ID, n).trace, grid(n)[sweep.own - 1]];
    for (const [name, column] of Object.entries(own)) assert.deepEqual(there[name], column, name);
  }
});

test("a stop's scene has the light where its trace has it, and is otherwise the scene", () => {
  const stops = read("stops");
  for (const [k, value] of sweep.values.entries()) {
    const there = sceneAt(scene, stops.stops[k], sweep.id, k + 1);
    assert.deepEqual(there.lights[0].position, value);
    assert.equal(there.lights[0].name, scene.lights[0].name);
    assert.equal(there.objects, scene.objects);
    assert.deepEqual(there.levels, [15, 33]);
  }
});

test("what names no stop is none", () => {
  for (const text of ["", "none", `${sweep.id}`, `${sweep.id}:0`, `${sweep.id}:1.5`, `${sweep.id}:${sweep.values.length + 1}`, "other:1"]) assert.equal(stopIn(scene, text), null, text);
  assert.equal(stopIn(scene, `${sweep.id}:2`).stop, 2);
});

test("of two values that are crossed every stop has its number: row by row", () => {
  const grid = { id: "place", values: [1, 2, 3], across: { values: [5, 6] } };
  const stops = Array.from({ length: 8 }, (_, stop) => stopIn({ sweeps: [grid] }, `place:${stop}`)?.stop ?? null);
  assert.deepEqual(stops, [null, 1, 2, 3, 4, 5, 6, null]);
  assert.deepEqual([1, 3, 4, 6].map((stop) => placeOf(grid, stop)), [[0, 0], [2, 0], [0, 1], [2, 1]]);
});

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { held: true });
});
after(async () => {
  assert.deepEqual(page.faults, []);
  await browser.close();
});
const show = (hash) => open(page, ON_DISK, `scenes/${ID}/index.html`, `gl=none&${hash}`);
const slider = () => page.locator(".sweeps input");
const at = (stop) => until(page, (s, t, [wanted]) => s.sweep === wanted && t.tiles.length > 0, [`${sweep.id}:${stop}`]);
const tiles = async () => (await stats(page)).tiles;

test("a link to a stop opens there: tiles, picture, slider and its words are that stop's", async () => {
  await show(`sweep=${sweep.id}:3&tiles=filled&p=9,8&n=15`);
  assert.deepEqual(await tiles(), [...grid(15)[2].tiles]);
  assert.match(await page.locator(".picture img").getAttribute("src"), /lamp-height\/3\/\.\.\/3\.webp$/);
  assert.equal(await slider().inputValue(), "3");
  assert.match(await slider().getAttribute("aria-valuetext"), /stop 3 of 11/);
  assert.match(await page.locator(".sweeps output").innerText(), /−2.*−1.*1/);
  assert.match(page.url(), /sweep=lamp-height:3/);
});

test("keys, buttons and the slider go from stop to stop, and end at the last", async () => {
  await press(page, ">");
  await at(4);
  assert.deepEqual(await tiles(), [...grid(15)[3].tiles]);
  await press(page, "<", "<");
  await at(2);
  await slider().fill("11");
  await at(11);
  await press(page, ">");
  await at(11);
  assert.equal(await page.locator(".sweep button").nth(1).getAttribute("aria-disabled"), "true");
  await page.locator(".sweep button").first().click();
  await at(10);
});

test("at a stop there are two grids; at the scene's own all of them", async () => {
  await press(page, "+", "+", "+");
  await until(page, (s, t) => s.n === 33 && t.tiles.length === 3 * 33 * 33);
  assert.deepEqual(await tiles(), [...grid(33)[9].tiles]);
  await slider().fill(String(sweep.own));
  await at(sweep.own);
  await press(page, "+");
  await until(page, (s, t) => s.n === 55 && t.tiles.length === 3 * 55 * 55);
  await press(page, ">");
  await until(page, (s, t) => s.n === 33 && t.tiles.length === 3 * 33 * 33);
});

test("switches work at a stop as they do in the scene", async () => {
  await show(`sweep=${sweep.id}:8&tiles=filled&n=15&p=9,8`);
  const before = await tiles();
  await press(page, "s");
  await until(page, (s, t, [before]) => JSON.stringify(t.tiles) !== before, [JSON.stringify(before)]);
  const lit = await stats(page);
  assert.ok(lit.lines.some(({ light, kind }) => light < 0 || kind !== "blocked"));
  await press(page, "s");
  await until(page, (s, t, [before]) => JSON.stringify(t.tiles) === before, [JSON.stringify(before)]);
});

test("it goes to and fro by itself until it is stopped", async () => {
  await show(`sweep=${sweep.id}:10&tiles=filled`);
  const seen = [];
  await page.locator(".to-and-fro").click();
  for (let k = 0; k < 4; k++) {
    await pass(page, 451);
    await settled(page);
    seen.push(Number((await state(page)).sweep.split(":")[1]));
  }
  assert.deepEqual(seen, [11, 10, 9, 8]);
  await page.locator(".to-and-fro").click();
  await pass(page, 2000);
  assert.equal((await state(page)).sweep, `${sweep.id}:8`);
});

test("a lesson's step shows its stop, its answer another, and the next step the scene itself", async () => {
  const step = scene.lesson.findIndex(({ view }) => view.sweep);
  await show(`step=${step + 1}`);
  await at(6);
  assert.ok(await page.locator("#sweeps").isVisible());
  await show(`step=${step + 1}&answer=1`);
  await at(3);
  await press(page, "PageDown");
  await until(page, (s, t, [own]) => s.sweep === "" && JSON.stringify(t.tiles) === own, [JSON.stringify([...readTrace(ID, 15).trace.tiles])]);
});

test("a stop that there is not is named, and the scene shown as it is", async () => {
  await show("sweep=lamp-height:99&tiles=filled");
  await until(page, (s, t) => s.sweep === "" && /sweep/.test(t.notice) && t.tiles.length > 0);
  assert.deepEqual(await tiles(), [...readTrace(ID, 15).trace.tiles]);
});

test("the drawer opens the slider in a scene that has one, and offers none where there is none", async () => {
  await show("tiles=filled");
  assert.ok(!(await page.locator("#sweeps").isVisible()));
  await openDrawer(page);
  await page.locator(".open-sweeps").click();
  assert.ok(await page.locator("#sweeps").isVisible());
  assert.equal(await slider().inputValue(), String(sweep.own));
  await open(page, ON_DISK, "scenes/01-shading/index.html", "gl=none");
  await openDrawer(page);
  assert.equal(await page.locator(".open-sweeps:visible").count(), 0);
});

test("a kiosk goes through all stops of a step's answer, and ends where the step stands", async () => {
  const kiosk = await newPage(browser, { held: true, viewport: { width: 640, height: 480 } });
  await open(kiosk, ON_DISK, `scenes/${ID}/index.html`, "kiosk=1&gl=none&attract-pace=0.3");
  const step = scene.lesson.findIndex(({ view }) => view.sweep);
  const seen = new Set();
  const asked = new Set();
  let now = await state(kiosk);
  for (let k = 0; k < 600 && now.step <= step; k++) {
    await pass(kiosk, 200);
    now = await state(kiosk);
    if (now.step === step) (now.revealed ? seen : asked).add(now.sweep);
  }
  assert.deepEqual([...asked], [`${sweep.id}:6`], "while it asks nothing moves");
  assert.equal(seen.size, sweep.values.length);
  assert.equal(now.step, step + 1);
  assert.deepEqual(kiosk.faults, []);
  await kiosk.close();
});
