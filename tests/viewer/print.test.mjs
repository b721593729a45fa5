/** On paper: each step of the lesson with its figure, no heading without what it heads, nothing cut. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch, newPage, ON_DISK, open, openScene, richScene, keyedScenes, until } from "./browser.mjs";
import { cases } from "./cases.mjs";
import { readScene } from "./scene-files.mjs";

const PYTHON = [process.env.RAYWALK_PYTHON, ".venv/bin/python"].find((path) => path && existsSync(path));
const rich = richScene();
const other = keyedScenes()[1];
const folder = mkdtempSync(join(tmpdir(), "raywalk-print-"));
let browser, page;
before(async () => {
  browser = await launch();
  page = await newPage(browser);
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const words = (text) => text.normalize("NFKC").replace(/<[^>]+>/g, "").replace(/&[^;]+;|\s/g, ""); // paper has ligatures
/** One figure for each step and each answer. */
const figuresOf = ({ lesson }) => lesson.length + lesson.filter(({ answer }) => answer).length;

async function printed(format) {
  const path = join(folder, "page.pdf");
  await page.pdf({ path, format, preferCSSPageSize: true });
  return JSON.parse(execFileSync(PYTHON, ["tests/viewer/printed_pages.py", path]));
}

const WAYS = {
  "its own page": { path: rich.path, id: rich.id, come: () => {} },
  "its own page in German": { path: `de/${rich.path}`, id: rich.id, come: () => {} },
  "another scene's page, from which one has turned to it": { path: other.path, id: rich.id, come: () => openScene(page, rich.id) },
};
for (const [where, { path, id, come }] of Object.entries(WAYS))
  for (const format of cases(["A4", "Letter"], [path === rich.path ? "Letter" : "A4"]))
    test(`${id} printed from ${where} on ${format}: every step with its figure, no heading last on a page`, { skip: PYTHON ? false : "no Python here" }, async () => {
      await open(page, ON_DISK, path, "still=1&gl=none");
      await come();
      await until(page, (state, _stats, id) => state.scene === id, id);
      await page.waitForFunction((id) => document.querySelector("#page .plain-picture").src.includes(id), id);
      assert.equal(await page.locator(".step-figure").first().isVisible(), false, "on the screen the stage is the figure");
      const pages = await printed(format);
      const { seen, headings, lesson } = await page.evaluate(() => ({
        seen: [...document.querySelectorAll(".step-figure")].map((figure) => [figure.closest("li") && figure.naturalWidth > 0, figure.getAttribute("src"), figure.src]),
        headings: [...document.querySelectorAll("#page :is(h1, h2, summary)")].map((each) => each.textContent),
        lesson: [...document.querySelectorAll(".plain-lesson li")].map((each) => {
          const texts = document.createTreeWalker(each, NodeFilter.SHOW_TEXT); // apart: between a sentence and a choice is no space
          const parts = [];
          while (texts.nextNode()) parts.push(texts.currentNode.data);
          return parts.join(" ");
        }),
      }));
      const figures = figuresOf(readScene(id));
      assert.equal(seen.length, figures);
      assert.deepEqual(seen.filter(([isThere]) => !isThere), [], "paper's figures have been loaded");
      assert.equal(new Set(seen.map(([, source]) => source)).size, figures, "each its own");
      const pictures = pages.reduce((sum, each) => sum + each.pictures, 0);
      // Of a figure the shaded view, and in its corner the traced picture; seen from the camera its filled tiles, too.
      const drawn = seen.map(([, , file]) => readFileSync(fileURLToPath(file), "utf8").split("data:image/").length - 1);
      assert.ok(drawn.every((count) => count >= 1 && count <= 3));
      assert.equal(pictures, drawn.reduce((sum, count) => sum + count, 1), "on paper the scene's picture and all figures");
      for (const [k, { last }] of pages.entries()) assert.ok(!headings.some((heading) => words(heading) === words(last)), `page ${k + 1} ends on the heading "${last}"`);
      const all = words(pages.map(({ text }) => text).join(""));
      for (const step of lesson) for (const sentence of step.split("\n\n")) for (const word of sentence.split(/\s+/)) assert.ok(all.includes(words(word)), word);
    });

test("nothing is cut at the paper's edge, and no step is cut in two", async () => {
  await page.setViewportSize({ width: 690, height: 1000 }); // 18 cm at 96 dots an inch
  await open(page, ON_DISK, rich.path, "still=1&gl=none");
  await page.emulateMedia({ media: "print" });
  const { wide, whole } = await page.evaluate(() => ({
    wide: document.documentElement.scrollWidth - innerWidth,
    whole: [...document.querySelectorAll(".plain-lesson li, .figures div")].every((each) => getComputedStyle(each).breakInside === "avoid"),
  }));
  await page.emulateMedia({ media: null });
  assert.equal(wide, 0);
  assert.ok(whole);
});

test("nothing was said in the console", () => assert.deepEqual(page.faults, []));
