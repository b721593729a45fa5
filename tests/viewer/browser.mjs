/** One browser for a test file, and pages in it that remember what they should not have done. */
import { existsSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const DIST = resolve(process.env.RAYWALK_DIST ?? "dist");
export const ON_DISK = pathToFileURL(`${DIST}/`).href;

const BROWSERS = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
const FLAGS = "--no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --disable-background-networking --disable-sync --no-first-run";
// Without a graphics card WebGL is drawn in software. Putting the rest of the page together that way too doubles what a
// test costs: only tests of what a frame costs do so. The other way reads each drawing back, of which the driver warns.
const COMPOSED_APART = ["--disable-gpu-compositing"];
export const COMPOSED_TOGETHER = [];
const OF_READING_BACK = /GL Driver Message .* GPU stall due to ReadPixels/;

export function launch(more = [], composed = COMPOSED_APART) {
  const executablePath = BROWSERS.find((path) => path && existsSync(path));
  if (!executablePath) throw new Error("no browser: set CHROMIUM to the path of a Chromium or Chrome");
  return chromium.launch({ executablePath, args: [...FLAGS.split(" "), ...composed, ...more] });
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

/** The scene with mirrors if the site has it: its trees have several kinds of ray. */
export const richScene = () => scenesOfSite().find((scene) => scene.key === "5") ?? scenesOfSite()[0];

/** A page that notes console messages, errors and requests that leave the site. worker: with the service worker, which
 *  would answer from what it kept where other tests answer for the server. */
export async function newPage(browser, { worker = false, ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, ...options });
  if (!worker) await page.addInitScript(() => Object.defineProperty(Navigator.prototype, "serviceWorker", { get: () => undefined }));
  page.setDefaultTimeout(15000);
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

/** Goes there and waits until the viewer has drawn and all its parts are here. base: ON_DISK or a server's url. */
export async function open(page, base, path, hash = "") {
  page.home = base;
  await page.goto("about:blank");
  await page.goto(`${base}${path}${hash && `#${hash}`}`);
  await page.evaluate(() => window.raywalk?.ready);
  await page.evaluate(() => window.raywalk?.whole);
  await settled(page);
}

/** Another view in a page that is open, as a link to it would give: quicker than loading it anew. */
export async function follow(page, hash) {
  await page.evaluate((hash) => {
    history.replaceState(null, "", `#${hash}`);
    window.dispatchEvent(new PopStateEvent("popstate"));
    return window.raywalk.ready;
  }, hash);
  await settled(page);
}

/** Until the next two frames are drawn. */
export const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))));

export const state = (page) => page.evaluate(() => window.raywalk.state());
export const stats = (page) => page.evaluate(() => JSON.parse(JSON.stringify(window.raywalk.stats())));
export const press = async (page, ...keys) => {
  for (const key of keys) await page.keyboard.press(key);
  await settled(page);
};
/** Until the viewer's state fits. what: a function of state and stats, run in the page. */
export async function until(page, what, argument) {
  const ask = `window.raywalk?.state() ? !!(${what})(window.raywalk.state(), window.raywalk.stats(), ${JSON.stringify(argument) ?? null}) : false`;
  for (const end = Date.now() + 15000; Date.now() < end; ) {
    if (await page.evaluate(ask).catch(goneElsewhere)) return;
    await page.evaluate(() => new Promise((done) => setTimeout(done, 15))).catch(goneElsewhere);
  }
  throw new Error(`never came true: ${what}`);
}
/** A page that is on its way to another address cannot be asked just now. */
function goneElsewhere(error) {
  if (!/context was destroyed|navigation/i.test(error.message)) throw error;
  return false;
}

/** Where a tile's middle is on the page. */
export async function tileOnPage(page, column, row) {
  const box = await page.locator(".stage-view").boundingBox();
  const at = await page.evaluate(([c, r]) => window.raywalk.stats().tile(c, r), [column, row]);
  return { x: box.x + at.x, y: box.y + at.y };
}
