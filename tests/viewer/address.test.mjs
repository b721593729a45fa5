/** The whole view is in the address. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, openDrawer, press, reload, richScene, scenesOfSite, state, stats, until } from "./browser.mjs";

const rich = richScene();
const QUICK = "still=1&gl=none";
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(() => browser.close());
const hashWith = (text) => page.waitForFunction((part) => location.hash.includes(part), text);

test("what a person does is written into the address, and the address gives it back", async () => {
  await open(page, ON_DISK, rich.path, QUICK);
  await press(page, "+", "h", " ", "ArrowRight", "r");
  await hashWith("cam=camera");
  await until(page, (s, t) => t.tiles.length > 0);
  const [before, hash] = [await state(page), new URL(page.url()).hash.slice(1)];
  await open(page, ON_DISK, rich.path, hash);
  assert.deepEqual(await state(page), before);
});

test("a moved observer comes back where it was", async () => {
  await open(page, ON_DISK, rich.path, QUICK);
  await openDrawer(page);
  await page.getByRole("button", { name: "Turn the view left" }).click();
  await hashWith("cam=");
  const eye = (await stats(page)).eye;
  await reload(page);
  for (const [k, value] of (await stats(page)).eye.entries()) assert.ok(Math.abs(value - eye[k]) < 1e-3);
});

test("from a disk another scene is named in the address and survives a reload", async () => {
  const other = scenesOfSite().find((scene) => scene.id !== rich.id);
  await open(page, ON_DISK, rich.path, `scene=${other.id}&${QUICK}`);
  assert.equal((await state(page)).scene, other.id);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
