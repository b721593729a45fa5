/** A kiosk shows itself, is begun by a touch, starts again when nobody is left, and recovers from faults. Its hours and
 *  seconds are a held clock's: none of them depends on how fast this machine is. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { launch, newPage, ON_DISK, open, openMenu, pass, press, scenesOfSite, settled, state, stats, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";

const scenes = scenesOfSite();
const [first] = scenes;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
let browser, page;
before(async () => (browser = await launch()));
after(() => browser.close());
beforeEach(async () => (page = await newPage(browser, { held: true })));
afterEach(() => page.close());

const PACE = 7; // seconds that a stop is shown, where the address does not say
const FADES = 400; // ms, of cover and warning
const status = async (of = page) => (await stats(of)).kiosk;
const isAttract = (s, t) => t.kiosk?.attract === true && document.documentElement.classList.contains("attract");
const isVisited = (s, t) => t.kiosk?.attract === false && t.kiosk.left !== null;
/** Flat where the stage is not what is asked about: it needs no compiled shaders. */
const FLAT = "kiosk=1&still=1&gl=none";
const begun = async (hash = FLAT) => {
  await open(page, ON_DISK, first.path, hash);
  await until(page, isAttract);
  await page.mouse.click(400, 300);
  await until(page, isVisited);
  await pass(page, FADES + 50);
};
/** The page is loaded anew, soon after it was given a reason. */
const loadsAnew = (why) => Promise.all([page.waitForEvent("load"), why().then(() => pass(page, 500))]);

test("unattended it walks every scene's lesson, in order and round again, under one address", async () => {
  const page = await newPage(browser, { held: true, viewport: { width: 640, height: 480 } }); // quickly drawn
  const pace = 2; // seconds: the clock's frames are what costs here
  const walked = cases([...scenes, first], [...scenes.slice(-2), first]);
  await open(page, ON_DISK, walked[0].path, `${FLAT}&attract-pace=${pace}`);
  const stopsOf = ({ id }) => readScene(id).lesson.flatMap(({ answer }, step) => [`${id} ${step} false`, ...(answer ? [`${id} ${step} true`] : [])]);
  for (const [k, stop] of walked.flatMap(stopsOf).entries()) {
    await until(page, (s, t, [stops, stop]) => t.kiosk.stops === stops && `${s.scene} ${s.step} ${s.revealed}` === stop, [k + 1, stop]);
    await pass(page, 1000 * pace - 100); // asking took a little, too
    if (k === 20) assert.equal((await status(page)).stops, 21, "not before its time"); // by now we ask soon after it has come
  }
  assert.equal((await status(page)).cycles, walked.length - 1);
  assert.match(page.url(), /#kiosk=1&/);
  assert.equal(await page.evaluate(() => history.length <= 3), true, "no way back that piles up");
  assert.deepEqual(page.faults, []);
  await page.close();
});

test("a touch begins with the scene that is shown, at its start; what lay under the finger is not pressed", async () => {
  await open(page, ON_DISK, first.path, FLAT);
  await until(page, isAttract);
  assert.equal(await page.locator(".kiosk-begin").innerText(), "Touch to begin\nZum Beginnen berühren");
  const below = await page.locator(".chooser").boundingBox();
  await page.mouse.click(below.x + 20, below.y + 20);
  await until(page, isVisited);
  await settled(page);
  const now = await state(page);
  assert.deepEqual([now.scene, now.step], [first.id, 0]);
  assert.match(page.url(), /visitor=1/);
  assert.equal(await page.locator("nav.scenes").isVisible(), false);
});

test("a key begins too, and is not one of the viewer's yet", async () => {
  await open(page, ON_DISK, first.path, FLAT);
  await until(page, isAttract);
  const { pixel } = await state(page);
  await page.keyboard.press("ArrowRight");
  await until(page, isVisited);
  assert.deepEqual((await state(page)).pixel, pixel);
});

test("left alone it asks, counts down, goes on at a touch, and else starts again with nothing kept", async () => {
  await begun("kiosk=1&idle=80&warn=15&still=1&gl=none");
  await openMenu(page);
  await page.getByRole("link", { name: "Deutsch" }).click();
  await until(page, isVisited);
  assert.equal(await page.evaluate(() => document.documentElement.lang), "de");
  await press(page, "c", "x", "PageDown");
  await page.evaluate(() => localStorage.setItem("raywalk test", "kept"));
  const warning = page.locator(".kiosk-warning");
  await pass(page, 64_000);
  assert.ok(!(await warning.isVisible()));
  await pass(page, 3000);
  assert.match(await warning.innerText(), /Ist noch jemand da\?\s+Beginnt in 1[2-5] Sekunden von vorn\s+Weiter/);
  await warning.getByRole("button").click();
  await pass(page, FADES);
  assert.ok(!(await warning.isVisible()));
  assert.ok((await status()).left > 79);
  await pass(page, 78_000);
  assert.equal((await status()).attract, false);
  await pass(page, 2000);
  await until(page, isAttract);
  const now = await state(page);
  assert.deepEqual([now.scene, now.slice, now.colours, now.step], [first.id, "none", "picture", 0]);
  assert.equal(await page.evaluate(() => document.documentElement.lang), "en");
  assert.equal(await page.evaluate(() => localStorage.getItem("raywalk test")), null);
  assert.match(page.url(), /#kiosk=1&idle=80&warn=15&home=en/);
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

test("every target is at least 64 px each way, and nothing is cut off, on a wide, a small and an upright screen", async () => {
  await begun();
  for (const size of [{ width: 1920, height: 1080 }, { width: 1280, height: 800 }, { width: 1080, height: 1920 }]) {
    await page.setViewportSize(size);
    await settled(page);
    for (const hash of ["step=1", "e=3&n=15", "colours=tests&if=-shadows"]) {
      await page.evaluate((hash) => {
        history.replaceState(null, "", `${location.hash.replace(/&?(step|e|n|colours|if)=[^&]*/g, "")}&${hash}`);
        window.dispatchEvent(new PopStateEvent("popstate"));
      }, hash);
      await until(page, (s, t) => t.shown.n === s.n);
      const small = await page.evaluate(() => {
        const targets = [...document.querySelectorAll("button, a[href], select, input, summary")].filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.matches(".skip, .card *, .lesson-text *"));
        return targets
          .map((each) => ({ name: each.getAttribute("aria-label") ?? each.textContent.trim().slice(0, 30), box: each.getBoundingClientRect() }))
          .filter(({ box }) => box.width < 63.5 || box.height < 63.5 || box.right > innerWidth + 1 || box.left < -1)
          .map(({ name, box }) => `${name}: ${Math.round(box.width)} x ${Math.round(box.height)} at ${Math.round(box.left)}`);
      });
      assert.deepEqual(small, [], `${JSON.stringify(size)} ${hash}`);
    }
  }
});

test("no menu, no selection, no zoom, no shortcut of the browser, no way out", async () => {
  await begun();
  const prevented = await page.evaluate(() => {
    const on = document.querySelector(".lesson-text");
    const fire = (event) => !on.dispatchEvent(event);
    const options = { bubbles: true, cancelable: true };
    return {
      contextmenu: fire(new MouseEvent("contextmenu", options)),
      selectstart: fire(new Event("selectstart", options)),
      dragstart: fire(new Event("dragstart", options)),
      zoom: fire(new WheelEvent("wheel", { ...options, ctrlKey: true })),
      print: fire(new KeyboardEvent("keydown", { ...options, key: "p", ctrlKey: true })),
      reload: fire(new KeyboardEvent("keydown", { ...options, key: "F5" })),
      back: fire(new KeyboardEvent("keydown", { ...options, key: "ArrowLeft", altKey: true })),
      wheel: fire(new WheelEvent("wheel", options)),
      ...Object.fromEntries(["Backspace", "'", "/"].map((key) => [key, fire(new KeyboardEvent("keydown", { ...options, key }))])),
      mouseBack: ["mousedown", "mouseup"].every((what) => fire(new MouseEvent(what, { ...options, button: 3 }))),
      mouseForward: ["mousedown", "mouseup"].every((what) => fire(new MouseEvent(what, { ...options, button: 4 }))),
      mouseLeft: fire(new MouseEvent("mousedown", options)),
    };
  });
  assert.deepEqual(prevented, { contextmenu: true, selectstart: true, dragstart: true, zoom: true, print: true, reload: true, back: true, wheel: false, Backspace: true, "'": true, "/": true, mouseBack: true, mouseForward: true, mouseLeft: false });
  const address = page.url();
  const input = await page.context().newCDPSession(page);
  for (const button of ["back", "forward"]) for (const type of ["mousePressed", "mouseReleased"]) await input.send("Input.dispatchMouseEvent", { type, button, x: 400, y: 300, clickCount: 1 });
  await settled(page);
  assert.equal(page.url(), address);
  assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector(".lesson-text")).userSelect), "none");
  const made = await page.evaluate(() => {
    document.querySelector(".lesson-text").insertAdjacentHTML("beforeend", '<p><a href="https://example.org/" target="_blank">a book</a> <a href="../../slides/index.html">slides</a> <a href="../02-shadows/index.html">next</a></p>');
    return Promise.resolve().then(() => [...document.querySelectorAll(".lesson-text p:last-child a")].map((link) => link.hasAttribute("href")));
  });
  assert.deepEqual(made, [false, false, true]);
  await openMenu(page);
  for (const part of [".tools", ".take-open"]) assert.ok(!(await page.locator(part).isVisible()), `${part}: nothing that is saved or copied`);
});

test("the gallery and the model page are the kiosk's too: no way out, a way back, and idle they start again", async () => {
  await begun();
  await page.locator("a.brand").click();
  await page.locator("body.gallery").waitFor({ state: "attached" }); // at first a page has no body
  assert.match(page.url(), /index\.html#kiosk=1&.*visitor=1/);
  await page.getByRole("link", { name: /model/i }).click();
  await page.waitForURL(/model\/index\.html#kiosk=1/);
  for (const link of await page.locator("a[href]").evaluateAll((all) => all.map((each) => each.href))) assert.ok(link.startsWith(ON_DISK) && !link.includes("slides/"), link);
  await page.getByRole("button", { name: "Start again" }).waitFor();
  await pass(page, 80_000);
  assert.match(page.url(), /model/);
  await pass(page, 11_000);
  await until(page, isAttract);
  assert.equal((await state(page)).scene, first.id);
  assert.deepEqual(page.faults, []);
});

test("after hours unattended the page begins anew, between two rounds and not before", async () => {
  const pace = 1; // second
  await open(page, ON_DISK, scenes.at(-2).path, `${FLAT}&attract-pace=${pace}`);
  await until(page, isAttract);
  await page.clock.fastForward("06:00:00"); // every timer that is due is met once
  let loads = 0;
  page.on("load", () => loads++);
  await until(page, (s, t, id) => s.scene === id, scenes.at(-1).id);
  assert.equal(loads, 0);
  await Promise.all([page.waitForEvent("load"), pass(page, 1000 * pace * (2 * readScene(scenes.at(-1).id).lesson.length + 1))]);
  await until(page, isAttract);
  assert.deepEqual([(await state(page)).scene, (await status()).strikes], [first.id, 0]);
  assert.match(page.url(), new RegExp(`${first.path}#kiosk=1&`));
  assert.deepEqual(page.faults, []);
});

test("when nothing helps, the page is loaded anew once a minute only", async () => {
  await open(page, ON_DISK, first.path, `${FLAT}&strikes=6`);
  await until(page, isAttract);
  await page.evaluate(() => {
    window.same = true;
    for (let k = 0; k < 3; k++) window.dispatchEvent(new ErrorEvent("error", { error: new Error("on purpose"), message: "on purpose" }));
  });
  await pass(page, 59_900);
  assert.equal(await page.evaluate(() => window.same), true, "three faults, one wait, and it is a minute");
  await loadsAnew(async () => {});
  await until(page, (s, t) => t.kiosk?.attract === true && t.kiosk.strikes === 7);
  assert.deepEqual(page.faults, []);
});

test("an uncaught error loads the view anew, the fourth one without WebGL, and a visitor keeps the view", async () => {
  // In every run from the third on: the fourth is the one after which the page is another.
  await begun(`kiosk=1&still=1&strikes=${cases(0, 3)}`);
  assert.equal((await stats(page)).renderer, "webgl");
  await press(page, "2");
  await until(page, (s) => s.scene.startsWith("02"));
  await press(page, "a");
  await pass(page, 300); // the address follows the view
  for (const time of cases([1, 2, 3, 4], [4])) {
    await loadsAnew(() => page.evaluate(() => queueMicrotask(() => { throw new Error("on purpose"); })));
    await until(page, (s, t, time) => t.kiosk?.strikes === time && t.kiosk.left !== null, time);
    const now = await state(page);
    assert.deepEqual([now.scene.slice(0, 2), now.rays.includes("all")], ["02", true]);
    assert.equal((await stats(page)).renderer, time > 3 ? "flat" : "webgl");
  }
  await page.getByRole("button", { name: "Start again" }).click();
  await until(page, isAttract);
  assert.equal((await stats(page)).renderer, "flat", "what broke four times is not tried again at once");
  assert.deepEqual(page.faults.filter((fault) => !fault.includes("on purpose")), []);
});

test("a drawing context that is lost while nobody is there comes back with a fresh page", async () => {
  await open(page, ON_DISK, first.path, "kiosk=1&still=1");
  await until(page, isAttract);
  await loadsAnew(() => page.evaluate(() => window.raywalk.loseContext()));
  await until(page, isAttract);
  assert.equal((await stats(page)).renderer, "webgl");
  assert.equal((await status()).strikes, 1);
});

test("settings that are no numbers, or too large, are clamped and named; reduced motion shows stops only", async () => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page, ON_DISK, first.path, "kiosk=1&gl=none&idle=soon&warn=999");
  for (let stop = 1; stop < 5; stop++) {
    await until(page, (s, t, stop) => t.kiosk?.stops === stop, stop);
    for (let k = 0; k < PACE; k++, await pass(page, 900)) assert.deepEqual([(await state(page)).playing, (await state(page)).tiles === "filling"], [false, false]);
  }
  await open(page, ON_DISK, first.path, "kiosk=1&gl=none&idle=soon&warn=999&visitor=1");
  assert.match((await stats(page)).notice, /idle, warn/);
  assert.ok((await status()).left > 85);
});

test("axe finds nothing wrong: unattended, with a visitor, while it warns, and on the page that is not kept", async () => {
  const page = await newPage(browser); // axe has timers of its own
  const violations = async () => {
    await page.evaluate(axe);
    return page.evaluate(async (runOnly) => (await window.axe.run(document, { preload: false, runOnly })).violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target).join(" ")}`), ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]);
  };
  await open(page, ON_DISK, first.path, FLAT);
  await until(page, isAttract);
  assert.deepEqual(await violations(), []);
  await page.mouse.click(400, 300);
  await until(page, isVisited);
  await page.waitForFunction(() => !document.querySelector(".kiosk-begin")); // it has faded
  assert.deepEqual(await violations(), []);
  await page.evaluate(() => document.querySelector(".kiosk-warning").showModal());
  assert.deepEqual(await violations(), []);
  for (const home of ["", "de/"]) {
    await page.goto(`${ON_DISK}${home}offline/index.html`);
    assert.deepEqual(await violations(), []);
  }
  await page.close();
});

test("the screen is asked to stay on", async () => {
  await page.addInitScript(() => {
    window.asked = 0;
    Object.defineProperty(navigator, "wakeLock", { value: { request: () => Promise.resolve({ released: ++window.asked < 0 }) } });
  });
  await open(page, ON_DISK, first.path, FLAT);
  await until(page, (s, t) => t.kiosk?.awake === true);
  assert.equal(await page.evaluate(() => window.asked), 1);
});
