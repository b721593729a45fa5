/** A surface that faces away from a light: one fact, said alike by list, tree, player, sum, copies and sentence, with shadows or without. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { after, before, test } from "node:test";
import { chooseTab, launch, newPage, ON_DISK, open, press, sceneCalled, scenesOfSite, stats } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { rayRows } = await load("state/ray-rows.ts");
const { eventsOf } = await load("state/events.ts");
const { treeText, treeTable } = await load("panels/copies.ts");
const GRAZING = 1e-3; // cosines: stored normals and points are rounded, nearer to 0 either may be true

for (const { id } of scenesOfSite().filter(({ key }) => "1238".includes(key || "-"))) {
  const { scene, trace } = readTrace(id, 15);

  test(`${id}: turned away from a light is what the normal says, and rows, events and copies agree`, () => {
    let turned = 0;
    for (let pixel = 0; pixel < 225; pixel++) {
      const rows = rayRows(trace, scene, pixel);
      const events = eventsOf(trace, scene, pixel);
      const [names, ...table] = treeTable(rows).trimEnd().split("\r\n").map((line) => line.split(","));
      for (const [k, row] of rows.entries())
        for (const { light, seen, gives } of row.lights) {
          const way = scene.lights[light].position.map((v, c) => v - row.point[c]);
          const cosine = way.reduce((sum, v, c) => sum + v * row.normal[c], 0) / Math.hypot(...way);
          const event = events.find((each) => each.ray === row.ray && each.light === light);
          assert.equal(event.what, seen, `pixel ${pixel}, ray ${row.number}`);
          const column = names.indexOf(`light${light + 1}_seen`);
          if (column >= 0) assert.equal(table[k][column], seen);
          if (Math.abs(cosine) < GRAZING) continue;
          assert.equal(seen === "away", cosine < 0, `pixel ${pixel}, ray ${row.number}, ${seen} at a cosine of ${cosine}`);
          if (seen !== "away") continue;
          turned++;
          assert.deepEqual([...gives], [0, 0, 0]);
          assert.match(treeText("", rows), /faces away/);
        }
    }
    assert.ok(turned > 0);
  });
}

const PIXEL = [2, 4]; // of the 5 x 5 grid of scene 1, which has no shadows: it was "faces away", "counts as seen" and a dot at once
const shading = sceneCalled("01-shading");
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
  await open(page, ON_DISK, shading.path, `still=1&gl=none&n=5&p=${PIXEL.join()}`);
});
after(() => browser.close());
const UNASKED = /counts as seen|light arrives/i;

test("01#p=2,4: sentence, list, tree, player and sum say that it faces away, and nothing says otherwise", async () => {
  await page.locator(".lesson-text .why").filter({ hasText: /\w/ }).waitFor();
  assert.match(await page.locator(".lesson-text").innerText(), /faces away from light 1/);
  await chooseTab(page, "rays");
  const row = page.locator("li.ray[data-light='0']");
  assert.match(await row.innerText(), /faces away/);
  assert.doesNotMatch(await row.innerText(), UNASKED);
  assert.match(await row.getAttribute("class"), /\baway\b/);
  await chooseTab(page, "tree");
  const node = page.locator(".node").first();
  assert.match(await node.getAttribute("aria-label"), /faces away/);
  assert.deepEqual([await node.locator(".mark.away").count(), await node.locator(".mark.reached").count()], [1, 0]);
  await chooseTab(page, "sum");
  assert.match(await page.locator(".sums").innerText(), /faces away/);
  const { events } = await stats(page);
  const said = [];
  for (const { what } of events) {
    await press(page, ".");
    await page.locator(".event-says").waitFor();
    said.push([what, await page.locator(".lesson-text").innerText()]);
  }
  assert.match(said.find(([what]) => what === "away")[1], /faces away from light 1/);
  assert.match(said.find(([what]) => what === "pixel")[1], /faces away from light 1/);
  for (const [what, words] of said) assert.doesNotMatch(words, UNASKED, what);
});

test("the command line's JSON says so too", { skip: existsSync(".venv/bin/python") ? false : "no Python here" }, () => {
  const text = execFileSync(".venv/bin/python", ["-m", "raywalk", "pixel", shading.id, "--size", "5", "--at", PIXEL.join(), "--json"], { encoding: "utf8" });
  const { tree } = JSON.parse(text);
  assert.deepEqual(tree.lights.map(({ faces_away, visible, blocker }) => [faces_away, visible, blocker]), [[true, false, tree.object]]);
  const say = (...more) => execFileSync(".venv/bin/python", ["-m", "raywalk", ...more], { encoding: "utf8" });
  assert.match(say("pixel", shading.id, "--size", "5", "--at", PIXEL.join()), /light 1 is faced away from/);
  const filed = ["inspect", `dist/${shading.path.replace("index.html", "5.js")}`, "--pixel", PIXEL.join()];
  assert.match(say(...filed), /light 1: behind the surface/);
  assert.deepEqual(JSON.parse(say(...filed, "--json")).tree.lights.map(({ facesAway }) => facesAway), [true]);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
