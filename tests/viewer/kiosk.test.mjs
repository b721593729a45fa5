/** A kiosk shows itself, is begun by a touch, starts again when nobody is left, and recovers from faults. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, press, scenesOfSite, settled, state, stats, until } from "./browser.mjs";

const scenes = scenesOfSite();
const [first] = scenes;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
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
    for (const end = Date.now() + 60000; Date.now() < end && seen.length < count; await new Promise((done) => setTimeout(done, 5))) {
      const at = window.raywalk.state()?.scene;
      if (at && at !== seen.at(-1)) seen.push(at);
    }
    return seen;
  }, scenes.length + 1);
  const ids = scenes.map(({ id }) => id);
  const from = ids.indexOf(seen[0]); // where it was when we began to look
  assert.deepEqual(seen, [...ids.slice(from), ...ids.slice(0, from), ids[from]]);
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

test("every target is at least 64 px each way, and nothing is cut off, on a wide, a small and an upright screen", async () => {
  for (const size of [{ width: 1920, height: 1080 }, { width: 1280, height: 800 }, { width: 1080, height: 1920 }]) {
    await page.setViewportSize(size);
    await begun();
    for (const hash of ["step=1", "e=3&n=15", "colours=tests&if=-shadows"]) {
      const small = await page.evaluate(async (hash) => {
        history.replaceState(null, "", `${location.hash.replace(/&?(step|e|n|colours|if)=[^&]*/g, "")}&${hash}`);
        window.dispatchEvent(new PopStateEvent("popstate"));
        await window.raywalk.ready;
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        const targets = [...document.querySelectorAll("button, a[href], select, input, summary")].filter((each) => each.checkVisibility({ visibilityProperty: true }) && !each.matches(".skip, .card *, .lesson-text *"));
        return targets
          .map((each) => ({ name: each.getAttribute("aria-label") ?? each.textContent.trim().slice(0, 30), box: each.getBoundingClientRect() }))
          .filter(({ box }) => box.width < 63.5 || box.height < 63.5 || box.right > innerWidth + 1 || box.left < -1)
          .map(({ name, box }) => `${name}: ${Math.round(box.width)} x ${Math.round(box.height)} at ${Math.round(box.left)}`);
      }, hash);
      assert.deepEqual(small, [], `${JSON.stringify(size)} ${hash}`);
    }
  }
  await page.setViewportSize({ width: 1280, height: 800 });
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
    };
  });
  assert.deepEqual(prevented, { contextmenu: true, selectstart: true, dragstart: true, zoom: true, print: true, reload: true, back: true, wheel: false });
  assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector(".lesson-text")).userSelect), "none");
  const made = await page.evaluate(async () => {
    document.querySelector(".lesson-text").insertAdjacentHTML("beforeend", '<p><a href="https://example.org/" target="_blank">a book</a> <a href="../../slides/index.html">slides</a> <a href="../02-shadows/index.html">next</a></p>');
    await new Promise((done) => setTimeout(done));
    return [...document.querySelectorAll(".lesson-text a")].map((link) => link.hasAttribute("href"));
  });
  assert.deepEqual(made, [false, false, true]);
  assert.ok(!(await page.locator(".tools").isVisible()), "nothing that is saved or copied");
});

test("the gallery and the model page are the kiosk's too: no way out, a way back, and idle they start again", async () => {
  await begun("kiosk=1&idle=2&warn=0.5&attract-pace=60&still=1");
  await page.locator("a.brand").click();
  await page.waitForFunction(() => document.body.classList.contains("gallery"));
  assert.match(page.url(), /index\.html#kiosk=1&.*visitor=1/);
  await page.getByRole("link", { name: /model/i }).click();
  await page.waitForURL(/model\/index\.html#kiosk=1/);
  for (const link of await page.locator("a[href]").evaluateAll((all) => all.map((each) => each.href))) assert.ok(link.startsWith(ON_DISK) && !link.includes("slides/"), link);
  await page.getByRole("button", { name: "Start again" }).waitFor();
  await until(page, isAttract);
  assert.equal((await state(page)).scene, first.id);
  assert.deepEqual(page.faults, []);
});

test("after hours unattended the page begins anew, between two rounds and not before", async () => {
  await open(page, ON_DISK, scenes.at(-2).path, "kiosk=1&attract-pace=0.02&still=1&gl=none");
  await page.evaluate(() => {
    const { now } = performance;
    performance.now = () => now.call(performance) + 6 * 3_600_000;
  });
  const loaded = page.waitForEvent("load");
  await until(page, (s, t, id) => s.scene === id, scenes.at(-1).id);
  await loaded;
  await until(page, isAttract);
  assert.deepEqual([(await state(page)).scene, (await told()).strikes], [first.id, 0]);
  assert.match(page.url(), new RegExp(`${first.path}#kiosk=1&`));
  assert.deepEqual(page.faults, []);
});

test("when nothing helps, the page is loaded anew once a minute only", async () => {
  await page.evaluate(() => sessionStorage.setItem("raywalk.strikes", "6"));
  await open(page, ON_DISK, first.path, "kiosk=1&attract-pace=60&still=1");
  await until(page, isAttract);
  await page.evaluate(() => {
    window.waits = [];
    const { setTimeout } = window;
    window.setTimeout = (act, ms, ...more) => {
      window.waits.push(ms);
      return setTimeout(act, ms === 60_000 ? 100 : ms, ...more);
    };
  });
  const loaded = page.waitForEvent("load");
  const waits = await page.evaluate(() => {
    for (let k = 0; k < 3; k++) window.dispatchEvent(new ErrorEvent("error", { error: new Error("on purpose"), message: "on purpose" }));
    return window.waits;
  });
  assert.deepEqual(waits, [60_000], "three faults, one wait, and it is a minute");
  await loaded;
  await until(page, (s, t) => t.kiosk?.attract === true && t.kiosk.strikes === 7);
  assert.deepEqual(page.faults, []);
  await page.evaluate(() => sessionStorage.clear());
});

test("an uncaught error loads the view anew, the fourth one without WebGL, and a visitor keeps the view", async () => {
  await begun();
  await press(page, "2");
  await until(page, (s) => s.scene.startsWith("02"));
  await press(page, "a");
  await page.waitForTimeout(300); // the address follows the view
  for (const time of [1, 2, 3, 4]) {
    await Promise.all([page.waitForEvent("load"), page.evaluate(() => setTimeout(() => { throw new Error("on purpose"); }))]);
    await until(page, (s, t, time) => t.kiosk?.strikes === time && t.kiosk.left !== null, time);
    const now = await state(page);
    assert.deepEqual([now.scene.slice(0, 2), now.rays.includes("all")], ["02", true]);
    assert.equal((await stats(page)).renderer, time > 3 ? "flat" : "webgl");
  }
  await page.getByRole("button", { name: "Start again" }).click();
  await until(page, isAttract);
  assert.equal((await stats(page)).renderer, "flat", "what broke four times is not tried again at once");
  assert.deepEqual(page.faults.filter((fault) => !fault.includes("on purpose")), []);
  page.faults.length = 0;
  await page.evaluate(() => sessionStorage.clear());
});

test("a drawing context that is lost while nobody is there comes back with a fresh page", async () => {
  await open(page, ON_DISK, first.path, "kiosk=1&attract-pace=60&still=1");
  await until(page, isAttract);
  await Promise.all([page.waitForEvent("load"), page.evaluate(() => window.raywalk.loseContext())]);
  await until(page, isAttract);
  assert.equal((await stats(page)).renderer, "webgl");
  assert.equal((await told()).strikes, 1);
  await page.evaluate(() => sessionStorage.clear());
});

test("settings that are no numbers, or too large, are clamped and named; reduced motion shows stops only", async () => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page, ON_DISK, first.path, "kiosk=1&idle=soon&warn=999&attract-pace=0.05");
  await until(page, (s, t) => t.kiosk?.stops > 2);
  const moved = await page.evaluate(async () => {
    let moved = 0;
    for (let k = 0; k < 40; k++, await new Promise((done) => setTimeout(done, 10))) if (window.raywalk.state().playing || window.raywalk.state().tiles === "filling") moved++;
    return moved;
  });
  assert.equal(moved, 0);
  await open(page, ON_DISK, first.path, "kiosk=1&idle=soon&warn=999&attract-pace=60&visitor=1");
  assert.match((await stats(page)).notice, /idle, warn/);
  assert.ok((await told()).left > 85);
  await page.emulateMedia({ reducedMotion: null });
});

test("axe finds nothing wrong: unattended, with a visitor, while it warns, and on the page that is not kept", async () => {
  const violations = async () => {
    await page.evaluate(axe);
    return page.evaluate(async (runOnly) => (await window.axe.run(document, { preload: false, runOnly })).violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target).join(" ")}`), ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]);
  };
  await open(page, ON_DISK, first.path, "kiosk=1&attract-pace=60&still=1");
  await until(page, isAttract);
  assert.deepEqual(await violations(), []);
  await begun("kiosk=1&idle=40&warn=20&attract-pace=60&still=1");
  assert.deepEqual(await violations(), []);
  await page.evaluate(() => document.querySelector(".kiosk-warning").showModal());
  assert.deepEqual(await violations(), []);
  for (const home of ["", "de/"]) {
    await page.goto(`${ON_DISK}${home}offline/index.html`);
    assert.deepEqual(await violations(), []);
  }
});

test("the screen is asked to stay on", async () => {
  await page.addInitScript(() => {
    window.asked = 0;
    Object.defineProperty(navigator, "wakeLock", { value: { request: () => Promise.resolve({ released: ++window.asked < 0 }) } });
  });
  await open(page, ON_DISK, first.path, "kiosk=1&attract-pace=60&still=1");
  await until(page, (s, t) => t.kiosk?.awake === true);
  assert.equal(await page.evaluate(() => window.asked), 1);
});
