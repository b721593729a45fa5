/** Every page in every language: same state, its own words, remembered where the browser allows it. */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { DIST, isWhole, launch, newPage, ON_DISK, open, openMenu, PATIENCE, press, richScene, scenesOfSite, showsScene, state, stats } from "./browser.mjs";
import { readScene } from "./scene-files.mjs";
import { serve } from "./server.mjs";

const rich = richScene();
const QUICK = "still=1&gl=none";
const german = `de/${rich.path}`;
let browser, page, server;
before(async () => {
  browser = await launch();
  server = await serve(DIST, "/course/rays/");
  page = await newPage(browser);
});
after(async () => {
  await browser.close();
  server.close();
});
const language = (of = page) => of.locator("a.language");

test("the German page speaks German: sentences, scene, numbers", async () => {
  await open(page, ON_DISK, german, `${QUICK}&n=15&p=5,8`);
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  await press(page, ".");
  assert.equal(await page.locator(".event-says").innerText(), "Ein Kamerastrahl verlässt das Auge durch Pixel (5, 8).");
  assert.match(await page.locator(".event-numbers").innerText(), /^vom Auge \([\u22120-9]+,\d{3}; /);
  const { events } = await stats(page);
  const own = readScene(rich.id);
  assert.ok(events.some((event) => event.what === "meets" && !own.objects.some(({ name }) => name === event.name)), "names are translated");
  assert.equal(await page.getByRole("button", { name: "Die Strahlen Schritt für Schritt abspielen" }).count(), 1);
});

for (const where of ["a disk", "a server, in a folder"])
  test(`from ${where} the language link keeps the view, there and back`, async () => {
    const base = where === "a disk" ? ON_DISK : server.url;
    await open(page, base, rich.path, `${QUICK}&n=15&p=5,8&e=3&rays=pixel,row`);
    const before = await state(page);
    for (const [code, name] of [["de", "Deutsch"], ["en", "English"]]) {
      await openMenu(page);
      assert.equal(await language().innerText(), name);
      await Promise.all([page.waitForURL((url) => url.pathname.includes("/de/") === (code === "de")), language().click()]);
      await isWhole(page);
      assert.equal(await page.locator("html").getAttribute("lang"), code);
      assert.deepEqual(await state(page), before);
    }
  });

test("after another scene was opened in the page, the link leads to that one", async () => {
  const other = scenesOfSite().find(({ key, id }) => key && id !== rich.id);
  await open(page, server.url, rich.path, QUICK);
  await press(page, other.key);
  await showsScene(page, other.id);
  await openMenu(page);
  await Promise.all([page.waitForURL("**/de/**"), language().click()]);
  await isWhole(page);
  assert.equal((await state(page)).scene, other.id);
});

test("the language is remembered: the first page opens in it, a scene's address decides by itself", async () => {
  const context = await browser.newContext();
  context.setDefaultTimeout(PATIENCE);
  const fresh = await context.newPage();
  await fresh.goto(`${server.url}index.html`);
  assert.equal(await fresh.locator("html").getAttribute("lang"), "en");
  await Promise.all([fresh.waitForURL("**/de/index.html"), language(fresh).click()]);
  await fresh.goto(`${server.url}index.html`, { waitUntil: "commit" }); // from there it goes on by itself
  await fresh.waitForURL("**/de/index.html");
  await fresh.goto(`${server.url}${rich.path}`);
  assert.equal(await fresh.locator("html").getAttribute("lang"), "en");
  await fresh.goto(`${server.url}de/index.html`);
  await Promise.all([fresh.waitForURL((url) => !url.pathname.includes("/de/")), language(fresh).click()]);
  await fresh.goto(`${server.url}index.html`);
  assert.equal(await fresh.locator("html").getAttribute("lang"), "en");
  await context.close();
});

test("refused storage changes nothing but the memory", async () => {
  const context = await browser.newContext();
  context.setDefaultTimeout(PATIENCE);
  await context.addInitScript(() => Object.defineProperty(window, "localStorage", { get: () => { throw new DOMException("refused", "SecurityError"); } }));
  const fresh = await context.newPage();
  const faults = [];
  fresh.on("pageerror", (error) => faults.push(error.message));
  await fresh.goto(`${server.url}index.html`);
  await Promise.all([fresh.waitForURL("**/de/index.html"), language(fresh).click()]);
  await fresh.goto(`${server.url}index.html`);
  assert.equal(await fresh.locator("html").getAttribute("lang"), "en");
  assert.deepEqual(faults, []);
  await context.close();
});

test("every page of a language has its twin, names its language and links to it", () => {
  const pages = readdirSync(DIST, { recursive: true }).filter((file) => /^(index|model\/index|scenes\/[^/]+\/index)\.html$/.test(file));
  assert.ok(pages.length >= scenesOfSite().length + 2);
  for (const file of pages)
    for (const [code, path] of [["en", file], ["de", `de/${file}`]]) {
      const html = readFileSync(`${DIST}/${path}`, "utf8");
      assert.match(html, new RegExp(`<html lang="${code}"`), path);
      for (const each of ["en", "de"]) assert.match(html, new RegExp(`<link rel="alternate" hreflang="${each}"`), path);
      assert.match(html, /<a class="language" href="[^"]+" hreflang="(en|de)" lang="\1">/, path);
    }
});

test("pictures, traces and scripts stand once: a language adds pages, slides and words alone", () => {
  const inGerman = readdirSync(`${DIST}/de`, { recursive: true }).filter((file) => /\.\w+$/.test(file) && !file.startsWith("slides"));
  const drawn = /^scenes\/[^/]+\/pictures\//; // into a lesson's text: each language may have its own
  assert.deepEqual(inGerman.filter((file) => !file.endsWith(".html") && !drawn.test(file)).sort(), ["glossary/terms.js", "manifest.webmanifest"]); // its words too
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
