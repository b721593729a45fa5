/** Every scene's lesson: walked by button, by key and by clicker, and every stop of it reached by its link. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, press, scenesOfSite, settled, showsScene, state, stats, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene, readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { switchesFrom, isSwitched } = await load("state/switches.ts");

const scenes = scenesOfSite();
const QUICK = "still=1&gl=none"; // a lesson is the same on the flat stage, which needs no compiled shaders
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 800, height: 500 } }); // small: drawn in less time
});
after(() => browser.close());
const button = (name) => page.getByRole("button", { name });
const words = (html) => html.replace(/<[^>]+>/g, "").replace(/&[^;]+;/g, "").replace(/\s+/g, "").normalize("NFKC"); // browsers set a formula's letters in italics of their own, and spaces round them
/** Steps and answers in the order in which they are walked. */
const stopsOf = (lesson) =>
  lesson.flatMap(({ html, view, answer, choices }, step) => [
    { step, revealed: false, asks: !!answer, choices, html, view },
    ...(answer ? [{ step, revealed: true, asks: false, ...answer }] : []),
  ]);

function fits(now, stop, scene) {
  const { step, revealed, view } = stop;
  assert.deepEqual([now.step, now.revealed], [step, revealed]);
  assert.equal(now.n, view.resolution ?? scene.start.resolution);
  if (view.pixel) assert.deepEqual(now.pixel, view.pixel);
  assert.deepEqual([...now.rays].sort(), [...(view.rays ?? ["pixel"])].sort());
  assert.equal(now.tiles, view.tiles ?? "empty");
  assert.deepEqual(now.observer, view.observer ?? "start");
  assert.deepEqual(now.switches, switchesFrom(view.switches, scene));
}

// A kiosk walks every one in each run (kiosk.test.mjs).
for (const { id, path } of cases(scenes, scenes.filter(({ key }) => ["3", "5"].includes(key))))
  test(`${id}: one click starts the lesson, Next and Page down walk it to its end, and every stop's link comes back to it`, async () => {
    const { scene } = await readTrace(id, 15);
    const stops = stopsOf(scene.lesson);
    assert.ok(scene.lesson.length >= 4 && scene.lesson.length <= 12, `${scene.lesson.length} steps`); // in a row of lessons one may be short
    assert.ok(stops.at(-1).revealed, "it ends with an answer");
    await open(page, ON_DISK, path, QUICK);
    await button("Start the lesson").click();
    const links = [];
    for (const [k, stop] of stops.entries()) {
      await settled(page);
      await until(page, (s, t) => t.shown.n === s.n); // another grid comes with its rays
      const there = await state(page);
      fits(there, stop, scene);
      assert.ok(words(await page.locator(".lesson-text").innerText()).startsWith(words(stop.html).slice(0, 40)));
      assert.equal(await page.locator(".reveal").isVisible(), stop.asks);
      await page.waitForFunction((part) => location.hash.endsWith(part), `step=${stop.step + 1}${stop.revealed ? "&answer=1" : ""}&still=1&gl=none`);
      const hash = new URL(page.url()).hash.slice(1);
      assert.deepEqual([...new URLSearchParams(hash).keys()].sort(), ["gl", "still", "step", ...(stop.revealed ? ["answer"] : [])].sort(), "a stop as it is needs no more");
      links.push([hash, there]);
      if (k === stops.length - 1) break;
      if (k % 2) await press(page, "PageDown");
      else await (stop.choices ? button("Reveal without choosing") : button("Next step")).click();
    }
    for (const [hash, there] of links.reverse().slice(1)) { // slice: the page is at the last one
      await follow(page, hash);
      assert.deepEqual(await state(page), there);
    }
  });

// Scene 1 shows what a switch does before it asks; 6, 7 and 9 are about meshes, and about a picture as a whole.
for (const { id } of scenes.filter(({ key }) => "234580".includes(key || "-")))
  test(`${id}: its lesson lets a person predict what a switch does, and then switches`, () => {
    const { lesson, ...scene } = readScene(id);
    const asked = lesson.filter(({ view, answer }) => answer && isSwitched(switchesFrom(answer.view.switches, scene)) && !isSwitched(switchesFrom(view.switches, scene)));
    assert.ok(asked.length > 0);
    for (const { view, answer, choices = [] } of asked) {
      const pixel = choices.find(({ right }) => right)?.pixel ?? view.pixel; // one that was to be chosen is shown then
      assert.deepEqual([answer.view.tiles ?? "empty", answer.view.pixel, answer.view.resolution], ["filled", pixel, view.resolution], "the answer shows on the tiles");
    }
  });

test("Page up goes back, first from an answer to its question", async () => {
  const { scene } = await readTrace(scenes[0].id, 15);
  const stops = stopsOf(scene.lesson);
  await open(page, ON_DISK, scenes[0].path, `${QUICK}&step=${scene.lesson.length}&answer=1`);
  for (const stop of stops.toReversed()) {
    fits(await state(page), stop, scene);
    if (stop !== stops[0]) await press(page, "PageUp");
  }
});

test("after the last answer Page down begins the next scene's lesson: a clicker gives the whole course", async () => {
  const { scene } = await readTrace(scenes[0].id, 15);
  await open(page, ON_DISK, scenes[0].path, `${QUICK}&step=${scene.lesson.length}&answer=1`);
  await press(page, "PageDown");
  await showsScene(page, scenes[1].id);
  assert.equal((await state(page)).step, 0);
});

test("one press too many is undone: Page up at a lesson's first step leads to the end of the one before, question and answer", async () => {
  const { scene } = await readTrace(scenes[0].id, 15);
  const last = scene.lesson.length - 1;
  await open(page, ON_DISK, scenes[1].path, `${QUICK}&step=1`);
  await press(page, "PageUp");
  await showsScene(page, scenes[0].id);
  fits(await state(page), stopsOf(scene.lesson).at(-1), scene);
  assert.deepEqual([(await state(page)).step, (await state(page)).revealed], [last, Boolean(scene.lesson[last].answer)]);
  assert.equal((await stats(page)).notice, "");
  await press(page, "PageDown");
  await showsScene(page, scenes[1].id);
  assert.equal((await state(page)).step, 0);
});

test("at a lesson's end the button beside its place names the way on and leads there, on a phone too", async () => {
  const { scene } = await readTrace(scenes[0].id, 15);
  const narrow = await newPage(browser, { viewport: { width: 390, height: 844 } });
  for (const of of [page, narrow]) {
    await open(of, ON_DISK, scenes[0].path, `${QUICK}&step=${scene.lesson.length}&answer=1`);
    const next = of.locator(".lesson-steps .next");
    assert.match(await next.innerText(), /Next lesson/);
    await next.click();
    await showsScene(of, scenes[1].id);
    assert.equal((await state(of)).step, 0);
  }
  assert.deepEqual(narrow.faults, []);
  await narrow.close();
});

test("Reveal works by keyboard, and the focus goes on to Next", async () => {
  const { scene } = await readTrace(scenes[0].id, 15);
  const asking = scene.lesson.findIndex((step) => step.answer);
  await open(page, ON_DISK, scenes[0].path, `${QUICK}&step=${asking + 1}`);
  await page.locator(".reveal").focus();
  await press(page, "Enter");
  assert.equal((await state(page)).revealed, true);
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-label")), "Next step");
});

test("a step that was changed keeps the change in its link", async () => {
  await open(page, ON_DISK, scenes[0].path, `${QUICK}&step=2`);
  await press(page, "+", "ArrowRight", "h", " ", "r");
  await until(page, (s, t) => t.tiles.length > 0);
  await page.waitForFunction(() => location.hash.includes("cam=camera"));
  const [there, hash] = [await state(page), new URL(page.url()).hash.slice(1)];
  await follow(page, QUICK);
  await follow(page, hash);
  assert.deepEqual(await state(page), there);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
