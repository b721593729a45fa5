/** What a browser really loads before the first page, and a scene's, are there: bytes as a host sends them, gzipped. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { DIST, launch, newPage, richScene, scenesOfSite, settled } from "./browser.mjs";
import { readScene } from "./scene-files.mjs";
import { serve } from "./server.mjs";

const KB = 1000;
const FIRST_PAGE = 200 * KB; // beside the thumbnails
const FIRST_VIEW = 190 * KB; // of a scene, beside its picture and its meshes
const SCRIPTS = 110 * KB; // of that; sentences are data
const THUMBNAIL = 200 * KB; // each; the dragon has the finest grain
let browser, server;
before(async () => {
  [browser, server] = await Promise.all([launch(), serve(DIST)]);
});
after(async () => {
  await browser.close();
  server.close();
});

/** Name and bytes of everything that this address makes a new visitor's browser load. */
async function loadedBy(path, hash = "") {
  const page = await newPage(browser, { viewport: { width: 640, height: 480 } }); // quickly drawn; a phone loads the same
  page.home = server.url;
  const answers = [];
  page.on("response", (response) => answers.push(response));
  await page.goto(`${server.url}${path}${hash}`, { waitUntil: "load" });
  await page.evaluate(() => window.raywalk?.ready);
  for (const image of await page.locator("img:visible").all()) await image.evaluate((each) => (each.scrollIntoView(), each.decode())); // lazy ones too
  await settled(page);
  const loaded = await Promise.all(
    answers.filter((answer) => answer.url().startsWith(server.url)).map(async (answer) => {
      const body = await answer.body();
      const name = new URL(answer.url()).pathname.slice(1);
      return { name, bytes: /\.(png|webp|jpe?g)$/.test(name) ? body.length : Math.min(body.length, gzipSync(body, { level: 9 }).length) };
    }),
  );
  assert.deepEqual(page.faults, []);
  await page.close();
  return loaded;
}
const sum = (files) => files.reduce((all, { bytes }) => all + bytes, 0);
const listed = (files) => files.map(({ name, bytes }) => `${(bytes / KB).toFixed(1)} KB ${name}`).join("\n");

test("the first page weighs at most 200 KB beside its thumbnails, which are small and of each scene one", async () => {
  const loaded = await loadedBy("index.html");
  const thumbnails = loaded.filter(({ name }) => /thumb/.test(name));
  const rest = loaded.filter((file) => !thumbnails.includes(file));
  assert.ok(sum(rest) <= FIRST_PAGE, listed(rest));
  const pictures = new Set(scenesOfSite().map(({ id }) => readScene(id).of)); // lessons on a scene share its picture
  assert.equal(thumbnails.length, pictures.size);
  for (const each of thumbnails) assert.ok(each.bytes <= THUMBNAIL, listed([each]));
});

/** How much of a scene's data its meshes are. */
function meshesIn({ id }) {
  const size = (text) => gzipSync(text, { level: 9 }).length;
  const whole = readFileSync(`${DIST}/scenes/${id}/scene.js`, "utf8");
  const packed = gzipSync(JSON.stringify({ ...readScene(id), meshes: {} }), { level: 9 }).toString("base64");
  return size(whole) - size(`raywalkReceive("${id}/scene","${packed}")\n`);
}

const dearest = scenesOfSite().map((scene) => ({ ...scene, meshes: meshesIn(scene) })).sort((a, b) => b.meshes - a.meshes)[0];
for (const scene of [{ ...richScene(), meshes: 0 }, dearest])
  test(`a first view of ${scene.id} is at most 190 KB beside picture and meshes, rays and all; scripts are 110 KB of it; parts come after it`, async () => {
    const loaded = await loadedBy(scene.path);
    const isPart = ({ name }) => name.startsWith("assets/part-") || name.endsWith("/surroundings.js"); // what mirrors and glass show comes with the look, once the scene is there
    const first = loaded.filter((file) => !isPart(file) && !/picture/.test(file.name));
    assert.ok(sum(first) - scene.meshes <= FIRST_VIEW, `${(sum(first) / KB).toFixed(1)} KB, ${scene.meshes} bytes of them meshes:\n${listed(first)}`);
    const scripts = first.filter(({ name }) => /^assets\/(viewer|page)-/.test(name));
    assert.ok(scripts.length === 2 && sum(scripts) <= SCRIPTS, listed(scripts));
    const [lastOfFirst, firstPart] = [loaded.findLastIndex((file) => /scenes\/.*\.js$/.test(file.name) && !isPart(file)), loaded.findIndex(isPart)];
    assert.ok(firstPart < 0 || firstPart > lastOfFirst, listed(loaded));
  });
