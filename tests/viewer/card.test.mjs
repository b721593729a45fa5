/** The ray card: its numbers are the trace's; list, tree, sum and copies say the same; a click goes to the ray's event. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { chooseTab, follow, keyedScenes, launch, newPage, ON_DISK, open, press, reload, richScene, scenesOfSite, settled, state, stats } from "./browser.mjs";
import { readTrace } from "./scene-files.mjs";
import { load } from "./typescript.mjs";

const { rayRows } = await load("state/ray-rows.ts");
const { treeText, treeTable } = await load("panels/copies.ts");
const rich = richScene();
const glass = scenesOfSite().find(({ key }) => key === "8") ?? rich;
const START = "still=1&gl=none&n=15&p=5,8";
const close = (a, b, tolerance) => assert.ok(a.every((v, k) => Math.abs(v - b[k]) <= tolerance), `${a} is not ${b}`);
const plus = (a, b, by) => a.map((v, k) => v + by * b[k]);

for (const { id } of [...new Set([rich, glass, ...keyedScenes().slice(0, 3)])]) {
  const { scene, trace } = await readTrace(id, 15);
  const all = Array.from({ length: 225 }, (_, pixel) => rayRows(trace, scene, pixel));

  test(`${id}: what the lights give adds up to the surface's colour, own and sent rays to each ray's, all to the pixel's`, () => {
    for (const [pixel, rows] of all.entries()) {
      for (const row of rows) {
        if (row.lights.length) close(row.lights.reduce((sum, { gives }) => plus(sum, gives, 1), row.ambient), row.local, 1e-12); // the same sum in another order
        const sent = rows.filter(({ of }) => of === row.number);
        const own = row.object ? plus([0, 0, 0], row.local, row.keeps) : row.local;
        close(sent.reduce((sum, { colour, weight }) => plus(sum, colour, weight), own), row.colour, 1e-12);
      }
      const shares = rows.reduce((sum, row) => plus(sum, row.local, row.share * (row.object ? row.keeps : 1)), [0, 0, 0]);
      close(shares, rows[0].colour, 1e-9); // up to 44 products in another order
      // Terms are stored rounded, tiles exactly: they may round to neighbours.
      for (const c of [0, 1, 2]) assert.ok(Math.abs(Math.min(1, Math.max(0, rows[0].colour[c])) * 255 - trace.tiles[3 * pixel + c]) <= 1);
    }
  });

  test(`${id}: the table for spreadsheets has a line a ray, and its numbers are the trace's`, () => {
    for (const rows of all) {
      const [names, ...lines] = treeTable(rows).trimEnd().split("\r\n").map((line) => line.split(","));
      assert.equal(lines.length, rows.length);
      assert.ok(lines.every((line) => line.length === names.length));
      for (const [k, row] of rows.entries()) {
        const of = (name) => lines[k][names.indexOf(name)];
        assert.deepEqual([of("ray"), of("kind"), of("object")], [String(k + 1), row.kind, row.object]);
        close(["x", "y", "z"].map((axis) => Number(of(`point_${axis}`))), row.point, 1e-5); // eight figures
        close(["r", "g", "b"].map((c) => Number(of(`colour_${c}`))), row.colour, 1e-6);
        for (const [l, { gives, by }] of row.lights.entries()) {
          close(["r", "g", "b"].map((c) => Number(of(`light${l + 1}_gives_${c}`))), gives, 1e-6);
          assert.equal(of(`light${l + 1}_blocked_by`), by);
        }
      }
      const text = treeText("Title", rows);
      assert.doesNotMatch(text, /undefined|NaN|Infinity|null/);
      assert.equal(text.split("\n").filter((line) => /^ *\d+ {2}/.test(line)).length, rows.length);
    }
  });
}

let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
  await open(page, ON_DISK, rich.path, START);
});
after(() => browser.close());
const button = (name) => page.getByRole("button", { name, exact: true });
const tab = (name) => page.getByRole("tab", { name });
const current = async () => (await state(page)).event;

test("tabs show one panel or none, by click and by arrow key; the choice is part of the address and outlasts a reload", async () => {
  const visible = () => page.locator("[role=tabpanel]").evaluateAll((panels) => panels.filter((panel) => panel.checkVisibility()).map((panel) => panel.firstElementChild.className));
  assert.deepEqual(await visible(), []);
  assert.equal(await page.locator(".made-of").isVisible(), true, "at first what the colour is made of");
  await tab("The ray tree").click();
  await settled(page);
  assert.deepEqual(await visible(), ["tree"]);
  assert.equal(await page.locator(".made-of").isVisible(), false);
  await tab("The ray tree").focus();
  await press(page, "ArrowRight");
  assert.deepEqual(await visible(), ["sums"]);
  assert.deepEqual((await state(page)).pixel, [5, 8], "the arrows belong to the tabs");
  await page.waitForFunction(() => location.hash.includes("tab=sum"));
  await reload(page);
  await page.locator(".sums").waitFor();
  assert.deepEqual(await visible(), ["sums"]);
  await tab("How the pixel").click();
  await settled(page);
  assert.deepEqual(await visible(), [], "pressed once more it closes");
  assert.equal(await page.locator(".made-of").isVisible(), true);
  await page.waitForFunction(() => !location.hash.includes("tab="));
});

test("a row, a node and a sum go to their event by click and by Enter, and the current one is marked in each", async () => {
  await follow(page, START);
  const { events } = await stats(page);
  const at = (ray, ...whats) => events.findIndex((event) => event.ray === ray && event.light < 0 && whats.includes(event.what));
  await chooseTab(page, "rays");
  const second = page.locator("li.ray").nth(1);
  const ray = Number(await second.getAttribute("data-ray"));
  await second.click();
  assert.equal(await current(), at(ray, "meets", "background"));
  await page.locator("li.ray").nth(2).focus();
  await press(page, "Enter");
  assert.equal(await current(), events.findIndex(({ light }) => light >= 0));
  await chooseTab(page, "tree");
  assert.equal(await page.locator(".node").count(), new Set(events.map((event) => event.ray)).size);
  await page.locator(".node").nth(0).click();
  assert.equal(await current(), at(events[0].ray, "meets"));
  await page.locator(".node").nth(0).focus();
  await press(page, "ArrowDown", "Enter");
  assert.equal(await current(), at(ray, "meets"));
  assert.deepEqual((await state(page)).pixel, [5, 8], "the arrows walk the tree");
  await page.mouse.move(2, 2);
  await page.evaluate(() => document.activeElement.blur());
  await settled(page);
  assert.equal(await page.locator(".node.lit").count(), 1);
  await chooseTab(page, "sum");
  await page.locator(".sum").first().click();
  await settled(page);
  assert.equal(await current(), events.length - 1);
  assert.equal(await page.locator(".sum.lit").count(), 1);
});

test("the sum is native MathML with the pixel's numbers put in", async () => {
  await follow(page, START);
  await chooseTab(page, "sum");
  const { scene, trace } = await readTrace(rich.id, 15);
  const [pixel] = await page.locator(".sum").evaluateAll((sums) => sums.map((sum) => [...sum.querySelectorAll("math")].map((math) => math.textContent).join(" ")));
  const [first] = rayRows(trace, scene, 8 * 15 + 5);
  assert.ok(pixel.includes(first.colour[0].toFixed(3)), pixel);
  assert.match(pixel, /255.*180/);
  const tree = JSON.stringify(await page.evaluate(() => [...document.querySelectorAll("math")].map((math) => math.namespaceURI)));
  assert.match(tree, /MathML/);
});

test("a large tree folds what hardly counts, unfolds at a press, and shows the current event's ray", async () => {
  const { trace } = await readTrace(glass.id, 105);
  const sizes = new Int32Array(105 * 105);
  for (let k = 0; k < trace.count; k++) sizes[trace.pixel[k]]++;
  const largest = sizes.indexOf(Math.max(...sizes));
  await open(page, ON_DISK, glass.path, `still=1&gl=none&n=105&p=${largest % 105},${Math.floor(largest / 105)}`);
  await chooseTab(page, "tree");
  const folds = page.locator(".node.fold");
  assert.ok((await folds.count()) > 0);
  assert.ok((await page.locator(".node").count()) < sizes[largest]);
  await page.keyboard.press(".");
  const { events } = await stats(page);
  for (let k = 1; k < events.length; k += 7) {
    await press(page, ".", ".", ".", ".", ".", ".", ".");
    const [seen] = await page.locator(".node.lit").evaluateAll((nodes) => nodes.map((node) => {
      const [a, b] = [node.getBoundingClientRect(), document.querySelector(".tree-window").getBoundingClientRect()];
      const grown = 8; // px: by its outline and its lights' marks, while it is lit
      return a.left >= b.left - grown && a.right <= b.right + grown && a.top >= b.top - grown && a.bottom <= b.bottom + grown;
    }));
    assert.equal(seen, true, `event ${k}`);
  }
  await follow(page, `still=1&gl=none&n=105&p=${(largest % 105) - 1},${Math.floor(largest / 105)}&tab=tree`);
  await follow(page, `still=1&gl=none&n=105&p=${largest % 105},${Math.floor(largest / 105)}&tab=tree`);
  await folds.first().focus();
  await press(page, "Enter");
  assert.equal(await page.locator(".node").count(), sizes[largest]);
});

test("a tree larger than its panel fades where it goes on, can be fitted, and its names stay inside their nodes", async () => {
  await open(page, ON_DISK, glass.path, "still=1&gl=none&n=15&p=2,11&tab=tree");
  await page.locator(".node").first().waitFor();
  const panel = page.locator(".tree-window");
  const goesOn = () => panel.evaluate((e) => [e.scrollWidth > e.clientWidth + 1 || e.scrollHeight > e.clientHeight + 1, /more-(right|bottom|left|top)/.test(e.className)]);
  assert.deepEqual(await goesOn(), [true, true]);
  const touching = await page.locator(".node").evaluateAll((nodes) =>
    nodes.filter((node) => {
      const [name, outline] = [".node-name", ".outline"].map((part) => node.querySelector(part).getBoundingClientRect());
      return name.left < outline.left + 4 || name.right > outline.right - 4;
    }).map((node) => node.textContent));
  assert.deepEqual(touching, []);
  await page.getByRole("button", { name: "Fit the whole tree" }).click();
  assert.deepEqual(await goesOn(), [false, false]);
  await page.getByRole("button", { name: "Large enough" }).click();
  assert.deepEqual(await goesOn(), [true, true]);
});

test("Copy and CSV fill the clipboard; where it is refused, a sheet has the text selected", async () => {
  await open(page, ON_DISK, rich.path, `${START}&tab=rays`);
  const { scene, trace } = await readTrace(rich.id, 15);
  const rows = rayRows(trace, scene, 8 * 15 + 5);
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { configurable: true, value: { writeText: async (text) => void (window.copied = text) } }));
  await page.getByRole("button", { name: "as a table" }).click();
  assert.equal(await page.evaluate(() => window.copied), treeTable(rows));
  await page.getByRole("button", { name: "rays as text" }).click();
  assert.match(await page.evaluate(() => window.copied), /Pixel 5, 8\n1 {2}camera ray hits mirror A/);
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { configurable: true, value: undefined }));
  await page.getByRole("button", { name: "as a table" }).click();
  const sheet = page.getByRole("dialog");
  await sheet.waitFor();
  assert.equal(await page.evaluate(() => String(document.activeElement.value).slice(document.activeElement.selectionStart, document.activeElement.selectionEnd).length), treeTable(rows).replaceAll("\r", "").length);
  await press(page, "ArrowRight", "h");
  assert.deepEqual([(await state(page)).pixel, (await state(page)).rays], [[5, 8], ["pixel"]], "keys in a sheet are the sheet's");
  await press(page, "Escape");
  assert.equal(await page.getByRole("dialog").count(), 0);
});

test("while a question waits, the card keeps the numbers to itself", async () => {
  const { scene } = await readTrace(rich.id, 15);
  const of = (isAsked) => scene.lesson.findIndex(isAsked) + 1;
  const [plain, choosing] = [of(({ answer, choices }) => answer && !choices), of(({ choices }) => choices)];
  if (plain) {
    await open(page, ON_DISK, rich.path, `still=1&gl=none&step=${plain}`);
    assert.match(await page.locator(".card .note:visible").innerText(), /Predict first/);
    assert.equal(await page.locator(".card-body").isVisible(), false);
  }
  await open(page, ON_DISK, rich.path, `still=1&gl=none&step=${choosing}`);
  await page.locator(".prediction").waitFor();
  assert.equal(await page.locator(".card-body").isVisible(), false);
  await press(page, "PageDown");
  assert.equal(await page.locator(".card-body").isVisible(), true);
});

test("before it is pressed the small picture says what is under the pointer, and keeps it to itself while a question waits", async () => {
  const { scene, trace } = await readTrace(rich.id, 15);
  const says = async ([column, row]) => {
    const { x, y, width, height } = await page.locator(".picture-frame").boundingBox();
    await page.mouse.move(x + ((column + 0.5) * width) / 15, y + ((row + 0.5) * height) / 15);
    return page.locator(".picture-frame").getAttribute("title");
  };
  await open(page, ON_DISK, rich.path, START);
  for (const pixel of [[5, 8], [9, 7], [0, 0]]) assert.equal(await says(pixel), scene.objects[trace.object[trace.pixel.indexOf(pixel[1] * 15 + pixel[0])]]?.name ?? "background");
  const asking = scene.lesson.findIndex((step) => step.answer);
  await follow(page, `${START}&step=${asking + 1}`);
  assert.equal(await says([5, 8]), "");
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
