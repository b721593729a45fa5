/** Selecting another pixel of the finest grid takes one frame: lines, card and tiles follow together, at an empty frame's cost. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { COMPOSED_TOGETHER, launch, newPage, ON_DISK, open, scenesOfSite } from "./browser.mjs";

const FRAMES = 10; // of each kind, one after the other in turn: what else the machine does meets both
const MOST = 4; // empty frames' time for one that selects; it was 1.5 to 2.8 on a busy machine
const CASES = { 5: "rays", 8: "tree", 9: "sum" }; // scene key: the card's side; the heaviest scenes with its dearest sides

let browser, page;
before(async () => {
  browser = await launch([], COMPOSED_TOGETHER);
  page = await newPage(browser);
});
after(() => browser.close());

for (const { id, path, key } of scenesOfSite().filter(({ key }) => key in CASES)) {
  const tab = CASES[key];
  test(`${id}, 105 x 105, ${tab}: one frame after a key all shows the new pixel, at the cost of a few empty frames`, async (t) => {
    await open(page, ON_DISK, path, "still=1");
    await page.evaluate((tab) => localStorage.setItem("raywalk card", tab), tab);
    await open(page, ON_DISK, path, "still=1&n=105&p=30,60&tiles=filled");
    const { empty, selecting, late } = await page.evaluate(async (frames) => {
      window.raywalk.hold();
      const frame = () => new Promise((done) => requestAnimationFrame(done));
      const times = { empty: [], selecting: [] };
      let late = 0;
      for (let k = 0; k < 2 * frames; k++) {
        const selects = k % 2 === 1;
        await frame();
        const from = performance.now();
        if (selects) window.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight" }));
        else window.raywalk.advance(0); // draws what is there
        await frame();
        const read = () => {
          const { pixel } = window.raywalk.state();
          const stats = window.raywalk.stats();
          const at = (pixel[1] * 105 + pixel[0]) * 3;
          return (
            stats.lines[0].ray === pixel[1] * 105 + pixel[0] && // camera rays stand first in a trace, in scan order
            document.querySelector(".pixel-name").textContent.endsWith(`${pixel[0]}, ${pixel[1]}`) &&
            document.querySelector(".pixel-colour").textContent === stats.tiles.slice(at, at + 3).join(", ")
          );
        };
        await new Promise((done) => setTimeout(done)); // the frame asked for by the key has run now
        times[selects ? "selecting" : "empty"].push(performance.now() - from);
        if (selects && !read()) late++;
      }
      return { ...times, late };
    }, FRAMES);
    const middle = (values) => values.sort((a, b) => a - b)[values.length >> 1];
    const [a, b] = [middle(empty), middle(selecting)];
    t.diagnostic(`empty ${a.toFixed(1)} ms, selecting ${b.toFixed(1)} ms, ratio ${(b / a).toFixed(2)}`);
    assert.equal(late, 0, "frames that showed an older pixel");
    assert.ok(b <= MOST * a, `${b} ms against ${a} ms`);
  });
}

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
