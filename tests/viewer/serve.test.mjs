/** raywalk serve: what is saved shows by itself; mistakes show as text and go when they are mended. */
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launch, newPage, until } from "./browser.mjs";
import { cases } from "./cases.mjs";

const PATIENCE = 600_000; // ms: the machine may be busy, and kernels may have to be compiled
const SCENE = `
version = 1
key = "1"
title = "Ball"
teaches = "A ball."
camera = { eye = [0, 0, 5], target = [0, 0, 0] }
render = { size = 63, resolutions = [7, 21], depth = 1 }
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 0.9
material = "coloured"
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "First words."
view = { resolution = 7, pixel = [3, 3] }
`;

let browser, folder, file, serving, page, url;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "raywalk-serve-"));
  file = join(folder, "scenes", "01-ball", "scene.toml");
  await mkdir(join(folder, "scenes", "01-ball"), { recursive: true });
  await writeFile(file, SCENE);
  execFileSync(".venv/bin/python", ["-m", "tests.with_viewer", join(folder, "work")]); // to bundle it anew takes seconds
  const places = ["--scenes", join(folder, "scenes"), "--out", join(folder, "dist"), "--work", join(folder, "work")];
  serving = spawn(".venv/bin/python", ["-m", "raywalk", "serve", "--port", "0", ...places], { stdio: ["ignore", "pipe", "inherit"] });
  url = await new Promise((found, failed) => {
    createInterface({ input: serving.stdout }).on("line", (line) => line.startsWith("http://") && found(line.split(" ")[0]));
    serving.on("exit", (code) => failed(new Error(`raywalk serve ended with ${code}`)));
  });
  browser = await launch();
  page = await newPage(browser);
  page.home = url;
  page.setDefaultTimeout(PATIENCE);
});

after(async () => {
  await browser?.close();
  serving?.removeAllListeners("exit");
  serving?.kill("SIGINT");
  await rm(folder, { recursive: true, force: true });
});

const save = (change) => writeFile(file, change(SCENE));
/** Not until it is loaded: a page that is followed may load itself anew before. */
const goTo = (path) => page.goto(url + path, { waitUntil: "commit" });
const panel = () => page.locator("#raywalk-serve");

test("a page that is asked for before the site is built shows it as soon as it is", async () => {
  await goTo("scenes/01-ball/index.html#n=7&p=2,5");
  await page.waitForFunction(() => document.querySelector("#page")?.textContent.includes("First words."));
});

test("a saved lesson shows by itself, and the address keeps its place", async () => {
  await page.waitForFunction(() => window.raywalk?.state());
  await save((text) => text.replace("First words.", "Other words."));
  await page.waitForFunction(() => document.querySelector("#page")?.textContent.includes("Other words."));
  await until(page, ({ n, pixel }) => n === 7 && pixel.join() === "2,5");
});

test("a mistake in a scene shows as text, markup in it too, while the old page stands", async () => {
  await save((text) => text.replace('"coloured"', '"<img src=x onerror=alert(1)>"'));
  await page.waitForFunction(() => document.querySelector("#raywalk-serve.trouble"));
  const text = await panel().innerText();
  assert.match(text, /scene\.toml: objects\[0\]\.material: no material is named "<img src=x/);
  assert.match(text, /1 error; nothing was traced/);
  assert.equal(await page.locator("#raywalk-serve img").count(), 0);
  assert.ok(await panel().isVisible());
  assert.ok((await page.locator("#page").textContent()).includes("Other words."));
});

test("the mistake goes when it is mended", async () => {
  await save((text) => text.replace("First words.", "Mended words."));
  await page.waitForFunction(() => document.querySelector("#page")?.textContent.includes("Mended words."));
  await page.waitForFunction(() => !document.querySelector("#raywalk-serve.trouble"));
});

/** As people name folders; a slash is all that a name cannot have. */
const NAMES = cases(["02 #1, 50 %? „Größe“", "03 a&b'\"<i>\\c> 😀"], ["02 #1, 50 %? „Größe“ a&b'\"<i>\\c> 😀"]);
const SECOND = (key) => SCENE.replace('key = "1"', `key = "${key}"`).replace('"Ball"', `"Ball ${key}"`);

test("a scene that is copied in shows by itself, whatever its folder is called, and its slides follow", async () => {
  await goTo("index.html");
  await page.waitForFunction(() => document.querySelectorAll(".scene-card").length === 1);
  for (const [k, name] of NAMES.entries()) {
    await mkdir(join(folder, "scenes", name));
    await writeFile(join(folder, "scenes", name, "scene.toml"), SECOND(k + 2));
  }
  await page.waitForFunction((count) => document.querySelectorAll(".scene-card").length === count, 1 + NAMES.length);
  for (const key of ["2", "3"].slice(0, NAMES.length)) {
    await goTo("index.html");
    await page.locator(".scene-card", { hasText: `Ball ${key}` }).click();
    await until(page, (s, t, title) => t.tiles.length > 0 && document.title.startsWith(title), `Ball ${key}`);
  }
  await eventually(() => decks().length === 1 + NAMES.length);
});

test("all that its pages link to is there, on a disk too", async () => {
  const pages = (await readdir(join(folder, "dist"), { recursive: true })).filter((path) => path.endsWith(".html") && !path.startsWith("slides/"));
  assert.ok(pages.some((path) => path.startsWith("de/scenes/02-1-50")), String(pages));
  for (const path of pages) {
    const here = pathToFileURL(join(folder, "dist", path));
    const text = await readFile(here, "utf8");
    for (const [, written] of text.matchAll(/\b(?:href|src)="([^"#]+)/g)) {
      const address = new URL(written.replaceAll("&amp;", "&"), here);
      if (address.protocol === "file:") assert.ok(existsSync(fileURLToPath(address)), `${path}: ${written}`);
    }
  }
});

test("a scene that is removed goes", async () => {
  for (const name of NAMES) await rm(join(folder, "scenes", name), { recursive: true });
  await goTo("index.html");
  await page.waitForFunction(() => document.querySelectorAll(".scene-card").length === 1);
  await eventually(() => decks().length === 1);
});

const decks = () => (existsSync(join(folder, "dist/slides")) ? readdirSync(join(folder, "dist/slides")).filter((name) => /^0.*\.pptx$/.test(name)) : []);
async function eventually(isSo) {
  for (const end = Date.now() + PATIENCE; !isSo(); await new Promise((done) => setTimeout(done, 50))) assert.ok(Date.now() < end, String(isSo));
}

test("the site on disk has none of this, and pages may talk to their own server only", async () => {
  const built = await readFile(join(folder, "dist", "scenes", "01-ball", "index.html"), "utf8");
  assert.ok(!built.includes("raywalk/reload") && !built.includes("connect-src"));
  const policy = await page.evaluate(() => document.querySelector("meta[http-equiv]").content);
  assert.ok(policy.startsWith("default-src 'none'; connect-src 'self'; script-src 'self';"));
  assert.deepEqual(page.faults.filter((fault) => !fault.includes("404")), []);
});
