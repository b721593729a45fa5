/** No word on the stage lies on a ray of the selected pixel, or on what its rays meet. Measured on the page, with rays of our own. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, scenesOfSite, settled, stats } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { seenWithin } from "./on-screen.mjs";
import { pixelOf, randomFrom } from "./random.mjs";
import { readScene } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { createProjection, corners, toObject, add, scale, sub } = await load("state/projection.ts", "state/placing.ts", "state/vectors.ts");
const SIZES = [[1280, 800, ""], [1920, 1080, ""], [390, 844, ""], [700, 460, "?embed"]];
const SCENES = scenesOfSite().filter(({ key }) => cases(["2", "3", "5", "8", "9"], ["3", "8"]).includes(key));
const SEED = 20261130;
const PIXELS = 6; // of 15 x 15, of each scene
const HALF_LINE = 1.5; // CSS pixels
const LARGE = 0.5; // of the stage: beside an object that takes more there is no room
const FOV = 40;
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
});
after(() => browser.close());

const labels = () =>
  page.evaluate(() => {
    const from = document.querySelector(".stage-view").getBoundingClientRect();
    return [...document.querySelectorAll(".stage-view .labels > span:not([hidden])")].map((span) => {
      const { left, top, right, bottom } = span.getBoundingClientRect();
      return { text: span.textContent, kind: span.className, left: left - from.left, top: top - from.top, right: right - from.left, bottom: bottom - from.top };
    });
  });

/** With the width of a line round it. */
const widened = ({ left, top, right, bottom }) => ({ left: left - HALF_LINE, top: top - HALF_LINE, right: right + HALF_LINE, bottom: bottom + HALF_LINE });

/** Does the ray from the eye meet the object's unit ball, or its box? In the object's own space. */
function meets(object, eye, way) {
  const from = toObject(object.transform, eye);
  const run = sub(toObject(object.transform, add(eye, way)), from);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  if (object.type === "sphere") {
    const [a, b, c] = [dot(run, run), dot(from, run), dot(from, from) - 1];
    return b < 0 && b * b >= a * c;
  }
  const [low, high] = object.box;
  const shares = [0, 1, 2].map((k) => [(low[k] - from[k]) / run[k], (high[k] - from[k]) / run[k]]);
  const enters = Math.max(0, ...shares.map((pair) => Math.min(...pair)));
  return enters < Math.min(...shares.map((pair) => Math.max(...pair)));
}

const BOXES = { box: [[-1, -1, -1], [1, 1, 1]], cylinder: [[-1, -1, -1], [1, 1, 1]], disc: [[-1, -1, 0], [1, 1, 1e-9]], triangle: [[0, 0, 0], [1, 1, 1e-9]] };
const boxOf = ({ type, mesh }, scene) => (mesh ? scene.meshes[mesh].box : BOXES[type]);

/** What the words must keep clear of: objects that the lines meet or that are in their way, seen whole and with room beside them. */
function metBy(lines, scene, names, projection) {
  const seen = scene.objects.filter(({ name, type }) => names.has(name) && type !== "plane");
  return seen.flatMap((object) => {
    const points = corners(object, scene).map(projection.project);
    const span = (of) => Math.max(...of) - Math.min(...of);
    if (points.some(({ depth }) => depth < scene.bounds.radius / 300)) return [];
    // A ball takes about half of the box round its corners' box.
    const share = (span(points.map(({ x }) => x)) * span(points.map(({ y }) => y))) / (projection.width * projection.height);
    return share > LARGE ? [] : [{ ...object, box: boxOf(object, scene) }];
  });
}

for (const [width, height, query] of SIZES)
  test(`at ${width} x ${height}${query} no word lies on a ray or on what it meets: ${SCENES.length} scenes, ${PIXELS} pixels each (seed ${SEED})`, async (t) => {
    await page.setViewportSize({ width, height });
    const random = randomFrom(SEED);
    let [asked, shown, all] = [0, 0, 0];
    for (const { id, path } of SCENES) {
      const scene = readScene(id);
      await open(page, ON_DISK, path + query, "still=1&gl=none&n=15&tiles=empty");
      for (let k = 0; k < PIXELS; k++) {
        const pixel = pixelOf(random, 15);
        await follow(page, `still=1&gl=none&n=15&tiles=empty&p=${pixel.join()}`);
        await settled(page);
        const [{ lines, eye, target, events, width: wide, height: high }, words] = [await stats(page), await labels()];
        const projection = createProjection({ eye, target, up: [0, 1, 0], fov: FOV }, wide, high);
        const names = new Set(events.flatMap(({ what, name, by }) => (what === "meets" ? [name] : what === "blocked" ? [by] : [])));
        const objects = metBy(lines, scene, names, projection);
        asked += lines.some(({ light, leaves }) => light < 0 && !leaves) ? 1 : 0;
        shown += words.some(({ kind }) => kind === "hit") ? 1 : 0;
        all += words.length;
        const where = `${id} ${pixel.join()}`;
        for (const word of words) {
          for (const line of lines) assert.ok(!seenWithin(line, widened(word), projection.project), `${where}: "${word.text}" lies on a line`);
          for (let x = word.left; x <= word.right; x += 3)
            for (let y = word.top; y <= word.bottom; y += 3) {
              const way = add(scale(projection.forward, projection.focal), add(scale(projection.right, x - wide / 2), scale(projection.up, high / 2 - y)));
              for (const object of objects) assert.ok(!meets(object, eye, way), `${where}: "${word.text}" lies on ${object.name}`);
            }
        }
      }
    }
    t.diagnostic(`${all} words; where the camera ray hits is named at ${shown} of ${asked} pixels`);
    assert.ok(shown >= 0.8 * asked, "not by leaving words out");
  });

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));

test("on a phone no word lies on a lamp, and what blocks a large lamp is named once", async () => {
  await page.setViewportSize({ width: 390, height: 844 });
  for (const id of ["11-what-is-a-ray", "15-soft-shadows-64"]) {
    await open(page, ON_DISK, `scenes/${id}/index.html`, "gl=none&step=2");
    const [{ eye, target, width, height }, words] = [await stats(page), await labels()];
    const projection = createProjection({ eye, target, up: [0, 1, 0], fov: FOV }, width, height);
    const lamps = readScene(id).lights.map(({ position }) => projection.project(position));
    const hidden = words.filter(({ left, top, right, bottom }) => lamps.some(({ x, y }) => left < x && x < right && top < y && y < bottom));
    assert.deepEqual(hidden.map(({ text }) => text), [], id);
    assert.ok(words.length >= 2 && words.filter(({ kind }) => kind === "stop").length <= 1, id);
  }
});
