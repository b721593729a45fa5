/** Rendering: tiles fill in scan order while the rays of the tile being filled grow. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, pass, press, richScene, state, stats, until } from "./browser.mjs";
import { load } from "./typescript.mjs";
import { readTrace } from "./scene-files.mjs";

const { startState, pressRender, advance } = await load("state/view-state.ts");
const { growingOf, glowing, grownLines, linesOf } = await load("state/growth.ts", "state/lines.ts");
const { withoutCrowd } = await load("state/shown.ts");
const rich = richScene();
const QUICK = "gl=none"; // the same tiles and lines, drawn in less time
const { scene, trace } = await readTrace(rich.id, 15);
const began = (n, speed) => pressRender({ ...startState(scene, { speed, still: false, gl: true }), n });
const longOf = (lines) => lines.reduce((sum, { from, to }) => sum + Math.hypot(...from.map((v, k) => to[k] - v)), 0);

test("60 and 120 frames a second show the same", () => {
  let [slow, fast] = [began(15, 0.25), began(15, 0.25)];
  for (let k = 0; k < 120; k++) {
    slow = advance(slow, 1 / 60);
    fast = advance(advance(fast, 1 / 120), 1 / 120);
    const [a, b] = [growingOf(slow), growingOf(fast)];
    assert.deepEqual([a.row, a.column], [b.row, b.column]);
    assert.ok(Math.abs(a.share - b.share) < 1e-9); // sums of seconds round differently
  }
});

test("at the slowest speed a tile's rays take many frames, at the fastest full ones still glow", () => {
  const shares = [];
  for (let state = began(5, 0.25); growingOf(state).column === 0; state = advance(state, 1 / 60)) shares.push(growingOf(state).share);
  assert.ok(shares.length >= 28 && shares.every((share, k) => k === 0 || share >= shares[k - 1]));
  assert.deepEqual(glowing(advance(began(5, 0.25), 5)), [10, 10], "slow ones are followed one by one");
  const [first, end] = glowing(advance(began(105, 8), 0.2));
  assert.ok(end - first >= 20 && end - first <= 48);
});

test("a tile's lines grow from the camera on, each from where its parent arrives, to all of them", () => {
  for (const pixel of [0, 112, 9 * 15 + 7, 14 * 15]) {
    const all = linesOf(trace, scene, pixel);
    assert.deepEqual(grownLines(trace, scene, pixel, 0), []);
    assert.deepEqual(grownLines(trace, scene, pixel, 1), all);
    let before = 0;
    for (let share = 0.02; share < 1; share += 0.02) {
      const lines = grownLines(trace, scene, pixel, share);
      assert.equal(lines[0].ray, pixel);
      assert.deepEqual(lines[0].from, scene.camera.eye);
      const whole = new Set(lines.filter((line) => !line.growing && line.light < 0).map((line) => line.ray));
      for (const line of lines.slice(1)) assert.ok(whole.has(line.light < 0 ? trace.parent[line.ray] : line.ray), "its parent has arrived");
      assert.ok(longOf(lines) > before);
      before = longOf(lines);
    }
  }
});

test("above 20 000 lines shadow rays are left out, and counted", () => {
  const line = (light) => ({ kind: "camera", from: [0, 0, 0], to: [1, 0, 0], ray: 0, light, leaves: false });
  const many = [...Array(15000).fill(line(-1)), ...Array(5001).fill(line(0))];
  assert.equal(withoutCrowd(many).lines.length, 15000);
  assert.equal(withoutCrowd(many).left, 5001);
  assert.equal(withoutCrowd(many.slice(1)).left, 0);
});

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { held: true, viewport: { width: 800, height: 600 } }); // quickly drawn
  await open(page, ON_DISK, rich.path, QUICK);
});
after(() => browser.close());

test("Space shoots the rays of one tile after the other, in scan order", async () => {
  await follow(page, `${QUICK}&n=5&speed=0.25`);
  await page.keyboard.press(" ");
  await pass(page, 16); // the frame that time begins with
  const tile = 16 * 30; // ms: four times three seconds for all 25
  let order = [];
  for (let k = 0; k < 24; k++) {
    await pass(page, tile / 4);
    const { growing, tilesShown, lines } = await stats(page);
    assert.equal(growing.row * 5 + growing.column, tilesShown, "the first tile that is still empty");
    const quarter = (k + 1) % 4;
    if (quarter === 0) continue; // the next tile's first frame, or this one's last
    // Three quarters of a tile's time are growth. Time began with one of the last two frames, and the last one was up to one ago.
    assert.ok(Math.abs(growing.share - Math.min(1, quarter / 4 / 0.75)) <= (2 * 16) / (0.75 * tile), `${quarter}: ${growing.share}`);
    assert.equal(lines.some((line) => line.growing), growing.share < 1);
    if (quarter === 1) order.push(growing.row * 5 + growing.column);
  }
  assert.deepEqual(order, [0, 1, 2, 3, 4, 5]);
  await press(page, " ");
  assert.equal((await state(page)).tiles, "filled");
  assert.equal((await stats(page)).growing, null);
});

test("a fast rendering shows the rays of tiles that have just been filled", async () => {
  await follow(page, `${QUICK}&n=15&speed=2`);
  await press(page, " ");
  await pass(page, 500);
  const { thin, tilesShown } = await stats(page);
  assert.ok(tilesShown > 60 && thin >= 10);
});

test("still=1 fills at once", async () => {
  await follow(page, `${QUICK}&n=5&still=1`);
  await press(page, " ");
  assert.equal((await state(page)).tiles, "filled");
});

test("where All leaves shadow rays out, the legend says so in a sentence", async () => {
  await follow(page, `${QUICK}&n=105&still=1&rays=all`);
  await until(page, (s, t) => t.shown.n === 105 && t.shown.lines > 0);
  const { left } = await stats(page);
  assert.ok(left > 0);
  assert.match(await page.locator(".legend .left-out").innerText(), /^[\d\u202f]+ shadow rays are left out: .* not drawn\.$/);
  await press(page, "a");
  assert.ok(!(await page.locator(".legend .left-out").isVisible()));
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
