/** Links, pictures, help, full screen, projector, and the page inside another one. */
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { chooseTab, DIST, framedIn, launch, newPage, ON_DISK, open, openMenu, press, reload, richScene, show, state, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { serve } from "./server.mjs";

const rich = richScene();
const START = "still=1&gl=none&n=15&p=5,8";
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true, viewport: { width: 1000, height: 700 } }); // what is drawn costs by its pixels
});
after(() => browser.close());
const button = (name) => page.getByRole("button", { name });

const places = () => page.evaluate(() => JSON.stringify([...document.querySelectorAll("header *, .top-tools *, .tools *, .side > *, .card-head *, .stage-view")].map((each) => each.getBoundingClientRect())));
/** What was done is said, its button ticked, and nothing has moved. */
async function isSaid(before, says) {
  const ticked = page.locator("button.done");
  await ticked.first().waitFor();
  assert.match(await page.locator(".done-sentence[role=status]").innerText(), says);
  assert.equal(await places(), before);
}

/** Another view than the page began with, the menu open, and what is copied kept; where everything then stands. */
async function readyToCopy() {
  await open(page, ON_DISK, rich.path, START);
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: async (text) => void (window.copied = text) } }));
  await press(page, "ArrowRight", "h");
  await openMenu(page);
  return places();
}

test("Link copies the address of this very view, and says so without moving anything", async () => {
  const before = await readyToCopy();
  await button("Copy the link").click();
  await isSaid(before, /link .* is copied/);
  const [copied, there] = [await page.evaluate(() => window.copied), await state(page)];
  assert.ok(copied.startsWith(ON_DISK));
  await open(page, ON_DISK, rich.path, new URL(copied).hash.slice(1));
  assert.deepEqual(await state(page), there);
});

test("Embed copies a frame's code that shows this very view in another page, and says so", async () => {
  const before = await readyToCopy();
  await button("Copy the code").click();
  await isSaid(before, /code .* is copied/);
  const [copied, there] = [await page.evaluate(() => window.copied), await state(page)];
  const outer = await browser.newPage({ viewport: { width: 1000, height: 760 }, deviceScaleFactor: 0.5 });
  const file = join(mkdtempSync(join(tmpdir(), "course-")), "course.html");
  writeFileSync(file, `<!doctype html><meta charset="utf-8"><title>Course</title>${copied}`);
  await outer.goto(pathToFileURL(file).href);
  const frame = await framedIn(outer);
  assert.equal(await outer.locator("iframe").getAttribute("title"), await page.title());
  assert.deepEqual(await frame.evaluate(() => window.raywalk.state()), there);
  assert.ok(await frame.evaluate(() => document.body.classList.contains("embed")));
  await outer.close();
});

// From WebGL a picture is saved in every run by saved-picture.test.mjs.
for (const how of cases(["", "&gl=none", "&slice=row"], ["&gl=none", "&gl=none&slice=row"]))
  test(`Save gives a picture of the view, named by scene and pixel (${how || "WebGL"})`, async () => {
    await open(page, ON_DISK, rich.path, `still=1&n=15&p=5,8&look=plain${how}`);
    if (how.includes("slice")) await page.locator(".slice canvas").waitFor();
    await openMenu(page);
    const before = await places();
    const [download] = await Promise.all([page.waitForEvent("download"), button("Save this view").click()]);
    await isSaid(before, new RegExp(`saved: ${rich.id}-5-8.png`));
    assert.equal(download.suggestedFilename(), `${rich.id}-5-8.png`);
    const { PNG } = await import("pngjs");
    const image = PNG.sync.read(readFileSync(await download.path()));
    const box = await page.locator(".stage-view:visible, .slice:visible").boundingBox();
    assert.ok(Math.abs(image.width - box.width) <= 1 && image.height > box.height);
    const colours = new Set();
    for (let at = 0; at < image.data.length; at += 40) colours.add(image.data.readUInt32BE(at));
    assert.ok(colours.size > 20, "something is drawn");
  });

for (const how of ["", "&gl=none"])
  test(`Slide gives the view as an SVG whose rays end where the stage shows them (${how || "WebGL"})`, async () => {
    await open(page, ON_DISK, rich.path, `still=1&n=15&p=5,8&look=plain${how}`);
    await openMenu(page);
    const before = await places();
    const [download] = await Promise.all([page.waitForEvent("download"), button("A figure of this view").click()]);
    await isSaid(before, new RegExp(`saved: ${rich.id}-5-8.svg`));
    assert.equal(download.suggestedFilename(), `${rich.id}-5-8.svg`);
    const text = readFileSync(await download.path(), "utf8");
    assert.ok(!/href="(?!data:)|<script|style=/.test(text), "nothing from elsewhere");
    const lines = await page.evaluate(() => window.raywalk.stats().lines.length);
    const drawn = [...text.matchAll(/<line x1="([^"]+)" y1="([^"]+)" x2="([^"]+)" y2="([^"]+)"/g)].map((found) => found.slice(1).map(Number));
    assert.equal(drawn.length, lines);
    // A place 0.8 of the way is asked of the stage; lines are written to a hundredth of a pixel. Only
    // the observer's perspective moves it along the line, so it is compared across.
    for (const [k, [x1, y1, x2, y2]] of drawn.entries()) {
      const on = await page.evaluate((line) => window.raywalk.stats().onLine(line), k);
      const away = Math.abs((x2 - x1) * (on.y - y1) - (y2 - y1) * (on.x - x1)) / Math.hypot(x2 - x1, y2 - y1);
      assert.ok(away < 0.1, `line ${k} is ${away} pixels away`);
    }
    assert.match(text, /<text [^>]*>camera<\/text>/);
  });

test("the help sheet lists every key, keeps the focus, and closes with Esc, its key and its cross", async () => {
  await open(page, ON_DISK, rich.path, START);
  for (const close of [() => press(page, "Escape"), () => press(page, "?"), () => page.getByRole("button", { name: "Close (Esc)" }).click()]) {
    await press(page, "?");
    assert.equal(await page.getByRole("dialog").count(), 1);
    for (let k = 0; k < 6; k++) await page.keyboard.press("Tab");
    assert.ok(await page.evaluate(() => document.activeElement === document.body || !!document.activeElement.closest("dialog")));
    await press(page, "a", "PageDown");
    await close();
    assert.equal(await page.getByRole("dialog").count(), 0);
  }
  assert.deepEqual((await state(page)).rays, ["pixel"], "the page keeps still under a sheet");
  assert.equal((await state(page)).scene, rich.id);
  await openMenu(page);
  await button("All keys").click();
  const listed = await page.locator("dialog kbd").allInnerTexts();
  const keys = readFileSync("site_src/viewer/keys.ts", "utf8").match(/const table.*? = \{\n(.*?)\n {2}\};/s)[1];
  const bound = [...keys.matchAll(/^ {4}"?([^":\s]+| )"?:/gm)].map(([, key]) => key).filter((key) => key.length === 1 && key !== " " && key !== "=");
  assert.ok(bound.length > 10);
  assert.deepEqual(bound.filter((key) => !listed.includes(key === "-" ? "\u2212" : key.toUpperCase())), []);
});

test("F asks for the full screen, and a refusal is said", async () => {
  await open(page, ON_DISK, rich.path, START);
  await page.evaluate(() => (document.documentElement.requestFullscreen = () => ((window.asked = true), Promise.reject(new Error("no")))));
  await press(page, "f");
  assert.equal(await page.evaluate(() => window.asked), true);
  assert.match(await page.locator("#notice").innerText(), /does not let this page fill the screen/);
});

test("a lecture's page is light, large, in the address, and shows pressed keys", async () => {
  await show(page, ON_DISK, rich.path, START);
  const looks = () => page.evaluate(() => ["body", ".lesson-text"].map((part) => getComputedStyle(document.querySelector(part))).map((style, k) => (k ? parseFloat(style.fontSize) : style.backgroundColor)));
  const [, plain] = await looks();
  await press(page, "j", "h");
  const [ground, large] = await looks();
  assert.equal(ground, "rgb(255, 255, 255)");
  assert.ok(large >= 1.2 * plain); // how large in a hall: lecture.test.mjs
  assert.match(await page.locator(".key-sign").innerText(), /H\s+rays of the selected row/);
  await page.waitForFunction(() => location.hash.includes("projector=1"));
  await reload(page);
  assert.equal((await state(page)).projector, true);
  await press(page, "2");
  await until(page, (s, t) => t.shown.scene === s.scene && t.shown.scene.startsWith("02"));
  assert.equal((await state(page)).projector, true, "it stays from scene to scene");
  await button("Lecture mode").click();
  assert.equal((await state(page)).projector, false);
});

for (const where of ["a file", "another origin"])
  test(`inside ${where} it is compact, works, and leads to the whole page`, async () => {
    const site = await serve(DIST);
    try {
      const base = where === "a file" ? ON_DISK : site.url;
      const folder = mkdtempSync(join(tmpdir(), "course-"));
      writeFileSync(join(folder, "course.html"), `<!doctype html><title>Course</title><iframe src="${base}${rich.path}?embed#${START}" width="900" height="640" title="Ray walk"></iframe>`);
      const outer = await browser.newPage({ viewport: { width: 1000, height: 760 }, deviceScaleFactor: 0.5 });
      await outer.goto(pathToFileURL(join(folder, "course.html")).href);
      const frame = await framedIn(outer, where !== "a file");
      await frame.locator(".lesson-text").filter({ hasText: /\w/ }).waitFor();
      const isThere = (parts) => Promise.all(parts.map((part) => frame.locator(part).isVisible()));
      assert.deepEqual(await isThere([".stage-view", ".picture", ".lesson-text", ".start-lesson", ".play", ".scrub"]), Array(6).fill(true));
      assert.deepEqual(await isThere([".top", ".top-tools", "nav.scenes", ".card", ".controls", ".legend"]), Array(6).fill(false));
      await frame.getByRole("slider", { name: "Event" }).press("ArrowRight");
      await frame.getByRole("button", { name: "One event on" }).click();
      assert.equal((await frame.evaluate(() => window.raywalk.state())).event, 1);
      const whole = frame.getByRole("link", { name: "Open in Raywalk" });
      await whole.focus();
      const to = new URL(await whole.getAttribute("href"));
      assert.ok(to.href.startsWith(base) && !to.search && to.hash.includes("e=2"), to.href);
      const { wide, small } = await frame.evaluate(() => ({
        wide: document.documentElement.scrollWidth - innerWidth,
        small: [...document.querySelectorAll("button, a, input")].filter((e) => e.checkVisibility({ visibilityProperty: true }) && e.offsetWidth && (e.offsetWidth < 44 || e.offsetHeight < 44)).map((e) => e.getAttribute("aria-label") ?? e.textContent),
      }));
      assert.deepEqual([wide, small], [0, []]);
      await outer.close();
    } finally {
      site.close();
    }
  });

test("the pseudo-code has a tab of the card, marks the current event's line, also while a question waits, and is part of the address", async () => {
  await open(page, ON_DISK, rich.path, START);
  const code = page.getByRole("region", { name: "The algorithm" });
  assert.equal(await code.isVisible(), false);
  await chooseTab(page, "rays");
  const stage = await page.locator(".stage-view").boundingBox();
  await page.getByRole("tab", { name: /pseudo-code/ }).click();
  await code.waitFor();
  assert.deepEqual(await page.locator(".stage-view").boundingBox(), stage, "the stage keeps its room from tab to tab");
  const lines = [];
  const events = await page.evaluate(() => window.raywalk.stats().events.map((event) => event.what));
  for (const what of events) {
    await press(page, ".");
    const here = await page.locator(".code-lines [aria-current]").allInnerTexts();
    assert.equal(here.length, 1, what);
    lines.push([what, here[0]]);
  }
  const of = new Map(lines);
  assert.match(of.get("meets"), /nearest/);
  assert.match(of.get("reached"), /shadow ray/);
  assert.match(of.get("reflected"), /trace\(reflected\)/);
  assert.match(of.get("pixel"), /^pixel/);
  await page.waitForFunction(() => location.hash.includes("tab=code"));
  await reload(page);
  await code.waitFor();
  const asking = await page.evaluate(() => window.raywalk.lesson().findIndex((step) => step.answer));
  await open(page, ON_DISK, rich.path, `still=1&gl=none&step=${asking + 1}&tab=code`);
  await code.waitFor();
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
