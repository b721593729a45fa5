/** One browser for a test file, and pages in it that remember what they should not have done. */
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { PNG } from "pngjs";

// Asked for as CommonJS, which it is: to import it node would read its megabytes twice, first for what they export.
export const { chromium } = createRequire(import.meta.url)("playwright-core");

export const DIST = resolve(process.env.RAYWALK_DIST ?? "dist");
export const ON_DISK = pathToFileURL(`${DIST}/`).href;
/** ms until what does not come counts as never coming: a machine that does ten other things must not fail a test. */
export const PATIENCE = 180_000;

const BROWSERS = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
/** The same engine without windows: starting it and putting a page together cost half. */
const SHELL = /headless-shell$/;
const SHELLS = ["/usr/bin/chromium-headless-shell"];
const FLAGS = "--no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --disable-background-networking --disable-sync --no-first-run";
// Without a graphics card WebGL is drawn in software. Putting the rest of the page together that way too would double what
// a test costs. The other way reads each drawing back, of which the driver warns.
const COMPOSED_APART = "--disable-gpu-compositing";
const OF_READING_BACK = /GL Driver Message .* GPU stall due to ReadPixels/;
// Four samples a pixel make a stage in space dearer by a third.
const JAGGED = "--webgl-msaa-sample-count=0";

/** whole: the browser that people have, for tests of what the one without windows lacks: idle time, say. smooth: edges in
 *  space are smoothed, as people see them. */
export async function launch(more = [], { whole = false, smooth = false } = {}) {
  const [asked, ...others] = BROWSERS;
  const executablePath = [asked, ...(whole ? [] : SHELLS), ...others].find((path) => path && existsSync(path));
  if (!executablePath) throw new Error("no browser: set CHROMIUM to the path of a Chromium or Chrome");
  const browser = await chromium.launch({ executablePath, timeout: PATIENCE, args: [...FLAGS.split(" "), COMPOSED_APART, ...(smooth ? [] : [JAGGED]), ...more] });
  return Object.assign(browser, { isShell: SHELL.test(executablePath) });
}

/** The scenes the site has, from the first scene page's links: [{ id, key, path }]. */
export function scenesOfSite() {
  const home = readFileSync(`${DIST}/index.html`, "utf8");
  const paths = [...home.matchAll(/class="scene-card" href="([^"]+)"/g)].map((match) => match[1]);
  return paths.map((path) => {
    const page = readFileSync(`${DIST}/${path}`, "utf8");
    const id = page.match(/<body[^>]*data-scene="([^"]+)"/)[1];
    return { id, path, key: page.match(new RegExp(`data-scene="${id}" data-key="([^"]*)"`))[1] };
  });
}

/** Those that a key selects: none of them is a lesson on another, which has no rays of its own. */
export const keyedScenes = () => scenesOfSite().filter(({ key }) => key);

/** The one in this folder, whatever its place in the course. */
export function sceneCalled(id) {
  const scene = scenesOfSite().find((each) => each.id === id);
  if (!scene) throw new Error(`the site has no scene ${id}`);
  return scene;
}

/** The scene with mirrors if the site has it: its trees have several kinds of ray. */
export const richScene = () => scenesOfSite().find((scene) => scene.key === "5") ?? scenesOfSite()[0];

/** A page that notes console messages, errors and requests that leave the site. worker: with the service worker, which
 *  would answer from what it kept where other tests answer for the server. held: its clock (timers, frames, dates) stands
 *  still and moves by `pass` only, or while this file's helpers wait for the page. sharp: a pixel of the screen for each of
 *  the page's, for tests of pictures and sizes; else half as many each way, which are drawn in much less time. */
export async function newPage(browser, { worker = false, held = false, sharp = false, ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, deviceScaleFactor: sharp ? 1 : 0.5, ...options });
  if (!worker) await page.addInitScript(() => Object.defineProperty(Navigator.prototype, "serviceWorker", { get: () => undefined }));
  // Without windows the browser is never idle; the viewer then waits as in a browser that does not tell of idle time.
  if (browser.isShell) await page.addInitScript(() => delete window.requestIdleCallback);
  page.setDefaultTimeout(PATIENCE);
  const evaluate = page.evaluate.bind(page);
  page.evaluate = (...what) => inTime(evaluate(...what), `the page never answered: ${what[0]}`);
  if (!held) await page.addInitScript(patient);
  else {
    await page.clock.install({ time: 0 });
    await page.clock.pauseAt(3_600_000); // it ran until now
    page.isHeld = true;
  }
  page.faults = [];
  page.on("console", (message) => OF_READING_BACK.test(message.text()) || page.faults.push(`console ${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => page.faults.push(`error: ${error.message}`));
  page.on("request", (request) => {
    const url = request.url();
    const home = page.home ?? ON_DISK;
    if (!url.startsWith(home) && !/^(data|blob):/.test(url)) page.faults.push(`outside request: ${url}`);
  });
  return page;
}

/** In the page: what ends after seconds (a tick, a sentence, patience with slow data) lasts. How long a machine takes until a
 *  test looks is nothing that a page is asked about, and time itself is asked of held pages. */
function patient() {
  const SECONDS = 1500; // ms: the shortest of those
  const { setTimeout } = window;
  window.setTimeout = (act, ms, ...more) => setTimeout(act, ms >= SECONDS ? 3_600_000 : ms, ...more);
}

/** Goes there and waits until the viewer has drawn and all its parts are here. base: ON_DISK or a server's url. */
export async function open(page, base, path, hash = "") {
  await page.goto("about:blank"); // what the page before still asks for is asked from its home
  page.home = base;
  await page.goto(`${base}${path}${hash && `#${hash}`}`);
  await isWhole(page);
}

/** Loads the page anew and waits as `open` does: the scene alone is ready before anything of it is drawn. */
export async function reload(page) {
  await page.reload();
  await isWhole(page);
}

/** Of a page that a link or another page has opened: waits as `open` does. page: or a frame. */
export async function isWhole(page) {
  await whilePassing(page, page.evaluate(() => window.raywalk?.ready));
  await whilePassing(page, page.evaluate(() => window.raywalk?.whole), 50); // they wait for idle time
  await settled(page);
}

/** The scene's page in a frame of another page, once it is whole. isStranger: of another origin, where without a screen there
 *  is no idle time; its parts come when they are asked for. */
export async function framedIn(page, isStranger = false) {
  const frame = await (await page.locator("iframe").elementHandle()).contentFrame();
  await frame.waitForFunction(() => window.raywalk);
  if (!isStranger) await inTime(isWhole(frame), "the frame was never whole");
  await frame.evaluate(() => window.raywalk.ready);
  await settled(frame);
  return frame;
}

/** Another view in a page that is open, as a link to it would give: quicker than loading it anew. */
export async function follow(page, hash) {
  const followed = page.evaluate((hash) => {
    history.replaceState(null, "", `#${hash}`);
    window.dispatchEvent(new PopStateEvent("popstate"));
    return window.raywalk.ready;
  }, hash);
  await whilePassing(page, followed);
  await settled(page);
}

/** Goes there as a link would: where that very page is open already, without loading it anew. */
export const show = (page, base, path, hash = "") => {
  const [address, at = ""] = page.url().split("#");
  return address === base + path && !at.includes("scene=") ? follow(page, hash) : open(page, base, path, hash);
};

/** What is awaited in a page has no end of its own: a promise that never settles would hold its test for ever. */
export async function inTime(promise, complaint) {
  let clock;
  const never = new Promise((_, fail) => (clock = setTimeout(() => fail(new Error(complaint)), PATIENCE)));
  return Promise.race([promise, never]).finally(() => clearTimeout(clock));
}

const rest = (ms) => new Promise((done) => setTimeout(done, ms));
const POLL = 15; // ms, ours
const TICK = 5; // ms, ours, while a held page waits for its machine: each question is work for all that it waits for
const FRAME = 16; // ms of a held page: its clock's frames
const MOST_AT_ONCE = 200; // ms of a held page that pass between two questions

/** ms of a held page. What its timers throw fails the test. */
export const pass = (page, ms) => page.clock.runFor(ms);

/** On a held page a promise of the page's may need its timers: they get a millisecond now and then, so that nothing is late. */
async function whilePassing(page, promise, step = 1) {
  let isOver = !page.isHeld;
  const over = () => (isOver = true);
  promise.then(over, over);
  for (; !isOver; await rest(TICK)) await pass(page, step);
  return promise;
}

/** Until the next two frames are drawn: those that the page asked for, and what the browser makes of them. */
export async function settled(page) {
  if (!page.isHeld) return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))));
  await pass(page, 2 * FRAME + 1);
  return page.evaluate(async () => {
    // The browser's own frames: an observer tells of what it is given with the next one, whatever the clock says.
    const frame = () => new Promise((done) => new ResizeObserver((_, it) => (it.disconnect(), done())).observe(document.documentElement));
    await frame();
    await frame();
  });
}

/** Until the page says that nothing is on its way, nothing moves and no frame is asked for. */
export async function atRest(page) {
  await poll(page, "window.raywalk?.pending() ?? ['the viewer']", (pending) => !pending.length, (pending) => `never at rest: ${pending.join(", ")}`);
  await page.evaluate(() => Promise.all([...document.images].filter((image) => image.checkVisibility()).map((image) => image.decode().catch(() => {}))));
  await settled(page);
}

/** A picture of the page, or of a part of it, at rest. */
export async function pictureOf(page, part = page) {
  await atRest(page);
  return PNG.sync.read(await part.screenshot({ animations: "disabled" }));
}

/** What the page's main thread has worked so far: ms of processor time, which other programs do not add to. */
export async function workOf(page) {
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Performance.enable", { timeDomain: "threadTicks" });
  return async () => 1000 * (await devtools.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
}

export const state = (page) => page.evaluate(() => window.raywalk.state());
export const stats = (page) => page.evaluate(() => JSON.parse(JSON.stringify(window.raywalk.stats())));
/** From the observer to what it looks at, world units. Of stats. */
export const reach = ({ eye, target }) => Math.hypot(...eye.map((v, k) => v - target[k]));
export const press = async (page, ...keys) => {
  for (const key of keys) await page.keyboard.press(key);
  await settled(page);
};
/** Until the viewer's state fits. what: a function of state and stats, run in the page. */
export async function until(page, what, argument) {
  await poll(page, `window.raywalk?.state() ? !!(${what})(window.raywalk.state(), window.raywalk.stats(), ${JSON.stringify(argument) ?? null}) : false`, Boolean, () => `never came true: ${what}`);
  if (page.isHeld) await settled(page);
}
/** Until the page shows this scene with its rays. Before them it shows the scene alone, and the address is not written yet. */
export const showsScene = (page, id) => until(page, (s, t, id) => t.shown.scene === id && t.tiles.length > 0, id);
/** Asks until the answer is right. On a held page time passes meanwhile, by more and more at once; by single milliseconds
 *  while something is on its way, because what is slow then is this machine and not what the page waits for. */
async function poll(page, expression, isRight, complaint) {
  const ask = `({ answer: ${expression}, waits: window.raywalk?.loading().length !== 0 })`;
  let now = null;
  let step = FRAME;
  for (const end = Date.now() + PATIENCE; Date.now() < end; await rest(!page.isHeld ? POLL : now?.waits ? TICK : 1)) {
    now = await page.evaluate(ask).catch(goneElsewhere);
    if (now && isRight(now.answer)) return;
    if (page.isHeld) await pass(page, !now || now.waits ? 1 : (step = Math.min(MOST_AT_ONCE, 1.2 * step))).catch(goneElsewhere);
  }
  throw new Error(complaint(now?.answer));
}
/** A page that is on its way to another address cannot be asked just now. */
function goneElsewhere(error) {
  if (!/context was destroyed|navigation/i.test(error.message)) throw error;
  return null;
}

/** Where a tile's middle is on the page. */
export async function tileOnPage(page, column, row) {
  const box = await page.locator(".stage-view").boundingBox();
  const at = await page.evaluate(([c, r]) => window.raywalk.stats().tile(c, r), [column, row]);
  return { x: box.x + at.x, y: box.y + at.y };
}

/** What stands behind a button is opened unless it is open: the drawer of tools, the page's menu, the scene chooser. */
export async function openDrawer(page) {
  if ((await page.locator(".open-drawer").getAttribute("aria-expanded")) === "false") await page.locator(".open-drawer").click();
  await page.locator(".drawer .view-switch").waitFor(); // its part comes when asked for
  await settled(page);
}
const openPopover = (opener, popover) => async (page) => {
  if (!(await page.locator(popover).isVisible())) await page.locator(opener).click();
  await page.locator(popover).waitFor();
};
export async function openMenu(page) {
  await openPopover(".menu-open", "#menu")(page);
  await page.locator("#menu .tools").waitFor({ state: "attached" }); // its part comes when asked for; a kiosk does not show it
}
export const openChooser = openPopover(".chooser", "nav.scenes");

/** Another scene, chosen by its picture. */
export async function openScene(page, id) {
  await openChooser(page);
  await page.locator(`nav.scenes a[data-scene="${id}"]`).click();
}

/** A tab of the ray card, unless it is the chosen one, which a press would close. tab: rays, tree, sum or code. */
export async function chooseTab(page, tab) {
  if ((await state(page)).tab !== tab) await page.locator(`#tab-card-${tab}`).click();
  await page.locator(`#panel-card-${tab} > *`).waitFor(); // its part comes when asked for
  await settled(page);
}
