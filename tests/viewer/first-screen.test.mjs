/** What is seen on arrival: few controls, a large stage, and the way on without scrolling; on a desk, a phone, in a frame. */
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { follow, framedIn, launch, newPage, ON_DISK, open, press, reach, richScene, sceneCalled, stats } from "./browser.mjs";

const rich = richScene();
const MOST_CONTROLS = 20; // that can be reached before anything is opened, the skip link among them
const DESKS = [[1280, 800], [1366, 768]];
const PHONES = [[390, 844], [360, 640]];
const FRAMES = [[700, 460], [480, 360]];
const folder = mkdtempSync(join(tmpdir(), "raywalk-course-"));
let browser, page, outer;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
  outer = await newPage(browser, { viewport: { width: 1000, height: 700 } }); // a course's
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const QUICK = "still=1&gl=none";
/** On arrival, and then where a link leads. */
const at = async (width, height, hash = "", path = rich.path) => {
  await page.setViewportSize({ width, height });
  await (hash ? follow(page, `${QUICK}&${hash}`) : open(page, ON_DISK, path, QUICK));
};
/** How much of the window the stage takes. */
const shareOfStage = (of = page) =>
  of.evaluate(() => {
    const { left, right, top, bottom } = document.querySelector(".stage-view").getBoundingClientRect();
    const seen = Math.max(0, Math.min(innerWidth, right) - Math.max(0, left)) * Math.max(0, Math.min(innerHeight, bottom) - Math.max(0, top));
    return seen / (innerWidth * innerHeight);
  });
/** Of these parts, those that one cannot see whole without scrolling, or that something lies on. */
const outOfSight = (parts, of = page) =>
  of.evaluate((parts) => parts.filter((part) => {
    const element = document.querySelector(part);
    if (!element?.checkVisibility({ visibilityProperty: true })) return true;
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const onTop = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    return top < 0 || left < 0 || bottom > innerHeight || right > innerWidth || !(element.contains(onTop) || onTop?.contains(element));
  }), parts);

for (const { id, path } of [rich, sceneCalled("11-what-is-a-ray"), sceneCalled("22-rasterised-glass")])
  test(`${id}: on arrival at most ${MOST_CONTROLS} controls can be reached, none twice, and then the page is over`, async () => {
    await at(1280, 800, "", path);
    const names = [];
    for (let k = 0; k <= MOST_CONTROLS; k++) {
      await page.keyboard.press("Tab");
      const name = await page.evaluate(() => {
        const here = document.activeElement;
        return here === document.body ? null : here.getAttribute("aria-label") || here.textContent.trim() || here.className;
      });
      if (name === null) break;
      names.push(name);
    }
    assert.ok(names.length <= MOST_CONTROLS, `${names.length}: ${names.join("; ")}`);
    assert.ok(names.length >= 10, names.join("; "));
  });

for (const [width, height] of DESKS)
  test(`at ${width} x ${height} the stage has at least 60 % of the window, and sentence, Start, Play, Render and picture are in sight`, async () => {
    for (const hash of ["", "step=2", "e=3"]) {
      await at(width, height, hash);
      const share = await shareOfStage();
      assert.ok(share >= 0.6, `#${hash}: ${(100 * share).toFixed(1)} %`);
      if (!hash) assert.deepEqual(await outOfSight([".lesson-text", ".start-lesson", ".play", ".render", ".picture-frame", ".made-of"]), []);
    }
  });

for (const [width, height] of PHONES)
  test(`on a phone of ${width} x ${height} the stage has at least 45 % of the window, and what one presses is within the first screen`, async () => {
    const pressed = {
      "": [".stage-view", ".picture-frame", ".lesson-text", ".start-lesson", ".play", ".render"],
      "e=3": [],
      "step=2": [".lesson-text", ".lesson-steps .next", ".lesson-steps > button:first-child", ".render"],
    };
    for (const [hash, parts] of Object.entries(pressed)) {
      await at(width, height, hash);
      const share = await shareOfStage();
      assert.ok(share >= 0.45, `#${hash}: ${(100 * share).toFixed(1)} %`);
      assert.deepEqual(await outOfSight(parts), [], hash);
    }
    const { step } = await page.evaluate(() => window.raywalk.lesson().reduce((found, each, step) => (found.step < 0 && each.answer ? { step } : found), { step: -1 }));
    await at(width, height, `step=${step + 1}`);
    assert.deepEqual(await outOfSight([".reveal", ".option"]), []);
  });

/** A course's page, longer than its window, with this scene in a frame. */
async function course(query, hash, [width, height]) {
  const file = join(folder, `course-${width}${query}${hash.length}.html`.replace("?", "-"));
  writeFileSync(file, `<!doctype html><title>Course</title><p>Rays</p><iframe src="${ON_DISK}${rich.path}${query}#${hash}" width="${width}" height="${height}" style="border:0" title="Ray walk"></iframe><div style="height: 3000px">More</div>`);
  await outer.goto(pathToFileURL(file).href);
  return framedIn(outer);
}

// However it is asked for: the smaller frame shows it.
const ASKED = [[FRAMES[0], "?embed", "still=1&gl=none"], [FRAMES[1], "?embed", "still=1&gl=none"], [FRAMES[1], "", "embed=1&still=1&gl=none"], [FRAMES[1], "", "embed&still=1&gl=none"]];
for (const [size, query, hash] of ASKED)
  test(`in a frame of ${size.join(" x ")} by ${query || `#${hash.split("&")[0]}`} the stage has at least 40 %, with sentence, step and play, and no notice`, async () => {
    const frame = await course(query, hash, size);
    for (const more of ["", "&step=2", "&e=2"]) {
      if (more) await follow(frame, hash + more);
      assert.ok(!(await frame.locator("#notice").isVisible()), await frame.locator("#notice").innerText());
      const share = await shareOfStage(frame);
      assert.ok(share >= 0.4, `${more}: ${(100 * share).toFixed(1)} %`);
      assert.deepEqual(await outOfSight([".stage-view", ".lesson-text", ".play", more ? ".embed-bar a" : ".start-lesson", ...(more === "&step=2" ? [".lesson-steps .next"] : [])], frame), [], more);
      assert.equal(await frame.evaluate(() => document.documentElement.scrollHeight - innerHeight), 0, "the frame itself has nothing to scroll");
    }
  });

test("the wheel over a frame scrolls the page around it until the frame has the focus, then it zooms", async () => {
  const frame = await course("?embed", "still=1&gl=none", FRAMES[0]);
  const before = reach(await stats(frame));
  const box = await outer.locator("iframe").boundingBox();
  await outer.mouse.move(box.x + 100, box.y + 60);
  await outer.mouse.wheel(0, 40);
  await outer.waitForFunction(() => scrollY > 0);
  assert.equal(reach(await stats(frame)), before);
  await outer.evaluate(() => scrollTo(0, 0));
  await outer.mouse.click(box.x + 100, box.y + 60);
  await outer.mouse.wheel(0, 40);
  await frame.waitForFunction((before) => (({ eye, target }) => Math.hypot(...eye.map((v, k) => v - target[k])))(window.raywalk.stats()) > before, before);
  assert.equal(await outer.evaluate(() => scrollY), 0);
});

test("PageDown begins the lesson where none runs, and goes through it", async () => {
  await at(1280, 800);
  const now = () => page.evaluate(() => window.raywalk.state()).then(({ scene, step }) => [scene, step]);
  await press(page, "PageDown");
  assert.deepEqual(await now(), [rich.id, 0]);
  await press(page, "PageDown");
  assert.deepEqual(await now(), [rich.id, 1]);
});

test("nothing was said in the console", () => assert.deepEqual([page.faults, outer.faults.filter((fault) => !/outside request/.test(fault))], [[], []]));
