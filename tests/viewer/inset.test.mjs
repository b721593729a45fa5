/** Where there is no room beside the stage the picture stands in a corner of it, in one where it covers no lamp and no selected ray. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, press, scenesOfSite, settled, stats } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { seenWithin } from "./on-screen.mjs";
import { pixelOf, randomFrom } from "./random.mjs";
import { readScene } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { createProjection } = await load("state/projection.ts");
const SIZES = cases([[390, 844, ""], [360, 640, ""], [700, 460, "?embed"]], [[360, 640, ""], [700, 460, "?embed"]]); // the smallest of each kind
const SCENES = scenesOfSite().filter(({ key }) => ["1", "2", "3", "5", "9"].includes(key));
const SEED = 20261130;
const PIXELS = 5; // of each scene
const FOV = 40;
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
});
after(() => browser.close());

const boxes = () => page.evaluate(() => [".stage-view", ".stage > .picture .picture-frame"].map((part) => document.querySelector(part).getBoundingClientRect().toJSON()));

for (const [width, height, query] of SIZES)
  test(`at ${width} x ${height}${query} it covers no lamp and no ray: ${SCENES.length} scenes, ${PIXELS} pixels each (seed ${SEED})`, async () => {
    await page.setViewportSize({ width, height });
    const random = randomFrom(SEED);
    for (const { id, path } of SCENES) {
      const { lights } = readScene(id);
      await open(page, ON_DISK, path + query, "still=1&gl=none&n=15&tiles=empty");
      for (let k = 0; k < PIXELS; k++) {
        const pixel = pixelOf(random, 15);
        await follow(page, `still=1&gl=none&n=15&tiles=empty&p=${pixel.join()}`);
        await settled(page);
        const [{ lines, eye, target, width: wide, height: high }, [stage, frame]] = [await stats(page), await boxes()];
        const { project } = createProjection({ eye, target, up: [0, 1, 0], fov: FOV }, wide, high);
        const under = { left: frame.left - stage.x, top: frame.top - stage.y, right: frame.right - stage.x, bottom: frame.bottom - stage.y };
        const isUnder = ({ x, y, depth }) => depth > 0 && x > under.left && x < under.right && y > under.top && y < under.bottom;
        assert.ok(frame.left >= stage.left && frame.right <= stage.right && frame.top >= stage.top && frame.bottom <= stage.bottom);
        for (const { name, position } of lights) assert.ok(!isUnder(project(position)), `${id} ${pixel.join()}: ${name} is under the picture`);
        for (const line of lines) assert.ok(!seenWithin(line, under, project), `${id} ${pixel.join()}: a ray is under the picture`);
      }
    }
  });

test("while the player goes through a pixel's rays the picture keeps its place", async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, ON_DISK, SCENES.at(-1).path, "still=1&gl=none&n=15");
  const before = await boxes();
  for (let k = 0; k < 12; k++) {
    await press(page, ".");
    assert.deepEqual(await boxes(), before, `event ${k + 1}`);
  }
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
