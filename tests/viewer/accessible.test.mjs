/** WCAG 2.2 AA as far as a machine can tell, in every state and language; and what only people notice. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { chooseTab, DIST, follow, keyedScenes, launch, newPage, ON_DISK, open, openChooser, openDrawer, openMenu, pass, press, reload, richScene, scenesOfSite, settled, state, stats, until } from "./browser.mjs";
import { cases, oneMore } from "./cases.mjs";
import { pngOf, rightPicture } from "./check-data.mjs";
import { readScene } from "./scene-files.mjs";
import { serve } from "./server.mjs";

const rich = richScene();
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"];
let browser, server, page;
before(async () => {
  [browser, server] = await Promise.all([launch(), serve(DIST)]);
  page = await newPage(browser);
  page.home = server.url;
});
after(async () => {
  await browser.close();
  server.close();
});
afterEach(async () => {
  await page.unrouteAll();
  await page.emulateMedia({ media: null });
  await page.setViewportSize({ width: 1280, height: 800 });
});

/** The tree of rays names its nodes by what they are, not by the short words drawn in them. contrast: of colours, half
 *  of the time; they are the same in every language. */
async function violations(where = page, contrast = true) {
  if (!(await where.evaluate(() => "axe" in window))) await where.evaluate(axe);
  const options = { preload: false, runOnly: RULES, resultTypes: ["violations"], rules: { "color-contrast": { enabled: contrast } } };
  const found = await where.evaluate(async (options) => (await window.axe.run(document, options)).violations, options);
  return found.map((each) => `${each.id}: ${each.nodes.map((node) => node.target).filter((target) => !(each.id === "label-content-name-mismatch" && /^g\[/.test(target))).join(" ")}`).filter((line) => !line.endsWith(": "));
}

const click = (selector) => (page) => page.locator(selector).first().click();
/** State, its address, what to do there, what to undo. One page goes through all of them; what stands beside one another is
 *  looked at together. */
const STATES = [
  ["the selected pixel", ""],
  ["filled, all rays, a slice", "tiles=filled&rays=pixel,all&n=5&slice=row", (page) => page.locator(".slice canvas").waitFor()],
  ["a lesson's step", "step=2"],
  ["a question", "step=7"],
  ["its answer", "step=7&answer=1"],
  ["the player, the pseudo-code", "n=15&p=5,8&e=5", (page) => chooseTab(page, "code")],
  ["what a link asked for in vain, the sum", "n=16&p=5,8", (page) => chooseTab(page, "sum")],
  ["all keys", "", (page) => press(page, "?"), (page) => press(page, "Escape")],
  ["the link to be copied by hand", "", (page) => page.evaluate(() => Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: () => Promise.reject() } })).then(() => openMenu(page)).then(() => click(".tools button")(page)).then(() => page.locator("dialog").waitFor()), (page) => press(page, "Escape")],
  ["a lecture", "e=3&projector=1"],
  ["a lecture's question", "step=7&projector=1"],
  ["a lecture, blackened", "projector=1", (page) => press(page, "b"), (page) => press(page, "b")],
  ["the traced picture on the stage, every ray", "look=traced&n=15&p=5,8", (page) => chooseTab(page, "rays")],
  ["the drawer of tools, and what-if switches, one of them thrown", "if=-shadows", (page) => openDrawer(page).then(() => page.locator(".what-if .lamp").first().waitFor()), click(".open-drawer")],
  ["the choice of scenes", "", openChooser, (page) => press(page, "Escape")],
  ["the page's menu", "", openMenu, (page) => press(page, "Escape")],
  ["tiles coloured by tests, the tree", "colours=tests&tiles=filled&n=15&p=5,8", (page) => chooseTab(page, "tree")],
  ["the slides to take away", "", (page) => openMenu(page).then(() => click(".take-open")(page)), (page) => press(page, "Escape", "Escape")],
];
/** Where the page is otherwise: size, theme. */
const SURROUNDINGS = [
  ["a phone", { width: 390, height: 844 }, ["", "step=7", "n=15&p=5,8&e=5", "projector=1"]],
  ["a turned phone", { width: 844, height: 390 }, ["step=7"]],
];
/** The lesson whose slides are the shortest page: all are of one template, and axe looks at each of thousands of lines. */
function leastSlides() {
  const size = ({ id }) => statSync(`${DIST}/slides/${id}.html`).size;
  return keyedScenes().reduce((least, scene) => (size(scene) < size(least) ? scene : least)).id;
}
/** Of a table's rows, which one template makes, the first ones: axe looks at each, in every run at no more of them. */
const ROWS = cases(Infinity, 12);
const shortened = () => page.evaluate((most) => document.querySelectorAll("tbody").forEach((body) => [...body.rows].slice(most).forEach((row) => row.remove())), ROWS);
/** Pages that are no scene's. */
const slides = `slides/${cases(rich.id, leastSlides())}.html`;
const PAGES = ["index.html", "model/index.html", "slides/index.html", "offline/index.html", "check/index.html", "mistakes/index.html", "mistakes/total-black/index.html", "mistakes/which/index.html", `${rich.path}?embed`];
const WITHOUT_SCRIPTS = ["index.html", rich.path, "slides/index.html"];
const PAGES_OF_ENGLISH = [slides, "sizes/index.html"];

for (const home of ["", "de/"]) {
  const language = home || "en/";
  (home ? oneMore : test)(`axe finds nothing wrong (${language}) in ${STATES.length} states of a scene's page`, async () => {
    await open(page, server.url, `${home}${rich.path}`, "still=1&gl=none");
    const wrong = [];
    for (const [name, hash, act, undo] of STATES) {
      await follow(page, `still=1&gl=none&${hash}`);
      await act?.(page);
      wrong.push(...(await violations(page, !home)).map((each) => `${name}: ${each}`));
      await undo?.(page);
    }
    assert.deepEqual(wrong, []);
  });

  (home ? oneMore : test)(`axe finds nothing wrong (${language}) on the other pages`, async () => {
    const wrong = [];
    for (const path of [...PAGES.map((each) => home + each), ...(home ? [] : PAGES_OF_ENGLISH)]) {
      await open(page, server.url, path, "still=1&gl=none");
      await shortened();
      wrong.push(...(await violations(page, !home)).map((each) => `${path}: ${each}`));
    }
    // As a browser without scripts shows them; axe is one itself.
    await page.route("**/*.html", async (route) => {
      const response = await route.fetch();
      const body = (await response.text()).replace(/<script[\s\S]*?<\/script>/g, "").replace(/<\/?noscript>/g, "");
      await route.fulfill({ response, body });
    });
    for (const path of WITHOUT_SCRIPTS) {
      await page.goto(`${server.url}${home}${path}`);
      assert.equal(await page.locator("#viewer:visible, script").count(), 0);
      wrong.push(...(await violations(page, !home)).map((each) => `${path} without scripts: ${each}`));
    }
    assert.deepEqual(wrong, []);
  });
}

const movers = scenesOfSite().filter(({ id }) => readScene(id).sweeps);
const crossed = movers.find(({ id }) => readScene(id).sweeps.some(({ across }) => across));
for (const home of cases(["", "de/"], ["de/"])) // its words are longer
  test(`axe finds nothing wrong (${home || "en/"}) where something moves: its slider, its pad, in a lecture and on a phone too`, async () => {
    const wrong = [];
    for (const { id, path } of [...new Set([movers[0], crossed ?? movers[0]])]) {
      const [{ id: sweep }] = readScene(id).sweeps;
      await open(page, server.url, `${home}${path}`, "still=1&gl=none");
      for (const more of ["", "&projector=1"]) {
        await follow(page, `still=1&gl=none&sweep=${sweep}:2${more}`);
        assert.ok(await page.locator("#sweeps .sweep").first().isVisible());
        wrong.push(...(await violations(page)).map((each) => `${id}${more}: ${each}`));
      }
      await page.setViewportSize({ width: 390, height: 844 });
      wrong.push(...(await violations(page)).map((each) => `${id} on a phone: ${each}`));
      await page.setViewportSize({ width: 1280, height: 800 });
    }
    assert.deepEqual(wrong, []);
  });

test("axe finds nothing wrong where a picture was checked, right or wrong", async () => {
  const wrong = [];
  for (const scene of ["02-shadows", "03-two-lights"]) {
    await open(page, server.url, "check/index.html", `scene=${scene}`);
    await page.locator("#file").setInputFiles(join(DIST, "scenes/03-two-lights/picture.png"));
    await page.locator("#found:not([hidden])").waitFor();
    wrong.push(...(await violations(page)).map((each) => `${scene}: ${each}`));
  }
  const swapped = await rightPicture("03-two-lights", 100);
  for (let i = 0; i < swapped.values.length; i += 3) [swapped.values[i], swapped.values[i + 2]] = [swapped.values[i + 2], swapped.values[i]];
  await page.locator("#file").setInputFiles({ name: "mine.png", mimeType: "", buffer: pngOf(swapped) });
  await page.locator(".check-answers .lines").first().waitFor();
  wrong.push(...(await violations(page)).map((each) => `a named mistake: ${each}`));
  await page.locator(".check-answers h3 a").first().click();
  await page.locator(".of-scene").waitFor();
  wrong.push(...(await violations(page)).map((each) => `its page: ${each}`));
  assert.deepEqual(wrong, []);
});

/** In English: kiosk.test.mjs. */
test("axe finds nothing wrong in a German kiosk", async () => {
  const wrong = [];
  const look = async (name) => wrong.push(...(await violations(page, false)).map((each) => `${name}: ${each}`));
  await open(page, server.url, `de/${rich.path}`, "kiosk=1&attract-pace=600&still=1&gl=none");
  await page.locator(".kiosk-begin").waitFor();
  await look("a kiosk that shows itself");
  await page.evaluate(() => (location.hash = "kiosk=1&idle=3600&visitor=1&still=1&gl=none"));
  await reload(page);
  await look("a kiosk with a visitor");
  await page.evaluate(() => document.querySelector(".kiosk-warning").showModal());
  await look("a kiosk's warning");
  assert.deepEqual(wrong, []);
});

/** Other sizes and fewer things than above, not other words: in one language. */
test("axe finds nothing wrong on a phone, printed, and where something is missing", async () => {
  const wrong = [];
  await open(page, server.url, rich.path, "still=1&gl=none");
  const look = async (name) => wrong.push(...(await violations()).map((each) => `${name}: ${each}`));
  for (const [name, size, hashes] of SURROUNDINGS) {
    await page.setViewportSize(size);
    for (const hash of hashes) {
      await follow(page, `still=1&gl=none&${hash}`);
      await look(`${name} #${hash}`);
    }
  }
  await page.setViewportSize({ width: 1280, height: 800 });
  await follow(page, "still=1&gl=none");
  await page.emulateMedia({ media: "print" });
  await look("printed");
  await page.emulateMedia({ media: null });

  await page.route(`**/${rich.id}/*.js*`, (route) => (/\/\d+\.js/.test(route.request().url()) ? route.abort() : route.continue()));
  await follow(page, "still=1&gl=none&n=55");
  await page.locator(".notice-ways button").waitFor();
  await look("a trace is missing");
  await page.route("**/assets/viewer-*.js", (route) => route.abort());
  await page.goto(`${server.url}${rich.path}`);
  await page.locator("#broken").waitFor();
  await look("the viewer is missing");
  await page.unrouteAll();
  assert.deepEqual(wrong, []);
});

test("axe finds nothing wrong on the page of benchmarks, measured here or not", async () => {
  const out = mkdtempSync(join(tmpdir(), "raywalk-measured-"));
  const style = readFileSync(`${DIST}/index.html`, "utf8").match(/assets\/style-[^"]+/)[0];
  const python = existsSync(".venv/bin/python") ? resolve(".venv/bin/python") : "python3";
  execFileSync(python, ["tests/bench/measured_page.py", out, style]);
  await page.route("**/benchmarks/*", (route) => route.fulfill({ path: join(out, new URL(route.request().url()).pathname) }));
  await page.goto(`${server.url}benchmarks/index.html`);
  assert.match(await page.locator("main").innerText(), /fast <&>/);
  assert.deepEqual(await violations(), []);
  rmSync(out, { recursive: true });
});

test("the selected ray is put into words once the selection rests, not while it moves or plays", async () => {
  const page = await newPage(browser, { held: true });
  await open(page, ON_DISK, rich.path, "still=1&gl=none&n=15&p=5,8");
  const spoken = page.locator("p.unseen[role=status]");
  await until(page, () => document.querySelector("p.unseen").textContent !== "");
  assert.equal(await spoken.textContent(), "Pixel 5, 8: 2 rays. The camera ray meets mirror A. Colour 180, 180, 180.");
  await spoken.evaluate((words) => {
    window.changes = 0;
    new MutationObserver(() => window.changes++).observe(words, { childList: true, characterData: true, subtree: true });
  });
  for (let k = 0; k < 6; k++) await press(page, "ArrowRight");
  await pass(page, 1200);
  assert.equal(await page.evaluate(() => window.changes), 1, "six pixels passed by, the last one is said");
  const before = await spoken.textContent();
  await press(page, ".", ".");
  await pass(page, 60_000);
  assert.equal(await spoken.textContent(), before, "the player's sentence has its own place");
  assert.deepEqual(page.faults, []);
  await page.close();
});

test("keys of one character can be turned off, and stay off; Space, arrows and buttons go on", async () => {
  await open(page, ON_DISK, rich.path, "still=1&gl=none");
  await press(page, "?");
  await page.getByRole("button", { name: "Letters, digits and signs" }).click();
  await page.keyboard.press("Escape");
  for (let visit = 0; visit < 2; visit++) {
    const { rays, pixel, scene } = await state(page);
    await press(page, "h", "a", "2", ".", "?", "+");
    assert.deepEqual(await state(page).then((now) => [now.rays, now.scene, now.event]), [rays, scene, null]);
    assert.equal(await page.locator("dialog").count(), 0);
    await press(page, "ArrowRight");
    assert.notDeepEqual((await state(page)).pixel, pixel);
    await open(page, ON_DISK, rich.path, "still=1&gl=none");
  }
  await openMenu(page);
  await page.getByRole("button", { name: "All keys" }).click();
  await page.getByRole("button", { name: "Letters, digits and signs" }).click();
  await press(page, "Escape", "Escape"); // the sheet, and the menu that it was opened from
  assert.equal(await page.locator("#menu").isVisible(), false);
  await press(page, "h");
  assert.ok((await state(page)).rays.includes("row"));
});

for (const home of cases(["", "de/"], ["de/"])) // its words are longer
  test(`at 400 % (320 px wide) the page scrolls one way only, and everything is there (${home || "en/"})`, async () => {
    await page.setViewportSize({ width: 320, height: 256 });
    await open(page, server.url, `${home}${rich.path}`, "still=1&gl=none");
    for (const hash of ["", "step=2", "step=7&answer=1", "n=15&p=5,8&e=5", "n=16", "projector=1"]) {
      await follow(page, `still=1&gl=none&${hash}`);
      const { wide, outside } = await page.evaluate(() => ({
        wide: document.documentElement.scrollWidth - innerWidth,
        outside: [...document.querySelectorAll("button, a, input")].filter((e) => e.checkVisibility({ visibilityProperty: true }) && e.getBoundingClientRect().right > innerWidth + 1).map((e) => e.getAttribute("aria-label") ?? e.textContent),
      }));
      assert.deepEqual([wide, outside], [0, []], hash);
    }
    for (const path of [...PAGES.map((each) => home + each), ...(home ? [] : PAGES_OF_ENGLISH)]) {
      await open(page, server.url, path, "still=1&gl=none");
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, path);
    }
    await page.setViewportSize({ width: 1280, height: 800 });
  });

test("where the system's own colours replace the page's, what is chosen differs from what is not, and swatches keep theirs", async () => {
  await page.emulateMedia({ forcedColors: "active" });
  await open(page, server.url, rich.path, "still=1&gl=none&n=15&p=5,8&tab=rays");
  await openChooser(page); // all that can be chosen is to be seen
  const colours = (selector) => page.locator(selector).first().evaluate((each) => [getComputedStyle(each).backgroundColor, getComputedStyle(each).color]);
  const [plain] = await colours(".controls button[aria-pressed=false]");
  for (const chosen of [".controls button[aria-pressed=true]", "[role=tab][aria-selected=true]", "nav.scenes a[aria-current]"]) {
    const [ground, words] = await colours(chosen);
    assert.ok(ground !== plain && ground !== words, `${chosen}: ${ground}, ${words}`);
  }
  assert.equal((await colours(".card-head .swatch"))[0], "rgb(180, 180, 180)");
  await page.emulateMedia({ forcedColors: null });
});

test("the card is a list of rays, the page has its landmarks, each with a name", async () => {
  await open(page, ON_DISK, rich.path, "still=1&gl=none&n=15&p=5,8");
  assert.ok((await page.getByRole("list").filter({ has: page.locator(".share") }).getByRole("listitem").count()) >= 1);
  await chooseTab(page, "rays");
  assert.ok((await page.getByRole("list").filter({ has: page.locator("li.ray") }).getByRole("listitem").count()) >= 3);
  await openChooser(page); // the navigation
  for (const role of ["banner", "main", "navigation"]) assert.ok((await page.getByRole(role).count()) >= 1, role);
  for (const section of await page.locator("#viewer section").all()) assert.ok((await section.getAttribute("aria-label")) || (await section.getAttribute("class")) === "stage", await section.getAttribute("class"));
});

test("what dragging does, buttons do: turn, shift and zoom the view, scrub pixels and events, switch a light", async () => {
  await open(page, server.url, rich.path, "still=1&gl=none&n=15&p=5,8&tab=rays&e=1");
  await openDrawer(page);
  const press = async (name) => {
    await page.getByRole("button", { name }).first().click();
    await settled(page);
  };
  const view = () => stats(page).then(({ eye, target }) => JSON.stringify([eye, target]));
  for (const name of ["Turn the view left", "Turn the view up", "Zoom in", "Zoom out"]) {
    const before = await view();
    await press(name);
    assert.notEqual(await view(), before, name);
  }
  const { target } = await stats(page);
  await page.locator(".view-pad button").nth(4).click(); // from turning to shifting
  await press("Move the view left");
  assert.notDeepEqual((await stats(page)).target, target);
  await press("Pixel to the right");
  assert.deepEqual((await state(page)).pixel, [6, 8]);
  await press("Play the rays"); // without a clock it is at the end at once
  for (const name of ["One event back", "One event back", "One event on"]) await press(name);
  assert.equal((await state(page)).event, (await stats(page)).events.length - 2);
  await page.locator(".open-what-if").click();
  await page.locator(".lamp label").first().click();
  assert.equal((await state(page)).switches.lamps[0], 0);
  await page.locator(".open-what-if").click();
});

test("nothing was said in the console but what was made to be missing", () => {
  assert.deepEqual(page.faults.filter((fault) => !fault.endsWith("net::ERR_FAILED")), []);
});
