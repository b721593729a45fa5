/** What can go wrong, each with the sentence that a person reads then, and the rest that keeps working. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { gunzipSync, gzipSync } from "node:zlib";
import { atRest, DIST, framedIn, keyedScenes, launch, newPage, open, openMenu, openScene, pass, press, richScene, scenesOfSite, settled, showsScene, state, stats, until } from "./browser.mjs";
import { cases, oneMore } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";
import { serve } from "./server.mjs";

const rich = richScene();
const other = keyedScenes().find((scene) => scene.id !== rich.id);
const meshes = scenesOfSite().find((scene) => Object.keys(readScene(scene.id).meshes).length);
const swept = scenesOfSite().find(({ id }) => readScene(id).sweeps && readScene(id).of === id); // a lesson on a scene has none of its own
const N = readScene(rich.id).start.resolution;
const TRACE = `**/scenes/${rich.id}/${N}.js*`;
let browser, server, page;

/** What a browser may refuse from the first moment on, by the name after ?fault= in the address. */
function refuse() {
  const is = (name) => new URLSearchParams(location.search).get("fault") === name;
  const throwing = () => {
    throw new DOMException("refused", "SecurityError");
  };
  const patch = (of, name, value) => Object.defineProperty(of, name, { configurable: true, value });
  if (is("webgl")) {
    const { getContext } = HTMLCanvasElement.prototype;
    patch(HTMLCanvasElement.prototype, "getContext", function (kind, ...more) {
      return /webgl/.test(kind) ? null : getContext.call(this, kind, ...more);
    });
  }
  if (is("storage")) Object.defineProperty(window, "localStorage", { get: throwing });
  if (is("quota")) patch(Storage.prototype, "setItem", () => { throw new DOMException("full", "QuotaExceededError"); });
  if (is("unpacking")) delete window.DecompressionStream;
  if (is("history")) for (const write of ["replaceState", "pushState"]) patch(history, write, throwing);
  if (is("fullscreen")) patch(Element.prototype, "requestFullscreen", () => Promise.reject(new Error("no")));
  if (is("clipboard")) patch(navigator, "clipboard", { writeText: () => Promise.reject(new Error("no")) });
  if (is("download")) patch(URL, "createObjectURL", throwing);
  if (is("drawing")) patch(HTMLCanvasElement.prototype, "toBlob", (done) => done(null));
}

before(async () => {
  [browser, server] = await Promise.all([launch(), serve(DIST)]);
  page = await newPage(browser);
  await page.addInitScript(refuse);
});
after(async () => {
  await browser.close();
  server.close();
});

const notice = () => page.locator("#notice .notice-text").innerText();
const isQuiet = async () => !(await page.locator("#notice").isVisible());
const isLive = () => page.evaluate(() => document.body?.classList.contains("live"));
const shows = (selector) => page.locator(selector).evaluate((image) => image.complete && image.naturalWidth > 0);
const again = () => page.getByRole("button", { name: "Try again" }).click();
const answer = (pattern, reply) => page.route(pattern, reply);
const gone = (pattern) => answer(pattern, (route) => route.fulfill({ status: 404 }));
const script = (pattern, body, contentType = "text/javascript") => answer(pattern, (route) => route.fulfill({ contentType, body }));
/** A promise that is kept when `open` is called. */
function gate() {
  let open;
  return Object.assign(new Promise((done) => (open = done)), { open });
}
const wholeAgain = () => page.unrouteAll({ behavior: "ignoreErrors" });
const rays = () => until(page, (s, t) => t.tiles.length === 3 * s.n * s.n);

const PACKED = readFileSync(`${DIST}/scenes/${rich.id}/${N}.js`, "utf8");
const base64 = PACKED.match(/,\s*"([^"]+)"/)[1];
const flipped = () => {
  const bytes = Buffer.from(base64, "base64");
  bytes[Math.floor(bytes.length / 2)] ^= 1;
  return bytes.toString("base64");
};
const altered = (file, change) => {
  const text = readFileSync(`${DIST}/scenes/${rich.id}/${file}.js`, "utf8");
  const json = JSON.parse(gunzipSync(Buffer.from(text.match(/,\s*"([^"]+)"/)[1], "base64")));
  return received(file, gzipSync(JSON.stringify({ ...json, ...change })).toString("base64"));
};
const [SWEEP] = readScene(swept.id).sweeps.map(({ id }) => id);
function withoutStop(stop) {
  const [name, packed] = readFileSync(`${DIST}/scenes/${swept.id}/${SWEEP}/15.js`, "utf8").match(/"[^"]+"/g).map((text) => text.slice(1, -1));
  const json = JSON.parse(gunzipSync(Buffer.from(packed, "base64")));
  json.stops[stop - 1] = { whole: {} };
  return `raywalkReceive("${name}", "${gzipSync(JSON.stringify(json)).toString("base64")}")`;
}
const received = (name, data) => `raywalkReceive("${rich.id}/${name}", "${data}")`;
const HTML = "<!doctype html><title>Sign in</title><p>Please sign in to this network.</p>";

/** The lesson, the picture, the card and the keys are there, whatever else is not. */
async function theRestWorks(of = page) {
  await of.evaluate(() => (document.querySelector("#menu").hidePopover(), document.activeElement.blur())); // arrows in it are its own
  const { pixel, n } = await state(of);
  await press(of, "ArrowRight");
  assert.deepEqual((await state(of)).pixel, [(pixel[0] + 1) % n, pixel[1]], "the arrows pick");
  assert.ok(await of.locator(".lesson").isVisible());
  await openMenu(of);
  assert.ok(await of.locator(".tools button").last().isVisible());
  await of.keyboard.press("Escape");
  await of.evaluate(() => document.activeElement.blur()); // Space is to render
}
/** The one choice that the browser is to keep. */
async function turnKeysOff() {
  await press(page, "?");
  await page.getByRole("button", { name: "Letters, digits and signs" }).click();
  await page.keyboard.press("Escape");
}
async function thePlainPageIsThere() {
  assert.equal(await isLive(), false);
  assert.ok(await shows(".plain-picture"));
  assert.ok(await page.locator(".plain-lesson").isVisible());
  assert.ok((await page.locator("nav.scenes a").count()) > 2);
}

const MISSING = /^The rays of the \d+ × \d+ grid could not be loaded; the picture, the lesson and the scene in space still work, and so may another grid\.$/;
const DAMAGED = /^The rays of the \d+ × \d+ grid are damaged; the picture, the lesson and the scene in space still work, and so may another grid\.$/;
const VERSION = /^The data belongs to another version of this page, which goes away when it is loaded anew; the picture and the lesson work\.$/;
const PLAIN = /^A part of this page did not arrive, so nothing can be moved here; the picture, the lesson and the figures below are complete\./;
const KEPT = /^This browser keeps nothing for the next visit; until then the choice holds\.$/;
const NOT_SAVED = /^The browser did not let this file be saved; a screenshot shows the same\.$/;

/** Of a trace: what the server answers; then every grid but this one works, and a second try brings it. */
const TRACES = {
  "the trace is not there": [() => gone(TRACE), MISSING],
  "the line goes dead in the middle of loading": [() => answer(TRACE, (route) => route.abort("connectionreset")), MISSING],
  "a bit of the trace has flipped": [() => script(TRACE, received(N, flipped())), DAMAGED],
  "the trace's text is cut": [() => script(TRACE, received(N, base64.slice(0, base64.length / 2))), DAMAGED],
  "the trace's file is cut": [() => script(TRACE, PACKED.slice(0, PACKED.length / 2)), DAMAGED],
  "the trace is an empty file": [() => script(TRACE, ""), DAMAGED],
  "the trace is a sign-in page": [() => script(TRACE, HTML, "text/html"), DAMAGED],
  "the trace is another scene's": [() => script(TRACE, readFileSync(`${DIST}/scenes/${other.id}/${N}.js`, "utf8")), DAMAGED],
  "the trace is no trace": [() => script(TRACE, received(N, gzipSync("{}").toString("base64"))), DAMAGED],
};
/** One that does not come, one that is cut, one that is something else altogether; what refuses them: check of traces' files. */
const LEAST = ["the line goes dead in the middle of loading", "a bit of the trace has flipped", "the trace is a sign-in page", "the trace is another scene's"];
for (const [name, [make, sentence]] of Object.entries(TRACES).filter(([name]) => cases(true, LEAST.includes(name))))
  test(`${name}: said; the rest works; a second try brings it`, async () => {
    await make();
    await open(page, server.url, rich.path, "still=1&gl=none");
    assert.match(await notice(), sentence);
    assert.match(await page.locator(".card").innerText(), /not here/);
    assert.ok(await shows(".picture img"));
    await theRestWorks();
    await press(page, " ", "a", "a"); // off again: thousands of lines would only take time
    assert.equal((await stats(page)).tilesShown, 0, "an empty frustum stays empty");
    await wholeAgain();
    await again();
    await rays();
    assert.ok(await isQuiet());
  });

/** Name: what is wrong, what to open, what is said, and what holds then. isOneMore: another one is told by the same sentence. */
const FAULTS = [
  {
    name: "the trace is of another version: loading the page anew brings it",
    make: () => script(TRACE, altered(N, { version: 99 })),
    says: VERSION,
    async then() {
      await theRestWorks();
      await wholeAgain();
      await page.getByRole("button", { name: "Load the page anew" }).click();
      await rays();
    },
  },
  {
    name: "the trace is of another build, which the host got while the page was open: none of it is shown",
    make: () => script(TRACE, altered(N, { background: [0.25, 0.5, 0.75] })),
    says: VERSION,
    async then() {
      await theRestWorks();
      assert.equal((await stats(page)).tilesShown, 0);
      await wholeAgain();
      await page.getByRole("button", { name: "Load the page anew" }).click();
      await rays();
    },
  },
  {
    name: "another grid works where one is missing, and the sentence goes",
    make: () => gone(TRACE),
    says: MISSING,
    async then() {
      await press(page, "+");
      await rays();
      assert.ok(await isQuiet());
    },
  },
  {
    name: "the scene is not there: its plain page, and a second try",
    make: () => gone(`**/${rich.id}/scene.js*`),
    says: /^The scene's data could not be loaded, so nothing can be moved here; the picture, the lesson and the figures below are complete\.$/,
    async then() {
      await thePlainPageIsThere();
      await wholeAgain();
      await again();
      await rays();
      assert.ok(await isLive());
    },
  },
  {
    name: "the scene is damaged: its plain page, and other scenes open from it",
    make: () => script(`**/${rich.id}/scene.js*`, received("scene", gzipSync("{}").toString("base64"))),
    says: /^The scene's data is damaged, so nothing can be moved here; the picture, the lesson and the figures below are complete\.$/,
    async then() {
      await thePlainPageIsThere();
      await openScene(page, other.id);
      await showsScene(page, other.id);
      assert.ok(await isQuiet());
    },
  },
  { name: "the scene is of another version", isOneMore: true, make: () => script(`**/${rich.id}/scene.js*`, altered("scene", { format: 99 })), says: VERSION, then: () => thePlainPageIsThere() },
  {
    name: "the next scene is not there: this one goes on, and a second try brings it",
    make: () => gone(`**/${other.id}/scene.js*`),
    act: () => openScene(page, other.id),
    says: /^“[^”]+” could not be loaded; this scene goes on\.$/,
    async then() {
      assert.equal((await state(page)).scene, rich.id);
      assert.match(page.url(), new RegExp(rich.id));
      await theRestWorks();
      await wholeAgain();
      await again();
      await showsScene(page, other.id);
      assert.ok(await isQuiet());
    },
  },
  {
    name: "the network goes away and comes back: what is missing arrives by itself",
    act: async () => {
      await page.context().setOffline(true);
      await press(page, "+");
      await until(page, (s, t) => t.notice !== "");
    },
    says: MISSING,
    async then() {
      await theRestWorks();
      await page.context().setOffline(false);
      await rays();
      assert.ok(await isQuiet());
    },
  },
  {
    name: "rays and picture are both missing: one sentence for both, one button tries both",
    make: async () => (await gone(TRACE), gone("**/picture.webp*")),
    says: /^Neither the rays nor the picture could be loaded; the lesson and the scene in space still work\.$/,
    async then() {
      await wholeAgain();
      await again();
      await rays();
      await page.waitForFunction(() => document.querySelector(".picture img").naturalWidth > 0);
      assert.ok(await isQuiet());
    },
  },
  { name: "the picture is not there", make: () => gone("**/picture.webp*"), says: /^The picture could not be loaded; the tiles and the rays still work\.$/, then: () => theRestWorks() },
  {
    name: "the outlines of slices are not there",
    make: () => gone(`**/${rich.id}/sections.js*`),
    act: () => press(page, "x").then(() => until(page, (s, t) => t.notice !== "")),
    says: /^The outlines for the flat drawing could not be loaded; everything else works\.$/,
    async then() {
      assert.equal((await state(page)).slice, "none");
      await theRestWorks();
      await wholeAgain();
      await again();
      await page.locator(".slice canvas").waitFor();
    },
  },
  {
    name: "the boxes of a mesh are not there",
    scene: meshes,
    hash: "still=1&gl=none&n=5&colours=tests",
    make: () => gone(`**/${meshes.id}/boxes.js*`),
    act: () => until(page, (s, t) => t.notice !== ""),
    says: /^The bounding boxes could not be loaded; everything else works\.$/,
    async then() {
      await theRestWorks();
      await wholeAgain();
      await again();
      await until(page, (s, t) => t.boxes > 0);
    },
  },
  {
    name: "a stop of what moves is damaged in a file that reads well: a second try has the file anew, not the copy that is there",
    scene: swept,
    hash: `still=1&gl=none&tiles=filled&n=15&sweep=${SWEEP}:3`,
    make: () => script(`**/${SWEEP}/15.js`, withoutStop(3)), // without ?again
    says: DAMAGED,
    async then() {
      await theRestWorks();
      await again();
      await rays();
      assert.equal((await state(page)).sweep, `${SWEEP}:3`);
      assert.ok(await isQuiet());
    },
  },
  { name: "the browser gives no WebGL", query: "?fault=webgl", hash: "still=1", says: /^This browser gives no WebGL: the scene is drawn in a simpler way; everything else works\.$/, then: () => theRestWorks() },
  {
    name: "storage is refused: nothing is said before something is to be kept",
    query: "?fault=storage",
    act: async () => {
      assert.ok(await isQuiet());
      await turnKeysOff();
    },
    says: KEPT,
    then: () => theRestWorks(),
  },
  { name: "storage is full", isOneMore: true, query: "?fault=quota", act: turnKeysOff, says: KEPT, then: () => theRestWorks() },
  { name: "the browser cannot unpack", query: "?fault=unpacking", says: /^This browser is too old to unpack the rays; the picture, the lesson and the figures below are complete\.$/, then: () => thePlainPageIsThere() },
  {
    name: "the address cannot be written: the link is right all the same",
    query: "?fault=history",
    act: () => press(page, "ArrowRight", "h"),
    says: null,
    async then() {
      await theRestWorks();
      await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: async (text) => void (window.copied = text) } }));
      await openMenu(page);
      await page.getByRole("button", { name: "Copy the link" }).click();
      assert.match(await page.evaluate(() => window.copied), /rays=pixel,row/);
    },
  },
  { name: "full screen is refused", query: "?fault=fullscreen", act: () => press(page, "f"), says: /^The browser does not let this page fill the screen\.$/, then: () => theRestWorks() },
  {
    name: "the clipboard is refused: the link stands there to be copied by hand",
    query: "?fault=clipboard",
    act: () => openMenu(page).then(() => page.getByRole("button", { name: "Copy the link" }).click()),
    says: null,
    async then() {
      assert.match(await page.getByRole("dialog").getAttribute("aria-label"), /copy/i);
      assert.match(await page.locator("textarea.by-hand").inputValue(), new RegExp(`^${server.url}${rich.path}`));
      await page.keyboard.press("Escape");
      await theRestWorks();
    },
  },
  { name: "saving is refused", query: "?fault=download", act: () => openMenu(page).then(() => page.getByRole("button", { name: "Save this view" }).click()).then(() => until(page, (s, t) => t.notice !== "")), says: NOT_SAVED, then: () => theRestWorks() },
  { name: "no memory for the picture to be saved", isOneMore: true, query: "?fault=drawing", act: () => openMenu(page).then(() => page.getByRole("button", { name: "Save this view" }).click()).then(() => until(page, (s, t) => t.notice !== "")), says: NOT_SAVED, then: () => theRestWorks() },
  {
    name: "something breaks that nobody foresaw",
    act: () => page.evaluate(() => void Promise.reject(new Error("made by a test"))).then(() => until(page, (s, t) => t.notice !== "")),
    says: /^Something went wrong here; what still answers can be used, and loading the page anew puts the rest right\.$/,
    then: () => theRestWorks(),
  },
];

for (const fault of FAULTS)
  (fault.isOneMore ? oneMore : test)(fault.says ? `${fault.name}: said, and the rest works` : fault.name, async () => {
    await fault.make?.();
    await open(page, server.url, `${(fault.scene ?? rich).path}${fault.query ?? ""}`, fault.hash ?? "still=1&gl=none");
    await fault.act?.();
    await atRest(page); // a picture that does not come is known later than the scene
    if (fault.says) assert.match(await notice(), fault.says);
    else assert.ok(await isQuiet());
    await fault.then();
    await wholeAgain();
  });

test("the trace takes long: said, until it comes", async () => {
  const held = await newPage(browser, { held: true });
  held.home = server.url;
  const arrival = gate();
  await held.route(TRACE, (route) => arrival.then(() => route.continue()));
  await held.goto(`${server.url}${rich.path}#still=1&gl=none`, { waitUntil: "commit" });
  await held.waitForFunction((n) => window.raywalk?.loading().some((name) => name.endsWith(`/${n}`)), N);
  const said = held.locator("#notice .notice-text");
  await pass(held, 7500);
  assert.ok(!(await said.isVisible()));
  await pass(held, 1000);
  assert.equal(await said.innerText(), "The data is slow to arrive; what is here already works.");
  arrival.open();
  await until(held, (s, t) => t.tiles.length === 3 * s.n * s.n);
  assert.ok(!(await said.isVisible()));
  assert.deepEqual(held.faults, []);
  await held.close();
});

/** Pages whose own scripts are missing or damaged say so in the words they came with. */
const SCRIPTS = { "the words are": "**/assets/words-*.js", "the viewer is": "**/assets/viewer-*.js" };
const HOW = { missing: gone, "a sign-in page": (file) => script(file, HTML, "text/html") };
for (const [k, [what, file]] of Object.entries(SCRIPTS).entries())
  for (const [how, make] of cases(Object.entries(HOW), [Object.entries(HOW)[k]]))
    test(`${what} ${how}: the page as it was written, with one sentence`, async () => {
      await make(file);
      await page.goto("about:blank");
      await page.goto(`${server.url}${rich.path}?fault=webgl`); // nothing here is about the stage
      await page.locator("#broken").waitFor();
      assert.match(await page.locator("#broken").innerText(), PLAIN);
      await thePlainPageIsThere();
      await wholeAgain();
      await page.getByRole("link", { name: "Load the page anew" }).click();
      await page.waitForFunction(() => document.body?.classList.contains("live"));
      assert.equal(await page.locator("#broken").isVisible(), false);
    });

test("a language's words for a scene are missing: it is shown in the scene's own", async () => {
  await gone(`**/${rich.id}/words-de.js*`);
  await open(page, server.url, `de/${rich.path}`, "still=1&gl=none");
  await theRestWorks();
  assert.ok(await isQuiet());
  await wholeAgain();
});

test("thumbnails are missing: every card still has its name and leads to its scene", async () => {
  await gone("**/thumb.webp");
  await page.goto(server.url);
  for (const card of await page.locator("a.scene-card").all()) assert.ok((await card.innerText()).trim().length > 3);
  await page.locator("a.scene-card").first().click();
  await page.waitForFunction(() => document.body?.classList.contains("live"));
  await wholeAgain();
});

/** Link, what of it cannot be followed, and where it leads. start: the scene's. */
const LINKS = [
  ["p=99,2", "p", (now, { n }) => assert.deepEqual(now.pixel, [n - 1, 2])],
  ["p=-3,1e9", "p", (now, { n }) => assert.deepEqual(now.pixel, [0, n - 1])],
  ["p=NaN,2", "p"],
  ["p=1,2,3", "p"],
  ["p=1", "p"],
  ["n=16&p=3,4", "n", (now) => assert.deepEqual([now.n, now.pixel], [15, [3, 4]])],
  ["n=99999999999999999999", "n", (now, { levels }) => assert.equal(now.n, levels.at(-1))],
  ["n=-1", "n", (now, { levels }) => assert.equal(now.n, levels[0])],
  ["n=Infinity", "n"],
  ["n=&p=%%%", "n, p"],
  ["rays=diagonal", "rays"],
  ["tiles=half", "tiles"],
  ["cam=1,2", "cam"],
  ["cam=1,2,3,1,9,3", "cam"],
  ["cam=1e308,1e308,-1e308,0,0,0", "cam", (now) => assert.ok(now.observer.eye.every((v) => Math.abs(v) < 1e4))],
  ["look=x-ray", "look"],
  ["slice=diagonal", "slice"],
  ["if=b99", "if"],
  ["if=l99x1", "if"],
  ["if=%00,%F0%9F", "if"],
  ["colours=smell", "colours"],
  ["step=999", "step", (now, { lesson }) => assert.equal(now.step, lesson.length - 1)],
  ["step=0", "step", (now) => assert.equal(now.step, 0)],
  ["step=two", "step"],
  ["step=1&answer=1", "answer", (now) => assert.deepEqual([now.step, now.revealed], [0, false])],
  ["e=999", "e", (now, _, { events }) => assert.equal(now.event, events.length - 1)],
  ["e=0", "e", (now) => assert.equal(now.event, 0)],
  ["e=x", "e"],
  ["speed=3", "speed", (now) => assert.ok([2, 4].includes(now.speed))],
  ["speed=-1", "speed", (now) => assert.equal(now.speed, 0.25)],
  ["projector=yes", "projector"],
  ["colour=red", "colour"],
  ["__proto__=1&constructor=2", "__proto__, constructor"],
  [`${"x".repeat(5000)}=1`, `${"x".repeat(16)}…`],
  [Array.from({ length: 300 }, (_, k) => `k${k}=1`).join("&"), "k0, k1, k2, k3, k4, k5, …"],
  ["<img src=x onerror=alert(1)>=1", "<img src, …".slice(0, 8)],
];
test(`links with nonsense show the nearest there is, or the start, and name what they could not follow (${LINKS.length})`, async () => {
  const scene = readScene(rich.id);
  await open(page, server.url, rich.path, "still=1&gl=none");
  const start = await state(page);
  for (const [hash, keys, holds] of LINKS) {
    const { text, now, eye, events } = await page.evaluate(async (hash) => {
      history.replaceState(null, "", `#still=1&gl=none&${hash}`);
      dispatchEvent(new PopStateEvent("popstate"));
      await window.raywalk.ready;
      const { eye, events } = window.raywalk.stats();
      return JSON.parse(JSON.stringify({ text: document.querySelector("#notice .notice-text").innerText, now: window.raywalk.state(), eye, events }));
    }, hash);
    assert.ok(text.startsWith("The address asks for something this scene does not have ("), `${hash}: ${text}`);
    assert.ok(text.includes(`(${keys}`), `${hash}: ${text}`);
    if (holds) holds(now, { ...scene, n: start.n }, { events });
    else assert.deepEqual(now, start, hash);
    assert.ok(eye.every(Number.isFinite), hash);
  }
  await theRestWorks();
});

test("an unknown scene in the link: the page's own, and said", async () => {
  await open(page, server.url, rich.path, `still=1&gl=none&scene=${"no-such-scene".repeat(9)}`);
  assert.equal((await state(page)).scene, rich.id);
  assert.match(await notice(), /^There is no scene called “no-such-scene.*…”; this is the one the page is for\.$/);
});

test("three scenes in a row while they load slowly: only the last one is shown, and back is where one was", async () => {
  const ids = scenesOfSite().map(({ id }) => id).filter((id) => id !== rich.id);
  const lastIsShown = gate();
  await answer("**/scene.js*", async (route) => {
    if (ids.slice(0, 2).includes(route.request().url().split("/").at(-2))) await lastIsShown;
    await route.continue();
  });
  await open(page, server.url, rich.path, "still=1&gl=none");
  for (const id of ids.slice(0, 3)) await openScene(page, id);
  await showsScene(page, ids[2]);
  lastIsShown.open();
  await atRest(page); // the others have come
  assert.equal((await state(page)).scene, ids[2]);
  assert.match(page.url(), new RegExp(ids[2]));
  assert.ok(await isQuiet());
  await page.goBack();
  await showsScene(page, rich.id);
  await openScene(page, ids[3]);
  await openScene(page, rich.id);
  await atRest(page);
  assert.equal((await state(page)).scene, rich.id, "asked back before the other came");
  await wholeAgain();
});

test("three grids in a row while they load slowly: only the last one is shown; another scene meanwhile wins", async () => {
  await open(page, server.url, rich.path, "still=1&gl=none");
  const asked = [];
  await answer(`**/${rich.id}/*.js*`, (route) => void asked.push(route));
  await press(page, "+", "+", "+");
  while (asked.length < 3) await new Promise((done) => setTimeout(done, 15));
  await asked.pop().continue();
  await rays();
  const { n } = await state(page);
  for (const late of asked) await late.continue();
  await atRest(page);
  assert.deepEqual([(await stats(page)).shown.n, (await stats(page)).tiles.length], [n, 3 * n * n]);
  await openScene(page, other.id);
  await page.keyboard.press("+");
  await showsScene(page, other.id);
  assert.ok(await isQuiet());
  await wholeAgain();
});

test("the graphics card drops the drawing: flat at once and said, and back by itself; not for ever", async () => {
  const page = await newPage(browser, { held: true, viewport: { width: 640, height: 480 } });
  const said = page.locator("#notice .notice-text");
  await open(page, server.url, rich.path, "still=1&tiles=filled&n=5");
  for (let time = 1; time <= 3; time++) {
    assert.equal((await stats(page)).renderer, "webgl");
    await page.evaluate(() => window.raywalk.loseContext());
    await page.waitForFunction(() => window.raywalk.stats().renderer === "flat");
    assert.match(await said.innerText(), /^The graphics card dropped the drawing: the scene goes on in a simpler way; everything else works\.$/);
    assert.equal((await state(page)).tiles, "filled");
    if (time > 2) break;
    await pass(page, 1000);
    assert.equal((await stats(page)).renderer, "webgl");
    assert.ok(!(await said.isVisible()));
    await theRestWorks(page);
  }
  await pass(page, 600_000);
  assert.equal((await stats(page)).renderer, "flat", "a card that drops it a third time is left alone");
  await theRestWorks(page);
  assert.deepEqual(page.faults.filter((fault) => !/CONTEXT_LOST|context lost/i.test(fault)), []);
  await page.close();
});

test("a turned phone keeps the view, and nothing is cut off", async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, server.url, rich.path, "still=1&gl=none&step=2");
  const before = await state(page);
  for (const [width, height] of [[844, 390], [390, 844]]) {
    await page.setViewportSize({ width, height });
    await settled(page);
    assert.deepEqual(await state(page), before);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
    const drawn = await stats(page);
    assert.ok(drawn.width > 100 && drawn.width <= width && drawn.height > 100, `${drawn.width} x ${drawn.height}`);
  }
  await page.setViewportSize({ width: 1280, height: 800 });
});

test("in a frame that may not keep, save or write anything the scene is there", async () => {
  const frame = `<!doctype html><title>Course</title><iframe sandbox="allow-scripts" src="${server.url}${rich.path}?embed#still=1&gl=none" width="900" height="640" title="Ray walk"></iframe>`;
  await answer("**/course.html", (route) => route.fulfill({ contentType: "text/html", body: frame }));
  await page.goto(`${server.url}course.html`);
  const inner = await framedIn(page, true); // what is sandboxed has no origin
  await inner.getByRole("slider", { name: "Event" }).press("ArrowRight");
  await inner.locator(".event-says").waitFor();
  assert.equal(await inner.evaluate(() => window.raywalk.state().event), 0);
  await wholeAgain();
});

test("without JavaScript: picture, lesson, figures, one sentence", async () => {
  const plain = await newPage(browser, { javaScriptEnabled: false });
  await plain.goto(server.url + rich.path);
  assert.equal(await plain.locator("noscript .notice").innerText(), "JavaScript is off: the rays cannot be moved; the picture, the lesson and the figures are here.");
  await plain.locator(".chooser").click(); // opened by the browser alone
  for (const part of [".plain-picture", ".plain-lesson li", ".figures dt", "nav.scenes a"]) assert.ok(await plain.locator(part).first().isVisible(), part);
  assert.ok(!(await plain.locator("#viewer").isVisible()));
  await plain.goto(server.url);
  assert.ok((await plain.locator("a.scene-card").count()) > 2);
  await plain.close();
});

test("nothing was thrown but what the tests threw, and nothing outside was asked for", () => {
  const expected = /Failed to load resource|Unexpected token '<'|Invalid or unexpected token|Unexpected end of input|made by a test|net::ERR|sandboxed|Blocked script execution/;
  assert.deepEqual(page.faults.filter((fault) => !expected.test(fault)), []);
});
