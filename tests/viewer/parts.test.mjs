/** Parts of the viewer come when they are first used, or before, in idle time; where one cannot be had that is said. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { bundleParts } from "../../site_src/bundle.mjs";
import { asOfferedPart } from "../../site_src/parts.mjs";
import { DIST, launch, newPage, ON_DISK, openChooser, openDrawer, openMenu, press, richScene, scenesOfSite, settled, state, stats } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";
import { serve } from "./server.mjs";

const rich = richScene();
const mesh = scenesOfSite().find(({ id }) => Object.keys(readScene(id).meshes).length);
const HASH = "#still=1&look=plain"; // the approximate look would ask for what mirrors show
const FLAT = "#still=1&gl=none"; // for what other parts do: drawn in less time
let browser, server;
before(async () => {
  [browser, server] = await Promise.all([launch(), serve(DIST)]);
});
after(async () => {
  await browser.close();
  server.close();
});

const tab = (name) => (page) => page.locator(`#tab-card-${name}`).click();
const tool = (name) => (page) => page.getByRole("button", { name }).click();
const download = (name) => async (page) => {
  await openMenu(page);
  const [file] = await Promise.all([page.waitForEvent("download"), tool(name)(page)]);
  return file.suggestedFilename();
};

/** Part -> [what asks for it, what then is there]; in an order in which none asks for another's. */
const PARTS = {
  surroundings: [(page) => page.keyboard.press("t"), ".stage-view canvas"],
  "traced-picture": [(page) => page.keyboard.press("t"), ".traced-picture"],
  flat: [(page) => page.evaluate(() => window.raywalk.loseContext()), "body[data-renderer=flat] .stage-view canvas"],
  "tile-legend": [(page) => page.keyboard.press("c"), ".tile-legend .means"],
  "event-words": [(page) => page.keyboard.press("."), ".event-says"],
  slice: [(page) => page.keyboard.press("x"), ".slice canvas"],
  drawer: [(page) => page.locator(".open-drawer").click(), ".drawer .view-switch"],
  "what-if": [(page) => page.locator(".open-what-if").click(), ".what-if .lamp"],
  "switch-acts": [(page) => page.keyboard.press("s"), ".recombined-size"],
  told: [(page) => openChooser(page).then(() => page.locator(`nav.scenes a[data-scene="${mesh.id}"]`).click()), `#page img[src*="${mesh.id}"]`],
  "card-rays": [tab("rays"), "li.ray"],
  "card-tree": [tab("tree"), ".tree .node"],
  "card-sum": [tab("sum"), ".sums .formula"],
  code: [tab("code"), ".code-lines li"],
  "at-hand": [(page) => page.locator(".menu-open").click(), ".tools button"],
  saving: [download("Save this view"), "button.done"],
  "box-lines": [(page) => page.locator(".tile-menu").selectOption("tests"), ".tile-values span:nth-child(3)"],
  lecture: [(page) => press(page, "j", "b"), ".blackout"],
};

const IN_IDLE_TIME = ["spoken", "inset", "busy", "guide", "marks", "choices", "worked", "sweeps"]; // the page speaks once it is whole; a narrow page, a slow machine and a lesson, a scene in which something moves ask for the others
const ALL = [...Object.keys(PARTS), ...IN_IDLE_TIME].sort();

const partOf = (request) => /assets\/part-(.+)-\w+\.js/.exec(request.url())?.[1];

/** A page whose browser is never idle, or is of those that have idle time, and the parts it asks for. */
async function pageAt(base, { idle = false, path = rich.path, hash = HASH, of = browser } = {}) {
  const page = await newPage(of);
  if (!idle) await page.addInitScript(() => (window.requestIdleCallback = () => 0));
  page.home = base;
  page.asked = [];
  page.on("request", (request) => {
    const name = partOf(request);
    if (name) page.asked.push(name);
  });
  await page.goto(`${base}${path}${hash}`);
  await page.evaluate(() => window.raywalk.ready);
  await settled(page);
  return page;
}

test("the bundle's parts are those that are tried here, each module stands in one script, and each part is at most 15 KB", async () => {
  const { parts, modules } = await bundleParts();
  assert.deepEqual(Object.keys(parts).sort(), ALL);
  const all = Object.values(modules).flat();
  assert.deepEqual(all.filter((path, at) => all.indexOf(path) !== at), []);
  for (const [name, text] of Object.entries(parts)) assert.ok(gzipSync(text, { level: 9 }).length <= 15_000, name);
});

test("a part takes from the viewer's script what both need, and gives what it exports", () => {
  const taken = ["words list"];
  const script = asOfferedPart("sum", 'import{say as a,list}from"shared:words";function b(){return a(list)}export{b as sum};', taken);
  assert.deepEqual(taken, ["words list", "words say"]);
  const offered = {};
  new Function("raywalkParts", script)({ offer: (name, make) => (offered[name] = make([3, (of) => `said ${of}`])) });
  assert.equal(offered.sum.sum(), "said 3");
  assert.throws(() => asOfferedPart("all", 'import*as a from"shared:words";export{a};', []), /imports or exports in a way/);
});

const MOVES = readScene(rich.id).sweeps ? ["sweeps"] : []; // what opens the slider is in sight on arrival
/** Where it comes from, its page's hash, and the parts that its first view asks for. */
const SOURCES = [["a host", () => server.url, HASH, []], ["a disk", () => ON_DISK, ...cases([HASH, []], [FLAT, ["flat"]])]];
/** Each is tried once: in space, from a host, those that only a stage in space asks for, and the others, drawn flat, from a disk. */
const OF_WEBGL = ["surroundings", "traced-picture", "flat"]; // drawn flat the first is not asked for, nor, by its key, the second
for (const [where, base, hash, first] of SOURCES)
  test(`from ${where}: a first view asks for no part${first.length ? " but the one that draws it flat" : ""}, each comes when it is first used, and what asked for it is done`, async () => {
    const page = await pageAt(base(), { hash });
    assert.deepEqual(page.asked.splice(0), [...first, ...MOVES]);
    for (const [name, [act, shows]] of Object.entries(PARTS)) {
      if (cases(false, OF_WEBGL.includes(name) === (hash === FLAT))) continue;
      await Promise.all([page.waitForRequest((request) => partOf(request) === name), act(page)]);
      await page.locator(shows).first().waitFor({ state: name === "told" ? "attached" : "visible" });
      assert.deepEqual(page.asked.splice(0), [name]);
      await page.keyboard.press("Escape");
    }
    assert.deepEqual(page.faults, []);
    await page.close();
  });

test("parts come in idle time, after the scene is there", async () => {
  const whole = await launch([], { whole: true });
  const page = await pageAt(server.url, { idle: true, of: whole, hash: FLAT });
  await page.evaluate(() => window.raywalk.whole);
  assert.deepEqual(page.asked.sort(), ALL);
  await tab("tree")(page);
  await settled(page);
  assert.ok(await page.locator(".tree .node").first().isVisible(), "at once");
  await whole.close();
});

test("what was left open at the last visit, or is in the address, comes by itself", async () => {
  const page = await pageAt(server.url, { hash: "#still=1&gl=none&n=15&p=5,8&slice=row&if=-shadows&e=2" });
  for (const name of ["slice", "what-if", "switch-acts", "event-words"]) await page.locator(PARTS[name][1]).first().waitFor();
  assert.ok(page.asked.includes("flat"), "without WebGL");
  await tab("tree")(page);
  await page.waitForFunction(() => location.hash.includes("tab=tree"));
  await page.reload();
  await page.locator(".tree .node").first().waitFor();
  assert.ok(!page.asked.includes("card-sum"));
  await page.close();
});

/** Holds what is asked for until it is let go; asked: once it has been asked for. */
async function hold(page, address) {
  let letGo;
  const waits = new Promise((done) => (letGo = done));
  await page.route(address, (route) => waits.then(() => route.continue()));
  return { asked: page.waitForRequest(address), letGo };
}

test("several keys before a part is there all count, in their order", async () => {
  const page = await pageAt(server.url, { hash: FLAT });
  await page.evaluate(() => {
    window.heard = [];
    addEventListener("keydown", ({ key }) => window.heard.push(key));
  });
  const { asked, letGo } = await hold(page, "**/part-at-hand-*");
  await press(page, "?");
  await asked;
  await press(page, "?", "?");
  assert.deepEqual(await page.evaluate(() => window.heard), ["?", "?", "?"]);
  letGo();
  // Opened, closed, opened; or it is said why not, and three minutes of waiting would not tell.
  await page.locator("dialog[open], #notice .notice-text:not(:empty)").first().waitFor();
  assert.equal((await stats(page)).notice, "", page.faults.join());
  await page.waitForFunction(() => document.querySelectorAll("dialog").length === 1); // a closed one goes with the next frame
  assert.ok(await page.locator("dialog[open] .keys").first().isVisible());
  await page.close();
});

test("a part that is late does not show where something else was asked for meanwhile", async () => {
  const page = await pageAt(server.url, { hash: FLAT });
  const { asked, letGo } = await hold(page, "**/part-card-tree-*");
  await tab("tree")(page);
  await asked;
  await tab("rays")(page);
  letGo();
  await page.waitForFunction(() => performance.getEntriesByType("resource").some(({ name }) => /part-card-tree/.test(name)));
  await settled(page);
  await page.locator("li.ray").first().waitFor();
  assert.ok(!(await page.locator(".tree").isVisible()));
  await page.close();
});

const MISSING = /^A part of the page could not be loaded; everything else works\.$/;
const REPLIES = Object.entries({
  "is not there": (route) => route.fulfill({ status: 404 }),
  "is lost on its way": (route) => route.abort("connectionreset"),
  "is a sign-in page": (route) => route.fulfill({ contentType: "text/html", body: "<!doctype html><title>Sign in</title>" }),
  "is cut": (route) => route.fulfill({ contentType: "text/javascript", body: 'raywalkParts.offer("at-hand",$shared=>{' }),
  "is empty": (route) => route.fulfill({ contentType: "text/javascript", body: "" }),
});
for (const [what, reply] of cases(REPLIES, REPLIES.slice(1, 4)))
  test(`a part ${what}: said when it is used, not in idle time; the rest works; a second try does what was asked for`, async () => {
    const page = await newPage(browser);
    await page.route("**/part-at-hand-*", reply);
    page.home = server.url;
    await page.goto(`${server.url}${rich.path}${FLAT}`);
    await page.evaluate(() => window.raywalk.whole);
    assert.ok(!(await page.locator("#notice").isVisible()));
    await press(page, "?");
    await page.locator("#notice .notice-text").waitFor();
    assert.match(await page.locator("#notice .notice-text").innerText(), MISSING);
    const { pixel } = await state(page);
    await press(page, "ArrowRight");
    assert.notDeepEqual((await state(page)).pixel, pixel);
    await tab("tree")(page);
    await settled(page);
    assert.ok(await page.locator(".tree .node").first().isVisible());
    await page.unrouteAll({ behavior: "ignoreErrors" });
    await page.getByRole("button", { name: "Try again" }).click();
    await page.locator("dialog[open] .keys").first().waitFor();
    assert.ok(!(await page.locator("#notice").isVisible()));
    await page.close();
  });

test("several parts that cannot be had are one sentence, and the network's return brings all that was asked for", async () => {
  const page = await pageAt(server.url, { hash: FLAT });
  await openDrawer(page); // it holds what opens the switches
  await page.context().setOffline(true);
  await page.locator(".open-what-if").click();
  await tab("tree")(page);
  await press(page, "x");
  await page.waitForFunction(() => document.querySelector("#notice .notice-text").textContent.includes("flat drawing"));
  const said = await page.locator("#notice .notice-text").innerText();
  assert.equal(said.match(/A part of the page could not be loaded/g).length, 1, said);
  assert.equal(await page.getByRole("button", { name: "Try again" }).count(), 1);
  for (const _ of "123") await press(page, "ArrowRight"); // drawn anew: not asked for anew each time
  assert.ok(page.asked.filter((name) => name === "card-tree").length === 1, page.asked.join());
  await page.context().setOffline(false);
  await page.locator(".tree .node").first().waitFor();
  await page.locator(PARTS["what-if"][1]).first().waitFor();
  await page.locator(PARTS.slice[1]).waitFor();
  assert.ok(!(await page.locator("#notice").isVisible()));
  await page.close();
});
