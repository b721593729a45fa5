/**
 * What a check of a picture costs: processor time of the page check/, from the file given to all that is shown: at once in a new page;
 * in one that rests, as it does while a file is looked for; and once more. Beside the least that any check must do: reading the picture, and one pass over its colours and the right ones. `raywalk bench --only check` asks for it
 * and has the bounds.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { launch, newPage, ON_DISK, PATIENCE, workOf } from "./browser.mjs";
import { pngOf, rightPicture, wrongPicture } from "./check-data.mjs";
import { load } from "./typescript.mjs";

const skip = process.env.RAYWALK_CHECK_WORK ? false : "asked for by raywalk bench --only check";
const ROUNDS = 5;
/** A scene, and a mistake there that leaves enough unexplained for all pairs to be tried. */
const STUDENTS = [["02-shadows", "phong-for-blinn"], ["08-glass", "not-bent-at-exit"]];

const { readPicture, taken } = await load("../check/main.ts");

/** The atlas' wrong picture, each of its pixels so large that it has the size. */
async function wrongFile(scene, name, n) {
  return { name: `${name}.png`, mimeType: "image/png", buffer: pngOf(taken(await wrongPicture(scene, name), n)) };
}

async function checked(page, file, work) {
  await page.evaluate(() => (document.getElementById("found").hidden = true));
  const before = await work();
  await page.locator("#file").setInputFiles(file);
  await page.locator("#found:not([hidden])").waitFor({ timeout: PATIENCE });
  return (await work()) - before;
}

/** ms: the picture is read and gone through once. Here, not in the page: the engine is the same. */
function floorOf({ buffer }, right) {
  const before = process.cpuUsage();
  const { values } = readPicture(new Uint8Array(buffer));
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += Math.abs(values[i] - right.values[i]);
  const { user, system } = process.cpuUsage(before);
  assert.ok(sum > 0);
  return (user + system) / 1000;
}

/** Until the page has had nothing to do for longer than it pauses before it prepares. */
async function rests(page, work) {
  for (let before = -1, now = await work(); now - before > 1; before = now, now = await work()) await page.waitForTimeout(1500);
}

/** ms: a check in a page that has just opened, with loading and preparing; the first in one that rests; another one; the floor. The
 *  least of all rounds. */
async function measured(browser, scene, name, n) {
  const file = await wrongFile(scene, name, n);
  const right = taken(await rightPicture(scene, n), n);
  const least = { atOnce: Infinity, first: Infinity, again: Infinity, floor: Infinity };
  const keep = (key, ms) => (least[key] = Math.min(least[key], ms));
  for (let round = 0; round < ROUNDS; round++) {
    for (const which of ["atOnce", "first"]) {
      const page = await newPage(browser); // has nothing loaded, and nothing compiled
      const work = await workOf(page);
      await page.goto(`${ON_DISK}check/index.html#scene=${scene}`);
      if (which === "first") await rests(page, work);
      keep(which, await checked(page, file, work));
      if (which === "atOnce") for (let k = 0; k < 2; k++) keep("again", await checked(page, file, work));
      await page.close();
    }
    for (let k = 0; k < 4; k++) keep("floor", floorOf(file, right)); // the engine warms to it
  }
  return { scene, size: n, ...least };
}

test("what is measured is a wrong picture of the size asked for, and its floor reads it", async () => {
  const [[scene, name]] = STUDENTS;
  const file = await wrongFile(scene, name, 512);
  const { width, height } = readPicture(new Uint8Array(file.buffer));
  assert.deepEqual([width, height], [512, 512]);
  assert.ok(floorOf(file, taken(await rightPicture(scene, 512), 512)) >= 0);
});

test("the work of a check", { skip }, async (t) => {
  const browser = await launch();
  t.after(() => browser.close());
  for (const [scene, name] of STUDENTS) for (const n of [512, 1155]) console.log(`# check ${JSON.stringify(await measured(browser, scene, name, n))}`);
});
