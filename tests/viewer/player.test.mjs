/** The step-by-step player: by key, by button, by the scrub bar, from the address. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, pass, press, richScene, settled, state, stats, until } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";

const rich = richScene();
const PLAYED = "n=15&p=5,8&speed=1&gl=none";
const START = "still=1&gl=none&n=15&p=5,8&tab=rays"; // flat: the same lines, drawn in less time
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
  await open(page, ON_DISK, rich.path, START);
});
after(() => browser.close());
const button = (name) => page.getByRole("button", { name });
const scrub = () => page.getByRole("slider", { name: "Event" });
const current = async () => (await state(page)).event;
const says = () => page.locator(".lesson-text").innerText();
const lines = async () => (await stats(page)).lines.length;

test("at first there is no current event: all of the pixel's rays show, and the scene's sentence", async () => {
  assert.equal(await current(), null);
  const { lines, events } = await stats(page);
  assert.equal(lines.length, events.filter((event) => event.long > 0).length);
  assert.equal(await page.locator(".event-says").count(), 0);
  await press(page, ",");
  assert.equal(await current(), null);
});

test("full stop and comma go on and back: each event's line, row and sentence belong together", async () => {
  await follow(page, START);
  const { events } = await stats(page);
  const sentences = new Set();
  for (const [k, event] of events.entries()) {
    await press(page, ".");
    assert.equal(await current(), k);
    const now = await stats(page);
    assert.deepEqual(now.lit, { ray: event.ray, light: event.light });
    assert.equal(now.lines.length, events.slice(0, k + 1).filter((each) => each.long > 0).length);
    if (event.long > 0) assert.deepEqual([now.lines.at(-1).ray, now.lines.at(-1).light], [event.ray, event.light]);
    const rows = await page.locator("li.ray.lit").evaluateAll((rows) => rows.map((row) => [Number(row.dataset.ray), Number(row.dataset.light)]));
    assert.deepEqual(rows, [[event.ray, event.light]]);
    const inSight = await page.locator("li.ray.lit").evaluate((row) => row.getBoundingClientRect().top >= row.parentElement.getBoundingClientRect().top - 1);
    assert.ok(inSight);
    assert.equal(await page.locator(".lesson-text").getAttribute("aria-live"), "polite");
    sentences.add(await page.locator(".event-says").innerText());
  }
  assert.equal(sentences.size, events.length, "each has its own sentence");
  const { tiles } = await stats(page);
  assert.ok((await says()).includes(tiles.slice(3 * (8 * 15 + 5), 3 * (8 * 15 + 5) + 3).join(", ")), "the last one names the pixel's colour");
  await press(page, ".");
  assert.equal(await current(), events.length - 1);
  await press(page, ",");
  assert.equal(await current(), events.length - 2);
  await press(page, "Escape");
  assert.equal(await current(), null);
});

test("the buttons do the same", async () => {
  await follow(page, START);
  const shown = () => Promise.all(["One event back", "One event on", "Leave the step-by-step player"].map((name) => button(name).isVisible()));
  assert.deepEqual(await shown(), [false, false, false], "before the first event there is Play and the bar");
  await press(page, ".");
  assert.deepEqual(await shown(), [true, true, true]);
  await button("One event on").click();
  assert.equal(await current(), 1);
  await button("One event back").click();
  await button("One event back").click();
  assert.equal(await current(), null);
  await settled(page);
  assert.deepEqual(await shown(), [false, false, false]);
  await press(page, ".");
  await button("Leave the step-by-step player").click();
  await settled(page);
  assert.equal(await current(), null);
  assert.ok(!(await button("Leave the step-by-step player").isVisible()));
});

test("the event is in the address, and its end is what a link shows", async () => {
  await follow(page, START);
  await press(page, ".", ".", ".");
  await page.waitForFunction(() => location.hash.includes("e=3"));
  const there = await lines();
  await follow(page, `${START}&e=3`);
  assert.equal(await current(), 2);
  assert.equal(await lines(), there);
  await follow(page, `${START}&e=99`);
  assert.equal(await current(), 7, "the nearest there is: the last of eight events");
  assert.match(await page.locator("#notice").innerText(), /\(e\)/);
});

test("another pixel, another grid and a lesson's step begin anew", async () => {
  for (const key of ["ArrowRight", "+"]) {
    await follow(page, `${START}&e=3`);
    await press(page, key);
    assert.equal(await current(), null);
  }
  await follow(page, `${START}&step=1&e=3`);
  assert.equal(await current(), 2);
  await button("Next step").click();
  assert.equal(await current(), null);
});

test("the scrub bar is a slider for hand and keyboard, and says the sentence", async () => {
  await follow(page, START);
  await scrub().focus();
  await press(page, "ArrowRight", "ArrowRight");
  assert.equal(await current(), 1);
  assert.match(await scrub().getAttribute("aria-valuetext"), /^2 of \d+: It meets /);
  await press(page, "ArrowLeft");
  assert.equal(await current(), 0);
  await press(page, "End");
  assert.equal(await current(), (await stats(page)).events.length - 1);
  await press(page, "Home");
  assert.equal(await current(), null);
  assert.deepEqual((await state(page)).pixel, [5, 8], "the arrows move the bar, not the pixel");
  await press(page, ".", "Escape");
  assert.equal(await current(), null, "other keys still work from there");
  const box = await scrub().boundingBox();
  await page.mouse.click(box.x + 0.5 * box.width, box.y + box.height / 2);
  assert.ok((await current()) > 1);
  await scrub().evaluate((bar) => bar.blur());
});

test("without a clock P is at the end at once", async () => {
  await follow(page, "n=15&p=5,8&still=1&gl=none");
  await press(page, "p");
  assert.equal(await current(), (await stats(page)).events.length - 1);
});

test("P plays: time moves the line on, P pauses it there, and the end is the last event", async () => {
  const page = await newPage(browser, { held: true });
  const button = (name) => page.getByRole("button", { name });
  await open(page, ON_DISK, rich.path, PLAYED);
  await press(page, "p");
  assert.equal((await state(page)).playing, true);
  assert.equal(await page.locator(".lesson-text").getAttribute("aria-live"), "off");
  let before = 0;
  for (let k = 0; k < 5; k++) {
    await pass(page, 100);
    const { grown, lines } = await stats(page);
    assert.ok(grown > before && grown < 1 && lines.length === 1 && lines[0].growing);
    before = grown;
  }
  await button("Pause").click();
  await pass(page, 1000);
  assert.equal((await stats(page)).grown, before);
  await button("Play the rays").click();
  await pass(page, 100);
  assert.ok((await stats(page)).grown > before, "on from there");
  await follow(page, `${PLAYED.replace("speed=1", "speed=8")}&e=6`); // sooner at the end
  await button("Play the rays").click();
  await until(page, (s) => !s.playing);
  assert.equal((await state(page)).event, (await stats(page)).events.length - 1);
  assert.deepEqual(page.faults, []);
  await page.close();
});

test("speed is one for rendering and playing", async () => {
  const page = await newPage(browser, { held: true });
  await open(page, ON_DISK, rich.path, "n=15&p=5,8&gl=none");
  const grown = [];
  for (const [speed, frames] of [[4, 3], [1, 12]]) {
    await follow(page, `n=15&p=5,8&gl=none&speed=${speed}`);
    await page.keyboard.press("p");
    await pass(page, 17); // to the first frame it is a part of one
    const begun = (await stats(page)).grown;
    await pass(page, 16 * frames);
    grown.push((await stats(page)).grown - begun);
  }
  assert.ok(grown[0] > 0.1 && Math.abs(grown[0] - grown[1]) < 1e-9, String(grown));
  await press(page, " ");
  assert.equal((await state(page)).playing, false, "rendering takes over");
  assert.deepEqual(page.faults, []);
  await page.close();
});

test("the card names each hit's normal and what each light gives there", async () => {
  await follow(page, START);
  const { trace } = await readTrace(rich.id, 15);
  const shown = (v) => v.toFixed(3).replace("-", "\u2212").replace(/^\u2212(0\.000)$/, "$1");
  const rows = await page.locator("li.ray").evaluateAll((rows) => rows.map((row) => [Number(row.dataset.ray), Number(row.dataset.light), row.innerText]));
  assert.ok(rows.some(([, light]) => light >= 0));
  for (const [ray, light, text] of rows) {
    const at = ray * trace.lights + light;
    if (light < 0 && trace.object[ray] >= 0) assert.ok(text.includes(`normal (${[...trace.normal.slice(3 * ray, 3 * ray + 3)].map(shown).join(", ")})`), text);
    if (light >= 0 && trace.visibility[at] === 1) assert.ok(text.includes(`diffuse ${shown(trace.diffuse[at])} \u00b7 specular ${shown(trace.specular[at])}`), text);
    if (light >= 0) assert.ok(trace.localWeight[ray] > 0, "a mirror asks no light");
  }
});

test("while the player tells, the legend stays as it is", async () => {
  await follow(page, START);
  const all = (await stats(page)).kinds;
  await press(page, ".");
  assert.deepEqual((await stats(page)).kinds, all);
});

test("pointing at a row wins over the current event as long as it lasts", async () => {
  await follow(page, `${START}&e=1`);
  await page.locator("li.ray").nth(1).hover();
  await settled(page);
  assert.notDeepEqual((await stats(page)).lit.ray, (await stats(page)).events[0].ray);
  await page.mouse.move(2, 2);
  await settled(page);
  assert.equal((await stats(page)).lit.ray, (await stats(page)).events[0].ray);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
