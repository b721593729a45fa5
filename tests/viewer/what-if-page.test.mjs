/** Switches and tile views on the page: by key, by mouse, by finger, from a link; all parts follow at once. */
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { follow, keyedScenes, launch, newPage, ON_DISK, open, openDrawer, press, reload, richScene, settled, state, stats, tileOnPage, until } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { createWhatIf, readSwitches } = await load("state/what-if.ts", "state/switches.ts");
const rich = richScene();
const QUICK = "still=1&gl=none"; // flat: the same tiles and lines, drawn in less time; look.test.mjs has the WebGL stage follow
const START = `${QUICK}&n=15&p=7,12&tiles=filled`;
const { scene, trace } = readTrace(rich.id, 15);
const expected = (text) => [...createWhatIf().of(trace, scene, readSwitches(text, scene)).trace.tiles];
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
  await open(page, ON_DISK, rich.path, START);
});
after(() => browser.close());
const switches = async () => (await state(page)).switches;
const panel = () => page.getByRole("region", { name: "What if", exact: true });
const opener = () => page.getByRole("button", { name: /^What if: / });
const undo = () => page.getByRole("button", { name: "Undo all switches" });
const recombined = () => page.locator(".picture .recombined");
const hash = () => new URL(page.url()).hash;

test("at first the panel is closed, nothing is switched and nothing says so", async () => {
  assert.equal(await panel().isVisible(), false);
  assert.equal(await undo().isVisible(), false);
  assert.equal(await recombined().isVisible(), false);
});

test("brackets lower and raise the bounce limit, and say where it ends", async () => {
  await follow(page, START);
  await press(page, "]");
  assert.equal((await switches()).bounces, null);
  for (let k = 0; k < scene.depth + 2; k++) await press(page, "[");
  assert.equal((await switches()).bounces, 0);
  assert.deepEqual((await stats(page)).tiles, expected("b0"));
  assert.match(await page.getByRole("button", { name: "More bounces (])" }).getAttribute("title"), /more cannot be shown/);
  for (let k = 0; k < scene.depth + 2; k++) await press(page, "]");
  assert.equal((await switches()).bounces, null);
  assert.deepEqual((await stats(page)).tiles, [...trace.tiles]);
  assert.equal(await page.getByRole("button", { name: "More bounces (])" }).getAttribute("aria-disabled"), "true");
});

test("L and a number turn that light off and on; without L a number is a scene", async () => {
  await follow(page, START);
  await press(page, "l", "2");
  assert.deepEqual((await switches()).lamps, [1, 0]);
  assert.deepEqual((await stats(page)).tiles, expected("l2x0"));
  assert.ok((await stats(page)).lines.every(({ light }) => light !== 1));
  await press(page, "l", "9");
  assert.equal((await state(page)).scene, rich.id);
  await press(page, "l", "2");
  assert.deepEqual((await switches()).lamps, []);
});

test("S turns shadows off: tiles, lines, card, sentence and sum follow in the same frame", async () => {
  await follow(page, `${START}&tab=rays`);
  await page.locator("li.ray").first().waitFor();
  const blocked = await page.locator("li.ray.blocked").count();
  assert.ok(blocked > 0, "the pixel has a blocked light");
  await press(page, "s");
  const now = await stats(page);
  assert.deepEqual(now.tiles, expected("-shadows"));
  assert.ok(now.lines.every(({ light }) => light < 0));
  assert.equal(await page.locator("li.ray.blocked, li.ray.reached").count(), 0);
  const end = now.events.at(-1);
  assert.deepEqual(end.bytes, now.tiles.slice(3 * (12 * 15 + 7), 3 * (12 * 15 + 7) + 3));
  assert.equal((await page.locator(".pixel-colour").innerText()).trim(), end.bytes.join(", "));
  await press(page, "s");
  assert.deepEqual((await stats(page)).tiles, [...trace.tiles]);
});

test("a switch keeps the player at its event, and leaves it where that is gone", async () => {
  await follow(page, START);
  const { events } = await stats(page);
  const at = events.findIndex(({ what }) => what === "blocked");
  for (let k = 0; k <= at; k++) await press(page, ".");
  await press(page, "s");
  const current = (await stats(page)).events[(await state(page)).event];
  assert.deepEqual([current.ray, current.light, current.what], [events[at].ray, events[at].light, "unasked"]);
  await follow(page, `${QUICK}&n=15&p=9,7`);
  for (let k = 0; k < 4; k++) await press(page, ".");
  for (let k = 0; k < scene.depth; k++) await press(page, "[");
  const { event } = await state(page);
  assert.ok(event === null || (await stats(page)).events[event]);
});

test("the first switch fills empty tiles: they show what it does", async () => {
  await follow(page, `${QUICK}&n=15`);
  assert.equal((await state(page)).tiles, "empty");
  await press(page, "s");
  assert.equal((await state(page)).tiles, "filled");
});

test("by mouse: boxes and sliders do the same; As traced undoes all and goes", async () => {
  await follow(page, START);
  await openDrawer(page);
  await opener().click();
  if (!(await panel().isVisible())) await opener().click();
  await panel().getByLabel("specular").click();
  await panel().getByRole("checkbox", { name: "light 1" }).click();
  await panel().getByRole("slider", { name: "Brightness of light 2" }).fill("1.5");
  await settled(page);
  assert.deepEqual(await switches(), { bounces: null, lamps: [0, 1.5], shadows: true, without: ["specular"] });
  assert.deepEqual((await stats(page)).tiles, expected("l1x0,l2x1.5,-specular"));
  await undo().click();
  await settled(page);
  assert.deepEqual((await stats(page)).tiles, [...trace.tiles]);
  assert.equal(await undo().isVisible(), false);
});

test("a light's brightness by buttons: a quarter at a time, from where the slider left it, as far as it goes", async () => {
  await follow(page, `${START}&if=l1x0.9`);
  const press = async (word, times) => {
    for (let k = 0; k < times; k++) await panel().getByRole("button", { name: `light 1 ${word}`, exact: true }).click({ force: true });
    await settled(page);
    return (await switches()).lamps[0] ?? 1;
  };
  assert.deepEqual([await press("darker", 1), await press("darker", 1), await press("brighter", 3)], [0.75, 0.5, 1.25]);
  assert.deepEqual((await stats(page)).tiles, expected("l1x1.25"));
  const ended = (word) => panel().getByRole("button", { name: `light 1 ${word}`, exact: true }).getAttribute("aria-disabled");
  assert.deepEqual([await press("brighter", 5), await ended("brighter"), await ended("darker")], [2, "true", "false"]);
  assert.deepEqual([await press("darker", 10), await ended("brighter"), await ended("darker")], [0, "false", "true"]);
  assert.equal(await panel().getByRole("checkbox", { name: "light 1" }).isChecked(), false);
});

test("the picture follows in the finest tiles, says so, and is itself again without switches; in the traced look too", async () => {
  await follow(page, START);
  await press(page, "l", "2");
  await page.waitForFunction(() => document.querySelector(".picture .recombined").width === 105);
  await settled(page);
  const fine = readTrace(rich.id, 105);
  const wanted = [...createWhatIf().of(fine.trace, fine.scene, readSwitches("l2x0", fine.scene)).trace.tiles];
  const shown = (where) => page.locator(`${where} .recombined`).evaluate((canvas) => [...canvas.getContext("2d").getImageData(0, 0, 105, 105).data].filter((_, k) => k % 4 < 3));
  assert.deepEqual(await shown(".picture"), wanted);
  assert.equal(await page.locator(".recombined-size").innerText(), "105 × 105, recombined");
  await press(page, "t");
  assert.equal(await page.locator(".traced-picture .recombined").isVisible(), true);
  assert.deepEqual(await shown(".traced-picture"), wanted);
  await undo().click();
  await settled(page);
  for (const where of [".picture", ".traced-picture"]) assert.equal(await page.locator(`${where} .recombined`).isVisible(), false);
  assert.equal(await page.locator(".recombined-size").isVisible(), false);
});

test("by keyboard alone: Tab reaches every switch, Space ticks, arrows dim", async () => {
  await follow(page, START);
  await openDrawer(page);
  if (!(await panel().isVisible())) await opener().press("Enter");
  await panel().getByRole("checkbox", { name: "shadows" }).focus();
  await page.keyboard.press("Space");
  await settled(page);
  assert.equal((await switches()).shadows, false);
  assert.equal((await state(page)).tiles, "filled", "Space ticked the box and did not empty the tiles");
  await panel().getByRole("slider", { name: "Brightness of light 1" }).focus();
  await page.keyboard.press("ArrowLeft");
  await settled(page);
  assert.deepEqual((await switches()).lamps, [0.95, 1]);
});

test("switches and tile view are in the address and come back after a reload", async () => {
  await follow(page, START);
  await press(page, "[", "s", "l", "1", "c");
  await page.waitForFunction(() => location.hash.includes("colours="));
  const before = await state(page);
  assert.match(decodeURIComponent(hash()), /if=b9,l1x0,-shadows/);
  await reload(page);
  await until(page, (s, t) => t.tiles.length > 0);
  assert.deepEqual(await state(page), before);
  await panel().waitFor(); // what is switched is there to be seen; its part comes when asked for
});

test("C goes round all tile views; the menu does the same; legend and numbers follow", async () => {
  await follow(page, START);
  const seen = [];
  do {
    await press(page, "c");
    seen.push((await state(page)).colours);
    assert.equal(await page.locator(".tile-legend").isVisible(), seen.at(-1) !== "picture");
  } while (seen.at(-1) !== "picture" && seen.length < 20);
  assert.deepEqual(seen, ["rays", "depth", "tests", "distance", "shadow", "normal", "picture"]);
  await openDrawer(page);
  await page.getByRole("combobox", { name: "Tiles show" }).selectOption("rays");
  await settled(page);
  const { lines } = await stats(page);
  assert.match(await page.locator(".tile-legend").innerText(), new RegExp(`selected 7, 12: ${lines.length} rays`));
  const at = await tileOnPage(page, 3, 4);
  await page.mouse.move(at.x, at.y);
  await settled(page);
  assert.match(await page.locator(".tile-legend").innerText(), /pointer 3, 4: \d+ rays?/);
});

test("a damaged switch in a link is named, and the view is as traced", async () => {
  await follow(page, `${QUICK}&if=b99`);
  assert.match(await page.locator("#notice").innerText(), /\(if\)/);
  assert.deepEqual(await switches(), { bounces: null, lamps: [], shadows: true, without: [] });
});

const meshes = keyedScenes().filter(({ id }) => Object.keys(readTrace(id, 15).scene.meshes).length > 0);
test("with tests shown, a mesh's boxes that the selected ray tested are drawn, with the tests they saved", async () => {
  const at = meshes.find(({ key }) => key === "7") ?? meshes[0];
  const mesh = readTrace(at.id, 15);
  const pixel = mesh.trace.object.findIndex((object, k) => k < 225 && mesh.scene.objects[object]?.type === "mesh");
  await open(page, ON_DISK, at.path, `${QUICK}&n=15&p=${pixel % 15},${Math.floor(pixel / 15)}&tiles=filled`);
  assert.equal((await stats(page)).boxes, 0);
  await openDrawer(page);
  await page.getByRole("combobox", { name: "Tiles show" }).selectOption("tests");
  await until(page, (s, t) => t.boxes > 5);
  await settled(page);
  const text = await page.locator(".tile-legend").innerText();
  assert.ok(text.includes(`${mesh.trace.tests[pixel]} tests with boxes`), text);
  assert.match(text, /without \(9\d(\.\d)?\u202f% saved\)/);
});

describe("on a phone", () => {
  let phone;
  before(async () => {
    phone = await newPage(browser, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await open(phone, ON_DISK, rich.path, START);
  });
  test("by finger: the panel opens, a box is ticked, all targets are 44 pixels at least and nothing sticks out", async () => {
    await phone.locator(".open-drawer").tap();
    await phone.getByRole("button", { name: /^What if: / }).tap();
    await phone.getByRole("checkbox", { name: "diffuse" }).tap();
    await until(phone, ({ switches }) => switches.without.join() === "diffuse"); // a tap becomes a click a moment after the finger has left
    await settled(phone);
    const boxes = await phone.locator(".what-if label:visible, .what-if button, .what-if input[type=range], .drawer button:visible, .tile-menu").evaluateAll((all) => all.map((each) => each.getBoundingClientRect().toJSON()));
    assert.ok(boxes.length > 8);
    for (const box of boxes) {
      assert.ok(box.height >= 44 && box.width >= 44, JSON.stringify(box));
      assert.ok(box.left >= 0 && box.right <= 390, JSON.stringify(box));
    }
    assert.equal(await phone.evaluate(() => document.documentElement.scrollWidth), 390);
  });
  after(() => assert.deepEqual(phone.faults, []));
});

test("at 105 x 105 a switch is drawn within two frames, also with most rays", async () => {
  const most = keyedScenes().find(({ id }) => id.startsWith("08")) ?? rich;
  await open(page, ON_DISK, most.path, "still=1&n=105&tiles=filled&gl=none");
  const turn = () =>
    page.evaluate(async () => {
      const frame = () => new Promise((done) => requestAnimationFrame(done));
      const press = (key) => window.dispatchEvent(new KeyboardEvent("keydown", { key }));
      const frames = async (act) => {
        await frame();
        const before = window.raywalk.stats().tiles;
        act();
        for (let k = 1; k <= 4; k++) {
          await frame();
          if (window.raywalk.stats().tiles.some((v, at) => v !== before[at])) return k;
        }
        return Infinity;
      };
      return [await frames(() => press("s")), await frames(() => press("["))];
    });
  for (const frames of await turn()) assert.ok(frames <= 2, `${frames} frames`);
});

test("nothing of all this left a message in the console", () => assert.deepEqual(page.faults, []));
