/** The slice view: the plane of a row's or a column's camera rays, drawn flat. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { follow, launch, newPage, ON_DISK, open, openDrawer, press, richScene, scenesOfSite, settled, state, until } from "./browser.mjs";
import { readSections, readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { sectionOf, frameOf, startState, select, picturePlane } = await load("state/section.ts", "state/view-state.ts", "state/frustum.ts");
/** How far a point is from a section's plane, in world units. */
const offPlane = ({ eye }, section, point) => Math.sqrt(Math.max(0, point.reduce((sum, v, k) => sum + (v - eye[k]) ** 2, 0) - Math.hypot(...section.flat(point)) ** 2));
const { silhouetteOf } = await load("state/silhouette.ts");
const rich = richScene();
const FLAT = "still=1&gl=none"; // what is asked about is drawn flat either way
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
  await open(page, ON_DISK, rich.path, `${FLAT}&n=15&p=5,8`);
});
after(() => browser.close());
const canvas = () => page.locator(".slice canvas");
const point = (trace, ray) => [...trace.point.slice(3 * ray, 3 * ray + 3)];

for (const { id } of scenesOfSite())
  test(`${id}: all camera rays of every row and column lie in its plane, and each is found again by pointing at it`, () => {
    const { scene, trace } = readTrace(id, 15);
    const data = readSections(id);
    const plane = picturePlane(scene);
    for (const slice of ["row", "column"])
      for (let k = 0; k < 15; k++) {
        const state = { ...select({ ...startState(scene, { speed: 1, still: true, gl: true }), n: 15 }, k, k), slice };
        const section = sectionOf(data, state, scene, trace, plane);
        assert.equal(section.rays.length, 15);
        for (const [along, { ray, end, tile }] of section.rays.entries()) {
          assert.equal(ray, slice === "row" ? k * 15 + along : along * 15 + k);
          assert.equal(section.pixelAt(end), along);
          assert.equal(section.pixelAt([(tile[0][0] + tile[1][0]) / 2, (tile[0][1] + tile[1][1]) / 2]), along);
          // Points are stored in steps of the scene's box / 65535, far rays a little coarser; 2e-4 of the ray covers both.
          const far = Math.hypot(...end);
          assert.ok(offPlane(data, section, point(trace, ray)) < 2e-4 * far + 3e-4 * scene.bounds.radius, `${slice} ${k}, ray ${along}`);
        }
        const [left, top, right, bottom] = frameOf(section, scene);
        assert.ok(left <= 0 && right > 0 && top <= 0 && bottom >= 0, "the eye is in the picture");
      }
  });

test("X goes round: space, row, column, space; the buttons do the same; the address keeps it", async () => {
  for (const slice of ["row", "column", "none"]) {
    await press(page, "x");
    assert.equal((await state(page)).slice, slice);
  }
  await openDrawer(page);
  await page.getByRole("button", { name: /Slice down this column/ }).click();
  await canvas().waitFor({ state: "visible" });
  assert.match(await canvas().getAttribute("aria-label"), /column's camera rays.*row 8/);
  await follow(page, `${FLAT}&n=15&p=5,8&slice=row`);
  assert.equal((await state(page)).slice, "row");
  await page.getByRole("button", { name: /Slice along this row/ }).click();
  await settled(page);
  assert.equal((await state(page)).slice, "none");
  assert.equal(await canvas().isVisible(), false);
});

test("pointing into the flat drawing selects the ray there, arrows still move the pixel", async () => {
  await follow(page, `${FLAT}&n=15&p=5,8&slice=row`);
  await canvas().waitFor({ state: "visible" });
  const box = await canvas().boundingBox();
  // A row is seen from above: its first pixels, on the left of the picture, are at the top.
  await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.3);
  await settled(page);
  const [high] = (await state(page)).pixel;
  await page.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.9);
  await settled(page);
  const [low, row] = (await state(page)).pixel;
  assert.ok(high < low, `${high} < ${low}`);
  assert.equal(row, 8);
  await press(page, "ArrowDown");
  assert.deepEqual((await state(page)).pixel, [low, 9]);
  assert.equal(await canvas().isVisible(), true);
});

test("an outline beside the plane holds every point of its object, and no less than that (seed 11)", () => {
  let seed = 11;
  const random = () => ((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 31) - 1;
  const onRim = (turn, z, tip = 1) => [Math.cos(4 * turn), Math.sin(4 * turn)].map((c) => c * (z > 0 ? 1 : tip)).concat(z);
  const flat = ([x, y, z]) => [x + 0.3 * y + 2, z - 0.2 * y - 1];
  for (const [type, tip] of [["sphere"], ["box"], ["cylinder"], ["cylinder", 0], ["cylinder", 0.4]])
    for (let k = 0; k < 20; k++) {
      const m = [random(), random(), random(), 0, random(), random(), random(), 0, random(), random(), random(), 0, 3 * random(), 3 * random(), 3 * random(), 1];
      const { kind, points } = silhouetteOf(0, { objects: [{ type, tip, transform: m }], meshes: {} }, flat);
      // Of an ellipse: how far out in units of its half axes. Of a hull: whether left of all its edges.
      const out = ([x, y]) => {
        if (kind === 2) {
          const [[cx, cy], [ux, uy], [, vy]] = points;
          const a = (x - cx) / ux;
          return Math.hypot(a, (y - cy - a * uy) / vy);
        }
        const beyond = points.map(([ax, ay], e) => [points[(e + 1) % points.length], [ax, ay]]).map(([[bx, by], [ax, ay]]) => ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / -Math.hypot(bx - ax, by - ay));
        return 1 + Math.max(...beyond);
      };
      let farthest = -9;
      for (let s = 0; s < 400; s++) {
        const v = [random(), random(), random()];
        const p = type === "box" ? v.map(Math.sign) : type === "cylinder" ? onRim(v[0], Math.sign(v[2]), tip) : v.map((c) => c / Math.hypot(...v));
        const world = [0, 1, 2].map((c) => m[c] * p[0] + m[4 + c] * p[1] + m[8 + c] * p[2] + m[12 + c]);
        farthest = Math.max(farthest, out(flat(world)));
      }
      // 400 random points come within 2 % of an outline; a circle of 32 corners lies within 0.5 % of a radius of at most 2.
      assert.ok(farthest <= 1.01 && farthest > 0.97, `${type} ${tip} ${k}: ${farthest}`);
    }
});

test("a blocker that does not reach into the plane is drawn beside it, dashed, and said to be off it", async () => {
  const { scene, trace } = readTrace(rich.id, 15);
  const data = readSections(rich.id);
  const plane = picturePlane(scene);
  const off = [...Array(225).keys()].find((pixel) => {
    const section = sectionOf(data, { ...select({ ...startState(scene, { speed: 1, still: true, gl: true }), n: 15 }, pixel % 15, Math.floor(pixel / 15)), slice: "row" }, scene, trace, plane);
    const [one, two] = [0, 1].map((light) => trace.blocker[pixel * trace.lights + light]);
    return [one, two].some((by) => by >= 0 && scene.objects[by].type === "sphere" && !section.curves.some(({ object }) => object === by));
  });
  await follow(page, `${FLAT}&n=15&p=${off % 15},${Math.floor(off / 15)}&slice=row`);
  await canvas().waitFor({ state: "visible" });
  await settled(page);
  assert.match((await page.locator(".slice .labels .stop:visible").allInnerTexts()).join(), /, off this plane/);
});

test("outlines that are missing: one sentence, and the scene in space again", async () => {
  const other = await newPage(browser);
  await other.route("**/sections.js", (route) => route.abort());
  await open(other, ON_DISK, rich.path, `${FLAT}&slice=row`);
  await until(other, (state, stats) => state.slice === "none" && stats.notice.includes("outlines"));
  await other.close();
});

test("nothing was said on the console", () => assert.deepEqual(page.faults, []));
