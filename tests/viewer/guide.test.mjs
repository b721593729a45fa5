/** A lesson's step that uses a tool opens the drawer it is in, once, with a word at the tool, where the stage has room left. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, press, scenesOfSite, settled, state } from "./browser.mjs";
import { readScene } from "./scene-files.mjs";

const scenes = scenesOfSite().map((scene) => ({ ...scene, lesson: readScene(scene.id).lesson }));
const counting = scenes.map(({ path, lesson }) => ({ path, step: lesson.findIndex(({ view }) => view.colours === "tests") })).find(({ step }) => step >= 0);
const switching = scenes.map(({ path, lesson }) => ({ path, step: lesson.findIndex(({ answer }) => answer?.view.switches) })).find(({ step }) => step >= 0);
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(() => browser.close());

const isOpen = () => page.locator(".drawer").isVisible();
const at = async ({ path, step }, size, more = "") => {
  await page.setViewportSize(size);
  await open(page, ON_DISK, path, `still=1&gl=none&step=${step + 1}${more}`);
};
const DESK = { width: 1280, height: 800 };

test("the first step that shows counts opens the drawer, with a word at the menu; closed, it stays so in the steps after", async () => {
  await at({ ...counting, step: counting.step - 1 }, DESK);
  assert.equal(await isOpen(), false);
  await press(page, "PageDown");
  await page.locator(".tile-choice + .introduces").waitFor();
  assert.equal((await state(page)).colours, "tests");
  assert.equal(await page.locator(".open-drawer").getAttribute("aria-expanded"), "true");
  assert.equal(await page.locator(".introduces").innerText(), "This step uses it.");
  await page.locator(".open-drawer").click();
  await press(page, "PageDown");
  assert.equal((await state(page)).colours, "tests");
  assert.equal(await isOpen(), false, "once");
  assert.equal(await page.locator(".introduces").count(), 0);
});

test("an answer that sets switches has its word at What if", async () => {
  await at(switching, DESK);
  assert.equal(await isOpen(), false, "the question would be answered");
  await page.locator(".reveal").click();
  await page.locator(".open-what-if + .introduces").waitFor();
});

for (const [where, size, more] of [["on a phone", { width: 390, height: 844 }, ""], ["in a lecture", DESK, "&projector=1"]])
  test(`${where} the stage keeps its room: the drawer stays closed`, async () => {
    await at(counting, size, more);
    await settled(page);
    assert.equal(await isOpen(), false);
  });

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
