/** A kiosk shows itself, is begun by a touch, starts again when nobody is left, and recovers from faults. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, press, scenesOfSite, settled, state, stats, until } from "./browser.mjs";

const scenes = scenesOfSite();
const [first] = scenes;
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(() => browser.close());

const told = async () => (await stats(page)).kiosk;
const isAttract = (s, t) => t.kiosk?.attract === true && document.documentElement.classList.contains("attract");
const isVisited = (s, t) => t.kiosk?.attract === false && t.kiosk.left !== null;
const begun = async (hash = "kiosk=1&attract-pace=60&still=1", path = first.path) => {
  await open(page, ON_DISK, path, hash);
  await until(page, isAttract);
  await page.mouse.click(400, 300);
  await until(page, isVisited);
  await page.waitForTimeout(450); // the cover has faded
};

test("unattended it walks every scene's lesson, in order and round again, under one address", async () => {
  await open(page, ON_DISK, first.path, "kiosk=1&attract-pace=0.02&still=1");
  const seen = await page.evaluate(async (count) => {
    const seen = [];
    for (const end = Date.now() + 15000; Date.now() < end && seen.length < count; await new Promise((done) => setTimeout(done, 5))) {
      const at = window.raywalk.state()?.scene;
      if (at && at !== seen.at(-1)) seen.push(at);
    }
    return seen;
  }, scenes.length + 1);
  assert.deepEqual(seen, [...scenes, first].map(({ id }) => id));
  const { cycles, stops } = await told();
  assert.ok(cycles >= scenes.length && stops > 3 * cycles, `${cycles} cycles, ${stops} stops`);
  assert.match(page.url(), /#kiosk=1&/);
  assert.equal(await page.evaluate(() => history.length <= 3), true, "no way back that piles up");
  assert.deepEqual(page.faults, []);
});

test("a touch begins with the scene that is shown, at its start; what lay under the finger is not pressed", async () => {
  await open(page, ON_DISK, first.path, "kiosk=1&attract-pace=60&still=1");
  await until(page, isAttract);
  assert.equal(await page.locator(".kiosk-begin").innerText(), "Touch to begin\nZum Beginnen berühren");
  const next = await page.locator("nav.scenes a[rel=next]").boundingBox();
  await page.mouse.click(next.x + 20, next.y + 20);
  await until(page, isVisited);
  await settled(page);
  const now = await state(page);
  assert.deepEqual([now.scene, now.step], [first.id, 0]);
  assert.match(page.url(), /visitor=1/);
});

test("a key begins too, and is not one of the viewer's yet", async () => {
  await open(page, ON_DISK, first.path, "kiosk=1&attract-pace=60&still=1");
  await until(page, isAttract);
  const { pixel } = await state(page);
  await page.keyboard.press("ArrowRight");
  await until(page, isVisited);
  assert.deepEqual((await state(page)).pixel, pixel);
});

test("left alone it asks, counts down, goes on at a touch, and else starts again with nothing kept", async () => {
  await begun("kiosk=1&idle=3&warn=1.5&attract-pace=60&still=1");
  await page.getByRole("link", { name: "Deutsch" }).click();
  await until(page, isVisited);
  assert.equal(await page.evaluate(() => document.documentElement.lang), "de");
  await press(page, "c", "x", "PageDown");
  await page.evaluate(() => localStorage.setItem("raywalk test", "kept"));
  const warning = page.locator(".kiosk-warning");
  await warning.waitFor({ state: "visible" });
  assert.match(await warning.innerText(), /Ist noch jemand da\?\s+Beginnt in \d Sekunden? von vorn\s+Weiter/);
  await warning.getByRole("button").click();
  await warning.waitFor({ state: "hidden" });
  assert.ok((await told()).left > 2);
  await until(page, isAttract);
  const now = await state(page);
  assert.deepEqual([now.scene, now.slice, now.colours, now.step], [first.id, "none", "picture", 0]);
  assert.equal(await page.evaluate(() => document.documentElement.lang), "en");
  assert.equal(await page.evaluate(() => localStorage.getItem("raywalk test")), null);
  assert.match(page.url(), /#kiosk=1&idle=3&warn=1.5&attract-pace=60&home=en/);
  assert.doesNotMatch(page.url(), /visitor/);
});

test("the button starts again at once", async () => {
  await begun();
  await press(page, "2", "a", "j");
  await page.getByRole("button", { name: "Start again" }).click();
  await until(page, isAttract);
  const now = await state(page);
  assert.deepEqual([now.scene, now.projector, now.step], [first.id, false, 0]);
});
