/** Sizes: nothing is cut off, everything can be hit, everything can be read. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chooseTab, follow, launch, newPage, ON_DISK, open, openDrawer, press, richScene, sceneCalled, scenesOfSite, show, state, stats } from "./browser.mjs";
import { cases } from "./cases.mjs";

const rich = richScene();
const QUICK = "still=1&gl=none"; // where things are does not depend on what draws the stage
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser, { sharp: true });
  await open(page, ON_DISK, rich.path, QUICK);
});
after(() => browser.close());

const SIZES = [[1280, 800], [1366, 768], [1920, 1080], [1280, 720], [1024, 768], [820, 1180], [390, 844], [360, 640]];
const size = (page, width, height) => page.setViewportSize({ width, height });

for (const [width, height] of SIZES)
  test(`at ${width} x ${height} nothing overflows and every target is at least 44 px`, async () => {
    await size(page, width, height);
    await follow(page, `${QUICK}&step=1&e=2`);
    const { wide, tall, small, cut } = await page.evaluate(() => {
      const targets = [...document.querySelectorAll("button, nav a, .top a, input")].filter((e) => e.checkVisibility({ visibilityProperty: true }) && e.offsetWidth);
      const name = (e) => `${e.getAttribute("aria-label") ?? e.textContent} ${e.offsetWidth} x ${e.offsetHeight}`;
      return {
        wide: document.documentElement.scrollWidth - innerWidth,
        tall: document.documentElement.scrollHeight - innerHeight,
        small: targets.filter((e) => e.offsetWidth < 44 || e.offsetHeight < 44).map(name),
        cut: targets.filter((e) => e.scrollWidth > e.offsetWidth + 1 || e.getBoundingClientRect().right > innerWidth + 1).map(name),
      };
    });
    assert.equal(wide, 0);
    assert.deepEqual(small, []);
    assert.deepEqual(cut, []);
    if (width > 760) assert.equal(tall, 0, "the main view needs no page scroll");
  });

test("on a phone the order is stage with the picture in its corner, sentence, player, controls, card", async () => {
  await size(page, 390, 844);
  await show(page, ON_DISK, rich.path, QUICK);
  const tops = await page.evaluate(() =>
    [".stage", ".lesson", ".player", ".controls", ".card-head", ".card"].map((part) => document.querySelector(part).getBoundingClientRect().top),
  );
  assert.deepEqual(tops, [...tops].sort((a, b) => a - b));
  assert.equal(await page.locator(".stage > .picture").count(), 1);
});

for (const [width, height] of [[390, 844], [360, 640]])
  test(`on a phone of ${width} x ${height} the stage stays in sight, and stepping moves nothing around the player`, async () => {
    await size(page, width, height);
    await show(page, ON_DISK, rich.path, `${QUICK}&n=15&p=5,8`);
    const box = () => page.evaluate(() => Object.fromEntries([".stage-view", ".picture-frame", ".lesson", ".controls", ".card-head"].map((part) => [part, document.querySelector(part).getBoundingClientRect().toJSON()])));
    const before = await box();
    for (const act of [() => page.locator(".play").click(), () => press(page, ","), () => press(page, "Escape"), () => page.getByRole("button", { name: "Start the lesson" }).click(), () => press(page, "PageDown", ".")]) {
      await act();
      await press(page);
      assert.deepEqual(await box(), before);
    }
    await press(page, "Escape");
    await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
    const { top, bottom } = await page.evaluate(() => document.querySelector(".stage-view").getBoundingClientRect().toJSON());
    assert.ok(Math.abs(top) < 2 && bottom < height, `scrolled to the page's end, the stage is at ${top} to ${bottom}`);
  });

const CARDS = [[390, 844], [360, 640], [820, 1180], [1280, 800]];
for (const { id, path } of [rich, sceneCalled("01-shading")])
  for (const home of cases(["", "de/"], ["de/"])) // its words are longer
    test(`in ${id} no part of the card lies on another, at ${CARDS.map((each) => each.join(" x ")).join(", ")}, whichever tab is open (${home || "en"})`, async () => {
      await open(page, ON_DISK, home + path, QUICK);
      for (const [width, height] of CARDS) {
        await size(page, width, height);
        for (const tab of ["none", "rays", "sum", "tree", "code"]) {
          await follow(page, `${QUICK}&tab=${tab}`);
          if (tab !== "none") await page.locator(`#panel-card-${tab} > *`).waitFor();
          const lies = await page.evaluate(() => {
            const parts = [...document.querySelectorAll(".side :is(.card-head > *, .shares-bar, .shares, .tabs, .tab-panel, .legend, .savings)")].filter((e) => e.checkVisibility() && e.offsetHeight);
            const boxes = parts.map((e) => [e, e.getBoundingClientRect()]);
            const over = (a, b) => Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1 && Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1;
            return boxes.flatMap(([a, one], k) => boxes.slice(k + 1).filter(([b, other]) => !a.contains(b) && !b.contains(a) && over(one, other)).map(([b]) => `${a.className} lies on ${b.className}`));
          });
          assert.deepEqual([...new Set(lies)], [], `${width} x ${height}, ${tab}`);
        }
      }
    });

test("the pixel's name and colour have room for three digits each: nothing beside them moves", async () => {
  await size(page, 1280, 800);
  await open(page, ON_DISK, rich.path, `${QUICK}&n=105&p=4,4`);
  const box = () => page.evaluate(() => JSON.stringify([...document.querySelectorAll(".card-head > *, .picture-frame, .card")].map((each) => each.getBoundingClientRect())));
  const before = await box();
  await follow(page, `${QUICK}&n=105&p=104,104`);
  assert.equal(await box(), before);
  assert.equal(await page.locator(".pixel-name").evaluate((e) => e.scrollWidth <= e.parentElement.clientWidth), true);
});

// The dragon's scene has four coloured lamps: no sum has more numbers in it.
for (const scene of [rich, scenesOfSite().find(({ key }) => key === "9") ?? rich])
  test(`whatever the player tells, the stage keeps its place, size and room (${scene.id}, 1280 x 800)`, async () => {
    await size(page, 1280, 800);
    await show(page, ON_DISK, scene.path, QUICK);
    const box = () => page.evaluate(() => JSON.stringify(document.querySelector(".stage-view").getBoundingClientRect()));
    const before = await box();
    assert.ok(JSON.parse(before).height > 300);
    const { events } = await stats(page);
    for (const k of events.keys()) {
      await press(page, ".");
      assert.equal(await box(), before, `event ${k + 1}`);
      const cut = await page.evaluate(() => document.querySelector(".lesson-text").scrollHeight - document.querySelector(".lesson-text").clientHeight);
      assert.ok(cut <= 0, `event ${k + 1}: ${cut} px of the sentence are cut off`);
    }
  });

test("with the keyboard alone every control can be reached, seen and used", async () => {
  await size(page, 1280, 800);
  await open(page, ON_DISK, rich.path, QUICK);
  await openDrawer(page);
  await page.locator(".open-what-if").click();
  await page.locator(".what-if .lamp").first().waitFor();
  await chooseTab(page, "rays");
  await press(page, ".");
  const reached = new Set();
  for (let k = 0; k < 100; k++) {
    await page.keyboard.press("Tab");
    const here = await page.evaluate(() => {
      const e = document.activeElement;
      return [e.getAttribute("aria-label") ?? e.className, getComputedStyle(e).outlineStyle];
    });
    if (here[0] && here[0] !== "scene live") assert.notEqual(here[1], "none", `no visible focus on ${here[0]}`);
    reached.add(here[0]);
  }
  const missing = await page.evaluate(
    (seen) => [...document.querySelectorAll("button:not([role=tab][aria-selected=false])")].filter((e) => e.checkVisibility({ visibilityProperty: true })).map((e) => e.getAttribute("aria-label") ?? e.className).filter((name) => !seen.includes(name)),
    [...reached],
  );
  assert.deepEqual(missing, []);
  await page.getByRole("button", { name: "selected row" }).focus();
  await press(page, " ");
  assert.ok((await state(page)).rays.includes("row"), "Space presses the focused button");
  assert.equal((await state(page)).tiles, "empty", "and does not render as well");
});

test("printed, the page is picture, lesson and figures", async () => {
  await show(page, ON_DISK, rich.path, QUICK);
  await page.emulateMedia({ media: "print" });
  const seen = await page.evaluate(() =>
    Object.fromEntries([".plain-picture", ".plain-lesson", "#page .figures", "#viewer", "nav.scenes"].map((part) => [part, document.querySelector(part).checkVisibility()])),
  );
  await page.emulateMedia({ media: null });
  assert.deepEqual(seen, { ".plain-picture": true, ".plain-lesson": true, "#page .figures": true, "#viewer": false, "nav.scenes": false });
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
