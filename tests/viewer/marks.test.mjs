/** What a lesson's step points at: rings round objects and lamps, their names, on which side names stand, and boxes. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, press, scenesOfSite, settled, state, stats, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { ringsOf, createProjection, toWorld, corners } = await load("state/rings.ts", "state/projection.ts", "state/placing.ts");
const SIZES = [[1280, 800], [390, 844]];
const FOV = 40; // the observer's
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
});
after(() => browser.close());

/** Every stop of the course's lessons whose view has the key. */
const stopsWith = (key) =>
  scenesOfSite().flatMap(({ id, path }) =>
    readScene(id).lesson.flatMap(({ view, answer }, step) => [
      ...(view[key] ? [{ id, path, view, at: `step=${step + 1}` }] : []),
      ...(answer?.view[key] ? [{ id, path, view: answer.view, at: `step=${step + 1}&answer=1` }] : []),
    ]),
  );
const rings = () =>
  page.evaluate(() => {
    const from = document.querySelector(".stage-view").getBoundingClientRect();
    return [...document.querySelectorAll(".rings > div")].map((ring) => {
      const { left, top, right, bottom } = ring.getBoundingClientRect();
      return { left: left - from.left, top: top - from.top, right: right - from.left, bottom: bottom - from.top };
    });
  });
const words = () => page.locator(".labels > span:not([hidden])").allInnerTexts();

/** One stop after the other: a scene's page is opened once. */
let shown;
async function show(path, at) {
  await (shown === path ? follow(page, `still=1&gl=none&${at}`) : open(page, ON_DISK, path, `still=1&gl=none&${at}`));
  shown = path;
}

/** Points on an object's surface, or its box's corners, in the world. */
function pointsOf(object, scene) {
  if (object.type !== "sphere") return corners(object, scene);
  const along = Array.from({ length: 40 }, (_, k) => (Math.PI * k) / 39);
  return along.flatMap((polar) => along.map((azimuth) => toWorld(object.transform, [Math.sin(polar) * Math.cos(2 * azimuth), Math.sin(polar) * Math.sin(2 * azimuth), Math.cos(polar)])));
}

for (const [width, height] of cases(SIZES, SIZES.slice(0, 1)))
  test(`at ${width} x ${height} each ring holds the whole of what the step names, and little else`, async () => {
    await page.setViewportSize({ width, height });
    const stops = stopsWith("highlight");
    assert.ok(stops.length >= 5, "the course points at things");
    for (const { id, path, view, at } of stops) {
      await show(path, at);
      await page.locator(".rings > div").first().waitFor({ state: "attached" });
      await settled(page);
      const scene = readScene(id);
      const { eye, target, width: wide, height: high } = await stats(page);
      const { project } = createProjection({ eye, target, up: [0, 1, 0], fov: FOV }, wide, high);
      const drawn = await rings();
      assert.equal(drawn.length, view.highlight.length, `${id} ${at}`);
      for (const [k, name] of view.highlight.entries()) {
        const seen = pointsOf(scene.objects.find((each) => each.name === name), scene).map(project);
        const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
        const { left, right, top, bottom } = drawn[k];
        assert.ok(left < Math.min(...xs) && right > Math.max(...xs) && top < Math.min(...ys) && bottom > Math.max(...ys), `${id} ${at}: ${name} reaches over its ring`);
        // Room, edge and border; a stretched ball's ring is that of a ball with its longest axis, at most 1.5 times as wide here.
        for (const [ring, of] of [[right - left, xs], [bottom - top, ys]]) assert.ok(ring < 1.5 * (Math.max(...of) - Math.min(...of)) + 24, `${id} ${at}: ${name}'s ring is ${ring} wide`);
      }
    }
  });

test("its name stands at the ring, in the page's language; both go with the lesson", async () => {
  await page.setViewportSize({ width: 1280, height: 800 });
  const [{ path, at, view }] = stopsWith("highlight");
  await show(path, at);
  await page.locator(".rings > div").first().waitFor();
  await settled(page);
  assert.ok((await words()).includes(view.highlight[0]));
  await show(`de/${path}`, at);
  await page.locator(".rings > div").first().waitFor();
  await settled(page);
  assert.ok(!(await words()).includes(view.highlight[0]), "in German");
  assert.equal((await rings()).length, 1);
  await page.locator(".lesson-steps button").last().click();
  await settled(page);
  assert.equal((await rings()).length, 0);
});

test("a name stands on the side that the step gives it", async () => {
  await page.setViewportSize({ width: 1280, height: 800 });
  const stops = stopsWith("labels");
  assert.ok(stops.length, "a step of the course gives one");
  for (const { id, path, view, at } of stops) {
    await show(path, at);
    await until(page, () => document.querySelector(".rings"));
    await settled(page);
    const { eye, target, width, height } = await stats(page);
    const { project } = createProjection({ eye, target, up: [0, 1, 0], fov: FOV }, width, height);
    for (const [name, side] of Object.entries(view.labels)) {
      const { x, y } = project(readScene(id).lights.find((light) => light.name === name).position);
      const box = await page.locator(".labels > span", { hasText: name }).boundingBox();
      const stage = await page.locator(".stage-view").boundingBox();
      const beside = { left: stage.x + x - (box.x + box.width), right: box.x - (stage.x + x), above: stage.y + y - (box.y + box.height), below: box.y - (stage.y + y) };
      assert.ok(beside[side] > 0, `${name}: ${JSON.stringify(beside)}`);
    }
  }
});

test("a step that asks for boxes has them while the tiles show the picture; they go with the lesson", async () => {
  const stop = stopsWith("boxes").find(({ view }) => !view.colours);
  assert.ok(stop, "a step of the course asks for them");
  await show(stop.path, stop.at);
  const inside = readScene(stop.id).lesson.find(({ view }) => view.colours === "tests").view.pixel;
  await show(stop.path, `${stop.at}&p=${inside.join()}`);
  await until(page, (_, { boxes }) => boxes > 0);
  assert.equal((await state(page)).colours, "picture");
  await page.locator(".lesson-steps button").last().click();
  await settled(page);
  assert.equal((await stats(page)).boxes, 0);
});

test("what is round the observer, behind it or without an end has no ring", () => {
  const scene = {
    bounds: { radius: 4 }, lights: [{ name: "lamp 1/2", position: [0, 2, 0] }, { name: "lamp 2/2", position: [1, 2, 0] }],
    objects: [
      { name: "ball", type: "sphere", transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] },
      { name: "behind", type: "sphere", transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 1] },
      { name: "floor", type: "plane", transform: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1] },
    ],
  };
  const of = (eye, ...highlight) => ringsOf({ highlight }, scene, createProjection({ eye, target: [0, 0, -9], up: [0, 1, 0], fov: FOV }, 800, 600), 0.01);
  assert.deepEqual(of([0, 0, 5], "ball", "behind", "floor", "lamp").map(({ name, isRound, isLamp }) => [name, isRound, isLamp]), [["ball", true, false], ["lamp", false, true]]);
  assert.deepEqual(of([0, 0, 0.5], "ball"), [], "the observer is in it");
});

test("while the observer is turned the ring goes with its object", async () => {
  await page.setViewportSize({ width: 1280, height: 800 });
  const { path, at } = stopsWith("highlight")[0];
  await show(path, at);
  await page.locator(".rings > div").first().waitFor();
  const before = await rings();
  await page.locator(".stage-view").focus();
  const stage = await page.locator(".stage-view").boundingBox();
  await page.mouse.move(stage.x + 30, stage.y + 30);
  await page.mouse.down();
  await page.mouse.move(stage.x + 130, stage.y + 60);
  await page.mouse.up();
  await settled(page);
  assert.notDeepEqual(await rings(), before);
  await press(page, "r");
});
