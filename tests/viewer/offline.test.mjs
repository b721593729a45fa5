/** On a host: without its network the site goes on, from what was kept; a newer build takes its place quietly. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { DIST, inTime, launch, newPage, open, PATIENCE, press, keyedScenes, scenesOfSite, state, stats, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";
import { serve } from "./server.mjs";

const [first, second, third] = keyedScenes();
const UNDER = "/a/b/"; // a sub-path, as project pages have
let browser, server, page, context;
before(async () => {
  browser = await launch();
  server = await serve(DIST, UNDER);
  page = await newPage(browser, { worker: true });
  context = page.context();
});
after(async () => {
  await browser.close();
  server.close();
});

const kept = () => page.evaluate(async () => (await Promise.all((await caches.keys()).map(async (name) => (await (await caches.open(name)).keys()).map(({ url }) => url)))).flat());
/** Until the worker has kept what this page used. */
const isKept = async (part) => {
  for (const end = Date.now() + PATIENCE; Date.now() < end; await page.waitForTimeout(30)) if ((await kept()).some((url) => url.endsWith(part))) return;
  throw new Error(`never kept: ${part}`);
};
const pictureShows = (selector) => page.locator(selector).first().evaluate((image) => image.complete && image.naturalWidth > 0);

test("under a sub-path every page links to its own only, and the manifest is found", async () => {
  await open(page, server.url, "index.html");
  assert.equal(await page.locator("link[rel=manifest]").evaluate((link) => link.href), `${server.url}manifest.webmanifest`);
  const links = new Set(await page.locator("a[href]").evaluateAll((all) => all.map((link) => link.href.split("#")[0])));
  for (const link of links) {
    assert.ok(link.startsWith(server.url), link);
    assert.equal((await page.request.get(link)).status(), 200, link);
  }
  assert.deepEqual(page.faults, []);
});

test("what was looked at is there when the host is gone; what was not is said", async () => {
  await open(page, server.url, first.path, "still=1&tiles=filled"); // in space: what draws it is kept, too
  const { n } = await state(page);
  await isKept(`${first.id}/${n}.js`);
  await isKept(`${first.id}/picture.webp`);
  await page.evaluate((id) => document.querySelector(`nav.scenes a[data-scene="${id}"]`).click(), second.id); // a scene in the same page, through the worker by now
  await until(page, (s, t, id) => s.scene === id && t.tiles.length > 0, second.id);
  await isKept(`${second.id}/picture.webp`);
  for (const name of readdirSync(`${DIST}/assets`).filter((each) => each.startsWith("part-"))) await isKept(name);
  server.close();
  server.close = () => {};
  await context.setOffline(true);
  for (const [scene, gl] of [[first, ""], [second, "&gl=none"]]) {
    await open(page, server.url, scene.path, `still=1&tiles=filled${gl}`);
    assert.equal((await state(page)).scene, scene.id);
    assert.ok((await stats(page)).tiles.length > 0);
    assert.ok(await pictureShows(".picture img"));
    await page.locator("#tab-card-tree").click(); // parts that come when asked for are there too
    await page.locator(".tree .node").first().waitFor();
    await press(page, "?");
    assert.ok(await page.locator("dialog[open] .keys").first().isVisible());
    assert.equal((await stats(page)).notice, "");
  }
  await open(page, server.url, "de/index.html");
  assert.ok(await pictureShows(".cards img"), "the gallery is there in every language");
  await page.goto(`${server.url}${third.path}`);
  assert.match(page.url(), /\/a\/b\/offline\/index\.html$/);
  assert.match(await page.locator("h1").innerText(), /not kept for offline use/);
  await page.goto(`${server.url}de/${third.path}`);
  assert.match(await page.locator("h1").innerText(), /nicht offline/);
  await page.getByRole("link", { name: "Alle Szenen" }).click();
  await page.waitForURL(/de\/index\.html$/);
  await context.setOffline(false);
});

/** A worker whose build has these scenes alone, of the check and the mistakes nothing: each file is kept as any other. */
function workerOf(ids) {
  const worker = readFileSync(join(DIST, "sw.js"), "utf8");
  const [line, json] = /^const BUILD = (.*);$/m.exec(worker);
  const build = JSON.parse(json);
  const isThere = (path) => !/^(\w+\/)?(check|mistakes)\//.test(path) && ids.includes(/scenes\/([^/]+)\//.exec(path)?.[1] ?? ids[0]);
  build.files = Object.fromEntries(Object.entries(build.files).filter(([path]) => isThere(path)));
  build.first = build.first.filter(isThere);
  return worker.replace(line, () => `const BUILD = ${JSON.stringify(build)};`);
}

test("one button keeps all scenes, tells how far it is, and then every scene opens without a network", async () => {
  // In every run the site's first scene, the one with the largest mesh, and the last one.
  const every = scenesOfSite();
  const all = cases(every, [every[0], every.find(({ key }) => key === "9"), every.at(-1)]);
  const ids = new Set(all.flatMap(({ id }) => [id, readScene(id).of]));
  server = await serve(DIST, UNDER, cases({}, { "sw.js": workerOf([...ids]) }));
  page.faults.length = 0;
  await open(page, server.url, "index.html");
  const panel = page.locator("#offline");
  const button = panel.getByRole("button", { name: /Keep all scenes for offline use \([\d.]+ MB\)/ });
  await button.waitFor();
  const heard = [];
  await page.exposeFunction("heard", (text) => heard.push(text));
  await panel.locator("output").evaluate((output) => new MutationObserver(() => window.heard(output.textContent)).observe(output, { childList: true }));
  await button.click();
  await panel.getByText("All scenes are kept for offline use").waitFor();
  assert.ok(heard.filter((text) => /^[\d.]+ MB of [\d.]+ MB are kept$/.test(text)).length > 3, heard.join("; "));
  await context.setOffline(true);
  const names = await kept();
  for (const { id } of all) for (const file of ["index.html", "scene.js", `${readScene(id).start.resolution}.js`]) assert.ok(names.some((url) => url.endsWith(`/${file === "index.html" || file === "scene.js" ? id : readScene(id).of}/${file}`)), `${id}/${file}`);
  for (const { id, path } of all) {
    await open(page, server.url, path, "still=1&gl=none&tiles=filled");
    assert.equal((await state(page)).scene, id);
    assert.ok((await stats(page)).tiles.length > 0, id);
    assert.ok(await pictureShows(".picture img"), id);
  }
  await context.setOffline(false);
  const own = page.faults.filter((fault) => !/outside request: .*icon-48/.test(fault)); // a tab's icon comes late: the server before had another port
  assert.deepEqual(own, []);
});

test("a newer build says so quietly, opens when asked, and leaves nothing of the older behind", async () => {
  const site = mkdtempSync(join(tmpdir(), "raywalk-newer-"));
  const own = await serve(site, "/");
  try {
    const worker = readFileSync(join(DIST, "sw.js"), "utf8");
    const { first, version } = JSON.parse(/^const BUILD = (.*);$/m.exec(worker)[1]);
    for (const path of ["index.html", "manifest.webmanifest", ...first]) cpSync(join(DIST, path), join(site, path));
    writeFileSync(join(site, "sw.js"), worker);
    const page = await newPage(browser, { worker: true });
    await open(page, own.url, "index.html");
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.locator("#offline button").waitFor();
    const names = await page.evaluate(() => caches.keys());
    assert.equal(names.length, 1);
    writeFileSync(join(site, "sw.js"), worker.replace(version, "0123456789abcdef"));
    await page.reload();
    await page.locator("#newer").waitFor();
    assert.match(await page.locator("#newer").innerText(), /A newer version of this site is ready/);
    await Promise.all([page.waitForEvent("load"), page.locator("#newer button").click()]);
    await page.waitForFunction(async () => (await caches.keys()).every((name) => name.endsWith("0123456789abcdef")));
    assert.ok(!(await page.locator("#newer").isVisible()));
    assert.deepEqual(page.faults, []);
    await page.close();
  } finally {
    own.close();
    rmSync(site, { recursive: true });
  }
});

test("two builds, one after the other, through one worker: pages and data are of the same build, whatever is asked for", async () => {
  const site = mkdtempSync(join(tmpdir(), "raywalk-two-builds-"));
  const own = await serve(site, "/");
  const context = await browser.newContext();
  try {
    cpSync(DIST, site, { recursive: true, filter: (path) => !/slides|sizes|benchmarks/.test(path.slice(DIST.length)) });
    const older = await context.newPage();
    older.setDefaultTimeout(PATIENCE);
    const flat = "#still=1&gl=none"; // nothing here is about the stage
    await older.goto(`${own.url}${first.path}${flat}`);
    await inTime(older.evaluate(() => Promise.all([window.raywalk.ready, navigator.serviceWorker.ready])), "no worker");
    await older.waitForFunction(async (id) => (await Promise.all((await caches.keys()).map(async (name) => (await (await caches.open(name)).keys()).map(({ url }) => url)))).flat().some((url) => url.endsWith(`${id}/scene.js`)), first.id);
    execFileSync(".venv/bin/python", ["tests/viewer/two_builds.py", site]);

    /** Its words are the newer build's. The browser is not asked for its title: while it still goes somewhere, that is "Loading ...". */
    const isNewer = (page) => page.waitForFunction(() => document.title.startsWith("Newer: "));

    /** In vain: what it asks for fails, and it stays where it is. */
    const stays = async (key) => {
      await Promise.all([older.waitForEvent("requestfailed"), older.keyboard.press(key)]);
      await older.waitForFunction(() => !window.raywalk.loading().length && document.querySelector("#notice .notice-text")?.textContent);
      assert.equal((await state(older)).scene, first.id, "an open page of the older build takes no data of the newer one");
    };
    await stays(second.key);

    const newer = await context.newPage();
    newer.setDefaultTimeout(PATIENCE);
    await newer.goto(`${own.url}${third.path}${flat}`); // not kept: it comes from the host
    await isNewer(newer);
    for (const { key, id } of [first, second]) {
      await newer.keyboard.press(key); // the first one's data are kept, of the older build
      await newer.waitForFunction((id) => window.raywalk.state()?.scene === id && window.raywalk.stats().shown.scene === id, id);
      await isNewer(newer);
    }
    await newer.goto(`${own.url}${first.path}${flat}`); // kept, but the host is known to be newer
    await isNewer(newer);

    await newer.goto(`${own.url}index.html`);
    await newer.locator("#newer button").waitFor();
    await Promise.all([newer.waitForEvent("load"), newer.locator("#newer button").click()]);
    await stays(third.key); // its worker is the newer one now
    await older.reload();
    await isNewer(older);
  } finally {
    await context.close();
    own.close();
    rmSync(site, { recursive: true });
  }
});

test("from a disk there is neither worker nor manifest, and no word about them", async () => {
  const page = await newPage(browser, { worker: true });
  await page.goto(new URL("index.html", `file://${DIST}/`).href);
  assert.equal(await page.locator("link[rel=manifest]").count(), 0);
  assert.ok(!(await page.locator("#offline").isVisible()));
  assert.deepEqual(page.faults, []);
  await page.close();
});
