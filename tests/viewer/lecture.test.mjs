/** A lecture: what can be read from the last row, what goes while the pointer rests, and what a clicker does. */
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, pass, press, richScene, scenesOfSite, settled, show, showsScene, state, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene, readWords } from "./scene-files.mjs";

const rich = richScene();
const HALL = { width: 1920, height: 1080 };
const QUICK = "still=1&gl=none&projector=1";
const RESTS = 2500; // ms without the pointer moving
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { held: true, viewport: HALL });
});
after(() => browser.close());
afterEach(async () => {
  assert.deepEqual(page.faults, []);
  await page.setViewportSize(HALL);
});

/** The smallest type in these parts, px, where they are seen; each of them must be. */
const smallest = (...parts) =>
  page.evaluate((parts) => parts.map((part) => {
    const scaled = (each) => (each instanceof SVGGraphicsElement ? each.getScreenCTM().a : 1); // a tree is drawn larger
    const sizes = [...document.querySelectorAll(part)].filter((each) => each.checkVisibility({ visibilityProperty: true }) && each.textContent.trim()).map((each) => parseFloat(getComputedStyle(each).fontSize) * scaled(each));
    return [part, Math.min(...sizes)];
  }), parts);
async function atLeast(px, ...parts) {
  for (const [part, size] of await smallest(...parts)) assert.ok(size >= px && size < 200, `${part}: ${size} px`);
}

test("at 1920 x 1080 the sentence has at least 36 px, numbers 26, labels 20", async () => {
  await show(page, ON_DISK, rich.path, `${QUICK}&n=15&p=5,8`);
  await atLeast(20, ".labels span");
  await atLeast(36, ".lesson-text p");
  await press(page, ".", ".", ".");
  await page.locator(".event-numbers").waitFor();
  await settled(page);
  await atLeast(36, ".event-says");
  await atLeast(26, ".event-numbers");
  await atLeast(20, ".labels span", ".event-count");
  await follow(page, `${QUICK}&step=2`);
  await atLeast(36, ".lesson-text p");
  await atLeast(20, ".lesson-place");
  const numbers = { rays: [".says", ".where", ".brings"], tree: [".tree .node-name"], sum: [".sum-title", ".formula"], code: [".code-lines li"] };
  for (const [tab, parts] of Object.entries(numbers)) {
    await follow(page, `${QUICK}&n=15&p=5,8&tab=${tab}`);
    await page.locator(parts[0]).first().waitFor();
    await atLeast(tab === "tree" ? 20 : 26, ".pixel", ...parts); // a node's name is a label
  }
});

test("no sentence of the event bar is cut off at that size, and the stage keeps its room", async () => {
  await show(page, ON_DISK, rich.path, `${QUICK}&n=15&p=5,8`);
  const box = () => page.locator(".stage-view").boundingBox();
  const before = await box();
  assert.ok(before.width === HALL.width && before.height >= 0.8 * HALL.height, `the stage has ${before.width} x ${before.height}`);
  const events = await page.evaluate(() => window.raywalk.stats().events.length);
  for (let k = 0; k < events; k++) {
    await press(page, ".");
    assert.deepEqual(await box(), before);
    const cut = await page.evaluate(() => document.querySelector(".lesson-text").scrollHeight - document.querySelector(".lesson-text").clientHeight);
    assert.ok(cut <= 0, `event ${k + 1}: ${cut} px are cut off`);
  }
});

test("controls go while the pointer rests and come when it moves; what has the keyboard's focus stays", async () => {
  await show(page, ON_DISK, rich.path, `${QUICK}&step=1`);
  const HIDDEN = [".top", ".top-tools", ".below-row"];
  const shown = () => page.evaluate((parts) => parts.filter((part) => getComputedStyle(document.querySelector(part)).opacity !== "0"), HIDDEN);
  const gone = async () => {
    await pass(page, RESTS + 100);
    await page.waitForFunction((parts) => parts.every((part) => getComputedStyle(document.querySelector(part)).opacity === "0"), HIDDEN);
  };
  const stage = await page.locator(".stage-view").boundingBox();
  await page.mouse.move(600, 400);
  await gone();
  assert.ok(await page.locator(".lesson-text").isVisible());
  assert.deepEqual(await page.locator(".stage-view").boundingBox(), stage, "it keeps its place");
  await page.mouse.move(620, 400);
  await page.waitForFunction((parts) => parts.every((part) => getComputedStyle(document.querySelector(part)).opacity === "1"), HIDDEN);
  await page.locator(".render").focus();
  await pass(page, RESTS + 100);
  await page.waitForFunction(() => getComputedStyle(document.querySelector(".top")).opacity === "0");
  assert.deepEqual(await shown(), [".below-row"]);
  await press(page, "j");
  assert.equal((await state(page)).projector, false);
  await pass(page, RESTS + 100);
  await page.waitForFunction((parts) => parts.every((part) => getComputedStyle(document.querySelector(part)).opacity === "1"), HIDDEN);
});

test("begun by a click on its button it has no tools over the picture once the pointer rests; how far the lesson has come is still seen", async () => {
  await show(page, ON_DISK, rich.path, "still=1&gl=none&step=2");
  await page.locator("button.lecture").click();
  assert.equal((await state(page)).projector, true);
  await pass(page, RESTS + 100);
  await page.waitForFunction(() => getComputedStyle(document.querySelector(".top-tools")).opacity === "0");
  assert.ok(await page.locator(".lesson-place").isVisible());
  assert.equal(await page.locator(".lesson-steps .next").isVisible(), false);
});

test("what the lines mean stays in sight in one row over the sentence, as large as numbers, with the keys that lead on, and goes back with the lecture", async () => {
  await show(page, ON_DISK, rich.path, "still=1&gl=none&step=2");
  const legend = page.locator(".legend");
  const shown = await legend.innerText();
  await press(page, "j");
  await pass(page, RESTS + 100);
  assert.equal(await legend.innerText(), shown);
  assert.match(shown, /shadow ray: reaches the light/);
  await atLeast(26, ".legend li:not([hidden])");
  await atLeast(20, ".lecture-keys");
  const [it, keys, text, below] = await Promise.all([".legend", ".lecture-keys", ".lesson-text", ".below"].map((part) => page.locator(part).boundingBox()));
  assert.ok(it.y >= below.y && it.y + it.height <= text.y && it.x + it.width <= keys.x && it.height < 40, JSON.stringify([it, keys, text, below]));
  assert.match(await page.locator(".lecture-keys").innerText(), /Page down\s+next step\s+Esc\s+leave the lecture/);
  await press(page, "j");
  assert.ok(await page.locator(".side > .legend").isVisible());
  assert.equal(await page.locator(".lecture-keys").count(), 0);
});

test("Escape leaves first the event that is told, then the lecture", async () => {
  await show(page, ON_DISK, rich.path, `${QUICK}&n=15&p=5,8&e=1`);
  await press(page, "Escape");
  assert.deepEqual([(await state(page)).event, (await state(page)).projector], [null, true]);
  await press(page, "Escape");
  assert.equal((await state(page)).projector, false);
});

test("when a clicker goes on to the next lesson its title stands on the stage for a while", async () => {
  const at = scenesOfSite().findIndex(({ id }) => id === rich.id);
  const { lesson } = readScene(rich.id);
  const next = readScene(scenesOfSite()[at + 1].id);
  await show(page, ON_DISK, rich.path, `${QUICK}&step=${lesson.length}&answer=1`);
  const sign = page.locator(".title-sign");
  assert.equal(await sign.count(), 0);
  await press(page, "PageDown");
  await until(page, () => document.querySelector(".title-sign"));
  assert.ok((await sign.innerText()).endsWith(next.title));
  await pass(page, 3100);
  assert.equal(await sign.count(), 0);
});

test("B blackens all of it until a key or a click, which does nothing else; outside of a lecture B is no key", async () => {
  await show(page, ON_DISK, rich.path, QUICK);
  const black = page.locator(".blackout");
  const { pixel } = await state(page);
  for (const again of [() => press(page, "ArrowRight"), () => press(page, "b"), () => page.mouse.click(700, 500)]) {
    await press(page, "b");
    await black.waitFor();
    assert.deepEqual(await black.boundingBox(), { x: 0, y: 0, ...HALL });
    assert.equal(await black.evaluate((each) => getComputedStyle(each).backgroundColor), "rgb(0, 0, 0)");
    await again();
    await settled(page);
    assert.equal(await black.count(), 0);
    assert.deepEqual((await state(page)).pixel, pixel);
  }
  await press(page, "j", "b");
  assert.equal(await black.count(), 0);
});

test("a clicker has Page down alone: it begins the lesson, and at its end the next scene's", async () => {
  const [first, second] = scenesOfSite();
  await show(page, ON_DISK, first.path, QUICK);
  await press(page, "PageDown");
  assert.deepEqual([(await state(page)).scene, (await state(page)).step], [first.id, 0]);
  const stops = await page.evaluate(() => window.raywalk.lesson().reduce((sum, { answer }) => sum + (answer ? 2 : 1), 0));
  for (let k = 1; k < stops; k++) await press(page, "PageDown");
  assert.equal((await state(page)).revealed, true);
  await press(page, "PageDown");
  await showsScene(page, second.id);
  const now = await state(page);
  assert.deepEqual([now.scene, now.step, now.projector], [second.id, 0, true]);
});

/** The step or answer of all lessons that says most: its scene, number, and whether it is an answer. */
function wordiest(lessonOf) {
  const said = scenesOfSite().flatMap((scene) =>
    lessonOf(scene.id).flatMap(({ html, answer }, k) => [{ scene, step: k + 1, html }, ...(answer ? [{ scene, step: k + 1, html: answer.html, isAnswer: true }] : [])]),
  );
  const lengthOf = ({ html }) => html.replace(/<[^>]+>/g, "").length;
  return said.reduce((most, each) => (lengthOf(each) > lengthOf(most) ? each : most));
}
const LANGUAGES = [["", (id) => readScene(id).lesson], ["de/", (id) => readWords(id, "de").lesson]];
for (const [home, lessonOf] of cases(LANGUAGES, LANGUAGES.slice(1))) // its words are longer
  for (const [where, size, hash] of [["in a hall", HALL, QUICK], ["on a desk", { width: 1280, height: 800 }, "still=1&gl=none"]])
    test(`the step with the most words is seen whole ${where} (${home || "en/"})`, async () => {
      const { scene, step, isAnswer } = wordiest(lessonOf);
      await page.setViewportSize(size);
      await show(page, ON_DISK, home + scene.path, `${hash}&step=${step}${isAnswer ? "&answer=1" : ""}`);
      const text = page.locator(".lesson-text");
      assert.ok((await text.innerText()).length > 100);
      const [cut, bottom] = await text.evaluate((it) => [it.scrollHeight - it.clientHeight, it.getBoundingClientRect().bottom]);
      assert.ok(cut <= 1, `${scene.id}, step ${step}: ${cut} px of it cannot be seen`);
      assert.ok(bottom <= size.height, `it ends at ${bottom}`);
    });
