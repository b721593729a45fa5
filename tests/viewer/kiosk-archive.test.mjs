/** The archive unpacked elsewhere, started by its own script, with a real profile and its rules. */
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium, DIST, PATIENCE, scenesOfSite, state, stats, until } from "./browser.mjs";
import { cases, oneMore } from "./cases.mjs";

const place = mkdtempSync(join(tmpdir(), "raywalk kiosk #1 50% ä-")); // as people name their folders
const profile = mkdtempSync(join(tmpdir(), "raywalk-profile-"));
const PYTHON = existsSync(".venv/bin/python") ? resolve(".venv/bin/python") : "python3";
// With the modes that unpacking programs keep.
const UNPACK = `
import os, sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as packed:
    for info in packed.infolist():
        os.chmod(packed.extract(info, sys.argv[2]), info.external_attr >> 16)
`;

let script, browser, page;
const said = [];

before(async () => {
  const zip = join(place, "raywalk-kiosk.zip");
  execFileSync(PYTHON, ["-m", "raywalk", "kiosk", "--site", DIST, "--out", zip]);
  execFileSync(PYTHON, ["-c", UNPACK, zip, place]);
  script = spawn(join(place, "raywalk-kiosk/start-linux.sh"), ["idle=3600&warn=1&attract-pace=0.4"], {
    env: { ...process.env, RAYWALK_PROFILE: profile, RAYWALK_ONCE: "1", RAYWALK_BROWSER: process.env.CHROMIUM ?? "/usr/bin/chromium", RAYWALK_FLAGS: "--headless=new --no-sandbox --remote-debugging-port=0 --window-size=500,400 --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --enable-logging=stderr" },
    stdio: ["ignore", "ignore", "pipe"],
    detached: true, // a group of its own: it ends with all that it started
  });
  script.stderr.on("data", (data) => said.push(String(data)));
  const ports = join(profile, "DevToolsActivePort");
  for (const end = Date.now() + PATIENCE; !existsSync(ports) || !readFileSync(ports, "utf8").includes("\n"); await new Promise((done) => setTimeout(done, 50)))
    assert.ok(Date.now() < end && script.exitCode === null, `the script did not start a browser: ${said.join("")}`);
  browser = await chromium.connectOverCDP(`http://127.0.0.1:${readFileSync(ports, "utf8").split("\n")[0]}`, { timeout: PATIENCE });
  for (const end = Date.now() + PATIENCE; !page; await new Promise((done) => setTimeout(done, 50))) {
    page = browser.contexts()[0].pages().find((each) => each.url().includes("kiosk=1")); // at first a window has no address yet
    assert.ok(Date.now() < end, "its page");
  }
  page.setDefaultTimeout(PATIENCE);
  page.faults = [];
  page.on("console", (message) => page.faults.push(`console ${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => page.faults.push(`error: ${error.message}`));
});
after(async () => {
  await browser?.close();
  try {
    if (script) process.kill(-script.pid);
  } catch {
    // it has ended with its browser
  }
  await new Promise((done) => (script?.exitCode === null && script.signalCode === null ? script.once("exit", done) : done()));
  for (const folder of [place, profile]) rmSync(folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
});

test("its script opens the first scene full of life, with nothing said on the console", async () => {
  const [first] = scenesOfSite();
  assert.match(page.url(), new RegExp(`^file:///.*raywalk%20kiosk%20%231%2050%25%20%C3%A4.*/course/${first.path}#kiosk=1`));
  await page.reload();
  await until(page, (s, t) => t.kiosk?.attract && t.kiosk.stops > 1);
  assert.deepEqual(page.faults, []);
  assert.doesNotMatch(said.join(""), /CONSOLE|unknown flag|Unrecognized/i);
});

test("a visitor reaches every scene and the pages around them, and nothing else", async () => {
  await page.mouse.click(300, 300);
  await until(page, (s, t) => t.kiosk?.left > 0);
  for (const { id } of cases(scenesOfSite(), scenesOfSite().slice(-2))) {
    await page.evaluate((id) => document.querySelector(`nav.scenes a[data-scene="${id}"]`).click(), id);
    await until(page, (s, t, id) => s.scene === id && t.tiles.length > 0, id);
    await page.mouse.move(300 + Math.random(), 300);
  }
  assert.equal((await stats(page)).renderer, "webgl");
  await page.locator("a.brand").click();
  await page.locator("html.kiosk body.gallery").waitFor({ state: "attached" });
  // In one step: between finding links and reading them the kiosk may take an address away.
  const ways = await page.evaluate(() => [...document.querySelectorAll("a[href]")].map((link) => link.getAttribute("href")));
  assert.ok(ways.length > 10);
  for (const way of ways) assert.match(way, /^(\.\.\/)*(de\/)?(index\.html|model\/index\.html|glossary\/index\.html|scenes\/[^/]+\/index\.html)?(#.*)?$/);
  assert.deepEqual(page.faults, []);
});

oneMore("each scene's own page opens from the disk in its own right", async () => {
  for (const { path, id } of scenesOfSite()) {
    await page.goto(`${pathToFileURL(join(place, "raywalk-kiosk/course", path)).href}#still=1&gl=none&tiles=filled`);
    await until(page, (s, t, id) => s.scene === id && t.tiles.length > 0, id);
  }
  assert.equal((await state(page)).tiles, "filled");
  assert.deepEqual(page.faults, []);
});
