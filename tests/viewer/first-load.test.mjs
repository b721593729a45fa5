/** What a browser really loads before the first page, and a scene's, are there: bytes as a host sends them, gzipped. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { DIST, launch, newPage, richScene, scenesOfSite, settled } from "./browser.mjs";
import { serve } from "./server.mjs";

const KB = 1000;
const FIRST_PAGE = 200 * KB; // beside the thumbnails
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
  const page = await newPage(browser);
  page.home = server.url;
  const answers = [];
  page.on("response", (response) => answers.push(response));
  await page.goto(`${server.url}${path}${hash}`, { waitUntil: "load" });
  await page.evaluate(() => window.raywalk?.ready);
  for (const image of await page.locator("img:visible").all()) await image.scrollIntoViewIfNeeded().catch(() => {}); // lazy ones too
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
const told = (files) => files.map(({ name, bytes }) => `${(bytes / KB).toFixed(1)} KB ${name}`).join("\n");

test("the first page weighs at most 200 KB beside its thumbnails, which are small and of each scene one", async () => {
  const loaded = await loadedBy("index.html");
  const thumbnails = loaded.filter(({ name }) => /thumb/.test(name));
  const rest = loaded.filter((file) => !thumbnails.includes(file));
  assert.ok(sum(rest) <= FIRST_PAGE, told(rest));
  assert.equal(thumbnails.length, scenesOfSite().length);
  for (const each of thumbnails) assert.ok(each.bytes <= THUMBNAIL, told([each]));
});

test("a scene's page weighs at most 200 KB beside its picture, rays and all", async () => {
  const loaded = await loadedBy(richScene().path);
  const rest = loaded.filter(({ name }) => !/picture/.test(name));
  assert.ok(sum(rest) <= FIRST_PAGE, `${(sum(rest) / KB).toFixed(1)} KB:\n${told(rest)}`);
});
