/** Firefox opens the built site by its own rules: from a disk every file is another origin, and nothing is relaxed. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { DIST, ON_DISK, richScene } from "../browser.mjs";
import { firefoxHere, startFirefox } from "../firefox.mjs";
import { GOOD, HOSTILE } from "../picture-files.mjs";
import { serve } from "../server.mjs";

const path = firefoxHere();
const skip = path ? false : "no Firefox here: apt-get install firefox-esr, or say where one is with FIREFOX=/path/to/firefox";
const rich = richScene();
let firefox, server;
before(async () => {
  if (!path) return;
  [firefox, server] = await Promise.all([startFirefox(path), serve(DIST)]);
  await firefox.resize(1280, 900);
});
after(async () => {
  await firefox?.close();
  server?.close();
});

/** Where a graphics driver is missing Firefox says that it refused WebGL, whenever a page asks for it. */
const REFUSED = /^content javascript: Failed to create WebGL context/;
const said = async (home) => (await firefox.said(home)).filter((message) => !REFUSED.test(message));

async function opens(home, page, hash = "") {
  await firefox.visit("about:blank");
  await firefox.visit(`${home}${page}${hash && `#${hash}`}`);
  await firefox.evaluate("window.raywalk?.whole"); // what still comes when a page is left fails, and is said, in a later test too
}

const until = (what) => firefox.evaluate(`new Promise((done) => { const ask = () => ((${what}) ? done() : setTimeout(ask, 20)); ask(); })`);

/** The tiles' colours as the screen has them, and as the trace has them. */
async function tilesOnScreen(places) {
  const { PNG } = await import("pngjs");
  const png = PNG.sync.read(await firefox.screenshot());
  const { at, ratio, tiles, n } = await firefox.evaluate(`(() => {
    const stats = window.raywalk.stats();
    const box = document.querySelector(".stage-view").getBoundingClientRect();
    const at = ${JSON.stringify(places)}.map(([c, r]) => stats.tile(c, r)).map(({ x, y }) => [box.x + x, box.y + y]);
    return { at, ratio: devicePixelRatio, tiles: stats.tiles, n: window.raywalk.state().n };
  })()`);
  return places.map(([column, row], k) => {
    const pixel = 4 * (Math.round(at[k][1] * ratio) * png.width + Math.round(at[k][0] * ratio));
    const tile = 3 * (row * n + column);
    return [[...png.data.subarray(pixel, pixel + 3)], tiles.slice(tile, tile + 3)];
  });
}

for (const where of ["a disk", "a server"])
  test(`from ${where}: a scene's tiles are shown in their colours, keys work, the next scene comes, and the console is empty`, { skip }, async () => {
    const home = where === "a disk" ? ON_DISK : server.url;
    await opens(home, rich.path, "still=1&n=5&tiles=filled&cam=camera&rays=none");
    await until("!window.raywalk.pending().length");
    await firefox.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done))))");
    for (const [seen, traced] of await tilesOnScreen([[0, 0], [2, 1], [4, 4]])) assert.deepEqual(seen, traced);
    await firefox.press("h", "\uE014", "2");
    await until("window.raywalk.state().scene.startsWith('02') && window.raywalk.stats().tiles.length");
    assert.deepEqual(await said(home), []);
  });

test("a picture of each kind is checked from a disk, what is no picture is said, and the right one is right", { skip }, async () => {
  await firefox.visit(`${ON_DISK}check/index.html#scene=03-two-lights`);
  const drop = (bytes) => firefox.evaluate(`(async () => {
    const [says, found] = ["says", "found"].map((id) => document.getElementById(id));
    [says.textContent, found.hidden] = ["", true];
    const given = new DataTransfer();
    given.items.add(new File([Uint8Array.from(atob("${Buffer.from(bytes).toString("base64")}"), (each) => each.charCodeAt(0))], "mine"));
    document.getElementById("drop").dispatchEvent(new DragEvent("drop", { dataTransfer: given, bubbles: true, cancelable: true }));
    while (found.hidden && (!says.textContent || /^Comparing/.test(says.textContent))) await new Promise((done) => setTimeout(done, 10));
    return found.hidden ? says.textContent : found.innerText;
  })()`);
  for (const [kind, bytes] of GOOD) assert.match(await drop(bytes), /mine, 7 × 5 pixels/, kind);
  for (const [kind, bytes, word] of HOSTILE) if (word && bytes.length < 1e6) assert.match(await drop(bytes), /^[A-Z][^{}]+[.?]$/, kind);
  assert.match(await drop(readFileSync(`${DIST}/scenes/03-two-lights/picture.png`)), /^This picture is right/);
  assert.deepEqual(await said(ON_DISK), []);
});

test("the kiosk's archive, unpacked elsewhere, shows itself from a disk, begins at a key, and its console is empty", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "kiosk-"));
  try {
    const [python, archive] = [".venv/bin/python", join(folder, "kiosk.zip")];
    execFileSync(python, ["-m", "raywalk", "kiosk", "--site", DIST, "--out", archive]);
    execFileSync(python, ["-m", "zipfile", "-e", archive, folder]);
    const home = pathToFileURL(`${folder}/`).href;
    const start = readdirSync(folder, { recursive: true }).find((name) => /scenes\/01-[^/]*\/index\.html$/.test(name) && !/\/de\//.test(name));
    await opens(home, start, "kiosk=1&attract-pace=0.05&idle=60&still=1");
    await until("window.raywalk?.stats().kiosk?.cycles >= 2");
    await firefox.press(" ");
    await until("window.raywalk.stats().kiosk?.attract === false && window.raywalk.stats().kiosk.left > 0 && window.raywalk.stats().tiles.length > 0");
    assert.deepEqual(await said(home), []);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

test("every kind of page opens from a disk with an empty console", { skip }, async () => {
  const slides = rich.path.replace(/^scenes\/([^/]+)\/.*/, "slides/$1.html");
  for (const page of ["index.html", "de/index.html", "model/index.html", "slides/index.html", slides, `de/${rich.path}`, `${rich.path}?embed`, "sizes/index.html"]) {
    await opens(ON_DISK, page);
    assert.ok(await firefox.evaluate("document.title.length > 0"), page);
    await until("!window.raywalk?.pending().length"); // a script that runs when its page is left is ended, which is said
  }
  assert.deepEqual(await said(ON_DISK), []);
});
