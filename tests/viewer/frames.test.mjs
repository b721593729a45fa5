/** Selecting another pixel of the finest grid takes one frame: lines, card and tiles follow together, at an empty frame's cost. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { atRest, launch, newPage, ON_DISK, open, scenesOfSite, state, workOf } from "./browser.mjs";
import { cases } from "./cases.mjs";

const FRAMES = 10; // of each kind
const MOST = 5; // empty frames' work for one that selects; it was 2.3 to 3.0
const CASES = cases({ 2: "none", 5: "rays", 8: "tree", 9: "sum" }, { 8: "tree" }); // scene key: the card's tab; the heaviest scene with its dearest one

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { viewport: { width: 640, height: 480 } }); // the graphics card's work, which a processor does here, is not asked about
});
after(() => browser.close());

for (const { id, path, key } of scenesOfSite().filter(({ key }) => key in CASES)) {
  const tab = CASES[key];
  test(`${id}, 105 x 105, ${tab}: one frame after a key all shows the new pixel, at the cost of a few empty frames`, async (t) => {
    await open(page, ON_DISK, path, `still=1&n=105&p=30,60&tiles=filled&cam=camera${tab === "none" ? "" : `&tab=${tab}`}`);
    await atRest(page);
    const work = await workOf(page);
    /** The key, frame after frame: ms of work a frame, and frames that showed an older pixel. */
    const pressed = async (key) => {
      const before = await work();
      const late = await page.evaluate(afterEach, [key, FRAMES]);
      return { late, each: ((await work()) - before) / FRAMES };
    };
    const empty = await pressed("r"); // draws what is there
    const selecting = await pressed("ArrowRight");
    t.diagnostic(`empty ${empty.each.toFixed(1)} ms, selecting ${selecting.each.toFixed(1)} ms, ratio ${(selecting.each / empty.each).toFixed(2)}`);
    assert.equal(selecting.late, 0);
    assert.equal((await state(page)).pixel[0], 30 + FRAMES);
    assert.ok(selecting.each <= MOST * empty.each, `${selecting.each} ms against ${empty.each} ms`);
  });
}

/** In the page: a key before each of so many frames; how many frames did not show the selected pixel everywhere. */
async function afterEach([key, frames]) {
  const shows = () => {
    const [column, row] = window.raywalk.state().pixel;
    const at = row * 105 + column;
    const stats = window.raywalk.stats();
    return (
      stats.lines[0].ray === at && // camera rays stand first in a trace, in scan order
      document.querySelector(".pixel-name").textContent.endsWith(`${column}, ${row}`) &&
      document.querySelector(".pixel-colour").textContent === stats.tiles.slice(3 * at, 3 * at + 3).join(", ")
    );
  };
  let late = 0;
  for (let k = 0; k < frames; k++) {
    window.dispatchEvent(new KeyboardEvent("keydown", { key }));
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done))); // the frame asked for by the key has run now
    if (!shows()) late++;
  }
  return late;
}

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
