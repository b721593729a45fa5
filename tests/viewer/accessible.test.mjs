/** WCAG 2.2 AA as far as a machine can tell, in every state and language; and what only people notice. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { launch, newPage, ON_DISK, open, press, richScene, state } from "./browser.mjs";

const rich = richScene();
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"];
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(() => browser.close());

/** The tree of rays names its nodes by what they are, not by the short words drawn in them. */
async function violations(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(async (rules) => (await window.axe.run(document, { preload: false, runOnly: rules })).violations, RULES);
  return found.map((each) => `${each.id}: ${each.nodes.map((node) => node.target).filter((target) => !(each.id === "label-content-name-mismatch" && /^g\[/.test(target))).join(" ")}`).filter((line) => !line.endsWith(": "));
}

/** Name, what to open, and what to do there. */
const STATES = [
  ["the selected pixel", "still=1"],
  ["filled, all rays", "still=1&tiles=filled&rays=pixel,all"],
  ["a lesson's step", "still=1&step=2"],
  ["a question", "still=1&step=6"],
  ["the player", "still=1&n=15&p=5,8&e=5"],
  ["a drawing without WebGL", "still=1&gl=none"],
  ["a notice", "still=1&n=16"],
  ["all keys", "still=1", (page) => press(page, "?")],
  ["the projector", "still=1&e=3", (page) => press(page, "j")],
  ["a slice", "still=1", (page) => press(page, "x")],
  ["the tree", "still=1&n=15&p=5,8", (page) => page.getByRole("tab").nth(1).click()],
  ["the sum", "still=1&n=15&p=5,8", (page) => page.getByRole("tab").nth(2).click()],
  ["the pseudo-code", "still=1&e=3", (page) => page.getByRole("tab").nth(3).click()],
];
for (const home of ["", "de/"]) {
  for (const [name, hash, act] of STATES)
    test(`axe finds nothing wrong (${home || "en/"}): ${name}`, async () => {
      await open(page, ON_DISK, `${home}${rich.path}`, hash);
      await act?.(page);
      assert.deepEqual(await violations(page), []);
      await page.keyboard.press("Escape");
      await page.evaluate(() => localStorage.clear());
    });
  for (const path of ["index.html", "model/index.html", `${rich.path}?embed`])
    test(`axe finds nothing wrong (${home || "en/"}): ${path}`, async () => {
      await page.goto(`${ON_DISK}${home}${path}`);
      await page.evaluate(() => window.raywalk?.ready);
      assert.deepEqual(await violations(page), []);
    });
}

test("the selected ray is told in words once the selection rests, not while it moves or plays", async () => {
  await open(page, ON_DISK, rich.path, "still=1&n=15&p=5,8");
  const spoken = page.locator("p.unseen[role=status]");
  await page.waitForFunction(() => document.querySelector("p.unseen").textContent !== "");
  assert.equal(await spoken.textContent(), "Pixel 5, 8: 2 rays. The camera ray meets mirror A. Colour 180, 180, 180.");
  const changes = await page.evaluate(async () => {
    let count = 0;
    new MutationObserver(() => count++).observe(document.querySelector("p.unseen"), { childList: true, characterData: true, subtree: true });
    for (let k = 0; k < 6; k++) {
      window.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight" }));
      await new Promise((done) => requestAnimationFrame(done));
    }
    await new Promise((done) => setTimeout(done, 1200));
    return count;
  });
  assert.equal(changes, 1, "six pixels passed by, the last one is said");
  const before = await spoken.textContent();
  await press(page, ".", ".");
  await new Promise((done) => setTimeout(done, 700));
  assert.equal(await spoken.textContent(), before, "the player's sentence has its own place");
});

test("keys of one character can be turned off, and stay off; Space, arrows and buttons go on", async () => {
  await open(page, ON_DISK, rich.path, "still=1");
  await press(page, "?");
  await page.getByRole("button", { name: "Letters, digits and signs" }).click();
  await page.keyboard.press("Escape");
  for (let visit = 0; visit < 2; visit++) {
    const { rays, pixel, scene } = await state(page);
    await press(page, "h", "a", "2", ".", "?", "+");
    assert.deepEqual(await state(page).then((now) => [now.rays, now.scene, now.event]), [rays, scene, null]);
    assert.equal(await page.locator("dialog").count(), 0);
    await press(page, "ArrowRight");
    assert.notDeepEqual((await state(page)).pixel, pixel);
    await open(page, ON_DISK, rich.path, "still=1");
  }
  await page.getByRole("button", { name: "All keys" }).click();
  await page.getByRole("button", { name: "Letters, digits and signs" }).click();
  await page.keyboard.press("Escape");
  await press(page, "h");
  assert.ok((await state(page)).rays.includes("row"));
});

for (const home of ["", "de/"])
  test(`at 400 % (320 px wide) the page scrolls one way only, and everything is there (${home || "en/"})`, async () => {
    await page.setViewportSize({ width: 320, height: 256 });
    for (const hash of ["still=1", "still=1&step=2", "still=1&n=15&p=5,8&e=5"]) {
      await open(page, ON_DISK, `${home}${rich.path}`, hash);
      const { wide, outside } = await page.evaluate(() => ({
        wide: document.documentElement.scrollWidth - innerWidth,
        outside: [...document.querySelectorAll("button, a, input")].filter((e) => e.checkVisibility({ visibilityProperty: true }) && e.getBoundingClientRect().right > innerWidth + 1).map((e) => e.getAttribute("aria-label") ?? e.textContent),
      }));
      assert.deepEqual([wide, outside], [0, []], hash);
    }
    for (const path of ["index.html", "model/index.html"]) {
      await page.goto(`${ON_DISK}${home}${path}`);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0, path);
    }
    await page.setViewportSize({ width: 1280, height: 800 });
  });

test("the card is a list of rays, the page has its landmarks, each with a name", async () => {
  await open(page, ON_DISK, rich.path, "still=1&n=15&p=5,8");
  assert.ok((await page.getByRole("list").filter({ has: page.locator("li.ray") }).getByRole("listitem").count()) >= 3);
  for (const role of ["banner", "main", "navigation"]) assert.ok((await page.getByRole(role).count()) >= 1, role);
  for (const section of await page.locator("#viewer section").all()) assert.ok((await section.getAttribute("aria-label")) || (await section.getAttribute("class")) === "stage", await section.getAttribute("class"));
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
