/** A slider moves what a sweep moves: each stop is a scene that was traced, and the page shows it as it shows any scene. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { gunzipSync } from "node:zlib";
import { DIST, follow, launch, newPage, ON_DISK, open, pass, press, scenesOfSite, settled, show, state, stats, until } from "./browser.mjs";
import { read as readPublished, readScene, readTrace } from "./scene-files.mjs";
import { cases } from "./cases.mjs";
import { load } from "./typescript.mjs";

const { decode, wholeAgain, sceneAt, placeOf, stopIn } = await load("trace/decode.ts", "trace/whole.ts", "state/swept.ts");
const ID = "02-shadows";
const scene = readScene(ID);
const [sweep] = scene.sweeps;
const read = (name, scene = ID, id = sweep.id) => JSON.parse(gunzipSync(Buffer.from(readFileSync(`${DIST}/scenes/${scene}/${id}/${name}.js`, "utf8").split('"')[3], "base64")));
const grid = (n, scene = ID, id = sweep.id) => wholeAgain(read(n, scene, id).stops).map((json) => decode(json, { scene, n }));

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

const light = (name, intensity, x = 0) => ({ name, intensity, position: [x, 0, 0] });
const area = (name, count, intensity) => Array.from({ length: count }, (_, k) => light(count > 1 ? `${name} ${k + 1}/${count}` : name, intensity / count, k));

test("where a lamp has more or fewer points a stop has its own lights, named in the language of the scene", () => {
  const lamps = { id: "x", of: "x", levels: [], files: {}, objects: [], materials: [], lights: [...area("Lampe", 4, 1), light("Licht", 2)] };
  const stop = (count) => sceneAt(lamps, { picture: "", lights: [...area("lamp", count, 1), light("light 1", 2)] }, "points", 1).lights;
  assert.deepEqual(stop(1).map(({ name }) => name), ["Lampe", "Licht"]);
  assert.deepEqual(stop(2).map(({ name, intensity }) => [name, intensity]), [["Lampe 1/2", 0.5], ["Lampe 2/2", 0.5], ["Licht", 2]]);
  const moved = sceneAt(lamps, { picture: "", lights: [{}, { position: [9, 9, 9] }, {}, {}, {}] }, "points", 1).lights;
  assert.deepEqual([moved[1].name, moved[1].position, moved[0]], ["Lampe 2/4", [9, 9, 9], lamps.lights[0]]);
});

test("each lamp is drawn with as many points at every stop, as bright as it is there: shaders want the same number", async () => {
  const { withMostPoints } = await load("state/between.ts");
  const sweeps = [{ points: [9, 1] }, {}];
  const drawn = [1, 4, 9].map((count) => withMostPoints({ sweeps, lights: [...area("lamp", count, 3), light("light 1", 2)] }));
  for (const { lights } of drawn) {
    assert.equal(lights.length, 10);
    const strength = (of) => lights.filter(({ name }) => name.startsWith(of)).reduce((sum, { intensity }) => sum + intensity, 0);
    assert.ok(Math.abs(strength("lamp") - 3) < 1e-12, "its sum is rounded ten times");
    assert.equal(strength("light"), 2);
  }
  assert.deepEqual(drawn[1].asked.map(({ name }) => name), ["lamp 1/4", "lamp 2/4", "lamp 3/4", "lamp 4/4", "light 1"]);
  const as = { sweeps: [{}], lights: [] };
  assert.equal(withMostPoints(as), as);
});

test("a link's bounce limit is kept that only a deeper stop has; beyond all stops there is none", async () => {
  const { readSwitches, bouncesOf, writeSwitches } = await load("state/switches.ts");
  const shallow = { depth: 2, lights: [], shadows: true, deepest: 6 };
  assert.equal(writeSwitches(readSwitches("b5", shallow)), "b5");
  assert.equal(readSwitches("b7", shallow), null);
  assert.equal(readSwitches("b3", { ...shallow, deepest: undefined }), null);
  assert.equal(bouncesOf(readSwitches("b5", shallow), shallow), 2, "what there is");
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

test("of a sweep some stops stand for all, from end to end, the one that is shown among them, in few words", async () => {
  const { someOfRow, shortValueAt } = await load("state/swept.ts", "sweep-words.ts");
  const long = { values: Array.from({ length: 11 }, (_, k) => [-2, k - 2, 1]), own: 1 };
  assert.deepEqual(someOfRow(long, 3, 5), [1, 3, 6, 9, 11]);
  assert.deepEqual(someOfRow(long, 7, 5), [1, 4, 7, 9, 11]);
  assert.deepEqual(someOfRow({ values: [1, 2, 3], across: { values: [5, 6] }, own: 1 }, 5, 5), [4, 5, 6]);
  globalThis.raywalkWords = { language: { code: "en" } };
  assert.equal(shortValueAt({ values: [1, 2, 3], across: { values: [5, 6] }, own: 1 }, 5).split(" \u00b7 ").length, 2);
  assert.ok(!shortValueAt(long, 3).includes("\u00b7"), "only what is other");
});

test("on paper a step at a stop is on the nearest grid that the stop has, as on the page", async () => {
  const { stopsOf } = await load("stops/seen.ts");
  const files = Object.fromEntries(Object.entries(scene.files).filter(([name]) => name !== `${sweep.id}/15`));
  const at = (stop) => stopsOf({ ...scene, files, lesson: [{ text: "", view: { resolution: 15, sweep: `${sweep.id}:${stop}` } }] })[0].state.n;
  assert.equal(at(1), 33);
  assert.equal(at(sweep.own), 15, "the scene itself has all of its own");
});

test("a bounce limit that is traced and one that is switched show the same tiles, byte for byte", async () => {
  const { createWhatIf } = await load("state/what-if.ts");
  const { AS_TRACED } = await load("state/switches.ts");
  const mirrors = readScene("05-many-bounces");
  const limits = mirrors.sweeps.find(({ id }) => id === "bounce-limit").values;
  for (const n of [15, 33]) {
    const stops = grid(n, "05-many-bounces", "bounce-limit");
    const { trace } = readTrace("05-many-bounces", n);
    const whatIf = createWhatIf();
    for (const [k, bounces] of limits.entries()) {
      const { tiles } = whatIf.of(trace, mirrors, { ...AS_TRACED, bounces }).trace;
      assert.deepEqual(tiles, stops[k].tiles, `${n} x ${n}, ${bounces} bounces`);
    }
  }
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
const goTo = (hash) => show(page, ON_DISK, `scenes/${ID}/index.html`, `gl=none&${hash}`);
const arrive = (hash) => open(page, ON_DISK, `scenes/${ID}/index.html`, `gl=none&${hash}`);
const slider = () => page.locator(".sweeps input");
const at = (stop) => until(page, (s, t, [wanted]) => s.sweep === wanted && t.tiles.length > 0, [`${sweep.id}:${stop}`]);
const tiles = async () => (await stats(page)).tiles;

test("a link to a stop opens there: tiles, picture, slider and its words are that stop's", async () => {
  await goTo(`sweep=${sweep.id}:3&tiles=filled&p=9,8&n=15`);
  assert.deepEqual(await tiles(), [...grid(15)[2].tiles]);
  assert.match(await page.locator(".picture img").getAttribute("src"), /lamp-height\/3\/\.\.\/3\.webp$/);
  assert.equal(await slider().inputValue(), "3");
  assert.match(await slider().getAttribute("aria-valuetext"), /stop 3 of 11/);
  assert.match(await page.locator(".sweeps output").innerText(), /−2.*−1.*1/);
  assert.match(page.url(), /sweep=lamp-height:3/);
});

test("in the traced look the picture over the stage is the stop's, also on the way to it, and the scene's own again", async () => {
  await goTo(`sweep=${sweep.id}:3&look=traced&cam=camera&n=15`);
  const picture = page.locator(".traced-picture img");
  const shows = (file) => until(page, (s, t, [file]) => document.querySelector(".traced-picture img").src.endsWith(file), [file]);
  await shows(`/${ID}/${sweep.id}/3.webp`);
  await press(page, ">");
  await at(4);
  await shows(`/${ID}/${sweep.id}/4.webp`);
  await slider().fill(String(sweep.own));
  await at(sweep.own);
  await shows(`/${ID}/${scene.picture}`);
  assert.ok(await picture.evaluate((image) => image.decode().then(() => image.naturalWidth > 0)));
  await goTo(`sweep=${sweep.id}:3&tiles=filled&p=9,8&n=15`);
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
  await goTo(`sweep=${sweep.id}:8&tiles=filled&n=15&p=9,8`);
  const before = await tiles();
  await press(page, "s");
  await until(page, (s, t, [before]) => JSON.stringify(t.tiles) !== before, [JSON.stringify(before)]);
  const lit = await stats(page);
  assert.ok(lit.lines.some(({ light, kind }) => light < 0 || kind !== "blocked"));
  await press(page, "s");
  await until(page, (s, t, [before]) => JSON.stringify(t.tiles) === before, [JSON.stringify(before)]);
});

test("a slice is drawn at a stop where only light is other; where things have moved it is left, and that is said", async () => {
  await goTo(`sweep=${sweep.id}:8&tiles=filled&n=15&p=9,8`);
  await press(page, "x");
  await until(page, (s) => s.slice === "row" && !!document.querySelector(".slice canvas")); // the page's clock goes on meanwhile
  const other = field?.own === 1 ? 2 : 1;
  const moved = field && readPublished(`${crossed.id}/${field.id}/stops`).stops[other - 1];
  if (!moved?.objects && !moved?.camera) return;
  await open(page, ON_DISK, `scenes/${crossed.id}/index.html`, `gl=none&tiles=filled&sweep=${field.id}:${other}`);
  await press(page, "x");
  await until(page, (s, t) => s.slice === "none" && /moved/.test(t.notice));
});

test("it goes to and fro by itself until it is stopped", async () => {
  await goTo(`sweep=${sweep.id}:10&tiles=filled`);
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
  await goTo(`step=${step + 1}`);
  await at(6);
  assert.ok(await page.locator("#sweeps").isVisible());
  await goTo(`step=${step + 1}&answer=1`);
  await at(3);
  await press(page, "PageDown");
  await until(page, (s, t, [own]) => s.sweep === "" && JSON.stringify(t.tiles) === own, [JSON.stringify([...readTrace(ID, 15).trace.tiles])]);
});

test("a stop that there is not is named, and the scene shown as it is", async () => {
  await goTo("sweep=lamp-height:99&tiles=filled");
  await until(page, (s, t) => s.sweep === "" && /sweep/.test(t.notice) && t.tiles.length > 0);
  assert.deepEqual(await tiles(), [...readTrace(ID, 15).trace.tiles]);
});

test("where something moves, what opens its slider is in sight on arrival, with its name, and in a lecture too; elsewhere there is none", async () => {
  await arrive("tiles=filled");
  const opener = page.locator(".open-sweeps");
  assert.ok(await opener.isVisible());
  assert.match(await opener.innerText(), /lamp height/i);
  assert.ok(!(await page.locator("#sweeps").isVisible()));
  await page.setViewportSize({ width: 390, height: 844 });
  assert.ok((await opener.boundingBox()).y + 44 <= 844, "on a phone within the first screen");
  await page.setViewportSize({ width: 1280, height: 800 });
  await press(page, "j");
  await pass(page, 3000);
  assert.ok(await page.locator("body.resting .lecture-row .open-sweeps").isVisible());
  await press(page, "Escape");
  await opener.click();
  assert.ok(await page.locator("#sweeps").isVisible());
  assert.equal(await slider().inputValue(), String(sweep.own));
  await open(page, ON_DISK, "scenes/04-one-bounce/index.html", "gl=none");
  assert.equal(await page.locator(".open-sweeps:visible").count(), 0);
});

/** How far down the stage the lamp is drawn, in pixels of the canvas: the mean of those that have its colour. */
const lampAt = (of = page) =>
  of.evaluate(() => {
    const canvas = document.querySelector(".stage-view canvas");
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let [count, sum] = [0, 0];
    for (let k = 0; k < data.length; k += 4) if (data[k] > 235 && data[k + 1] > 205 && data[k + 2] > 120 && data[k + 2] < 215) [count, sum] = [count + 1, sum + Math.floor(k / 4 / canvas.width)];
    return sum / count;
  });
const NEAR = 1; // pixel: a disc's edges are of many colours
const lampAtStop = async (stop) => (await arrive(`sweep=${sweep.id}:${stop}&tiles=filled&rays=`), lampAt());
const isNear = (there, expected) => assert.ok(Math.abs(there - expected) < NEAR, `${there}, not ${expected}`);

test("between stops the lamp follows the finger, while tiles are those of the nearest stop; let go, it glides there", async () => {
  const [third, fourth] = [await lampAtStop(3), await lampAtStop(4)];
  const { x, y, width, height } = await slider().boundingBox();
  const finger = (stop) => page.mouse.move(x + 8 + ((width - 16) * (stop - 1)) / (sweep.values.length - 1), y + height / 2);
  const between = fourth + 0.4 * (third - fourth);
  await finger(4);
  await page.mouse.down();
  await finger(3.6);
  await settled(page);
  isNear(await lampAt(), between);
  assert.equal((await state(page)).sweep, `${sweep.id}:4`);
  assert.deepEqual(await tiles(), [...grid(15)[3].tiles]);
  await page.mouse.up();
  await pass(page, 50);
  const leaving = await lampAt();
  assert.ok(leaving > fourth + NEAR && leaving < between - NEAR, "on its way");
  await pass(page, 1000);
  isNear(await lampAt(), fourth);
});

test("whoever wants no motion sees stops alone", async () => {
  const still = await newPage(browser, { held: true, reducedMotion: "reduce" });
  await open(still, ON_DISK, `scenes/${ID}/index.html`, `gl=none&sweep=${sweep.id}:3&tiles=filled&rays=`);
  await press(still, ">");
  await until(still, (s, t) => s.sweep.endsWith(":4") && t.tiles.length > 0);
  const fourth = await lampAt(still);
  await pass(still, 1000);
  assert.equal(await lampAt(still), fourth);
  assert.deepEqual(still.faults, []);
  await still.close();
});

test("a kiosk goes through all stops of a step's answer, and ends where the step stands", async () => {
  const kiosk = await newPage(browser, { held: true, viewport: { width: 640, height: 480 } });
  await open(kiosk, ON_DISK, `scenes/${ID}/index.html`, "kiosk=1&gl=none&attract-pace=0.1");
  const step = scene.lesson.findIndex(({ view }) => view.sweep);
  const seen = new Set();
  const asked = new Set();
  let now = await state(kiosk);
  for (let k = 0; k < 600 && now.step <= step; k++) {
    await pass(kiosk, 80); // less than a stop is shown
    now = await state(kiosk);
    if (now.step === step) (now.revealed ? seen : asked).add(now.sweep);
  }
  assert.deepEqual([...asked], [`${sweep.id}:6`], "while it asks nothing moves");
  assert.equal(seen.size, sweep.values.length);
  assert.equal(now.step, step + 1);
  assert.deepEqual(kiosk.faults, []);
  await kiosk.close();
});

const crossed = scenesOfSite().map(({ id }) => readScene(id)).find(({ id, of, sweeps }) => id === of && sweeps?.some(({ across }) => across));
const field = crossed?.sweeps.find(({ across }) => across);
const [columns, rows] = field ? [field.values.length, field.across.values.length] : [];
const stopOf = (column, row) => `${field.id}:${row * columns + column + 1}`;

test("of two values that are crossed a pad shows all stops: arrows go both ways, a finger drags, and both values are heard", { skip: !field && "nothing is crossed here" }, async () => {
  await open(page, ON_DISK, `scenes/${crossed.id}/index.html`, `gl=none&tiles=filled&sweep=${stopOf(1, 1)}`);
  const pad = page.locator(".pad").first();
  const is = (column, row) => until(page, (s, t, [wanted]) => s.sweep === wanted && t.tiles.length > 0, [stopOf(column, row)]);
  const { pixel } = await state(page);
  await pad.focus();
  await press(page, "ArrowRight");
  await is(2, 1);
  await press(page, "ArrowUp");
  await is(2, 2);
  await press(page, "ArrowLeft", "ArrowDown", "ArrowDown", "ArrowDown");
  await is(1, 0);
  assert.deepEqual((await state(page)).pixel, pixel, "the arrows are the pad's");
  assert.equal(await pad.getAttribute("aria-valuenow"), "2");
  const heard = await pad.getAttribute("aria-valuetext");
  const { number } = await page.evaluate(() => ({ number: document.querySelector(".sweep.crossed output").textContent }));
  assert.equal(heard, number);
  assert.match(heard, new RegExp(`stop 2 of ${columns * rows}`));
  const { x, y, width, height } = await pad.boundingBox();
  const corner = (right, up) => page.mouse.move(x + (right ? width - 12 : 12), y + (up ? 12 : height - 12));
  await corner(false, false);
  await page.mouse.down();
  await is(0, 0);
  await corner(true, true);
  await is(columns - 1, rows - 1);
  await page.mouse.up();
  for (const each of await page.locator(".sweep.crossed :is(button, .pad)").all()) {
    const box = await each.boundingBox();
    assert.ok(box.width >= 44 && box.height >= 44);
  }
});

test("at a stop with other points shadow rays go to as many, and one switch dims them all", { skip: !field?.points && "all stops have the same lights here" }, async () => {
  const counts = [stopOf(1, 0), stopOf(1, 1), stopOf(1, rows - 1)].map((stop) => grid(15, crossed.id, field.id)[Number(stop.split(":")[1]) - 1].lights);
  assert.equal(new Set(counts).size, 3);
  await open(page, ON_DISK, `scenes/${crossed.id}/index.html`, `gl=none&tiles=filled&n=15&p=10,11&sweep=${stopOf(1, 0)}`);
  for (const [k, row] of [0, 1, rows - 1].entries()) {
    if (k) await follow(page, `gl=none&tiles=filled&n=15&p=10,11&sweep=${stopOf(1, row)}`);
    const { lines } = await stats(page);
    assert.equal(lines.filter(({ light }) => light >= 0).length, counts[k]);
  }
  await follow(page, `gl=none&tiles=filled&n=15&p=10,11&sweep=${stopOf(1, 1)}&if=l1x0`);
  const dark = (await stats(page)).tiles;
  const [lit] = [grid(15, crossed.id, field.id)[columns + 1]];
  assert.ok(dark.every((value, at) => value <= lit.tiles[at]) && dark.some((value, at) => value < lit.tiles[at]));
});

test("by itself it goes through a grid in rows, to and fro, each stop beside the one before", { skip: !field && "nothing is crossed here" }, async () => {
  const { countOf, onTheWay, placeOf, wayTo } = await load("state/swept.ts");
  const all = Array.from({ length: countOf(field) }, (_, k) => onTheWay(field, k));
  assert.deepEqual([...all].sort((a, b) => a - b), Array.from(all, (_, k) => k + 1));
  all.forEach((stop, k) => assert.equal(wayTo(field, stop), k));
  for (let k = 1; k < all.length; k++) {
    const [[a, b], [c, d]] = [placeOf(field, all[k - 1]), placeOf(field, all[k])];
    assert.equal(Math.abs(a - c) + Math.abs(b - d), 1);
  }
  await open(page, ON_DISK, `scenes/${crossed.id}/index.html`, `gl=none&tiles=filled&sweep=${stopOf(columns - 2, 0)}`);
  await page.locator(".crossed .to-and-fro").click();
  const seen = [];
  for (let k = 0; k < 3; k++) {
    await pass(page, 451);
    await settled(page);
    seen.push((await state(page)).sweep);
  }
  assert.deepEqual(seen, [stopOf(columns - 1, 0), stopOf(columns - 1, 1), stopOf(columns - 2, 1)]);
});

test("a stop that was shown before is whole within two frames, at 33 x 33 and of a grid: tiles, rays and card", async () => {
  const [of, most] = field ? [crossed, field] : [scene, sweep];
  // Two rows and the first of the third: beyond them the way goes on as it began.
  const all = most.values.length * (most.across?.values.length ?? 1);
  const count = cases(all, Math.min(all, 2 * most.values.length + 1));
  await open(page, ON_DISK, `scenes/${of.id}/index.html`, `gl=none&n=33&tiles=filled&sweep=${most.id}:1`);
  /** Of the frame that was drawn last. */
  const shown = async () => {
    const { tiles, lines, renders } = await stats(page);
    return { renders, whole: JSON.stringify([await page.locator(".card-head").innerText(), tiles, lines]) };
  };
  const known = new Map();
  for (let k = 1; k < count; k++) {
    await press(page, ">");
    await until(page, () => !window.raywalk.loading().length); // the scene's own stop has a file of its own; now each is decoded
    known.set((await state(page)).sweep, (await shown()).whole);
  }
  assert.ok(new Set(known.values()).size > count / 2, "stops differ");
  for (let k = 2; k < count; k++) {
    const before = await shown();
    await page.keyboard.press("<");
    await pass(page, 2 * 16);
    const now = await shown();
    assert.equal(now.whole, known.get((await state(page)).sweep));
    assert.ok(now.renders > before.renders);
  }
});
